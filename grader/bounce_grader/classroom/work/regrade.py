"""Grades again: makes a new set of results beside the old one, shows the differences, and exchanges
the sets."""

import os
import re
import shutil
from collections.abc import Callable, Mapping
from fnmatch import fnmatch
from pathlib import Path
from typing import Any

from bounce_grader.classroom.intake.canvas import sanitized
from bounce_grader.classroom.intake.students import Class, Student
from bounce_grader.classroom.work import results
from bounce_grader.classroom.work.log import Log
from bounce_grader.classroom.work.summary import of_result, Summary
from bounce_grader.classroom.work.task import task_of, Stamp, Task
from bounce_grader.classroom.work.unit import result_path
from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import terminal
from bounce_grader.common.files import write_whole

FILTER = "filter.txt"
MARKER = "apply"
KINDS = "all, student=NAME (with * for any letters), status=STATUS, or score<POINTS"


def begin(out: Path, chosen: str, stamp: Stamp) -> Path:
    """The folder of the new set. A set begun by another version of the kit is discarded."""
    _filter(chosen)
    there = results.stamp_of(out / "results")
    if there is None:
        raise UsageError(f"{out} holds no results yet: run without --regrade first")
    if there != stamp and chosen != "all":
        raise UsageError(
            f"the results in {out / 'results'} were made {results.difference(there, stamp)}, and "
            "one class is graded by one kit: use --regrade all"
        )
    folder = out / "regrade"
    noted = folder / FILTER
    if folder.exists() and (results.stamp_of(folder) != stamp or not noted.exists()):
        shutil.rmtree(folder)
    elif folder.exists() and noted.read_text() != chosen:
        raise UsageError(
            f"{folder} holds what was graded again for {noted.read_text()!r}: take it over with "
            "--apply, or remove that folder"
        )
    results.begin(folder, stamp)
    write_whole(noted, chosen)
    return folder


def choose(out: Path, intake: Class, chosen: str) -> list[Student]:
    there = results.stamp_of(out / "results")
    assert there
    wanted = _filter(chosen)
    students = [s for s in intake.students if wanted(_summary(out / "results", s, there))]
    if not students:
        raise UsageError(f"--regrade {chosen} chooses no submission")
    return students


def _filter(words: str) -> Callable[[Summary], bool]:
    kind, _, value = words.partition("=")
    below = re.fullmatch(r"score<(\d+(?:\.\d+)?)", words)
    if words == "all":
        return lambda summary: True
    if below:
        limit = float(below[1])
        return lambda summary: summary.score is not None and summary.score < limit
    if kind == "student" and value:
        names = {value, "*".join(map(sanitized, value.split("*")))} - {""}
        return lambda s: any(
            fnmatch(own, name) for own in (s.student.id, s.student.name) for name in names
        )
    if kind == "status" and value:
        return lambda summary: value in {summary.state, *summary.statuses.values()}
    raise UsageError(f"--regrade doesn't know {words!r}; it takes {KINDS}")


def _summary(folder: Path, student: Student, stamp: Stamp) -> Summary:
    key, result = _result(folder, student, stamp)
    return of_result(student, key, result) if result else Summary(student, key, "not graded before")


def _result(folder: Path, student: Student, stamp: Stamp) -> tuple[str, dict[str, Any] | None]:
    """The key and the result, timed or not: timing changes no score."""
    for speed in (True, False):
        key = task_of(student, stamp, Path(), speed, trust=False).key
        result = results.load(folder, key)
        if result:
            break
    return key, result


def differences(out: Path, chosen: list[Student], tasks: Mapping[str, Task]) -> list[str]:
    there = results.stamp_of(out / "results")
    assert there
    lines = []
    for student in chosen:
        old = _summary(out / "results", student, there)
        new = _summary(out / "regrade", student, tasks[student.id].stamp)
        lines += _difference(old, new)
    changed = sum(not line.startswith(" ") for line in lines)
    return [f"{len(chosen)} submissions were graded again; {changed} differ.", *lines]


def _difference(old: Summary, new: Summary) -> list[str]:
    checks = [
        f"  {id}: {old.checks.get(id, 0):g} -> {points:g}"
        for id, points in new.checks.items()
        if points != old.checks.get(id, 0)
    ]
    if not checks and (old.state, old.score) == (new.state, new.score):
        return []
    student = terminal(f"{new.student.name} ({new.student.id})")
    return [f"{student}: {_points(old)} -> {_points(new)}", *checks]


def _points(summary: Summary) -> str:
    return summary.state if summary.score is None else f"{summary.score:g}"


def apply(out: Path, intake: Class, stamp: Stamp, log: Log) -> None:
    """Exchanges the sets; the old one is kept in a numbered folder."""
    new, old = out / "regrade", out / "results"
    if not (new / FILTER).exists():
        raise UsageError(f"{out} holds nothing to take over: run with --regrade FILTER first")
    if results.stamp_of(new) != stamp:
        raise UsageError("the kit or its fixtures changed since --regrade: run that again")
    chosen = choose(out, intake, (new / FILTER).read_text())
    missing = [s.name for s in chosen if not _result(new, s, stamp)[1]]
    if missing:
        raise UsageError(f"--regrade hasn't graded all ({missing[0]} is missing): run that again")
    if results.stamp_of(old) == stamp:
        for key in results.keys(old) - results.keys(new):
            os.link(result_path(old, key), result_path(new, key))
    write_whole(new / MARKER, "", durable=True)
    log.write("applied", filter=(new / FILTER).read_text(), submissions=len(chosen))
    finish(out)


def finish(out: Path) -> None:
    """Finishes an exchange that was begun, perhaps by a run that was killed meanwhile."""
    new, old = out / "regrade", out / "results"
    if not (new / MARKER).exists():
        return
    if old.exists():
        number = 1
        while (out / f"results-{number}").exists():
            number += 1
        old.rename(out / f"results-{number}")
    (new / FILTER).unlink(missing_ok=True)
    (new / MARKER).unlink()
    new.rename(old)
