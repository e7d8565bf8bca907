"""The parts and their checks, from grader/parts.json, the only place that defines points."""

import json
import math
import re
from collections.abc import Iterator, Sequence
from functools import cache
from typing import Any, NamedTuple

from bounce_grader.common.errors import UsageError
from bounce_grader.common.numbers import short
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
        manifest = json.loads((ROOT / "grader" / "parts.json").read_text())
        found = manifest["parts"]
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise UsageError(f"{NAME} can't be read as JSON with a list of parts: {error}") from error
    problem = next(_problems(found), "")
    if problem:
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
    if not isinstance(found, list) or not found:
        yield "it lists no parts"
        return
    seen: set[str] = set()
    for number, part in enumerate(found, 1):
        yield from _problems_of_part(number, part)
        for check in part["checks"]:
            if check["id"] in seen:
                yield f"the check {check['id']} is there twice: keep one"
            seen.add(check["id"])
    if not sum(part["points"] for part in found):
        yield "all checks together give no points"


def _problems_of_part(number: int, part: Any) -> Iterator[str]:
    if not isinstance(part, dict) or part.get("part") != number:
        yield f"entry {number} isn't part {number}: number the parts 1, 2, 3 and so on, in order"
        return
    for field, kind in FIELDS.items():
        if not isinstance(part.get(field), kind):
            yield f"part {number} lacks its {field!r}, or has another kind of value there"
            return
    if not _is_points(part.get("points")):
        yield f"the points of part {number} have to be a number that isn't negative"
        return
    known = _checks_in_tests(part["stem"])
    for check in part["checks"]:
        if not isinstance(check, dict) or check.keys() != {"id", "title", "points"}:
            yield f"each check of part {number} has to have an id, a title and points"
            return
        if not _is_points(check["points"]):
            yield f"the points of {check['id']} have to be a number that isn't negative"
            return
        if known and check["id"] not in known:
            yield (
                f"tests/parts/{part['stem']}_test.cpp has no check {check['id']}: correct the id, or "
                "leave the check out"
            )
    total = sum(check["points"] for check in part["checks"])
    if not math.isclose(total, part["points"], abs_tol=1e-9):
        yield (
            f"part {number} gives {short(part['points'])} points, and its checks {short(total)} "
            "together: make them equal"
        )


def _is_points(points: Any) -> bool:
    return type(points) in (int, float) and 0 <= points < math.inf


def _checks_in_tests(stem: str) -> set[str]:
    """The ids of the checks that the tests of a part define; empty if they aren't here."""
    try:
        text = (ROOT / "tests" / "parts" / f"{stem}_test.cpp").read_text()
    except OSError:
        return set()
    return {f"{part}.{name}" for part, name in re.findall(r"^TEST\((\w+), (\w+)\)", text, re.M)}
