"""Runs the judge on a runner, and reads its verdicts."""

import json
from dataclasses import dataclass
from pathlib import Path

from bounce_grader import processes
from bounce_grader.box import Box
from bounce_grader.errors import KitError
from bounce_grader.manifest import Part
from bounce_grader.paths import FIXTURES, JUDGE, REFERENCE_RUNNER, STOPWATCH

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
        check["id"]: Verdict(check["passed"], check["status"], check["message"])
        for check in answer["checks"]
    }
    return Judged(verdicts, answer["largest_error"], "given" if given else "own")


def speed(runner: Path, box: Box) -> dict[str, float] | None:
    """Nanoseconds per step, the submission's and the solution's; None where it can't be timed."""
    command = [str(STOPWATCH), *box.to_run(runner), "::", *box.to_run(REFERENCE_RUNNER)]
    result = processes.run(command, WAIT)
    if not result.ok:
        return None
    times = json.loads(result.out)
    submission, solution = times["ns_per_step"]
    return {"submission_ns": submission, "solution_ns": solution, "ratio": times["ratio"]}
