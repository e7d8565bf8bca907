"""A quick stand-in for grading, for tests of the process around it: the text of a part says what
becomes of it.

As a program it grades a class:
stand_in.py SECONDS_OF_EACH_GRADING SUBMISSIONS OUT [OPTION ...]
"""

import os
import re
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any
from unittest import mock

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "grader"))

from bounce_grader import cli
from bounce_grader.classroom import run
from bounce_grader.classroom.grading.results import grade_one, Task
from bounce_grader.common.errors import KitError
from bounce_grader.common.manifest import Part, parts
from bounce_grader.grading.judging import fact
from bounce_grader.grading.record import failed_part, whole
from bounce_grader.sandbox.budget import Budget
from bounce_grader.submission.submission import Submission

# A failed hidden case, and what is right there.
FAILURE: dict[str, Any] = {
    "cases": 9,
    "wrong": 1,
    "ended_at": 0,
    "again": False,
    "always_zero": False,
}
FAILURE |= {"name": "a corner sticks", "hidden": True, "input": [], "parameters": []}
PHI = {"name": "phi", "unit": "m", "got": [[0.5]], "right": [[False]]}
FAILURE |= {"sentence": "", "quantities": [PHI]}
ANSWER = {"contact": "", "expected": [[[0.8128]]]}


def _said(text: str, word: str, otherwise: str = "") -> str:
    """What a text says after a word: "fails: 2" fails the first two checks of a part."""
    found = re.search(rf"\b{word}: ([^;\n]*)", text)
    return found[1] if found else otherwise


def _part(part: Part, text: str | None, later: bool, points: Mapping[str, float]) -> dict[str, Any]:
    if text is None:
        return failed_part(part, "not_submitted", fact("not_submitted", part.file, ""))
    said = partial(_said, text)
    failing = int((said("later") if later else "") or said("fails", "0"))
    record: dict[str, Any] = failed_part(part, said("status", "graded"), fact("refused", ""))
    record["why"] = None
    for number, check in enumerate(record["checks"]):
        check["max_score"] = points.get(check["id"], check["max_score"])
        passed = {"passed": True, "score": check["max_score"]}
        check.update({"failure": FAILURE, "answer": ANSWER} if number < failing else passed)
    record["score"] = sum(check["score"] for check in record["checks"])
    record["mistakes"] = [name] if (name := said("mistake")) else []
    record["remarks"] = [fact("refused", remark)] if (remark := said("remark")) else []
    return record


def record_of(
    taken: Submission, later: bool = False, points: Mapping[str, float] = {}
) -> dict[str, Any]:
    """The record of a submission, whose text may say "later: 1" for another version of the kit.
    `points` are those of checks in a version that weighs them differently."""
    texts = {n: taken.files[name].decode(errors="replace") for n, name in taken.parts.items()}
    made = [_part(part, texts.get(part.number), later, points) for part in parts()]
    seconds = {"compile": 0.0, "run": 0.0, "total": 0.0}
    text = " ".join(texts.values())
    timed = _times(float(_said(text, "ns", "200")), float(_said(text, "error", "1e-13")))
    facts = {"box": _said(text, "box", "full"), "seconds": seconds, "fixtures_sha256": "0" * 64}
    if "breaks its page" in text:
        facts["examples"] = {"caught": []}
    return whole(taken, made, **facts, speed=timed)


def _times(ns: float, error: float) -> dict[str, Any]:
    """One scene: a time for each step, and errors that fall with it."""
    dts = [1e-2, 3e-3, 1e-3]

    def curve(a_step: float, times: float) -> list[dict[str, float]]:
        return [{"dt": dt, "ns": a_step / dt, "error": times * dt} for dt in dts]

    scene = {"scene": "tumble", "title": "Tumble", "seconds": 0.4}
    scene |= {"submission": curve(ns, 1.0), "solution": curve(200.0, 1.0)}
    scene |= {"least": curve(10.0, 0.5)}
    times = {"submission_ns": ns, "solution_ns": 200.0, "ratio": ns / 200, "largest_error": error}
    return {**times, "cut": None, "dt": dts, "scenes": [scene]}


def grade(
    taken: Submission,
    task: Task,
    _within: Budget,
    seconds: float = 0.0,
    later: bool = False,
    points: Mapping[str, float] = {},
) -> dict[str, Any]:
    """Grades a submission. Its text can ask for a fault of the worker, such as a crash."""
    time.sleep(seconds)
    text = b"".join(taken.files.values())
    if b"kills its grader" in text:
        os.kill(os.getpid(), 9)
    if b"breaks the kit" in text:
        raise KitError("no compiler: No space left on device")  # of its own words
    if b"divides by zero" in text:
        raise ZeroDivisionError("nobody thought of it")
    record = record_of(taken, later, points)
    return record if task.speed else {**record, "speed": None}


def grade_class(source: Path, out: Path, *more: str, seconds: float = 0.0) -> int:
    """Gives the command ./kit class in this process, where each grading takes so long."""
    with mock.patch.object(run, "UNIT", partial(grade_one, grade=partial(grade, seconds=seconds))):
        return cli.main(["class", str(source), "--out", str(out), "--jobs", "2", *more])


@contextmanager
def started(
    source: Path, out: Path, seconds: float = 0.0, *more: str
) -> Iterator["subprocess.Popen[str]"]:
    """Grades a class in a process of its own, which can be stopped and ends with the test."""
    environment = {**os.environ, "PYTHONPATH": f"{ROOT / 'grader'}:{Path(__file__).parent}"}
    # If the tests run in the background, Ctrl-C may be ignored, and children would inherit that.
    command = ["env", "--default-signal=INT", sys.executable, __file__]
    command += [str(seconds), str(source), str(out), *more]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, env=environment, stdout=pipe, stderr=pipe, text=True) as process:
        try:
            yield process
        finally:
            process.kill()
            process.communicate()  # its gradings have ended, too


if __name__ == "__main__":
    pause, submissions, results, *options = sys.argv[1:]
    sys.exit(grade_class(Path(submissions), Path(results), *options, seconds=float(pause)))
