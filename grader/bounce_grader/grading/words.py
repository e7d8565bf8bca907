"""Says what the judge's facts about a check mean, in the lines of a report."""

from collections.abc import Iterator
from typing import Any, NamedTuple

from bounce_grader.submission.submission import Place

Facts = dict[str, Any]  # a failed check in numbers (grader/judge/facts.hpp)
Rows = list[list[float | str]]
AGAIN = (
    " when asked again in another order, though right before: is something kept from one call to "
    "the next? "
)


class Verdict(NamedTuple):
    """What became of one check."""

    passed: bool
    status: str
    ended: str = ""  # how the program ended, if it did
    by: str = ""  # what explains a crash: "assertion", "sanitizer", or nothing
    stack: str = ""  # addresses, where it crashed
    failure: Facts | None = None  # None if the check passed, or failed as a whole
    place: Place | None = None  # of a crash in the submission, if known
    found: str = ""  # what sanitizers found, where a crash didn't say why

    @property
    def end(self) -> str:
        """How the program ended, and where."""
        return f"{self.ended}, at {self.place}" if self.place else self.ended

    @property
    def reason(self) -> str:
        """The exception of the failed case, or how the program crashed; empty if there is
        neither."""
        if self.status == "crashed":
            return self.end
        failure = self.failure if self.status == "graded" else None
        return str(failure["sentence"]) if failure and not failure["quantities"] else ""


def of_check(verdict: Verdict, revealed: bool = False) -> str:
    """What was asked, what came, and what is right, unless the case is hidden and not revealed."""
    failure = verdict.failure
    if failure is None:
        return verdict.end
    which = "the last" if failure["ended_at"] else "the first"
    hidden = " (a hidden case)" if failure["hidden"] else ""
    asked = failure["input"].replace("\n", "\n" + 11 * " ")
    lines = [
        f"{counts(failure)}{AGAIN if failure['again'] else '; '}{which}: {failure['name']}{hidden}",
        f"  input    {asked}",
        *_answer(verdict, failure, revealed or not failure["hidden"]),
    ]
    return "\n".join(lines) + (f"\n  checked  {verdict.found}" if verdict.found else "")


def counts(failure: Facts) -> str:
    """How many cases are wrong; or where the program ended, which is asked no more."""
    if not failure["ended_at"]:
        return f"{failure['wrong']} of {failure['cases']} cases wrong"
    before = [f"{n} {how}" for how, n in failure["before"].items() if n]
    with_ = f", with {' and '.join(before)} before it" if before else ""
    return f"ended at case {failure['ended_at']} of {failure['cases']}{with_}"


def _answer(verdict: Verdict, failure: Facts, shown: bool) -> Iterator[str]:
    if failure["sentence"]:
        yield f"  got      {verdict.end if failure['ended_at'] else failure['sentence']}"
    for quantity in failure["quantities"]:
        name, unit = f"{quantity['name']} = ", f"  {quantity['unit']}"
        indent = 11 + len(name)
        right = _matrix(quantity["expected"], indent) + unit
        yield f"  expected {name + right if shown else 'is not shown, this case is hidden'}"
        marked = ", [wrong]" if _size(quantity["got"]) > 1 else ""
        yield f"  got      {name}{_matrix(quantity['got'], indent, quantity['right'])}{unit}{marked}"


def _size(rows: Rows) -> int:
    return sum(map(len, rows))


def _matrix(rows: Rows, indent: int, right: list[list[bool]] | None = None) -> str:
    """A scalar, (a, b, c), or the rows of a matrix below each other, wrong entries in brackets."""
    if _size(rows) == 1:
        return _number(rows[0][0])
    marks = right or [[True] * len(row) for row in rows]
    entries = [
        [_number(x) if ok else f"[{_number(x)}]" for x, ok in zip(*row)] for row in zip(rows, marks)
    ]
    if all(len(row) == 1 for row in entries):  # a vector is written in one line
        entries = [[row[0] for row in entries]]
    return ("\n" + indent * " ").join(f"({', '.join(row)})" for row in entries)


def _number(x: float | str) -> str:
    return x if isinstance(x, str) else f"{x:.12g}"


def shown(failure: Facts, revealed: bool = False) -> Facts:
    """The failed case in numbers, for reports that draw it; of a hidden case, nothing that tells
    the answer unless it is revealed."""
    fields = ("name", "input", "sentence", "quantities", "contact", "scene", "path")
    case = {name: failure[name] for name in fields if failure.get(name) not in (None, "")}
    case.setdefault("sentence", "")
    if failure["hidden"] and not revealed:
        case.pop("contact", None)
        case["quantities"] = [_without(q, "expected") for q in failure["quantities"]]
        if "path" in case:
            case["path"] = _without(case["path"], "expected", "columns")
    return case


def _without(fields: Facts, *names: str) -> Facts:
    return {name: value for name, value in fields.items() if name not in names}
