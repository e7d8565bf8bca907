"""Runs the judge on a runner, and reads its verdicts."""

import json
import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from bounce_grader import processes
from bounce_grader.box import Box
from bounce_grader.errors import KitError
from bounce_grader.manifest import Part
from bounce_grader.paths import FIXTURES, JUDGE, REFERENCE_RUNNER, SOURCES, STOPWATCH, WORK_FOLDER

SYMBOLS = processes.Limits(cpu_seconds=5, wall_seconds=30, memory=1 << 30, file_size=0)
WAIT = processes.Limits(cpu_seconds=60, wall_seconds=300, memory=4 << 30, file_size=0)


@dataclass(frozen=True)
class Verdict:
    passed: bool
    status: str
    message: str


@dataclass(frozen=True)
class Judged:
    """The verdicts of one part, by check id; graded_with is "own" or "given"."""

    verdicts: dict[str, Verdict]
    largest_error: float | None
    graded_with: str

    def score(self, part: Part) -> float:
        return sum(check.points for check in part.checks if self.verdicts[check.id].passed)

    @property
    def status(self) -> str:
        """How the part went: "graded", or how its runner first ended."""
        ended = [v.status for v in self.verdicts.values() if v.status != "graded"]
        return ended[0] if ended else "graded"


def judge(part: Part, runner: Path, given: bool, hidden: Path, box: Box) -> Judged:
    """Raises KitError where the judge fails, or doesn't name every check exactly once."""
    command = [
        *(str(JUDGE), "--part", str(part.number)),
        *(["--given"] if given else []),
        *("--fixtures", str(FIXTURES / "public"), "--fixtures", str(hidden)),
        *("--", *box.to_run(runner)),
    ]
    result = processes.run(command, WAIT)
    if not result.ok:
        raise KitError(f"the judge failed on part {part.number}: {result.err.strip() or 'killed'}")
    answer = json.loads(result.out)
    ids = [check["id"] for check in answer["checks"]]
    if sorted(ids) != sorted(check.id for check in part.checks):
        raise KitError(f"the judge's checks of part {part.number} aren't those of parts.json")
    verdicts = {
        check["id"]: Verdict(check["passed"], check["status"], _with_place(check, runner, box))
        for check in answer["checks"]
    }
    return Judged(verdicts, answer["largest_error"], "given" if given else "own")


def _with_place(check: dict[str, str], runner: Path, box: Box) -> str:
    """The check's message; a crash's with the submission's file and line, where that is known."""
    place = _place(check["stack"], runner, box) if check["stack"] else None
    return f"{check['message']}, at {place}" if place else check["message"]


@cache
def _place(stack: str, runner: Path, box: Box) -> str | None:
    """The innermost line of the submission on the stack."""
    command = ["/usr/bin/addr2line", "-i", "-e", str(runner), *stack.split()]
    lines = processes.run(box.to_build(runner.parent, [runner]) + command, SYMBOLS).out
    inside = re.search(rf"/{WORK_FOLDER}[^/]*/{SOURCES}/(.+:\d+)", lines.decode("utf-8", "replace"))
    return inside.group(1) if inside else None


def speed(runner: Path, box: Box) -> dict[str, float] | None:
    """Nanoseconds per step, the submission's and the solution's; None where it can't be timed."""
    command = [str(STOPWATCH), *box.to_run(runner), "::", *box.to_run(REFERENCE_RUNNER)]
    result = processes.run(command, WAIT)
    if not result.ok:
        return None
    times = json.loads(result.out)
    submission, solution = times["ns_per_step"]
    return {"submission_ns": submission, "solution_ns": solution, "ratio": times["ratio"]}
