"""Writes grades.csv: every submission with its points by part and check."""

from collections.abc import Iterable

from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.common.escaping import csv_row, first_few, Value
from bounce_grader.common.manifest import parts
from bounce_grader.common.numbers import short
from bounce_grader.formats.html import MOST_UNUSED


def table(summaries: Iterable[Summary]) -> str:
    return csv_row(_header()) + "".join(csv_row(_row(summary)) for summary in summaries)


def _header() -> list[str]:
    return [
        *("student", "id", "late", "state", "score", "final", "adjustments"),
        *(part.stem for part in parts()),
        *(check.id for part in parts() for check in part.checks),
        *("mistakes", "times the solution's time", "largest error", "needs a look", "not used"),
        "result",
    ]


def _row(summary: Summary) -> list[Value]:
    student = summary.student
    points = [summary.parts.get(part.number) for part in parts()]
    checks = [summary.checks.get(check.id) for part in parts() for check in part.checks]
    return [
        student.shown,
        student.id,
        "late" if student.late else "",
        summary.state,
        _number(summary.score),
        _final_points(summary),
        _changes(summary),
        *map(_number, [*points, *checks]),
        "; ".join(summary.mistakes.values()),
        *map(_number, [summary.ratio, summary.error]),
        "; ".join(summary.needs_a_look),
        first_few([*student.unused, *summary.ignored], MOST_UNUSED, "; ", summary.ignored_more),
        summary.key,
    ]


def _final_points(summary: Summary) -> Value:
    """A number, or the points of each member of a group where they differ."""
    points = {one.id: round(one.points[0], 2) for one in summary.finals}
    if len(set(points.values())) <= 1:
        return _number(next(iter(points.values()), None))
    return "; ".join(f"{id}: {short(value)}" for id, value in points.items())


def _changes(summary: Summary) -> str:
    texts = {one.id: one.changes for one in summary.finals}
    if len(set(texts.values())) <= 1:
        return next(iter(texts.values()), "")
    return "; ".join(f"{id}: {text}" for id, text in texts.items() if text)


def _number(value: float | None) -> Value:
    if value is None:
        return None
    rounded = float(f"{value:.6g}")
    return int(rounded) if rounded.is_integer() else rounded
