"""Grades the submissions without a result, on any engine, and summarizes all results."""

import errno
import os
import sys
from collections.abc import Callable, Generator, Mapping
from contextlib import closing
from pathlib import Path

from bounce_grader.classroom.grading import results
from bounce_grader.classroom.grading.log import Log
from bounce_grader.classroom.grading.progress import Progress
from bounce_grader.classroom.grading.request import Request
from bounce_grader.classroom.grading.summary import of_result, Summary
from bounce_grader.classroom.grading.task import Task
from bounce_grader.classroom.grading.unit import Outcome
from bounce_grader.classroom.intake.student import Student

TRIES = 3  # of a grading if the kit fails
Engine = Callable[[list[Task]], Generator[tuple[Task, Outcome], None, None]]


def grade_missing(
    tasks: Mapping[str, Task], folder: Path, request: Request, log: Log
) -> dict[str, Outcome]:
    """Grades the submissions without a valid result. Returns the kit's failures, by key."""
    there = results.keys(folder)
    missing: dict[str, Task] = {}
    for task in tasks.values():
        result = results.load(folder, task.key) if task.key in there else None
        if result:
            log.graded(task, result["state"], None)
        else:
            missing[task.key] = task
    failed: dict[str, Outcome] = {}
    bar = Progress(len(missing))
    try:
        for attempt in range(TRIES):
            todo = [task for key, task in missing.items() if not attempt or key in failed]
            failed = {}
            with closing(_engine(request)(todo)) as outcomes:
                for task, outcome in outcomes:
                    if outcome.state == "failed":
                        failed[task.key] = outcome
                    _write_down(log, task, outcome)
                    if outcome.state != "failed" or attempt == TRIES - 1:
                        bar.advance()
            if not failed:
                break
    except KeyboardInterrupt:
        done = len(missing) - sum(results.load(folder, key) is None for key in missing)
        whole = len({task.key for task in tasks.values()})
        print(
            f"kit: stopped; {whole - len(missing) + done} of {whole} submissions are graded and "
            "kept. Run the same command again to go on.",
            file=sys.stderr,
        )
        sys.exit(130)
    return failed


def _write_down(log: Log, task: Task, outcome: Outcome) -> None:
    """Logs an outcome. Raises OSError if the disk is full."""
    if outcome.state != "failed":
        log.graded(task, outcome.state, outcome.seconds)
        return
    log.write("failed", task, message=outcome.message)
    if outcome.disk_full:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def summarize(
    students: list[Student], tasks: Mapping[str, Task], folder: Path, failed: Mapping[str, Outcome]
) -> list[Summary]:
    summaries = []
    for student in students:
        key = tasks[student.id].key
        result = results.load(folder, key)
        if result:
            summaries.append(of_result(student, key, result))
        else:
            message = f"the kit failed: {failed[key].message}"
            summaries.append(Summary(student, key, "failed", message))
    return summaries


def _engine(request: Request) -> Engine:
    jobs = request.jobs or os.cpu_count() or 1
    if request.engine == "dask":
        from bounce_grader.classroom.grading import engine_dask

        return lambda tasks: engine_dask.run(tasks, request.scheduler, request.unit)
    from bounce_grader.classroom.grading import engine_local

    return lambda tasks: engine_local.run(tasks, jobs, request.unit)
