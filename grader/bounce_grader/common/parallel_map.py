"""The same function for several items, a few at a time.

ThreadPoolExecutor doesn't do here: a signal that comes while it starts a thread leaves that thread
out of those that it waits for, and so a compiler at work in a folder that is being removed.
"""

from collections.abc import Callable, Iterable
from threading import Event, Thread
from typing import TypeVar

X = TypeVar("X")
Y = TypeVar("Y")


def parallel_map(function: Callable[[X], Y], items: Iterable[X], jobs: int) -> list[Y]:
    """function(item) for all items, in their order, in as many threads as there are jobs. After an
    error no other item is begun; it is raised when those that were have ended."""
    given = list(items)
    waiting = enumerate(given)  # whose next() no other thread can come between
    done: dict[int, Y] = {}
    errors: list[BaseException] = []

    def work() -> None:
        try:
            for number, item in waiting:
                done[number] = function(item)
        except BaseException as error:
            errors.append(error)
            _leave(waiting)

    if min(jobs, len(given)) > 1:
        _in_threads(work, min(jobs, len(given)), waiting)
    else:  # here, so that a signal stops what runs
        work()
    if errors:
        raise errors[0]
    return [done[number] for number in sorted(done)]


class _Worker(Thread):
    """Says when it has ended. After a signal in the midst of join(), a thread that still runs would
    be taken for one that has."""

    def __init__(self, work: Callable[[], None]) -> None:
        super().__init__(target=work)
        self.ended = Event()

    def run(self) -> None:
        try:
            super().run()
        finally:
            self.ended.set()


def _in_threads(work: Callable[[], None], number: int, waiting: Iterable[object]) -> None:
    """Whatever is raised here, by a signal or for want of threads, what has begun ends first."""
    workers = [_Worker(work) for _ in range(number)]
    try:
        for worker in workers:
            worker.start()
        _wait_for(workers)
    finally:
        _leave(waiting)
        _wait_for(workers)


def _wait_for(workers: Iterable[_Worker]) -> None:
    for worker in workers:
        if worker.ident is not None:  # it was started
            worker.ended.wait()


def _leave(waiting: Iterable[object]) -> None:
    for _ in waiting:
        pass
