"""The parts and their checks, from grader/parts.json, the only place that defines points."""

import json
from functools import cache
from typing import NamedTuple

from bounce_grader.common.paths import ROOT


class Check(NamedTuple):
    id: str
    title: str
    points: float


class Part(NamedTuple):
    number: int
    stem: str
    title: str
    function: str
    points: float
    checks: tuple[Check, ...]
    calls: tuple[int, ...]  # numbers of the earlier parts that it calls

    @property
    def file(self) -> str:
        return f"{self.stem}.cpp"


@cache
def parts() -> tuple[Part, ...]:
    manifest = json.loads((ROOT / "grader" / "parts.json").read_text())
    return tuple(
        Part(
            number=part["part"],
            stem=part["stem"],
            title=part["title"],
            function=part["function"],
            points=part["points"],
            checks=tuple(Check(**check) for check in part["checks"]),
            calls=tuple(part.get("calls", ())),
        )
        for part in manifest["parts"]
    )


def part_of(name: str) -> Part:
    """The part of a name such as part2_without_dt. Raises StopIteration if there is none."""
    return next(part for part in parts() if name.startswith(f"part{part.number}_"))
