"""The built-in engine: gradings side by side, each in a process of its own at that time, so that a
crash harms no other."""

import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Generator
from concurrent.futures import as_completed, ProcessPoolExecutor, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool

from bounce_grader.classroom.grading.results import Task
from bounce_grader.classroom.grading.unit import Outcome, Unit

TO_CLEAN_UP = 3.0  # seconds in which a terminated grading can remove its files
KILLED = "the process that graded it was killed, perhaps because memory ran out"


def run(tasks: list[Task], jobs: int, unit: Unit) -> Generator[tuple[Task, Outcome], None, None]:
    """Yields outcomes as they come. If the caller stops early, ends the gradings under way."""
    context = multiprocessing.get_context("spawn")
    idle = [ProcessPoolExecutor(1, context, _prepare) for _ in range(jobs)]  # one for each thread

    def graded(task: Task) -> Outcome:
        process = idle.pop()
        try:
            return process.submit(unit, task).result()
        except BrokenProcessPool:
            process = ProcessPoolExecutor(1, context, _prepare)
            return Outcome(KILLED)
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
