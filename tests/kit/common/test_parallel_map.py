"""parallel_map: errors and interruptions."""

import signal
import threading
import time

import pytest
from bounce_grader.common.parallel_map import parallel_map


@pytest.mark.parametrize("jobs", [1, 3])
def test_the_first_error_is_raised_and_no_other_item_is_begun(jobs: int) -> None:
    begun: list[int] = []
    all_here = threading.Barrier(jobs, timeout=60)  # is broken where one of them never comes

    def one(x: int) -> None:
        begun.append(x)
        all_here.wait()
        raise ValueError("the first")

    with pytest.raises(ValueError, match="the first"):
        parallel_map(one, range(100), jobs)
    assert len(begun) == jobs


def test_an_interruption_waits_for_what_has_begun_and_begins_nothing_more() -> None:
    """As with Ctrl-C, after which the folder that they work in is removed."""
    begun: list[int] = []
    ended: list[int] = []
    both = threading.Barrier(2, timeout=60)
    interrupted = threading.Event()

    def one(x: int) -> None:
        begun.append(x)
        if both.wait() == 0:
            signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGUSR1)
        assert interrupted.wait(60)
        time.sleep(0.05)  # time for the next item to begin, which it must not
        ended.append(x)

    def interrupt(*_: object) -> None:
        interrupted.set()
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGUSR1, interrupt)
    try:
        with pytest.raises(KeyboardInterrupt):
            parallel_map(one, range(10), 2)
    finally:
        signal.signal(signal.SIGUSR1, before)
    assert sorted(begun) == sorted(ended) == [0, 1]
