"""Which question is being answered: a bar on a terminal, plain lines elsewhere."""

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

Say = Callable[[str], None]


@contextmanager
def progress(total: int) -> Iterator[Say]:
    """Yields what to call with the name of each question as it begins."""
    if sys.stderr.isatty():
        with _bar(total) as say:
            yield say
    else:
        yield _lines(total)


def _lines(total: int) -> Say:
    start, count = time.monotonic(), 0

    def say(name: str) -> None:
        nonlocal count
        count += 1
        seconds = time.monotonic() - start
        print(f"kit: {count} of {total}, {seconds:.0f} s: {name}", file=sys.stderr, flush=True)

    return say


@contextmanager
def _bar(total: int) -> Iterator[Say]:
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn
    from rich.progress import TimeElapsedColumn

    columns = (TextColumn("{task.description:<28}"), BarColumn(), MofNCompleteColumn())
    with Progress(*columns, TimeElapsedColumn(), console=Console(stderr=True)) as rich:
        task, begun = rich.add_task("", total=total), False

        def say(name: str) -> None:
            nonlocal begun
            rich.update(task, description=name, advance=int(begun))
            begun = True

        yield say
        rich.update(task, advance=1)
