"""Grades again: makes results in a folder beside the old one, shows the differences, and exchanges
the folders."""

import os
import re
import shutil
from collections.abc import Callable, Sequence
from fnmatch import fnmatch
from pathlib import Path

from bounce_grader.classroom.grading import results
from bounce_grader.classroom.grading.log import Log
from bounce_grader.classroom.grading.results import Stamp, Task
from bounce_grader.classroom.grading.summary import of_result, Summary
from bounce_grader.classroom.intake.canvas import sanitized
from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import first_few, terminal

KINDS = "all, student=NAME (with * for any letters), status=STATUS, or score<POINTS"


def begin(out: Path, chosen: str, tasks: Sequence[Task], stamp: Stamp) -> list[Task]:
    """The tasks of those whom the filter chooses, in the folder of new results. Results there by
    another version of the kit are discarded."""
    wanted = _filter(chosen)
    old, new = out / "results", out / "regrade"
    there = results.stamp_of(old)
    if there is None:
        raise UsageError(f"{out} holds no results yet: run without --regrade first")
    if there != stamp and chosen != "all":
        raise UsageError(
            f"the results in {old} were made {results.difference(there, stamp)}, and one class is "
            "graded by one kit: use --regrade all"
        )
    again = [task._replace(folder=new) for task in tasks if wanted(_summary(old, task))]
    if not again:
        raise UsageError(f"--regrade {chosen} chooses no submission")
    if new.exists() and results.stamp_of(new) != stamp:
        shutil.rmtree(new)
    results.begin(new, stamp)
    return again


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


def _summary(folder: Path, task: Task) -> Summary:
    """What is known of a submission by the results in a folder."""
    stamp = results.stamp_of(folder)
    key = results.key_of(task.submission, stamp) if stamp else ""
    result = results.load(folder, key)
    if not result:
        return Summary(task.student, key, "not graded before")
    return of_result(task.student, key, result)


def differences(out: Path, again: Sequence[Task]) -> list[str]:
    """A summary, and then only what differs. If nothing does, there is nothing to take over, and
    these new results are removed."""
    old, new = out / "results", out / "regrade"
    pairs = [(_summary(old, task), _summary(new, task)) for task in again]
    differing = [lines for before, now in pairs if (lines := _difference(before, now))]
    lines = [
        f"Submissions graded again: {len(again)}; with another result: {len(differing)}.",
        *_weights(pairs),
        *(line for lines in differing for line in lines),
    ]
    if len(lines) == 1 and results.stamp_of(old) == results.stamp_of(new):
        for task in again:
            results.path_of(new, task.key).unlink(missing_ok=True)
        if not results.keys(new):
            shutil.rmtree(new)
        return [*lines, "There is nothing to take over."]
    lines.append("Nothing is changed yet. To take these over: --apply in place of --regrade.")
    return lines


def _weights(pairs: list[tuple[Summary, Summary]]) -> list[str]:
    """A line for each check whose points parts.json has changed."""
    before = {id: points for old, _ in pairs for id, points in old.most.items()}
    now = {id: points for _, new in pairs for id, points in new.most.items()}
    return [
        f"  {id} gives {before.get(id, 0):g} -> {now.get(id, 0):g} points"
        for id in dict.fromkeys([*now, *before])
        if before and now and before.get(id, 0) != now.get(id, 0)
    ]


def _difference(old: Summary, new: Summary) -> list[str]:
    """The points, and the checks that are passed now and weren't, or the other way round."""
    checks = [
        f"  {id}: {'failed -> passed' if id in new.passed else 'passed -> failed'}"
        for id in new.most
        if id in old.most and (id in new.passed) != (id in old.passed)
    ]
    if not checks and (old.state, old.score) == (new.state, new.score):
        return []
    student = terminal(f"{new.student.shown} ({new.student.id})")
    return [f"{student}: {_points(old)} -> {_points(new)}", *checks]


def _points(summary: Summary) -> str:
    return summary.state if summary.score is None else f"{summary.score:g}"


def apply(out: Path, tasks: Sequence[Task], stamp: Stamp, log: Log) -> None:
    """Exchanges the results; the old ones are kept in a numbered folder."""
    new, old = out / "regrade", out / "results"
    if not new.exists():
        raise UsageError(f"{out} holds nothing to take over: run with --regrade FILTER first")
    if results.stamp_of(new) != stamp:
        raise UsageError("the kit or its fixtures changed since --regrade: run that again")
    taken_over = results.keys(new)
    missing = [task.student.name for task in tasks if task.key not in taken_over]
    if results.stamp_of(old) == stamp:
        for key in results.keys(old) - taken_over:
            os.link(results.path_of(old, key), results.path_of(new, key))
    elif missing:
        raise UsageError(
            f"--regrade hasn't graded all ({first_few(missing)}): run it again, on the same "
            "submissions and with the same --gradebook, by which some are found"
        )
    log.write("applied", submissions=len(taken_over))
    number = 1
    while (out / f"results-{number}").exists():
        number += 1
    old.rename(out / f"results-{number}")
    finish(out)


def finish(out: Path) -> None:
    """Finishes an exchange, perhaps of a run that was killed in between."""
    if (out / "regrade").exists() and not (out / "results").exists():
        (out / "regrade").rename(out / "results")
