"""Applies a function to several items in parallel, in threads.

ThreadPoolExecutor won't do: if a signal arrives while it starts a thread, it never waits for that
thread, whose compiler is then still running while its folder is removed.
"""

from collections import deque
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
    if min(jobs, len(given)) < 2:  # in this thread, so that a signal interrupts the function
        return list(map(function, given))
    waiting = enumerate(given)  # its next() is atomic among threads
    done: dict[int, Y] = {}
    errors: list[BaseException] = []

    def work(end: Event) -> None:
        try:
            for number, item in waiting:
                done[number] = function(item)
        except BaseException as error:
            errors.append(error)
            deque(waiting, 0)  # nobody starts another
        finally:
            end.set()

    ends = [Event() for _ in range(min(jobs, len(given)))]
    workers = [Thread(target=work, args=[end]) for end in ends]
    try:
        for worker in workers:
            worker.start()
        _wait_for(workers, ends)
    finally:  # also after a signal, or if no thread can be started
        deque(waiting, 0)
        _wait_for(workers, ends)
    if errors:
        raise errors[0]
    return [done[number] for number in sorted(done)]


def _wait_for(workers: list[Thread], ends: list[Event]) -> None:
    """Waits for every thread that was started. join() isn't reliable: if a signal interrupts it, a
    running thread can count as ended."""
    for worker, end in zip(workers, ends):
        while worker.ident is not None and not end.wait(UNTIL_NEXT_LOOK):
            pass
