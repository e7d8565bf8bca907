"""Grades on a Dask cluster: each task is a future. Workers must see the kit, the submissions and
the results under the same paths; they may join, leave and crash."""

import sys
from collections.abc import Generator
from concurrent.futures import CancelledError
from contextlib import suppress
from typing import Any

from bounce_grader.classroom.grading.results import Task
from bounce_grader.classroom.grading.unit import Outcome, Unit
from bounce_grader.common.errors import KitError, UsageError

LOST_WORKERS = 3  # that a grading may crash before it counts as a failure of the kit
TO_CONNECT = "10s"
LOST = "the Dask scheduler was lost: start it, and run the same command again"


def run(
    tasks: list[Task], scheduler: str, unit: Unit
) -> Generator[tuple[Task, Outcome], None, None]:
    """Yields outcomes as they come. Raises UsageError if there is no such scheduler, KitError if it
    is lost."""
    if not tasks:
        return
    client = _client(scheduler)
    of: dict[Any, Task] = {}
    try:
        from distributed import as_completed

        _require_the_kit(client)
        for task in tasks:
            of[client.submit(unit, task, pure=False, retries=LOST_WORKERS)] = task
        for future in as_completed(list(of), loop=client.loop):
            yield of[future], _outcome(future)
    except (OSError, CancelledError) as error:
        raise KitError(LOST) from error
    finally:
        with suppress(OSError, CancelledError):
            client.cancel(list(of))
            client.close()


def _client(scheduler: str) -> Any:
    try:
        from distributed import Client
    except ImportError as error:
        raise UsageError(
            "Dask isn't installed here: apt-get install python3-distributed"
        ) from error
    try:
        return Client(scheduler, timeout=TO_CONNECT, set_as_default=False)
    except (OSError, ValueError) as error:
        raise UsageError(
            f"no Dask scheduler answers at {scheduler}: start one with dask-scheduler"
        ) from error


def _require_the_kit(client: Any) -> None:
    """Raises UsageError if a worker can't import the unit: it would fail on every submission. A
    worker that dies meanwhile isn't missed."""
    answers = client.run(_try_import, on_error="return").values()
    errors = [repr(answer) for answer in answers if isinstance(answer, Exception)]
    if any("bounce_grader" in error for error in errors):
        raise UsageError(
            "the Dask workers don't find the kit: start them with PYTHONPATH=KIT/grader, where KIT "
            "is this folder under the same path"
        )
    if not answers:
        print("kit: the Dask scheduler has no workers yet; waiting for them", file=sys.stderr)


def _try_import() -> str:
    import bounce_grader.classroom.grading.unit

    return bounce_grader.classroom.grading.unit.__name__


def _outcome(future: Any) -> Outcome:
    """Waits for a task whose worker died after it was done: Dask does it again. Raises
    CancelledError if the scheduler is lost."""
    error = future.exception()
    if error is None:
        outcome: Outcome = future.result()
        return outcome
    return Outcome(f"Dask: {type(error).__name__}: {error}"[:300])
