"""Runs the judge on a runner, and reads its verdicts.

A part may be built and run again with AddressSanitizer and UBSan: one that crashed, as they report
the first wrong memory access, not the last; or one with all points, whose right numbers may be luck.
This never changes the score."""

import json
import re
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any, Literal, NamedTuple

from bounce_grader.build.compile import compile_all, contents_of, store, stored, toolchain_digest
from bounce_grader.build.toolchain import link_alone, Work
from bounce_grader.common.errors import KitError
from bounce_grader.common.escaping import first_few, in_one_line, printable_name, printable_text
from bounce_grader.common.files import digest
from bounce_grader.common.manifest import Part
from bounce_grader.common.paths import FIXTURES, JUDGE, SENTENCES, SOURCES, WORK_FOLDER
from bounce_grader.sandbox import processes
from bounce_grader.sandbox.box import LARGEST_FILE
from bounce_grader.sandbox.budget import Overrun
from bounce_grader.submission.submission import Place

SYMBOLS = processes.Limits(cpu_seconds=5, wall_seconds=30, memory=1 << 30, file_size=0)
WAIT = processes.Limits(60, 300, memory=4 << 30, file_size=LARGEST_FILE, output=1 << 20)
IN_SOURCES = re.compile(rf"[^/]{{1,50}}/{SOURCES}-[0-9a-f]{{16}}/(.{{1,255}}?):(\d{{1,9}})(?!\d)")
MOST_CPU_SECONDS, MOST_SECONDS = 30, 200  # for all runners of a part together
SANITIZED_CPU_SECONDS, SANITIZED_SECONDS = 20.0, 80.0  # to build all parts, or to run one
MARGIN = 5.0  # s, to stop it
# In a runner of all parts, or of this one with given earlier parts.
How = Literal["together", "alone"]
Facts = dict[str, Any]


def fact(id: str, *words: str) -> Facts:
    """What there is to say of a part: the id of its sentence in grader/words/report.txt, and the
    words in it, which may hold any text."""
    return {"id": id, "words": [in_one_line(text) for text in words]}


class Verdict(NamedTuple):
    """What became of one check, as grader/judge/main.cpp says it."""

    passed: bool
    status: str
    ended: Facts | None = None  # how the program ended, if it did
    stack: str = ""  # addresses, where it crashed
    failure: Facts | None = None  # the failed case; None if the check passed, or failed as a whole
    answer: Facts | None = None  # what is right there, which a reader gets only of public cases
    place: Place | None = None  # of a crash in the submission, if known
    found: str = ""  # the sanitizers' name for what they found, where a crash didn't say why
    smallest: Facts | None = None  # the simplest case with a wrong number, for paper


class Judged(NamedTuple):
    """The verdicts of one part, by check id. graded_with is "given" if it called
    the part before it, and that was given; else "own", as where it shares a helper with that part.
    `mistakes` names the known mistakes that it makes. If there is none, `patterns` says what its
    wrong numbers have in common, such as a factor or a sign."""

    verdicts: dict[str, Verdict]
    largest_error: float | None
    graded_with: str
    mistakes: tuple[str, ...] = ()
    patterns: tuple[Facts, ...] = ()

    def score(self, part: Part) -> float:
        return sum(check.points for check in part.checks if self.verdicts[check.id].passed)

    @property
    def ended(self) -> list[Verdict]:
        """Of the checks in which its runner ended."""
        return [verdict for verdict in self.verdicts.values() if verdict.status != "graded"]

    @property
    def status(self) -> str:
        """The way in which its runner first ended; "graded" if it answered every question."""
        return self.ended[0].status if self.ended else "graded"


def which_counts(part: Part, own: Judged | None, given: Judged | None) -> Judged:
    """Of the runs with the student's own earlier parts and with given ones, of which one is there:
    the table of docs/grading.md."""
    if not own or (given and given.score(part) > own.score(part)):
        assert given
        return given
    if own.score(part) < part.points and given and given.status == "graded":
        # No wrong earlier part is in its numbers.
        verdicts = {
            id: verdict._replace(smallest=verdict.smallest or given.verdicts[id].smallest)
            for id, verdict in own.verdicts.items()
            if not verdict.passed
        }
        own = own._replace(verdicts=own.verdicts | verdicts)
        return own._replace(mistakes=given.mistakes, patterns=given.patterns)
    return own


def judge(part: Part, how: How, work: Work, runner: Path, hidden: Path | None) -> Judged:
    """Judges a part; without `hidden`, on the public cases alone. Checks that the grading has no
    time left for fail. Raises KitError if the judge fails or doesn't name every check."""
    box, sanitized = work.box, work.kind == "sanitized"
    cpu, wall = box.budget.left()
    asked = {
        "part": part.number,
        "fixtures": [str(FIXTURES / "public"), *([str(hidden)] if hidden else [])],
        "given": how == "alone" and bool(part.calls),
        "backwards": how == "alone" and not sanitized,
        "sanitized": sanitized,
        "recognise": how == "alone" and not sanitized,
        "boxed": box.kind != "none",
        "cpu_seconds": max(1, int(min(cpu, MOST_CPU_SECONDS))),
        "seconds": max(1, int(min(wall, MOST_SECONDS))),
    }
    box.budget.require_time()
    # Not limited by the budget: the judge keeps to the seconds above, and reports what passed.
    limits = WAIT._replace(memory=None) if sanitized else WAIT
    command = [str(JUDGE), json.dumps(asked), *box.to_run(runner, sanitized)]
    result = processes.run(command, limits)
    box.budget.require_responsive_machine()
    if not result.ok:
        raise KitError(f"the judge failed on part {part.number}: {result.err.strip() or 'killed'}")
    judged = read_answer(result.out, part)
    stacks = {verdict.stack for verdict in judged.verdicts.values() if verdict.stack}
    places = {stack: _place(stack, runner, work) for stack in stacks}
    verdicts = {id: v._replace(place=places.get(v.stack)) for id, v in judged.verdicts.items()}
    return judged._replace(verdicts=verdicts)


def read_answer(out: bytes, part: Part) -> Judged:
    """Parses the judge's answer, which grader/judge/main.cpp describes. Checks that parts.json
    leaves out are dropped. Raises KitError if it isn't whole, or lacks a check."""
    try:
        answer = _printable(json.loads(out))
        verdicts = {check.pop("id"): Verdict(**check) for check in answer["checks"]}
        largest, patterns = answer["largest_error"], answer["patterns"]
        mistakes = tuple(mistake["name"] for mistake in answer["mistakes"])
        graded_with = "given" if answer["asked_given"] else "own"
    except (ValueError, TypeError, LookupError) as error:
        raise KitError(f"the judge's answer on part {part.number} can't be read") from error
    if missing := [check.id for check in part.checks if check.id not in verdicts]:
        some = f"lack some of parts.json ({first_few(missing)})"
        correct = "correct the id there, or leave the check out"
        raise KitError(f"the judge's checks of part {part.number} {some}: {correct}")
    kept = {check.id: verdicts[check.id] for check in part.checks}
    return Judged(kept, largest, graded_with, mistakes, tuple(patterns))


def _printable(x: Any) -> Any:
    """The same JSON, with printable texts: some of them are a submission's."""
    if isinstance(x, dict):
        return {key: _printable(value) for key, value in x.items()}
    if isinstance(x, list):
        return [_printable(value) for value in x]
    return printable_text(x) if isinstance(x, str) else x


def _place(stack: str, runner: Path, work: Work) -> Place | None:
    """The innermost line on the stack that is in the submission's own files; None if unknown, also
    for want of time, as the verdict is valid without it."""
    command = ["/usr/bin/addr2line", "-i", "-e", str(runner), *stack.split()]
    with suppress(Overrun):
        result = work.box.run(work.box.to_build(runner.parent, [runner]) + command, SYMBOLS)
        return place_in(result.out, work.taken.files.__contains__) if result.ok else None
    return None


def place_in(lines: bytes, is_submitted: Callable[[str], bool] = bool) -> Place | None:
    """The first line in a file of the submission, which can put any name there by #line."""
    for line in lines.splitlines():
        _, _, rest = line.decode("utf-8", "replace").partition(f"/{WORK_FOLDER}")
        inside = IN_SOURCES.match(rest)
        if inside and is_submitted(inside[1]):
            return Place(printable_name(inside[1]), int(inside[2]))
    return None


# --- with sanitizers ---


def sanitized(work: Work) -> Work:
    """The same submission, built with sanitizers. Nothing is built where that can't be done: the
    score is valid without what they find."""
    box, none = work.box, work._replace(kind="sanitized", parts={}, helpers=())
    if box.kind != "full":
        return none
    with suppress(KitError, Overrun):
        limited = box.budget.part(*_limits(work), "building with sanitizers")
        built = compile_all(none._replace(box=box._replace(budget=limited)))
        return built._replace(box=box)
    return none


def _limits(work: Work) -> tuple[float, float]:
    """The CPU seconds and seconds that are left for sanitizers."""
    cpu, wall = (left - MARGIN for left in work.box.budget.left())
    return min(cpu, SANITIZED_CPU_SECONDS), min(wall, SANITIZED_SECONDS)


def with_cause(
    part: Part, judged: Judged, checked: Callable[[], Work], hidden: Path | None
) -> Judged:
    """The same verdicts; those about crashes that no assertion explains also say what the
    sanitizers found, if anything."""
    crashed = {id: v for id, v in judged.verdicts.items() if v.status == "crashed"}
    unclear = {id: v for id, v in crashed.items() if (v.ended or {}).get("what") != "assertion"}
    again = _again(part, checked(), hidden) if unclear else {}
    found = {id: _found_in(again[id]) for id in unclear if id in again}
    named = {id: unclear[id]._replace(found=kind) for id, kind in found.items()}
    return judged._replace(verdicts=judged.verdicts | named)


def _found_in(verdict: Verdict) -> str:
    """The sanitizers' name for the fault that ended the program; empty if they found none that has
    a sentence: a program can print any other name."""
    ended = verdict.ended or {}
    known = (SENTENCES / "crashes.txt").read_text("utf-8").split("\n")
    is_known = ended.get("what") == "sanitizer" and f"  {ended['text']}" in known
    return str(ended["text"]) if is_known else ""


def remark(part: Part, checked: Work) -> tuple[Facts, Place | None] | None:
    """What the sanitizers find in a part with all points, in public cases, and where, or None. It
    is kept, and looked for again only if something changed that it depends on."""
    objects = [str(b.path) for b in (checked.parts.get(part.number), *checked.helpers) if b]
    cases = [(f.name, f.stat().st_mtime_ns) for f in sorted((FIXTURES / "public").iterdir())]
    known = (SENTENCES / "crashes.txt").read_text("utf-8")
    made_from = [toolchain_digest(), JUDGE.stat().st_mtime_ns, part, objects, cases, known]
    name = digest("remark", *made_from)
    if there := stored(name):
        found, at = json.loads(contents_of(there))
        return (found, Place(*at) if at else None) if found else None
    again = _again(part, checked, None)
    made = _remark(part, again)
    if again and not any(verdict.status == "timed_out" for verdict in again.values()):
        store(json.dumps(made or [None, None]).encode(), name)
    return made


def _remark(part: Part, again: dict[str, Verdict]) -> tuple[Facts, Place | None] | None:
    for verdict in again.values():
        if kind := _found_in(verdict):
            return fact("found", str(verdict.place or part.file), kind), verdict.place
    for check, verdict in zip(part.checks, again.values()):
        answered = verdict.status == "graded" and (verdict.failure or {}).get("quantities")
        if not verdict.passed and answered:
            return fact("fails_with_sanitizers", part.file, check.title), None
    return None


def _again(part: Part, checked: Work, hidden: Path | None) -> dict[str, Verdict]:
    """The verdicts with sanitizers and given parts, on the public cases alone where no folder of
    hidden ones is given. Empty where they can't be had."""
    limited = checked.box.budget.part(*_limits(checked))
    work = checked._replace(box=checked.box._replace(budget=limited))
    with suppress(KitError, Overrun):
        if part.number in work.parts and work.parts[part.number].path:
            built = link_alone(part, work)
            if built.path:
                return judge(part, "alone", work, built.path, hidden).verdicts
    return {}
