"""Grades the submissions without a result, on any engine, and summarizes all results."""

import errno
import os
import sys
import time
from collections.abc import Generator, Mapping, Sequence
from contextlib import closing

from bounce_grader.classroom.grading import results
from bounce_grader.classroom.grading.results import Task
from bounce_grader.classroom.grading.summary import of_result, Summary
from bounce_grader.classroom.grading.unit import Outcome, Unit

TRIES = 3  # of a grading if the kit fails
Graded = Generator[tuple[Task, Outcome], None, None]


def grade_missing(
    tasks: Sequence[Task], unit: Unit, jobs: int = 0, scheduler: str = ""
) -> dict[str, str]:
    """Grades the submissions without a valid result. Returns why the kit failed, by key."""
    missing = {t.key: t for t in tasks if not results.load(t.folder, t.key, t.speed)}
    failed: dict[str, str] = {}
    progress = _Progress(len(missing))
    try:
        for attempt in range(TRIES):
            todo = [task for key, task in missing.items() if not attempt or key in failed]
            failed = {}
            with closing(_outcomes(todo, unit, jobs, scheduler)) as outcomes:
                for task, outcome in outcomes:
                    if outcome.disk_full:
                        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
                    if outcome.failure:
                        failed[task.key] = outcome.failure
                    if not outcome.failure or attempt == TRIES - 1:
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


def _outcomes(tasks: list[Task], unit: Unit, jobs: int, scheduler: str) -> Graded:
    if scheduler:
        from bounce_grader.classroom.grading import engine_dask

        return engine_dask.run(tasks, scheduler, unit)
    from bounce_grader.classroom.grading import engine_local

    return engine_local.run(tasks, jobs or os.cpu_count() or 1, unit)


class _Progress:
    """Says every few seconds how many are graded, the rate and the time left."""

    def __init__(self, total: int) -> None:
        self._total, self._done = total, 0
        self._start = self._last = time.monotonic()

    def advance(self) -> None:
        self._done += 1
        now, left = time.monotonic(), self._total - self._done
        if left and now - self._last < (5.0 if sys.stderr.isatty() else 15.0):
            return
        self._last = now
        rate = self._done / max(now - self._start, 1e-9)
        ahead = f", {left / rate:.0f} s left" if left else ""
        words = f"kit: {self._done} of {self._total} graded, {60 * rate:.0f} a minute{ahead}"
        print(words, file=sys.stderr, flush=True)


def summarize(tasks: Sequence[Task], failed: Mapping[str, str]) -> list[Summary]:
    summaries = []
    for task in tasks:
        result = results.load(task.folder, task.key)
        if result:
            summaries.append(of_result(task.student, task.key, result))
        else:
            message = f"the kit failed: {failed[task.key]}"
            summaries.append(Summary(task.student, task.key, "failed", message))
    return summaries
