"""Applies a function to several items in parallel, in threads.

ThreadPoolExecutor won't do: if a signal arrives while it starts a thread, it never waits for that
thread, whose compiler is then still running while its folder is removed.
"""

from collections.abc import Callable, Iterable
from threading import Event, Thread
from typing import TypeVar

X = TypeVar("X")
Y = TypeVar("Y")

# A signal that arrives just before a wait begins doesn't end it; so we look again after this time.
UNTIL_NEXT_LOOK = 0.5  # s


def parallel_map(function: Callable[[X], Y], items: Iterable[X], jobs: int) -> list[Y]:
    """Returns function(item) for all items, in their order, computed in `jobs` threads. After an
    error it starts no other item, and raises the error once the running ones have ended."""
    given = list(items)
    waiting = enumerate(given)  # its next() is atomic among threads
    done: dict[int, Y] = {}
    errors: list[BaseException] = []

    def work() -> None:
        try:
            for number, item in waiting:
                done[number] = function(item)
        except BaseException as error:
            errors.append(error)
            _discard(waiting)

    if min(jobs, len(given)) > 1:
        _in_threads(work, min(jobs, len(given)), waiting)
    else:  # in this thread, so that a signal interrupts the function
        work()
    if errors:
        raise errors[0]
    return [done[number] for number in sorted(done)]


class _Worker(Thread):
    """Sets an event when it has ended. join() isn't reliable: if a signal interrupts it, a running
    thread can count as ended."""

    def __init__(self, work: Callable[[], None]) -> None:
        super().__init__(target=work)
        self.ended = Event()

    def run(self) -> None:
        try:
            super().run()
        finally:
            self.ended.set()


def _in_threads(work: Callable[[], None], number: int, waiting: Iterable[object]) -> None:
    """Waits for every started thread, even if an exception is raised here, by a signal or because
    no thread can be started."""
    workers = [_Worker(work) for _ in range(number)]
    try:
        for worker in workers:
            worker.start()
        _wait_for(workers)
    finally:
        _discard(waiting)
        _wait_for(workers)


def _wait_for(workers: Iterable[_Worker]) -> None:
    for worker in workers:
        if worker.ident is not None:  # it was started
            while not worker.ended.wait(UNTIL_NEXT_LOOK):
                pass


def _discard(waiting: Iterable[object]) -> None:
    for _ in waiting:
        pass
