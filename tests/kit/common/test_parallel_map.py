"""parallel_map: results, errors and interruptions."""

import signal
import threading
import time

import pytest
from bounce_grader.common.parallel_map import parallel_map


@pytest.mark.parametrize("jobs", [1, 2, 9])
@pytest.mark.parametrize("number", [0, 1, 50])
def test_results_come_in_the_order_of_the_items(jobs: int, number: int) -> None:
    assert parallel_map(lambda x: x * x, range(number), jobs) == [x * x for x in range(number)]


def test_as_many_run_at_once_as_there_are_jobs() -> None:
    all_here = threading.Barrier(3, timeout=60)  # is broken where a third one never comes
    assert parallel_map(lambda x: all_here.wait() * 0 + x, range(6), 3) == list(range(6))


def test_one_job_runs_in_the_thread_that_asks() -> None:
    assert parallel_map(lambda _: threading.get_ident(), "ab", 1) == [threading.get_ident()] * 2


@pytest.mark.parametrize("jobs", [1, 3])
def test_the_first_error_is_raised_and_no_other_item_is_begun(jobs: int) -> None:
    begun: list[int] = []
    ended: list[int] = []
    of_the_third: list[threading.Thread] = []
    third = threading.Event()

    def one(x: int) -> None:
        begun.append(x)
        if x == 2:
            of_the_third.append(threading.current_thread())
            third.set()
            raise ValueError("the third")
        if x > 2:
            assert third.wait(60)
            of_the_third[0].join()
        ended.append(x)

    with pytest.raises(ValueError, match="the third"):
        parallel_map(one, range(100), jobs)
    assert len(begun) <= 2 + jobs and sorted([*ended, 2]) == sorted(begun)


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
