"""The built-in engine: a pool of processes, so that a crash harms no other grading."""

import multiprocessing
import os
import signal
import sys
import threading
from collections import deque
from collections.abc import Generator
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool

from bounce_grader.classroom.grading.results import Task
from bounce_grader.classroom.grading.unit import Outcome, Unit

TO_CLEAN_UP = 3.0  # seconds in which a terminated grading can remove its files
KILLED = "the process that graded it was killed, perhaps because memory ran out"
Graded = tuple[Task, Outcome]


def run(tasks: list[Task], jobs: int, unit: Unit) -> Generator[Graded, None, None]:
    """Yields outcomes as they come. If the caller stops early, ends the gradings under way."""
    waiting = deque(tasks)
    while waiting:
        for suspect in (yield from _graded(waiting, jobs, unit)):
            if (yield from _graded(deque([suspect]), 1, unit)):
                yield suspect, Outcome("failed", KILLED)


def _graded(waiting: deque[Task], jobs: int, unit: Unit) -> Generator[Graded, None, list[Task]]:
    """Grades what is waiting. If a process is killed, returns those that were under way: any may
    have been the reason, and the others can still be graded."""
    pool = ProcessPoolExecutor(jobs, multiprocessing.get_context("spawn"), _prepare)
    running: dict[Future[Outcome], Task] = {}
    try:
        while waiting or running:
            while waiting and len(running) < jobs:
                running[pool.submit(unit, waiting[0])] = waiting[0]
                waiting.popleft()
            done, _ = wait(running, return_when=FIRST_COMPLETED)
            for future in done:
                outcome = future.result()
                yield running.pop(future), outcome
    except BrokenProcessPool:
        return list(running.values())
    finally:
        workers = multiprocessing.active_children() if running else []
        for worker in workers:
            worker.terminate()
        pool.shutdown(wait=False, cancel_futures=True)
        for worker in workers:
            worker.join(TO_CLEAN_UP)
            worker.kill()
    return []


def _prepare() -> None:
    """Makes a process of the pool ignore Ctrl-C, which the class handles, and end when the class has
    ended. When it is terminated, it removes its temporary files first."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    threading.Thread(target=_end_with_the_class, daemon=True).start()


def _end_with_the_class() -> None:
    parent = multiprocessing.parent_process()
    assert parent
    parent.join()
    os._exit(1)
