"""The parts and their checks, from grader/parts.json, the only place that defines points.

A part's points are the sum of its checks'. A part may have a number of points itself: then its
checks share it in proportion to theirs, in whole points, since some services and ./check take no
others.
"""

import json
import math
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from functools import cache
from itertools import accumulate, pairwise
from typing import Any, NamedTuple

from bounce_grader.common.errors import UsageError
from bounce_grader.common.paths import ROOT

NAME = "grader/parts.json"
FORMS = {int: "a whole number", str: "a text", list: "a list"}


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
    except (OSError, ValueError) as error:
        raise UsageError(f"{NAME} can't be read as JSON: {error}") from error
    _require("it", written, parts=list)
    examples = written.get("examples", 0)
    found = tuple(_part(number, entry) for number, entry in enumerate(written["parts"], 1))
    for problem in _problems(found, examples):
        raise UsageError(f"{NAME}: {problem}")
    return tuple(part._replace(checks=_shared(part)) for part in found), float(examples)


def _part(number: int, entry: Any) -> Part:
    what = f"part {number}"
    _require(what, entry, part=int, stem=str, title=str, function=str, checks=list)
    entry = {"calls": []} | entry
    _require(what, entry, calls=list)
    for at, check in enumerate(entry["checks"], 1):
        _require(f"check {at} of {what}", check, id=str, title=str)
    checks = tuple(Check(one["id"], one["title"], one.get("points")) for one in entry["checks"])
    of = (entry["part"], entry["stem"], entry["title"], entry["function"])
    return Part(*of, entry.get("points", _sum(checks)), checks, tuple(entry["calls"]))


def _require(what: str, entry: Any, **forms: type) -> None:
    """Raises UsageError if an entry lacks something, or has it in another form."""
    for key, form in forms.items():
        if not (isinstance(entry, dict) and isinstance(entry.get(key), form)):
            raise UsageError(f'{NAME}: {what} needs "{key}", {FORMS[form]}')


def _sum(checks: Sequence[Check]) -> float:
    """Without those that are no number, which are told of."""
    return sum(check.points for check in checks if _is_points(check.points))


def _shared(part: Part) -> tuple[Check, ...]:
    """The checks with whole points that add up to the part's: their running totals are rounded."""
    scale = part.points / (_sum(part.checks) or 1)
    totals = accumulate((check.points for check in part.checks), initial=0.0)
    shares = pairwise(round(total * scale) for total in totals)
    return tuple(c._replace(points=end - start) for c, (start, end) in zip(part.checks, shares))


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
        if part.points and not _sum(part.checks):
            yield f"part {number} gives {part.points:g} points, and its checks none: give one some"
        shared = zip(part.checks, _shared(part))
        if any(check.points > 0 == whole.points for check, whole in shared):
            yield f"part {number} has too few points for its checks: give it more"
    for id, times in Counter(check.id for part in found for check in part.checks).items():
        if times > 1:
            yield f"the check {id} is there {times} times: keep one"
    if not _is_points(examples):
        yield "the points of examples have to be a whole number that isn't negative"
    if not sum(part.points for part in found):
        yield "all checks together give no points"


def _is_points(points: Any) -> bool:
    return type(points) in (int, float) and 0 <= points < math.inf and points == int(points)
