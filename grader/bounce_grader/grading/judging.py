"""Runs the judge on a runner, and reads its verdicts."""

import json
import re
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple, cast

from bounce_grader.common.errors import KitError
from bounce_grader.common.escaping import printable_name
from bounce_grader.common.manifest import Part
from bounce_grader.common.paths import FIXTURES, JUDGE, SOURCES, WORK_FOLDER
from bounce_grader.grading import failed_case
from bounce_grader.grading.failed_case import Shown
from bounce_grader.sandbox import processes
from bounce_grader.sandbox.box import LARGEST_FILE, Box
from bounce_grader.sandbox.budget import Overrun

SYMBOLS = processes.Limits(cpu_seconds=5, wall_seconds=30, memory=1 << 30, file_size=0)
WAIT = processes.Limits(60, 300, memory=4 << 30, file_size=LARGEST_FILE)
MOST_CPU_SECONDS, MOST_SECONDS = 30, 200  # for all runners of a part together
STATUSES = {"graded", "does_not_compile", "crashed", "timed_out", "out_of_memory", "no_answer"}


class Verdict(NamedTuple):
    """The judge's verdict on one check."""

    passed: bool
    status: str
    message: str
    shown: Shown | None = None  # the failed case in numbers
    revealed: Shown | None = None  # for a hidden case: "message" and "shown" with its answer


class Judged(NamedTuple):
    """The verdicts of one part, by check id. graded_with is "own" or "given" (earlier parts).
    `mistakes` names the known mistakes that it makes. If there is none, `patterns` says what its
    wrong numbers have in common, such as a factor or a sign."""

    verdicts: dict[str, Verdict]
    largest_error: float | None
    graded_with: str
    mistakes: tuple[str, ...] = ()
    patterns: tuple[str, ...] = ()

    def score(self, part: Part) -> float:
        return sum(check.points for check in part.checks if self.verdicts[check.id].passed)

    @property
    def status(self) -> str:
        """The way in which its runner first ended; "graded" if it answered every question."""
        ended = [v.status for v in self.verdicts.values() if v.status != "graded"]
        return ended[0] if ended else "graded"


def judge(
    part: Part,
    runner: Path,
    given: bool,
    hidden: Path | None,
    box: Box,
    sanitized: bool = False,
    recognise: bool = False,
    files: frozenset[str] = frozenset(),
) -> Judged:
    """Judges a part; without `hidden`, on the public cases alone. `given`: with given earlier
    parts; `sanitized`: the runner has sanitizers; `files`: the submission's files, in which a crash
    is located. Checks that the grading has no time left for fail. Raises KitError if the judge
    fails or doesn't name every check exactly once."""
    cpu, wall = box.budget.left()
    command = [
        *(str(JUDGE), "--part", str(part.number)),
        *(["--given"] if given else []),
        *(["--sanitized"] if sanitized else []),
        *(["--recognise"] if recognise else []),
        *(["--boxed"] if box.kind != "none" else []),
        *("--cpu-seconds", str(max(1, int(min(cpu, MOST_CPU_SECONDS))))),
        *("--seconds", str(max(1, int(min(wall, MOST_SECONDS))))),
        *("--fixtures", str(FIXTURES / "public")),
        *(["--fixtures", str(hidden)] if hidden else []),
        *("--", *(box.to_run_sanitized(runner) if sanitized else box.to_run(runner))),
    ]
    box.budget.require_time()
    # Not limited by the budget: the judge keeps to the seconds above, and reports what passed.
    result = processes.run(command, WAIT._replace(memory=None) if sanitized else WAIT)
    box.budget.require_responsive_machine()
    if not result.ok:
        raise KitError(f"the judge failed on part {part.number}: {result.err.strip() or 'killed'}")
    answer = read_answer(result.out, part)
    verdicts = {
        check["id"]: Verdict(
            check["passed"],
            check["status"],
            _with_place(check, runner, files, box),
            check["shown"],
            check["revealed"],
        )
        for check in answer["checks"]
    }
    return Judged(
        verdicts,
        answer["largest_error"],
        "given" if given else "own",
        tuple(answer["mistakes"]),
        tuple(answer["patterns"]),
    )


def read_answer(out: bytes, part: Part) -> dict[str, Any]:
    """Parses and validates the judge's answer, which grader/judge/main.cpp describes. Checks that
    parts.json leaves out are dropped. Raises KitError."""
    try:
        answer = json.loads(out, parse_constant=_no_number)
        sound = all(map(_is_sound, answer["checks"])) and _is_size(answer["largest_error"])
        for check in answer["checks"]:
            check["shown"] = failed_case.read(check["shown"])
            check["revealed"] = failed_case.read_revealed(check["revealed"])
        sound = sound and all(map(_are_texts, (answer["mistakes"], answer["patterns"])))
    except (ValueError, TypeError, KeyError, RecursionError) as error:
        raise KitError(f"the judge's answer on part {part.number} can't be read") from error
    if not sound:
        raise KitError(f"the judge's answer on part {part.number} has another shape than it should")
    wanted = {check.id for check in part.checks}
    answer["checks"] = [check for check in answer["checks"] if check["id"] in wanted]
    if sorted(check["id"] for check in answer["checks"]) != sorted(wanted):
        raise KitError(f"the judge's checks of part {part.number} lack some of parts.json")
    return {key: answer[key] for key in ("checks", "largest_error", "mistakes", "patterns")}


def _no_number(word: str) -> None:
    raise ValueError(f"{word} is no JSON")


def _is_sound(check: dict[str, Any]) -> bool:
    texts = all(isinstance(check[key], str) for key in ("id", "status", "stack", "message"))
    return texts and isinstance(check["passed"], bool) and check["status"] in STATUSES


def _are_texts(x: object) -> bool:
    return isinstance(x, list) and all(isinstance(text, str) for text in x)


def _is_size(x: object) -> bool:
    return x is None or type(x) in (int, float) and 0 <= cast(float, x) <= sys.float_info.max


def _with_place(check: dict[str, str], runner: Path, files: frozenset[str], box: Box) -> str:
    """The check's message; for a crash, with the submission's file and line if they are known."""
    try:
        place = _place(check["stack"], runner, files, box) if check["stack"] else None
    except Overrun:  # the verdict is valid without its line
        place = None
    return f"{check['message']}, at {place}" if place else check["message"]


@cache
def _place(stack: str, runner: Path, files: frozenset[str], box: Box) -> str | None:
    """The innermost line on the stack that is in the submission's own files."""
    command = ["/usr/bin/addr2line", "-i", "-e", str(runner), *stack.split()]
    result = box.run(box.to_build(runner.parent, [runner]) + command, SYMBOLS)
    return place_in(result.out, files.__contains__) if result.ok else None


def place_in(lines: bytes, is_submitted: Callable[[str], bool] = bool) -> str | None:
    """The first FILE:LINE in a file of the submission. The submission can put any name there by
    #line, so `is_submitted` checks it."""
    for line in lines.splitlines():
        _, _, rest = line.decode("utf-8", "replace").partition(f"/{WORK_FOLDER}")
        inside = re.match(
            rf"[^/]{{1,50}}/{SOURCES}(?:-[0-9a-f]{{16}})?/((.{{1,255}}?):\d{{1,9}})(?!\d)", rest
        )
        if inside and is_submitted(inside.group(2)):
            return printable_name(inside.group(1))
    return None
