"""Shows progress: a bar with rate and time left on a terminal, plain lines elsewhere."""

import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Protocol

SECONDS_BETWEEN_LINES = 15.0


class Progress(Protocol):
    """Counts the submissions that are done."""

    def advance(self) -> None:
        ...


@contextmanager
def progress(total: int) -> Iterator[Progress]:
    if sys.stderr.isatty():
        with _bar(total) as bar:
            yield bar
    else:
        yield _Lines(total)


class _Lines:
    def __init__(self, total: int) -> None:
        self._total, self._done = total, 0
        self._start = self._last = time.monotonic()

    def advance(self) -> None:
        self._done += 1
        now = time.monotonic()
        if self._done == self._total or now - self._last >= SECONDS_BETWEEN_LINES:
            self._last = now
            print(f"kit: {self._sentence(now - self._start)}", file=sys.stderr, flush=True)

    def _sentence(self, seconds: float) -> str:
        rate = self._done / max(seconds, 1e-9)
        left = (self._total - self._done) / rate
        ahead = f", {left:.0f} s left" if self._done < self._total else ""
        return f"{self._done} of {self._total} graded, {60 * rate:.0f} a minute{ahead}"


@contextmanager
def _bar(total: int) -> Iterator[Progress]:
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeRemainingColumn
    from rich.progress import Progress as Rich

    console = Console(stderr=True)
    rate = TextColumn("{task.fields[rate]}")
    columns = (TextColumn("grading"), BarColumn(), MofNCompleteColumn(), rate)
    with Rich(*columns, TimeRemainingColumn(), console=console) as rich:
        yield _Bar(rich, total)


class _Bar:
    def __init__(self, rich: object, total: int) -> None:
        from rich.progress import Progress as Rich

        assert isinstance(rich, Rich)
        self._rich, self._done, self._start = rich, 0, time.monotonic()
        self._task = rich.add_task("grading", total=total, rate="")

    def advance(self) -> None:
        self._done += 1
        rate = 60 * self._done / max(time.monotonic() - self._start, 1e-9)
        self._rich.update(self._task, advance=1, rate=f"{rate:.0f} a minute")
