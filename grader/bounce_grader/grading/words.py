"""Says what the judge's facts about a check mean, in the lines of a report."""

import re
from collections.abc import Iterator
from signal import Signals
from typing import Any, NamedTuple

from bounce_grader.build.errors import meaning, meanings
from bounce_grader.submission.submission import Place

Facts = dict[str, Any]  # a failed check in numbers (grader/judge/facts.hpp)
Rows = list[list[float | str]]
# How a program ended, by the judge's name for it (grader/judge/termination.hpp): with its number and
# text, {came} for how much of an answer came, and {call} for a system call's name or number.
ENDINGS = {
    "exited": "the program ended by itself (exit status {number}) in place of an answer: it called "
    "exit(), perhaps",
    "worked": "the program used more than {number} s of CPU time: a loop without end, perhaps",
    "stored": "the program was still storing more when its {number} s of CPU time were used up: a "
    "loop that stores without end, perhaps",
    "out of memory": "the program ran out of memory ({number} MB): a size that is wrong, or a loop "
    "that stores without end, perhaps",
    "threads": "the program was ended: it had more than {number} threads at a time",
    "waited": "{came}: the program waits for something, perhaps for input, or sleeps",
    "stopped": "{came}: the program stopped itself, as by SIGSTOP",
    "printed": "the program printed more than {number} MB and was stopped: a print in a loop "
    "without end, perhaps",
    "closed": "the program closed the pipe of its {text}, which is the kit's",
    "not started": "the system can't start the program that the parts were linked to: look for "
    "lines of assembler in them",
    "wrote no answer": "the program wrote to where answers go (descriptor 4, which is the kit's), "
    "and what came isn't the answer that was asked for",
    "read no replies": "the program asked for what earlier parts answer, and didn't read the "
    "replies",
    "asked": "the program asked for what isn't given to it",
    "called earlier parts": "the program called earlier parts {number} times for one answer: a loop "
    "without end, perhaps",
    "absent": "the file defines no {text} that other files can call: it takes the namespace and the "
    "arguments of its header, and neither static nor inline",
    "not asked as it hung": "nothing was asked here: the part hung before, and its time is used up",
    "not asked for want of time": "nothing was asked here: the time for this part, or for the whole "
    "grading, is used up",
    "call": "the program asked the system for what it isn't given: {call}",
}
STARTS_A_PROCESS = ("clone", "fork", "vfork")  # a thread is allowed, and asks clone otherwise
# How a signal ended it, and what the program reported of the cause (grader/runner/crash.hpp).
SIGNALS = {
    "SIGSEGV": "crashed with a segmentation fault: so early that it couldn't say where; global "
    "arrays that are too large, or a change of how signals are handled, do that",
    "SIGSEGV null pointer": "crashed with a segmentation fault: it followed a null pointer",
    "SIGSEGV full stack": "crashed with a segmentation fault: its stack is full: a recursion "
    "without end, or a very large local array",
    "SIGSEGV unknown": "crashed with a segmentation fault: it read or wrote memory that isn't its "
    "own (an index out of range, or a pointer to what is gone)",
    "SIGFPE": "crashed with an arithmetic error: an integer division by zero",
    "SIGFPE floating point": "crashed with an arithmetic error: it turned floating-point traps on, "
    "and an operation set one off",
    "SIGSYS": "asked the system for what it isn't given: a process, a thread, a file, a connection",
    "SIGILL": "crashed with an illegal instruction: a function that returns no value, perhaps",
    "SIGBUS": "crashed with a bus error: it touched memory that isn't there",
    "SIGTRAP": "stopped itself with a trap",
    "SIGXFSZ": "tried to write a file",
    "SIGKILL": "was killed: by itself, or by the system for want of memory or time",
}
THREW = (
    "the program threw where nothing catches it (before main, in a destructor, in a noexcept "
    "function or in what())"
)
ABORTED = "the program aborted: it called abort() or std::terminate(), perhaps"
OVERWROTE = "the program aborted: it wrote beyond the end of its memory, or freed some twice"
# What glibc says where it finds that its data about memory were overwritten.
OF_MEMORY = re.compile(
    r"(free|malloc|realloc|malloc_consolidate|munmap_chunk)\(\): |double free or corruption|"
    "corrupted size|corrupted double-linked|stack smashing detected"
)
NOTHING = 1e-14  # as in grader/diagnosis/feedback.cpp
CRASHES = "crashes.txt"  # what failed assertions and sanitizers mean, for ./check, too


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
    def is_of_assertion(self) -> bool:
        ended = self.ended or {"what": ""}
        return ended["what"] == "aborted" and failed_assertion(ended["text"]) is not None

    @property
    def is_of_sanitizer(self) -> bool:
        """Whether a sanitizer ended it, and named a fault that we know."""
        ended = self.ended or {"what": ""}
        return ended["what"] == "sanitizer" and ended["text"] in dict(meanings(CRASHES))

    @property
    def reason(self) -> str:
        """The exception of the failed case, or how the program crashed; empty if there is
        neither."""
        if self.status == "crashed":
            return self.end
        failure = self.failure if self.status == "graded" else None
        return str(failure["sentence"]) if failure and not failure["quantities"] else ""


def ending(ended: Facts) -> str:
    """How a program ended, and the likely cause. Raises KeyError if the facts are none of the
    judge's."""
    what, number, text = ended["what"], ended["number"], ended["text"]
    if what == "aborted":
        return _aborted(text)
    if what == "sanitizer" and (words := dict(meanings(CRASHES)).get(text)):
        return words
    if what in ("signal", "sanitizer"):
        return f"the program {_by_signal(number, text)}"
    came = "only a part of an answer came" if text else "no answer came"
    call = "to start a process" if text in STARTS_A_PROCESS else f"the system call {text or number}"
    return ENDINGS[what].format(text=text, number=number, came=came, call=call)


def failed_assertion(text: str) -> tuple[str, str] | None:
    """The place and the words of the first assertion among the lines that a program printed, in
    one of these forms: "program: path/File.h:12: function: Assertion `words' failed"."""
    for line in text.splitlines():
        before, _, after = line.partition("Assertion ")
        words, failed, _ = after[1:].rpartition("' failed")
        place = re.search(r"(?<![\w.+-])([\w.+-]+:\d+): ", before)
        if place and failed and after[0] in "`'":
            return place[1][:120], words
    return None


def _aborted(text: str) -> str:
    if assertion := failed_assertion(text):
        place, words = assertion
        return f"an assertion failed: {meaning(words, CRASHES) or f'{place}: {_line(words)}'}"
    _, thrown, rest = text.rpartition("terminate called after throwing an instance of '")
    if thrown:
        kind = rest.partition("\n")[0].partition("'")[0]
        _, said, what = rest.rpartition("  what():  ")
        what = what.partition("\n")[0] if said else ""
        return f"{THREW}: {_line(kind)}" + (f', "{_line(what)}"' if what else "")
    last = _line(text.rstrip("\n").rpartition("\n")[2])
    return f"{OVERWROTE} ({last})" if OF_MEMORY.search(last) else ABORTED


def _line(text: str) -> str:
    text = " ".join(text.split())  # many blanks could begin a line of the report at will
    return text if len(text) <= 120 else f"{text[:120]}..."


def _by_signal(number: int, cause: str) -> str:
    name = next((signal.name for signal in Signals if signal == number), str(number))
    cause = cause if f"{name} {cause}" in SIGNALS or not cause else "unknown"
    words = SIGNALS.get(f"{name} {cause}") or SIGNALS.get(name)
    return words or f"was ended by signal {name}, which it sent itself"


def of_check(verdict: Verdict, revealed: bool = False) -> str:
    """What was asked, what came, and what is right, unless the case is hidden and not revealed."""
    failure = verdict.failure
    if failure is None:
        return verdict.end
    which = "the last" if failure["ended_at"] else "the first"
    hidden = " (a hidden case)" if failure["hidden"] else ""
    asked = failure["input"].replace("\n", "\n" + 11 * " ")
    lines = [
        f"{counts(failure)}{failure['again'] or '; '}{which}: {failure['name']}{hidden}",
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


def shown(failure: Facts) -> Facts:
    """The failed case in numbers, for whoever reads the record."""
    fields = ("name", "input", "hidden", "contact", "sentence", "quantities")
    return {name: failure[name] for name in fields}
