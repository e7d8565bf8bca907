"""./kit class: what is asked for, and the order of it."""

import errno
import fcntl
import os
import sys
from collections.abc import Callable, Generator, Iterator, Mapping
from contextlib import closing, contextmanager
from dataclasses import dataclass, field
from pathlib import Path

from bounce_grader.classroom import outputs, regrade, results, similar, students
from bounce_grader.classroom import unit as units
from bounce_grader.classroom.gradebook import Gradebook
from bounce_grader.classroom.log import Log
from bounce_grader.classroom.progress import progress
from bounce_grader.classroom.students import Class, Student
from bounce_grader.classroom.summary import Summary, of_result
from bounce_grader.classroom.task import Stamp, Task, task_of
from bounce_grader.classroom.unit import Outcome
from bounce_grader.errors import KitError, UsageError
from bounce_grader.files import sweep
from bounce_grader.manifest import parts
from bounce_grader.report import clean

MOST_LINES = 40  # on the terminal; class.html has them all
TRIES = 3  # of a grading in which the kit fails
Engine = Callable[[list[Task]], Generator[tuple[Task, Outcome], None, None]]


@dataclass(frozen=True)
class Request:
    submissions: Path
    out: Path
    gradebook: Path | None = None
    columns: Mapping[int, str] = field(default_factory=dict)  # 0: the whole; n: part n
    engine: str = "local"
    jobs: int = 0
    scheduler: str = ""
    speed: bool = True
    trust: bool = False
    regrade: str = ""
    apply: bool = False
    unit: Callable[[Task], Outcome] = units.run


def run(request: Request) -> int:
    """0; or 3 where the kit failed on some submission, which then has no score."""
    found = students.read(request.submissions)
    book = _gradebook(request)
    with _alone(request.out):
        sweep(request.out)
        log = Log(request.out / "log.jsonl")
        try:
            return _run(request, found, book, log)
        except OSError as error:
            if error.errno != errno.ENOSPC:
                raise
            raise KitError(
                f"the disk with {request.out} or with the temporary files is full: make room, and "
                "run the same command again. What is graded is kept"
            ) from error
        finally:
            log.close()


def _run(request: Request, found: Class, book: Gradebook | None, log: Log) -> int:
    folder = request.out / "results"
    regrade.finish(request.out)
    stamp = results.stamp_now(request.speed, request.trust)
    if request.regrade:
        return _regrade(request, found, stamp, log)
    if request.apply:
        regrade.apply(request.out, found, stamp, log)
    results.begin(folder, stamp)
    tasks = {s.id: task_of(s, stamp, folder, request.speed, request.trust) for s in found.students}
    failed = grade_missing(tasks, folder, request, log)
    summaries = summarize(found.students, tasks, folder, failed)
    if summaries and all(summary.state == "waiting" for summary in summaries):
        return 0
    near = similar.find(request.out, found.students, tasks, request.trust)
    said = outputs.write(request.out, found, summaries, book, request.columns, near)
    return _say(request, found, summaries, said)


def grade_missing(
    tasks: Mapping[str, Task], folder: Path, request: Request, log: Log
) -> dict[str, Outcome]:
    """Grades what has no valid result, and gives the failures of the kit, by key."""
    there = results.keys(folder)
    missing: dict[str, Task] = {}
    for task in tasks.values():
        result = results.load(folder, task.key) if task.key in there else None
        if result:
            log.graded(task, result["state"], None)
        else:
            missing[task.key] = task
    failed: dict[str, Outcome] = {}
    try:
        with progress(len(missing)) as bar:
            for attempt in range(TRIES):
                todo = [task for key, task in missing.items() if not attempt or key in failed]
                failed = {}
                with closing(_engine(request)(todo)) as outcomes:
                    for task, outcome in outcomes:
                        if outcome.state == "failed":
                            failed[task.key] = outcome
                        _write_down(log, task, outcome)
                        if outcome.state != "failed" or attempt == TRIES - 1:
                            bar.advance()
                if not failed:
                    break
    except KeyboardInterrupt:
        done = len(missing) - sum(results.load(folder, key) is None for key in missing)
        whole = len({task.key for task in tasks.values()})
        print(
            f"kit: stopped; {whole - len(missing) + done} of {whole} submissions are graded and "
            "kept. Run the same command again to go on.",
            file=sys.stderr,
        )
        sys.exit(130)
    return failed


def _write_down(log: Log, task: Task, outcome: Outcome) -> None:
    """A full disk isn't tried again: the others would be graded for nothing."""
    if outcome.state != "failed":
        log.graded(task, outcome.state, outcome.seconds)
        return
    log.write("failed", task, message=outcome.message)
    if os.strerror(errno.ENOSPC) in outcome.message:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def summarize(
    found: list[Student], tasks: Mapping[str, Task], folder: Path, failed: Mapping[str, Outcome]
) -> list[Summary]:
    summaries = []
    for student in found:
        key = tasks[student.id].key
        result = results.load(folder, key)
        if result:
            summaries.append(of_result(student, key, result))
        elif key in failed:
            message = f"the kit failed: {failed[key].message}"
            summaries.append(Summary(student, key, "failed", message))
        else:
            summaries.append(Summary(student, key, "waiting", "not graded yet"))
    return summaries


def _engine(request: Request) -> Engine:
    jobs = request.jobs or os.cpu_count() or 1
    if request.engine == "dask":
        from bounce_grader.classroom.engines import dask

        return lambda tasks: dask.run(tasks, request.scheduler, request.unit)
    if request.engine == "slurm":
        from bounce_grader.classroom.engines import slurm

        return lambda tasks: slurm.run(tasks, request.out)
    from bounce_grader.classroom.engines import local

    return lambda tasks: local.run(tasks, jobs, request.unit)


def _gradebook(request: Request) -> Gradebook | None:
    """Read and checked before anything is graded or written."""
    if request.gradebook is None:
        return None
    if 0 not in request.columns:
        raise UsageError("--gradebook needs --column, the title of the column to fill")
    if request.gradebook.resolve() == (request.out / "gradebook.csv").resolve():
        raise UsageError(f"{request.gradebook} would be overwritten: give another folder as --out")
    most = {0: sum(part.points for part in parts()), **{p.number: p.points for p in parts()}}
    return Gradebook(request.gradebook, request.columns, most)


@contextmanager
def _alone(out: Path) -> Iterator[None]:
    """One run at a time in a folder; the lock goes with the process."""
    try:
        out.mkdir(parents=True, exist_ok=True)
        lock = os.open(out / ".lock", os.O_CREAT | os.O_RDWR, 0o644)
    except OSError as error:
        raise UsageError(f"{out} can't be written: {error.strerror}") from error
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError as error:
        os.close(lock)
        raise UsageError(f"another run is under way in {out}: wait for it, or stop it") from error
    try:
        yield
    finally:
        os.close(lock)


def _regrade(request: Request, found: Class, stamp: Stamp, log: Log) -> int:
    folder = regrade.begin(request.out, request.regrade, stamp)
    chosen = regrade.choose(request.out, found, request.regrade)
    tasks = {s.id: task_of(s, stamp, folder, request.speed, request.trust) for s in chosen}
    failed = grade_missing(tasks, folder, request, log)
    if failed:
        raise KitError(f"{len(failed)} submissions could not be graded again; nothing is changed")
    print("\n".join(regrade.differences(request.out, chosen, tasks)))
    print("Nothing is changed yet. To take these over: --apply in place of --regrade.")
    return 0


def _say(request: Request, found: Class, summaries: list[Summary], said: list[str]) -> int:
    graded = [s for s in summaries if s.state == "graded"]
    looks = sum(bool(s.needs_a_look) for s in summaries) + len(found.unmatched)
    print(f"{len(graded)} of {len(summaries)} submissions graded ({found.source}).")
    if looks:
        print(f"{looks} need a look; {request.out / 'class.html'} says which, and why.")
    lines = [f"{unmatched.name!r} {unmatched.reason}" for unmatched in found.unmatched]
    lines += [
        f"{s.student.name} ({s.student.id}): {s.message}"
        for s in summaries
        if s.message and s.state != "waiting"
    ]
    waiting = sum(s.state == "waiting" for s in summaries)
    lines += [f"{waiting} wait for a grading"] if waiting else []
    lines += said
    for line in lines[:MOST_LINES]:
        print(f"  {clean(line)}")
    if len(lines) > MOST_LINES:
        print(f"  and {len(lines) - MOST_LINES} more, in class.html")
    print(f"Written to {request.out}: gradebook.csv, grades.csv, class.html, feedback/")
    return 3 if any(s.state == "failed" for s in summaries) else 0
