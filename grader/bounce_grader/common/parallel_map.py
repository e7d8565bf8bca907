"""Applies a function to several items in parallel, in threads."""

import signal
from collections.abc import Callable, Iterable
from concurrent.futures import FIRST_EXCEPTION, ThreadPoolExecutor, wait
from signal import pthread_sigmask, SIG_BLOCK, SIG_SETMASK
from typing import TypeVar

X = TypeVar("X")
Y = TypeVar("Y")


def parallel_map(function: Callable[[X], Y], items: Iterable[X], jobs: int) -> list[Y]:
    """Returns function(item) for all items, in their order, computed in `jobs` threads. After an
    error it starts no other item, and raises the error once the running ones have ended."""
    given = list(items)
    if min(jobs, len(given)) < 2:  # in this thread, so that a signal interrupts the function
        return list(map(function, given))
    # The pool wouldn't wait for a thread that it was starting when a signal came, whose compiler would
    # go on while its folder is removed. The threads themselves, and what they start, get signals.
    before = pthread_sigmask(SIG_BLOCK, (signal.SIGINT, signal.SIGTERM))
    with ThreadPoolExecutor(jobs, "", pthread_sigmask, (SIG_SETMASK, before)) as pool:
        try:
            running = [pool.submit(function, item) for item in given]
            pthread_sigmask(SIG_SETMASK, before)
            wait(running, return_when=FIRST_EXCEPTION)
        finally:
            pthread_sigmask(SIG_SETMASK, before)
            pool.shutdown(cancel_futures=True)
    # Those that were cancelled come after all that began, whose error is raised here.
    return [future.result() for future in running]
