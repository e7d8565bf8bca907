"""Grades again: makes a new set of results beside the old one, shows the differences, and exchanges
the sets."""

import os
import re
import shutil
from collections.abc import Callable, Mapping
from fnmatch import fnmatch
from pathlib import Path
from typing import Any

from bounce_grader.classroom.grading import results
from bounce_grader.classroom.grading.log import Log
from bounce_grader.classroom.grading.summary import of_result, Summary
from bounce_grader.classroom.grading.task import task_of, Stamp, Task
from bounce_grader.classroom.grading.unit import result_path
from bounce_grader.classroom.intake.canvas import sanitized
from bounce_grader.classroom.intake.student import Class, Student
from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import first_few, terminal
from bounce_grader.common.files import write_whole

FILTER = "filter.txt"
MARKER = "apply"
SAME = "same"  # a file in a set that changes nothing
KINDS = "all, student=NAME (with * for any letters), status=STATUS, or score<POINTS"


def begin(out: Path, intake: Class, chosen: str, stamp: Stamp) -> tuple[Path, list[Student]]:
    """The folder of the new set, and whom the filter chooses. A set begun by another version of the
    kit is discarded, and so is one that changes nothing."""
    _filter(chosen)
    there = results.stamp_of(out / "results")
    if there is None:
        raise UsageError(f"{out} holds no results yet: run without --regrade first")
    if there != stamp and chosen != "all":
        raise UsageError(
            f"the results in {out / 'results'} were made {results.difference(there, stamp)}, and "
            "one class is graded by one kit: use --regrade all"
        )
    students = _choose(out, intake, chosen)
    folder = out / "regrade"
    noted = folder / FILTER
    dropped = results.stamp_of(folder) != stamp or not noted.exists() or (folder / SAME).exists()
    if folder.exists() and dropped:
        shutil.rmtree(folder)
    elif folder.exists() and noted.read_text() != chosen:
        raise UsageError(
            f"{folder} holds what was graded again for {noted.read_text()!r}: take it over with "
            "--apply, or remove that folder"
        )
    results.begin(folder, stamp)
    write_whole(noted, chosen)
    return folder, students


def _choose(out: Path, intake: Class, chosen: str) -> list[Student]:
    there = results.stamp_of(out / "results")
    assert there
    wanted = _filter(chosen)
    students = [s for s in intake.students if wanted(_summary(out / "results", s, there))]
    if not students:
        raise UsageError(f"--regrade {chosen} chooses no submission")
    return students


def _filter(expression: str) -> Callable[[Summary], bool]:
    kind, _, value = expression.partition("=")
    below = re.fullmatch(r"score<(\d+(?:\.\d+)?)", expression)
    if expression == "all":
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
    raise UsageError(f"--regrade doesn't know {expression!r}; it takes {KINDS}")


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
    """A summary, and then only what differs; nothing but the summary if nothing does."""
    there = results.stamp_of(out / "results")
    assert there
    pairs = [
        (_summary(out / "results", s, there), _summary(out / "regrade", s, tasks[s.id].stamp))
        for s in chosen
    ]
    differing = [lines for old, new in pairs if (lines := _difference(old, new))]
    return [
        f"Submissions graded again: {len(chosen)}; with another result: {len(differing)}.",
        *_weights(pairs),
        *(line for lines in differing for line in lines),
    ]


def _weights(pairs: list[tuple[Summary, Summary]]) -> list[str]:
    """A line for each check whose points parts.json has changed."""
    before = {id: points for old, _ in pairs for id, points in old.most.items()}
    now = {id: points for _, new in pairs for id, points in new.most.items()}
    if not before or not now:
        return []
    return [
        f"  {id} gives {before.get(id, 0):g} -> {now.get(id, 0):g} points"
        for id in dict.fromkeys([*now, *before])
        if before.get(id, 0) != now.get(id, 0)
    ]


def _difference(old: Summary, new: Summary) -> list[str]:
    """The points, and the checks that are passed now and weren't, or the other way round."""
    both = [id for id in new.most if id in old.most]
    checks = [
        f"  {id}: {'failed -> passed' if id in new.passed else 'passed -> failed'}"
        for id in both
        if (id in new.passed) != (id in old.passed)
    ]
    if not checks and (old.state, old.score) == (new.state, new.score):
        return []
    student = terminal(f"{new.student.shown} ({new.student.id})")
    return [f"{student}: {_points(old)} -> {_points(new)}", *checks]


def nothing_differs(out: Path, lines: list[str]) -> bool:
    """Whether these differences are none; then the set may be dropped for the next one."""
    same = len(lines) == 1 and results.stamp_of(out / "results") == results.stamp_of(
        out / "regrade"
    )
    if same:
        write_whole(out / "regrade" / SAME, "")
    return same


def _points(summary: Summary) -> str:
    return summary.state if summary.score is None else f"{summary.score:g}"


def apply(out: Path, intake: Class, stamp: Stamp, log: Log) -> None:
    """Exchanges the sets; the old one is kept in a numbered folder."""
    new, old = out / "regrade", out / "results"
    if not (new / FILTER).exists():
        raise UsageError(f"{out} holds nothing to take over: run with --regrade FILTER first")
    if results.stamp_of(new) != stamp:
        raise UsageError("the kit or its fixtures changed since --regrade: run that again")
    chosen = _choose(out, intake, (new / FILTER).read_text())
    missing = [s.name for s in chosen if not _result(new, s, stamp)[1]]
    if missing:
        raise UsageError(
            f"--regrade hasn't graded all ({first_few(missing)}): run it again, on the same "
            "submissions and with the same --gradebook, by which some are found"
        )
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
    for name in (FILTER, SAME):
        (new / name).unlink(missing_ok=True)
    (new / MARKER).unlink()
    new.rename(old)
