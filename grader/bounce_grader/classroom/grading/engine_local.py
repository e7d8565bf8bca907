"""The built-in engine. Each grading is a process of its own, so that a crash harms no other."""

import multiprocessing
import os
import select
import signal
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Generator, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from multiprocessing import forkserver
from multiprocessing.connection import Connection
from multiprocessing.context import ForkServerContext
from multiprocessing.process import BaseProcess

from bounce_grader.classroom.grading.task import Task
from bounce_grader.classroom.grading.unit import run as run_unit, Outcome
from bounce_grader.common.errors import UsageError

TO_CLEAN_UP = 3.0  # seconds in which a terminated grading can remove its files
LONGEST_TEMPORARY = 75  # bytes: a socket's path has 107, of which multiprocessing takes 32
LONGEST = 1800.0  # seconds; a grading's own limits are far below


def run(
    tasks: list[Task], jobs: int, unit: Callable[[Task], Outcome] = run_unit
) -> Generator[tuple[Task, Outcome], None, None]:
    """Yields outcomes as they come. If the caller stops early, ends the gradings under way."""
    context = multiprocessing.get_context("forkserver")
    _start_server()
    running = _Running(context, unit)
    waiting = iter(tasks)
    with ThreadPoolExecutor(jobs) as pool, running.ended_at_last():
        futures: dict[Future[Outcome], Task] = {}
        for task in waiting:
            futures[pool.submit(running.one, task)] = task
            if len(futures) == jobs:
                break
        while futures:
            done, _ = wait(futures, return_when=FIRST_COMPLETED)
            for future in done:
                task = futures.pop(future)
                following = next(waiting, None)
                if following:
                    futures[pool.submit(running.one, following)] = following
                yield task, future.result()


def _start_server() -> None:
    """Starts the server process that gradings are forked from. It must ignore Ctrl-C, even while it
    starts."""
    if len(os.fsencode(tempfile.gettempdir())) > LONGEST_TEMPORARY:
        raise UsageError(
            f"the path of the temporary folder, {tempfile.gettempdir()}, is too long for the "
            "sockets that a class is graded with: set TMPDIR to a shorter one"
        )
    if threading.current_thread() is not threading.main_thread():
        forkserver.ensure_running()
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        forkserver.ensure_running()
    finally:
        signal.signal(signal.SIGINT, before)


class _Running:
    """Runs gradings in processes, and keeps track of those under way."""

    def __init__(self, context: ForkServerContext, unit: Callable[[Task], Outcome]) -> None:
        self._context = context
        self._unit = unit
        self._lock = threading.Lock()
        self._processes: set[BaseProcess] = set()
        self._stopped = False

    def one(self, task: Task) -> Outcome:
        here, there = self._context.Pipe(duplex=False)
        process = self._context.Process(target=_child, args=(self._unit, task, there))
        with self._lock:
            if self._stopped:
                return Outcome(task.key, "failed", "stopped", 0.0)
            process.start()
            self._processes.add(process)
        there.close()
        try:
            return self._outcome(task, process, here)
        finally:
            here.close()
            process.kill()
            process.join()
            with self._lock:
                self._processes.discard(process)

    def _outcome(self, task: Task, process: BaseProcess, here: Connection) -> Outcome:
        try:
            if here.poll(LONGEST):
                outcome: Outcome = here.recv()
                return outcome
            reason = f"it took more than {LONGEST / 60:.0f} minutes"
        except EOFError:
            process.join()
            reason = f"its process ended with status {process.exitcode}"
        return Outcome(task.key, "failed", reason, 0.0)

    @contextmanager
    def ended_at_last(self) -> Iterator[None]:
        try:
            yield
        finally:
            with self._lock:
                self._stopped = True
                for process in self._processes:
                    process.terminate()
                end = time.monotonic() + TO_CLEAN_UP
                for process in self._processes:
                    process.join(max(0.0, end - time.monotonic()))
                    process.kill()


def _child(unit: Callable[[Task], Outcome], task: Task, answer: Connection) -> None:
    """The process of one grading. It ignores Ctrl-C, which the class handles, and ends when the
    class has ended. When it is terminated, it removes its temporary files first."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    threading.Thread(target=_end_with_the_reader, args=(answer.fileno(),), daemon=True).start()
    answer.send(unit(task))


def _end_with_the_reader(answer: int) -> None:
    """Ends this process when the pipe's reader is gone, which poll reports as an error."""
    poll = select.poll()
    poll.register(answer, 0)
    poll.poll()
    os._exit(1)
