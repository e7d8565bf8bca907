"""Grades the submissions without a result, on any engine, and summarizes all results."""

import errno
import os
import sys
import time
from collections.abc import Generator, Mapping, Sequence
from contextlib import closing

from bounce_grader.classroom.grading import results
from bounce_grader.classroom.grading.log import Log
from bounce_grader.classroom.grading.request import Request
from bounce_grader.classroom.grading.results import Task
from bounce_grader.classroom.grading.summary import of_result, Summary
from bounce_grader.classroom.grading.unit import Outcome

TRIES = 3  # of a grading if the kit fails
Graded = Generator[tuple[Task, Outcome], None, None]


def grade_missing(tasks: Sequence[Task], request: Request, log: Log) -> dict[str, Outcome]:
    """Grades the submissions without a valid result. Returns the kit's failures, by key."""
    missing: dict[str, Task] = {}
    for task in tasks:
        result = results.load(task.folder, task.key, task.speed)
        if result:
            log.graded(task, result["state"], None)
        else:
            missing[task.key] = task
    failed: dict[str, Outcome] = {}
    progress = _Progress(len(missing))
    try:
        for attempt in range(TRIES):
            todo = [task for key, task in missing.items() if not attempt or key in failed]
            failed = {}
            with closing(_outcomes(todo, request)) as outcomes:
                for task, outcome in outcomes:
                    _write_down(log, task, outcome)
                    if outcome.state == "failed":
                        failed[task.key] = outcome
                    if outcome.state != "failed" or attempt == TRIES - 1:
                        progress.advance()
            if not failed:
                break
    except KeyboardInterrupt:
        keys = {task.key for task in tasks}
        left = sum(results.load(t.folder, t.key, t.speed) is None for t in missing.values())
        print(
            f"kit: stopped; {len(keys) - left} of {len(keys)} submissions are graded and kept. Run "
            "the same command again to go on.",
            file=sys.stderr,
        )
        sys.exit(130)
    return failed


def _outcomes(tasks: list[Task], request: Request) -> Graded:
    if request.engine == "dask":
        from bounce_grader.classroom.grading import engine_dask

        return engine_dask.run(tasks, request.scheduler, request.unit)
    from bounce_grader.classroom.grading import engine_local

    return engine_local.run(tasks, request.jobs or os.cpu_count() or 1, request.unit)


def _write_down(log: Log, task: Task, outcome: Outcome) -> None:
    """Logs an outcome. Raises OSError if the disk is full."""
    if outcome.state != "failed":
        log.graded(task, outcome.state, outcome.seconds)
        return
    log.write("failed", task, message=outcome.message)
    if outcome.disk_full:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


class _Progress:
    """Shows how many are graded, the rate and the time left: on a terminal, in one line that is
    written over."""

    def __init__(self, total: int) -> None:
        self._total, self._done = total, 0
        self._start = self._last = time.monotonic()

    def advance(self) -> None:
        self._done += 1
        now, left = time.monotonic(), self._total - self._done
        in_place = sys.stderr.isatty()
        if left and now - self._last < (0.5 if in_place else 15.0):
            return
        self._last = now
        rate = self._done / max(now - self._start, 1e-9)
        ahead = f", {left / rate:.0f} s left" if left else ""
        words = f"kit: {self._done} of {self._total} graded, {60 * rate:.0f} a minute{ahead}"
        start, end = ("\r\33[K", "" if left else "\n") if in_place else ("", "\n")
        print(f"{start}{words}", end=end, file=sys.stderr, flush=True)


def summarize(tasks: Sequence[Task], failed: Mapping[str, Outcome]) -> list[Summary]:
    summaries = []
    for task in tasks:
        result = results.load(task.folder, task.key)
        if result:
            summaries.append(of_result(task.student, task.key, result))
        else:
            message = f"the kit failed: {failed[task.key].message}"
            summaries.append(Summary(task.student, task.key, "failed", message))
    return summaries
