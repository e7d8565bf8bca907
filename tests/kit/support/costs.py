"""python -m costs: prints what each mistake of the gallery costs, by part, the most expensive
first.

Read it when points or cases change: mistakes of the same weight should cost about the same.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from bounce_grader.common.manifest import parts, Part
from bounce_grader.grading.gallery import expected, points

MISTAKES = Path(__file__).resolve().parents[2] / "submissions" / "mistakes"


@dataclass(frozen=True)
class Cost:
    mistake: str
    part: Part
    points: float
    lost: tuple[str, ...]  # the names of the checks, without their part

    @property
    def share(self) -> float:
        return self.points / self.part.points


def costs() -> list[Cost]:
    """The costs by part; within a part, the most expensive first."""
    found = map(_cost, sorted(folder for folder in MISTAKES.iterdir() if folder.is_dir()))
    return sorted(found, key=lambda cost: (cost.part.number, -cost.points, cost.mistake))


def _cost(folder: Path) -> Cost:
    ids = expected(folder)["lost"]
    part, left = next((p, left) for p, left in zip(parts(), points(ids)) if left < p.points)
    lost = tuple(id.partition(".")[2] for id in ids)
    return Cost(folder.name, part, part.points - left, lost)


def table() -> str:
    return "\n".join(_lines())


def _lines() -> Iterator[str]:
    for part in parts():
        yield f"part {part.number}: {part.title}, {part.points} points"
        for cost in costs():
            if cost.part == part:
                yield f"{cost.points:4g}  {cost.mistake:48} {', '.join(cost.lost)}"


if __name__ == "__main__":
    print(table())
