"""Compares what two versions of the kit give a class, before the results of the newer one count."""

from collections.abc import Sequence
from pathlib import Path

from bounce_grader.classroom.grading import results
from bounce_grader.classroom.grading.results import Stamp, Task
from bounce_grader.classroom.grading.summary import of_result, Summary
from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import terminal


def stamp_before(folder: Path) -> Stamp:
    """The version whose results count so far. Raises UsageError if there are none."""
    there = results.stamp_of(folder)
    if there is None:
        raise UsageError(
            f"{folder.parent} holds no results yet: run without --regrade and --apply first"
        )
    return there


def differences(there: Stamp, tasks: Sequence[Task]) -> list[str]:
    """A summary, and then only what differs."""
    if all(task.stamp == there for task in tasks):
        return ["The results are by this version of the kit: there is nothing to take over."]
    pairs = [
        (_summary(task, results.key_of(task.submission, there)), _summary(task, task.key))
        for task in tasks
    ]
    differing = [lines for before, now in pairs if (lines := _difference(before, now))]
    return [
        f"Submissions graded again: {len(tasks)}; with another result: {len(differing)}.",
        *_weights(pairs),
        *(line for lines in differing for line in lines),
        "Nothing is changed yet. To take these over: --apply in place of --regrade.",
    ]


def _summary(task: Task, key: str) -> Summary:
    result = results.load(task.folder, key)
    if not result:
        return Summary(task.student, key, "not graded before")
    return of_result(task.student, key, result)


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
