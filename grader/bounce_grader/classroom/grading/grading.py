"""Grades the submissions without a result, on any engine, and summarizes all results."""

import multiprocessing
import os
import signal
import sys
import threading
import time
from collections.abc import Generator, Mapping, Sequence
from concurrent.futures import as_completed, ProcessPoolExecutor, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import closing

from bounce_grader.classroom.grading import results
from bounce_grader.classroom.grading.results import Task
from bounce_grader.classroom.grading.summary import of_result, Summary
from bounce_grader.classroom.grading.unit import Unit
from bounce_grader.classroom.intake.student import Student

TO_CLEAN_UP = 3.0  # seconds in which a terminated grading can remove its files
KILLED = "the process that graded it was killed, perhaps because memory ran out"
Graded = Generator[tuple[Task, str], None, None]


def grade_missing(
    tasks: Sequence[Task], unit: Unit, jobs: int = 0, scheduler: str = ""
) -> dict[str, str]:
    """Grades the submissions without a valid result. Returns why the kit failed, by key."""
    missing = {t.key: t for t in tasks if not results.load(t.folder, t.key, t.speed)}
    with closing(_outcomes(list(missing.values()), unit, jobs, scheduler)) as outcomes:
        told = _with_progress(outcomes, len(missing))
        return {task.key: failure for task, failure in told if failure}


def _outcomes(tasks: list[Task], unit: Unit, jobs: int, scheduler: str) -> Graded:
    if scheduler:
        from bounce_grader.classroom.grading import engine_dask

        return engine_dask.run(tasks, scheduler, unit)
    return in_processes(tasks, jobs or os.cpu_count() or 1, unit)


def in_processes(tasks: list[Task], jobs: int, unit: Unit) -> Graded:
    """The built-in engine: gradings side by side, each in a process of its own at that time, so that a
    crash harms no other. Yields what the unit returns, as it comes. If the caller stops early, ends
    the gradings under way."""
    context = multiprocessing.get_context("spawn")
    idle = [ProcessPoolExecutor(1, context, _prepare) for _ in range(jobs)]  # one for each thread

    def graded(task: Task) -> str:
        process = idle.pop()
        try:
            return process.submit(unit, task).result()
        except BrokenProcessPool:
            process = ProcessPoolExecutor(1, context, _prepare)
            return KILLED
        finally:
            idle.append(process)

    threads = ThreadPoolExecutor(jobs)
    futures = {threads.submit(graded, task): task for task in tasks}
    try:
        for future in as_completed(futures):
            yield futures[future], future.result()
    finally:
        threads.shutdown(wait=False, cancel_futures=True)
        under_way = not all(future.done() for future in futures)
        workers = multiprocessing.active_children() if under_way else []
        for worker in workers:
            worker.terminate()
        for worker in workers:
            worker.join(TO_CLEAN_UP)
            worker.kill()
        threads.shutdown()
        for process in idle:
            process.shutdown(wait=False)


def _prepare() -> None:
    """Makes a process ignore Ctrl-C, which the class handles, and end when the class has ended. When
    it is terminated, it removes its temporary files first."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    threading.Thread(target=_end_with_the_class, daemon=True).start()


def _end_with_the_class() -> None:
    parent = multiprocessing.parent_process()
    assert parent
    parent.join()
    os._exit(1)


def _with_progress(outcomes: Graded, number: int) -> Graded:
    """Says every few seconds how many are done, the rate and the time left."""
    start = last = time.monotonic()
    for done, outcome in enumerate(outcomes, 1):
        now, left = time.monotonic(), number - done
        if not left or now - last > (5.0 if sys.stderr.isatty() else 15.0):
            last, rate = now, done / max(now - start, 1e-9)
            ahead = f", {left / rate:.0f} s left" if left else ""
            words = f"kit: {done} of {number} done, {60 * rate:.0f} a minute{ahead}"
            print(words, file=sys.stderr, flush=True)
        yield outcome


def summarize(
    students: Sequence[Student], tasks: Sequence[Task], failed: Mapping[str, str]
) -> list[Summary]:
    of = {task.student.id: task for task in tasks}
    return [_summary(student, of.get(student.id), failed) for student in students]


def _summary(student: Student, task: Task | None, failed: Mapping[str, str]) -> Summary:
    if task is None:
        return Summary(student, "unreadable", student.refused)
    result = results.load(task.folder, task.key)
    if result:
        return of_result(student, result)
    why = f"the kit failed, so give the same command again: {failed[task.key]}"
    return Summary(student, "failed", why, task.key)
