"""Fuzzes the readers of submissions, and of text that submissions can influence.

    PYTHONPATH=grader:tests/kit/support python3 -m fuzzing READER COUNT

COUNT inputs, made from real ones, each from its own number, so that a run can be repeated. Whatever
comes must be taken within the limits or refused in one sentence. An input at which that fails is
written to build/fuzz/inputs/, and named.
"""

import random
import signal
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from bounce_grader.common.paths import ROOT
from bounce_grader.submission.entry import Entry
from fuzzing.answers import COMPILER_SEEDS, check_compiler, check_judge, judge_seeds
from fuzzing.mutation import Random, mutated
from fuzzing.submissions import check_entries, check_tree, check_zip
from fuzzing.submissions import some_entries, some_tree, some_zip

MOST_SECONDS = 10  # of CPU time, for one input


@dataclass(frozen=True)
class Reader:
    make: Callable[[Random], Any]
    check: Callable[[Any], bool]  # whether the input was taken; raises AssertionError
    least_taken: float  # the least share of inputs that must be taken, else they test too little


READERS = {
    "zip": Reader(some_zip, check_zip, 0.2),
    "folder": Reader(some_tree, check_tree, 0.5),
    "sources": Reader(some_entries, check_entries, 0.2),
    "judge": Reader(lambda rng: mutated(rng, judge_seeds(), 4), check_judge, 0.1),
    "compiler": Reader(lambda rng: mutated(rng, COMPILER_SEEDS), check_compiler, 0.2),
}


def run(name: str, first: int, count: int) -> int:
    """How many of the inputs first, first + 1, ... were taken."""
    reader, taken = READERS[name], 0
    signal.signal(signal.SIGPROF, _too_slow)
    signal.signal(signal.SIGALRM, _too_slow)
    for number in range(first, first + count):
        made = reader.make(random.Random(f"{name} {number}"))
        _set_timers(MOST_SECONDS)
        try:
            taken += reader.check(made)
        except BaseException as error:
            raise AssertionError(f"{_kept_as(name, number, made)}: {error!r}") from error
        finally:
            _set_timers(0)
    return taken


def _set_timers(seconds: int) -> None:
    """Sets a limit on CPU time, and a larger one on wall-clock time for inputs that make it
    wait."""
    signal.setitimer(signal.ITIMER_PROF, seconds)
    signal.setitimer(signal.ITIMER_REAL, 6 * seconds)


def _too_slow(*_: object) -> None:
    raise TimeoutError(f"more than {MOST_SECONDS} s of CPU time, or it waits")


def plain(made: Any) -> bytes:
    """An input as bytes, whatever it is."""
    if isinstance(made, bytes):
        return made
    told = [(x.name, x.size, x.link, x.read(99)) if isinstance(x, Entry) else x for x in made]
    return repr(told).encode()


def _kept_as(name: str, number: int, made: Any) -> Path:
    path = ROOT / "build" / "fuzz" / "inputs" / f"{name}-{number}"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(plain(made))
    return path
