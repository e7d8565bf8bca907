"""Says what the judge's facts about a check mean, in the lines of a report."""

import re
from collections.abc import Iterator
from pathlib import Path
from signal import Signals
from typing import Any, NamedTuple

from bounce_grader.build.errors import meaning, meanings
from bounce_grader.submission.submission import Place

Facts = dict[str, Any]  # a failed check in numbers (grader/judge/facts.hpp)
Rows = list[list[float | str]]
ENDINGS = Path(__file__).with_name("endings.txt")
STARTS_A_PROCESS = ("clone", "fork", "vfork")  # a thread is allowed, and asks clone otherwise
# What glibc says where it finds that its data about memory were overwritten.
OF_MEMORY = re.compile(
    r"(free|malloc|realloc|malloc_consolidate|munmap_chunk)\(\): |double free or corruption|"
    "corrupted size|corrupted double-linked|stack smashing detected"
)
NOTHING = 1e-14  # as in grader/diagnosis/feedback.cpp
CRASHES = "crashes.txt"  # what failed assertions and sanitizers mean, for ./check, too
AGAIN = (  # as in tests/parts/linked/main.cpp
    " when asked again in another order, though right before: is something kept from one call to "
    "the next? "
)


class Verdict(NamedTuple):
    """What became of one check."""

    passed: bool
    status: str
    ended: Facts | None = None  # how the program ended, if it did (grader/judge/termination.hpp)
    stack: str = ""  # addresses, where it crashed
    failure: Facts | None = None  # None if the check passed, or failed as a whole
    place: Place | None = None  # of a crash in the submission, if known
    found: str = ""  # what sanitizers found, where a crash didn't say why

    @property
    def end(self) -> str:
        """How the program ended, and where."""
        words = ending(self.ended) if self.ended else ""
        return f"{words}, at {self.place}" if self.place else words

    @property
    def kind_of_end(self) -> str:
        """Its name in endings.txt; empty if the program didn't end."""
        return _end(self.ended)[0] if self.ended else ""

    @property
    def reason(self) -> str:
        """The exception of the failed case, or how the program crashed; or empty."""
        if self.status == "crashed":
            return self.end
        failure = self.failure if self.status == "graded" else None
        return str(failure["sentence"]) if failure and not failure["quantities"] else ""


def ending(ended: Facts) -> str:
    """How a program ended, and the likely cause. Raises KeyError for what the judge never says."""
    kind, text = _end(ended)
    number = ended["number"]
    came = "only a part of an answer came" if text else "no answer came"
    call = "to start a process" if text in STARTS_A_PROCESS else f"the system call {text or number}"
    return dict(meanings(ENDINGS))[kind].format(text=text, number=number, came=came, call=call)


def _end(ended: Facts) -> tuple[str, str]:
    """The name in endings.txt of how a program ended, and the text in its sentence."""
    what, number, text = ended["what"], ended["number"], ended["text"]
    if what == "aborted":
        return _aborted(text)
    if what == "sanitizer" and (words := dict(meanings(CRASHES)).get(text)):
        return "found", words
    if what not in ("signal", "sanitizer"):
        return what, text
    name = next((signal.name for signal in Signals if signal == number), str(number))
    known = [f"{name} {text or 'early'}", name, "signal"]
    return next(kind for kind in known if kind in dict(meanings(ENDINGS))), name


def _aborted(text: str) -> tuple[str, str]:
    """The same of a program that printed this before it aborted, such as "program: path/File.h:12:
    function: Assertion `words' failed"."""
    for line in text.splitlines():
        before, _, after = line.partition("Assertion ")
        words, failed, _ = after[1:].rpartition("' failed")
        place = re.search(r"(?<![\w.+-])([\w.+-]+:\d+): ", before)
        if place and failed and after[0] in "`'":
            return "assertion", meaning(words, CRASHES) or f"{place[1][:120]}: {_line(words)}"
    _, thrown, rest = text.rpartition("terminate called after throwing an instance of '")
    if thrown:
        kind = rest.partition("\n")[0].partition("'")[0]
        _, said, what = rest.rpartition("  what():  ")
        what = what.partition("\n")[0] if said else ""
        return "threw", _line(kind) + (f', "{_line(what)}"' if what else "")
    last = _line(text.rstrip("\n").rpartition("\n")[2])
    return "overwrote" if OF_MEMORY.search(last) else "aborted", last


def _line(text: str) -> str:
    text = " ".join(text.split())  # many blanks could begin a line of the report at will
    return text if len(text) <= 120 else f"{text[:120]}..."


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
    return f"ended at case {failure['ended_at']} of {failure['cases']}"


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
    """With the rounding errors of 0 as 0."""
    return x if isinstance(x, str) else f"{0 if abs(x) < NOTHING else x:.12g}"
