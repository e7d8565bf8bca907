"""Shows which question is being measured: with a bar on a terminal, in plain lines elsewhere."""

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

Begin = Callable[[str], None]


@contextmanager
def progress(total: int) -> Iterator[Begin]:
    """Yields the function to call with the name of each question as it begins."""
    if sys.stderr.isatty():
        with _bar(total) as begin:
            yield begin
    else:
        yield _lines(total)


def _lines(total: int) -> Begin:
    start, count = time.monotonic(), 0

    def begin(name: str) -> None:
        nonlocal count
        count += 1
        seconds = time.monotonic() - start
        print(f"kit: {count} of {total}, {seconds:.0f} s: {name}", file=sys.stderr, flush=True)

    return begin


@contextmanager
def _bar(total: int) -> Iterator[Begin]:
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn
    from rich.progress import TimeElapsedColumn

    columns = (TextColumn("{task.description:<28}"), BarColumn(), MofNCompleteColumn())
    with Progress(*columns, TimeElapsedColumn(), console=Console(stderr=True)) as bar:
        task, has_begun = bar.add_task("", total=total), False

        def begin(name: str) -> None:
            nonlocal has_begun
            bar.update(task, description=name, advance=int(has_begun))
            has_begun = True

        yield begin
        bar.update(task, advance=1)
