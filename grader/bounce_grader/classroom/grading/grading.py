"""Grades submissions that have no result, here or on a Dask cluster, and summarizes all results."""

import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Generator, Sequence
from concurrent.futures import as_completed, CancelledError
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import closing, suppress
from typing import Any

from bounce_grader.classroom.grading import results
from bounce_grader.classroom.grading.results import Stamp, Task, Unit
from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.common.errors import KitError, raise_if_full, UsageError
from bounce_grader.common.escaping import terminal
from bounce_grader.common.progress import Progress
from bounce_grader.grading.report import NO_REPORT, reports

TO_CLEAN_UP = 3.0  # seconds in which a terminated grading can remove its files
KILLED = "the process that graded it was killed, perhaps because memory ran out"
LOST_WORKERS = 3  # of Dask, that a grading may crash before it counts as a failure of the kit
WITH_KIT = "start them with PYTHONPATH=KIT/grader, where KIT is this folder under the same path"
# Each task with what the unit returns, in the order in which they end.
Graded = Generator[tuple[Task, str], None, None]


def grade(
    tasks: Sequence[Task], unit: Unit, jobs: int, scheduler: str, reveal: bool = False
) -> list[Summary]:
    """Grades the submissions without a valid result, and says every few seconds how many are done,
    the rate and the time left. Returns a summary of each, with the answers of hidden cases only with
    `reveal`."""
    keyed = {t.key: t for t in tasks if not results.load(t.folder, t.key, t.speed)}
    missing, jobs = list(keyed.values()), jobs or os.cpu_count() or 1
    graded = on_dask(missing, scheduler, unit) if scheduler else in_processes(missing, jobs, unit)
    failed: dict[str, str] = {}
    progress = Progress(len(missing))
    with closing(graded):
        for task, failure in graded:
            failed |= progress.after({task.key: failure} if failure else {})
    loaded = [results.load(task.folder, task.key) for task in tasks]
    told = iter(reports([of["record"] for of in loaded if of and of["record"]], reveal))
    summaries = []
    for task, of in zip(tasks, loaded):
        if of:
            report = next(told) if of["record"] else NO_REPORT
            known = (of["state"], of["message"], of["key"], report, tuple(of["beside"]))
            summaries.append(Summary(task.student, *known))
        else:
            why = f"the kit failed, so run the same command again: {failed.get(task.key)}"
            summaries.append(Summary(task.student, "failed", why, task.key))
    return summaries


def differences(there: Stamp, tasks: Sequence[Task], summaries: Sequence[Summary]) -> list[str]:
    """How these results differ from those that count so far, in scores and passed checks. Of the
    latter, whose records another version of the kit has laid out, only the points are read."""
    lines, differing = [], 0
    for task, now in zip(tasks, summaries):
        missing = "failed" if now.state == "failed" else "not graded"
        earlier = task._replace(stamp=there)
        before = results.load(earlier.folder, earlier.key) or {"state": missing, "record": {}}
        parts = before["record"].get("parts", [])
        old = {check["id"]: check["score"] for part in parts for check in part["checks"]}
        new = {id: check["score"] for id, check in now.checks.items()}
        scores = [before["record"].get("score", before["state"])]
        scores.append(now.state if now.score is None else now.score)
        failing = [{id for id, points in of.items() if not points} for of in (old, new)]
        if scores[0] == scores[1] and failing[0] == failing[1]:
            continue
        differing += 1
        lines.append(terminal(f"{now.student.who}: {scores[0]} -> {scores[1]}"))
        changed = (id for id in old | new if old and new and old.get(id, 0) != new.get(id, 0))
        lines += [f"  {id}: {old.get(id, 0)} -> {new.get(id, 0)}" for id in changed]
    return [
        f"The results in {tasks[0].folder} are by another version of the kit, or of its cases or "
        "options.",
        f"Submissions graded again: {len(tasks)}; with another result: {differing}.",
        *lines,
        "Nothing is changed yet. To take these over, add --apply.",
    ]


# --- on this machine ---


def in_processes(tasks: Sequence[Task], jobs: int, unit: Unit) -> Graded:
    """Grades in `jobs` processes, so that a crash harms no other grading. If the caller stops
    early, ends the gradings under way."""
    context = multiprocessing.get_context("spawn")
    idle = [ProcessPoolExecutor(1, context, _prepare) for _ in range(jobs)]  # one for each thread

    def graded(task: Task) -> str:
        process = idle.pop()
        try:
            return process.submit(unit, task).result()
        except BrokenProcessPool:
            process = ProcessPoolExecutor(1, context, _prepare)
            return KILLED
        finally:
            idle.append(process)

    threads = ThreadPoolExecutor(jobs)
    futures = {threads.submit(graded, task): task for task in tasks}
    try:
        for future in as_completed(futures):
            yield futures[future], future.result()
    finally:
        threads.shutdown(wait=False, cancel_futures=True)
        workers = multiprocessing.active_children()
        for worker in workers:
            worker.terminate()
        for worker in workers:
            worker.join(TO_CLEAN_UP)
            worker.kill()
        threads.shutdown()


def _prepare() -> None:
    """Makes a process ignore Ctrl-C, end with the class, and clean up when it is terminated."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    threading.Thread(target=_end_with_the_class, daemon=True).start()


def _end_with_the_class() -> None:
    parent = multiprocessing.parent_process()
    assert parent
    parent.join()
    os._exit(1)


# --- on a Dask cluster ---


def on_dask(tasks: Sequence[Task], scheduler: str, unit: Unit) -> Graded:
    """Workers must see the kit, the submissions and the results under the same paths; they may
    join, leave and crash. Raises UsageError if there is no such scheduler, KitError if it is lost.
    """
    if not tasks:
        return
    try:
        from distributed import as_completed as as_done, Client

        client = Client(scheduler, timeout="10s", set_as_default=False)
    except ImportError as error:
        raise UsageError("Dask is missing: apt-get install python3-distributed") from error
    except (OSError, ValueError) as error:
        where = f"no Dask scheduler answers at {scheduler}"
        raise UsageError(f"{where}: start one with dask-scheduler") from error
    of: dict[Any, Task] = {}
    try:
        if not client.scheduler_info()["workers"]:
            print("kit: the Dask scheduler has no workers yet; waiting for them", file=sys.stderr)
        for task in tasks:
            of[client.submit(unit, task, pure=False, retries=LOST_WORKERS)] = task
        for future in as_done(list(of), loop=client.loop):
            yield of[future], _outcome(future)
    except (OSError, CancelledError) as error:
        raise_if_full(error)
        lost = "the Dask scheduler was lost: start it, and run the same command again"
        raise KitError(lost) from error
    finally:
        with suppress(OSError, CancelledError):
            client.cancel(list(of))
            client.close()


def _outcome(future: Any) -> str:
    """Waits for a task whose worker died after it was done: Dask does it again. Raises
    CancelledError if the scheduler is lost, OSError if the disk is full, UsageError if the worker
    doesn't find the kit: it would fail on every submission."""
    error = future.exception()
    if isinstance(error, OSError):
        raise error
    if isinstance(error, ImportError):
        raise UsageError(f"the Dask workers don't find the kit: {WITH_KIT}")
    return f"Dask: {type(error).__name__}: {error}"[:300] if error else str(future.result())
