"""A quick stand-in for grading, for tests of the process around it: the points of a submission
follow from its bytes.

As a program it grades a class:
stand_in.py SUBMISSIONS OUT SECONDS_OF_EACH_GRADING [DASK_SCHEDULER]
"""

import multiprocessing
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "grader"))

from bounce_grader.classroom.run import run
from bounce_grader.classroom.work import unit
from bounce_grader.classroom.work.request import Request
from bounce_grader.classroom.work.task import Task
from bounce_grader.common.errors import KitError
from bounce_grader.common.manifest import parts
from bounce_grader.grading.record import whole
from bounce_grader.submission import submission

# Else every grading would import all of this. The server that gradings are forked from looks for
# modules in the environment's path alone.
multiprocessing.set_forkserver_preload(["stand_in"])
os.environ["PYTHONPATH"] = os.pathsep.join(filter(None, sys.path))

HIDDEN_ANSWER = {
    "message": "1 of 9 cases wrong; the first: x\n  expected phi = 0.8128",
    "shown": {"name": "x", "input": "", "sentence": "", "quantities": []},
}


def record_of(taken: submission.Submission) -> dict[str, Any]:
    """Each check is passed or not as a bit of the digest says."""
    bits = int(taken.sha256, 16)
    part_records = []
    for part in parts():
        checks: list[dict[str, Any]] = []
        for check in part.checks:
            passed = bool(bits & 3)
            bits >>= 2
            checks.append(
                {
                    "id": check.id,
                    "title": check.title,
                    "score": check.points if passed else 0,
                    "max_score": check.points,
                    "passed": passed,
                    "message": "" if passed else "1 of 9 cases wrong; the first: a corner sticks",
                    "mistake": None,
                    **({} if passed else {"revealed": HIDDEN_ANSWER}),
                }
            )
        part_records.append(
            {
                "part": part.number,
                "stem": part.stem,
                "title": part.title,
                "score": sum(check["score"] for check in checks),
                "max_score": part.points,
                "status": "graded" if part.number in taken.parts else "not_submitted",
                "message": "",
                "graded_with": "own",
                "mistakes": [],
                "patterns": [],
                "checks": checks,
            }
        )
    speed = {
        "submission_ns": 200.0 + bits % 300,
        "solution_ns": 200.0,
        "ratio": 1 + bits % 300 / 200,
        "largest_error": 1e-13 if bits % 3 else 0.1,
        **curves(200.0 + bits % 300, 1.0 if bits % 3 else 20.0),
    }
    seconds = {"compile": 0.0, "run": 0.0, "total": 0.0}
    return whole(taken, part_records, "full", seconds, "0" * 64, speed)


def curves(ns: float, wrong: float) -> dict[str, Any]:
    """One scene: a time for each step, and errors that fall with it."""
    dts = [1e-2, 3e-3, 1e-3]

    def curve(a_step: float, times: float) -> list[dict[str, float]]:
        return [{"dt": dt, "ns": a_step / dt, "error": times * dt} for dt in dts]

    scene = {"scene": "tumble", "title": "Tumble", "seconds": 0.4}
    scene |= {"submission": curve(ns, wrong), "solution": curve(200.0, 1.0)}
    return {"cut": "", "dt": dts, "scenes": [{**scene, "least": curve(10.0, 0.5)}]}


def grade(taken: submission.Submission, task: Task, seconds: float = 0.0) -> dict[str, Any]:
    """Grades a submission. Its text can ask for a fault of the worker, such as a crash."""
    time.sleep(seconds)
    text = b"".join(taken.files.values())
    if b"kills its grader" in text:
        os.kill(os.getpid(), 9)
    if b"breaks the kit" in text:
        raise KitError("no compiler")
    record = record_of(taken)
    return record if task.speed else {**record, "speed": None}


def request(submissions: Path, out: Path, seconds: float = 0.0, **more: Any) -> Request:
    worker = partial(unit.run, grade=partial(grade, seconds=seconds))
    return Request(submissions, out, jobs=2, unit=worker, **more)


@contextmanager
def started(
    source: Path, out: Path, seconds: float = 0.0, scheduler: str = ""
) -> Iterator["subprocess.Popen[str]"]:
    """Grades a class in a process of its own, which can be stopped and ends with the test."""
    environment = {**os.environ, "PYTHONPATH": f"{ROOT / 'grader'}:{Path(__file__).parent}"}
    # If the tests run in the background, Ctrl-C may be ignored, and children would inherit that.
    command = ["env", "--default-signal=INT", sys.executable, __file__]
    command += [str(source), str(out), str(seconds), *([scheduler] if scheduler else [])]
    pipe = subprocess.PIPE
    with subprocess.Popen(command, env=environment, stdout=pipe, stderr=pipe, text=True) as process:
        try:
            yield process
        finally:
            process.kill()
            process.communicate()  # its gradings have ended, too


if __name__ == "__main__":
    submissions, results, pause, *cluster = sys.argv[1:]
    more = {"engine": "dask", "scheduler": cluster[0]} if cluster else {}
    sys.exit(run(request(Path(submissions), Path(results), float(pause), **more)))
