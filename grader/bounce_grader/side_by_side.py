"""The same for several things, a few at a time. What the library has for it takes longer to import
than a part to judge: it brings the modules for logging and for tracebacks."""

from collections.abc import Callable, Iterable
from threading import Thread
from typing import TypeVar

X = TypeVar("X")
Y = TypeVar("Y")


def each(function: Callable[[X], Y], items: Iterable[X], jobs: int) -> list[Y]:
    """function(item) for all items, in their order, in as many threads as there are jobs. After an
    error no other item is begun; it is raised when those that were have ended."""
    waiting = enumerate(list(items))  # whose next() no other thread can come between
    done: dict[int, Y] = {}
    errors: list[BaseException] = []

    def work() -> None:
        try:
            for number, item in waiting:
                done[number] = function(item)
        except BaseException as error:
            errors.append(error)
            _leave(waiting)

    if jobs == 1:  # here, so that a signal stops what runs
        work()
    else:
        _in_threads(work, jobs, waiting)
    if errors:
        raise errors[0]
    return [done[number] for number in sorted(done)]


def _in_threads(work: Callable[[], None], jobs: int, waiting: Iterable[object]) -> None:
    threads = [Thread(target=work) for _ in range(jobs)]
    for thread in threads:
        thread.start()
    try:
        for thread in threads:
            thread.join()
    finally:
        _leave(waiting)
        for thread in threads:
            thread.join()


def _leave(waiting: Iterable[object]) -> None:
    for _ in waiting:
        pass
