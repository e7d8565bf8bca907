"""Grades again: makes results in a folder beside the old one, shows the differences, and exchanges
the folders."""

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

KINDS = "all, student=NAME (with * for any letters), status=STATUS, or score<POINTS"


def begin(out: Path, intake: Class, chosen: str, stamp: Stamp) -> tuple[Path, list[Student]]:
    """The folder of new results, and whom the filter chooses. Results there by another version of
    the kit are discarded."""
    wanted = _filter(chosen)
    there = results.stamp_of(out / "results")
    if there is None:
        raise UsageError(f"{out} holds no results yet: run without --regrade first")
    if there != stamp and chosen != "all":
        raise UsageError(
            f"the results in {out / 'results'} were made {results.difference(there, stamp)}, and "
            "one class is graded by one kit: use --regrade all"
        )
    students = [s for s in intake.students if wanted(_summary(out / "results", s, there))]
    if not students:
        raise UsageError(f"--regrade {chosen} chooses no submission")
    folder = out / "regrade"
    if folder.exists() and results.stamp_of(folder) != stamp:
        shutil.rmtree(folder)
    results.begin(folder, stamp)
    return folder, students


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
    """A summary, and then only what differs. If nothing does, there is nothing to take over, and
    these new results are removed."""
    old, new = out / "results", out / "regrade"
    there = results.stamp_of(old)
    assert there
    pairs = [
        (_summary(old, student, there), _summary(new, student, tasks[student.id].stamp))
        for student in chosen
    ]
    differing = [lines for before, now in pairs if (lines := _difference(before, now))]
    said = [
        f"Submissions graded again: {len(chosen)}; with another result: {len(differing)}.",
        *_weights(pairs),
        *(line for lines in differing for line in lines),
    ]
    if len(said) == 1 and there == results.stamp_of(new):
        for student in chosen:
            result_path(new, tasks[student.id].key).unlink(missing_ok=True)
        if not results.keys(new):
            shutil.rmtree(new)
        return [*said, "There is nothing to take over."]
    said.append("Nothing is changed yet. To take these over: --apply in place of --regrade.")
    return said


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


def _points(summary: Summary) -> str:
    return summary.state if summary.score is None else f"{summary.score:g}"


def apply(out: Path, intake: Class, stamp: Stamp, log: Log) -> None:
    """Exchanges the results; the old ones are kept in a numbered folder."""
    new, old = out / "regrade", out / "results"
    if not new.exists():
        raise UsageError(f"{out} holds nothing to take over: run with --regrade FILTER first")
    if results.stamp_of(new) != stamp:
        raise UsageError("the kit or its fixtures changed since --regrade: run that again")
    taken_over = len(results.keys(new))
    missing = [s.name for s in intake.students if not _result(new, s, stamp)[1]]
    if results.stamp_of(old) == stamp:
        for key in results.keys(old) - results.keys(new):
            os.link(result_path(old, key), result_path(new, key))
    elif missing:
        raise UsageError(
            f"--regrade hasn't graded all ({first_few(missing)}): run it again, on the same "
            "submissions and with the same --gradebook, by which some are found"
        )
    log.write("applied", submissions=taken_over)
    number = 1
    while (out / f"results-{number}").exists():
        number += 1
    old.rename(out / f"results-{number}")
    finish(out)


def finish(out: Path) -> None:
    """Finishes an exchange, perhaps of a run that was killed in between."""
    if (out / "regrade").exists() and not (out / "results").exists():
        (out / "regrade").rename(out / "results")
