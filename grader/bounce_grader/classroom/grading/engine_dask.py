"""Grades on a Dask cluster: each task is a future. Workers must see the kit, the submissions and
the results under the same paths; they may join, leave and crash."""

import errno
import sys
from collections.abc import Generator
from concurrent.futures import CancelledError
from contextlib import suppress
from typing import Any

from bounce_grader.classroom.grading.results import Task
from bounce_grader.classroom.grading.unit import Unit
from bounce_grader.common.errors import KitError, UsageError

LOST_WORKERS = 3  # that a grading may crash before it counts as a failure of the kit
TO_CONNECT = "10s"
NO_KIT = (
    "the Dask workers don't find the kit: start them with PYTHONPATH=KIT/grader, where KIT is this "
    "folder under the same path"
)
LOST = "the Dask scheduler was lost: start it, and run the same command again"


def run(tasks: list[Task], scheduler: str, unit: Unit) -> Generator[tuple[Task, str], None, None]:
    """Yields what the unit returns, as it comes. Raises UsageError if there is no such scheduler,
    KitError if it is lost."""
    if not tasks:
        return
    client = _client(scheduler)
    of: dict[Any, Task] = {}
    try:
        from distributed import as_completed

        if not client.scheduler_info()["workers"]:
            print("kit: the Dask scheduler has no workers yet; waiting for them", file=sys.stderr)
        for task in tasks:
            of[client.submit(unit, task, pure=False, retries=LOST_WORKERS)] = task
        for future in as_completed(list(of), loop=client.loop):
            yield of[future], _failure(future)
    except (OSError, CancelledError) as error:
        if isinstance(error, OSError) and error.errno == errno.ENOSPC:
            raise
        raise KitError(LOST) from error
    finally:
        with suppress(OSError, CancelledError):
            client.cancel(list(of))
            client.close()


def _client(scheduler: str) -> Any:
    try:
        from distributed import Client
    except ImportError as error:
        raise UsageError("Dask is missing: apt-get install python3-distributed") from error
    try:
        return Client(scheduler, timeout=TO_CONNECT, set_as_default=False)
    except (OSError, ValueError) as error:
        where = f"no Dask scheduler answers at {scheduler}"
        raise UsageError(f"{where}: start one with dask-scheduler") from error


def _failure(future: Any) -> str:
    """Waits for a task whose worker died after it was done: Dask does it again. Raises
    CancelledError if the scheduler is lost, OSError if the disk is full, UsageError if the worker
    doesn't find the kit: it would fail on every submission."""
    error = future.exception()
    if isinstance(error, OSError):
        raise error
    if isinstance(error, ImportError):
        raise UsageError(NO_KIT)
    return f"Dask: {type(error).__name__}: {error}"[:300] if error else str(future.result())
