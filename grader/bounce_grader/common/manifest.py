"""The parts and their checks, from grader/parts.json, the only place that defines points."""

import json
import math
from collections.abc import Iterator, Sequence
from functools import cache
from typing import Any, NamedTuple

from bounce_grader.common.errors import UsageError
from bounce_grader.common.paths import ROOT

NAME = "grader/parts.json"
FIELDS = {"part": int, "stem": str, "title": str, "function": str, "checks": list}


class Check(NamedTuple):
    """A check of parts.json."""

    id: str
    title: str
    points: float


class Part(NamedTuple):
    """A part of parts.json."""

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
    """Raises UsageError if the manifest isn't valid."""
    try:
        found = json.loads((ROOT / NAME).read_text("utf-8"))["parts"]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise UsageError(f"{NAME} can't be read as JSON with a list of parts: {error}") from error
    for problem in _problems(found):
        raise UsageError(f"{NAME}: {problem}")
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
        for part in found
    )


@cache
def example_points() -> float:
    """What the cases give that students hand in; 0 unless the manifest says otherwise."""
    parts()  # which finds a manifest that isn't valid
    points = json.loads((ROOT / NAME).read_text("utf-8")).get("examples", 0)
    if not _is_points(points):
        raise UsageError(f"{NAME}: examples has to be a number of points that isn't negative")
    return float(points)


def full_points() -> float:
    return sum(part.points for part in parts()) + example_points()


def named_together(numbers: Sequence[int]) -> str:
    """Some parts in words: "part 2", "parts 1, 2 and 4", or "all parts"."""
    if len(numbers) == len(parts()) > 1:
        return "all parts"
    *first, last = map(str, numbers)
    return f"parts {', '.join(first)} and {last}" if first else f"part {last}"


def part_of(name: str) -> Part:
    """The part of a name such as part2_without_dt. Raises StopIteration if there is none."""
    return next(part for part in parts() if name.startswith(f"part{part.number}_"))


def _problems(found: Any) -> Iterator[str]:
    """What is wrong with the list of parts. Only the first counts: the others rely on it."""
    if not isinstance(found, list) or not found:
        yield "it lists no parts"
    ids: list[str] = []
    for number, part in enumerate(found, 1):
        if not isinstance(part, dict) or part.get("part") != number:
            yield f"entry {number} isn't part {number}: number the parts 1, 2, 3 and so on, in order"
        for field, kind in FIELDS.items():
            if not isinstance(part.get(field), kind):
                yield f"part {number} lacks its {field!r}, or has another kind of value there"
        if not _is_points(part.get("points")):
            yield f"the points of part {number} have to be a number that isn't negative"
        for check in part["checks"]:
            if not isinstance(check, dict) or check.keys() != set(Check._fields):
                yield f"each check of part {number} has to have an id, a title and points"
            if not _is_points(check["points"]):
                yield f"the points of {check['id']} have to be a number that isn't negative"
            if check["id"] in ids:
                yield f"the check {check['id']} is there twice: keep one"
            ids.append(check["id"])
        total = sum(check["points"] for check in part["checks"])
        if not math.isclose(total, part["points"], abs_tol=1e-9):
            yield (
                f"part {number} gives {part['points']:g} points, and its checks {total:g} "
                "together: make them equal"
            )
    if not sum(part["points"] for part in found):
        yield "all checks together give no points"


def _is_points(points: Any) -> bool:
    return type(points) in (int, float) and 0 <= points < math.inf
