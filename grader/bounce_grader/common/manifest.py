"""The parts and their checks, from grader/parts.json, the only place that defines points."""

import json
import math
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from functools import cache
from typing import Any, NamedTuple

from bounce_grader.common.errors import UsageError
from bounce_grader.common.paths import ROOT

NAME = "grader/parts.json"


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
def read() -> tuple[tuple[Part, ...], float]:
    """The parts and the points for examples. Raises UsageError if the manifest isn't valid."""
    try:
        written = json.loads((ROOT / NAME).read_text("utf-8"))
        found = tuple(_part(**one) for one in written["parts"])
        examples = written.get("examples", 0)
    except (OSError, ValueError) as error:
        raise UsageError(f"{NAME} can't be read as JSON: {error}") from error
    except (KeyError, TypeError) as error:
        lacks = isinstance(error, KeyError) or "missing" in str(error)
        keys = ", ".join(re.findall(r"'\w+'", str(error))) or "this form"
        raise UsageError(
            f"{NAME}: an entry {'lacks' if lacks else 'may not have'} {keys}"
        ) from error
    for problem in _problems(found, examples):
        raise UsageError(f"{NAME}: {problem}")
    return found, float(examples)


def _part(part: int, checks: list[Any], calls: Sequence[int] = (), **others: Any) -> Part:
    return Part(part, checks=tuple(Check(**one) for one in checks), calls=tuple(calls), **others)


def parts() -> tuple[Part, ...]:
    return read()[0]


def example_points() -> float:
    """What the cases give that students hand in; 0 unless the manifest says otherwise."""
    return read()[1]


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


def _problems(found: tuple[Part, ...], examples: object) -> Iterator[str]:
    """What is wrong with the parts and the points for examples. Only the first counts."""
    for number, part in enumerate(found, 1):
        if part.number != number:
            yield f"entry {number} isn't part {number}: number the parts 1, 2, 3 and so on, in order"
        given = {f"part {number}": part.points} | {c.id: c.points for c in part.checks}
        for what, points in given.items():
            if not _is_points(points):
                yield f"the points of {what} have to be a whole number that isn't negative"
        total = sum(check.points for check in part.checks)
        if not math.isclose(total, part.points, abs_tol=1e-9):
            unequal = f"gives {part.points:g} points, and its checks {total:g} together"
            yield f"part {number} {unequal}: make them equal"
    for id, times in Counter(check.id for part in found for check in part.checks).items():
        if times > 1:
            yield f"the check {id} is there {times} times: keep one"
    if not _is_points(examples):
        yield "the points of examples have to be a whole number that isn't negative"
    if not sum(part.points for part in found):
        yield "all checks together give no points"


def _is_points(points: Any) -> bool:
    """Whole, since some services and ./check take no others."""
    return type(points) in (int, float) and 0 <= points < math.inf and points == int(points)
