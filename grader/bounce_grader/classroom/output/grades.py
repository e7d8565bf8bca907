"""Writes grades.csv: every submission with its points by part and check."""

from collections.abc import Iterable, Mapping

from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.common.escaping import csv_row, first_few, Value
from bounce_grader.common.manifest import parts
from bounce_grader.formats.html import MOST_UNUSED


def table(summaries: Iterable[Summary]) -> str:
    header: list[Value] = [
        *("student", "id", "late", "state", "score", "final", "adjustments"),
        *_with_points(),
        *("mistakes", "times the solution's time", "largest error", "needs a look", "not used"),
        "result",
    ]
    return "".join(map(csv_row, [header, *map(_row, summaries)]))


def _with_points() -> list[str]:
    return [*(part.stem for part in parts()), *(c.id for part in parts() for c in part.checks)]


def _row(summary: Summary) -> list[Value]:
    student = summary.student
    points = {part["stem"]: part["score"] for part in summary.parts}
    points |= {id: check["score"] for id, check in summary.checks.items()}
    return [
        student.shown,
        student.id,
        "" if student.late_days == 0 else "late",
        summary.state,
        _number(summary.score),
        _of_members({one.id: _number(round(one.points, 2)) for one in summary.finals}),
        _of_members({one.id: one.changes for one in summary.finals}) or "",
        *(_number(points.get(column)) for column in _with_points()),
        "; ".join(summary.mistakes.values()),
        *(_number(summary.speed.get(name)) for name in ("ratio", "largest_error")),
        summary.needs_a_look,
        first_few(summary.unused, MOST_UNUSED, "; ", summary.unused_more),
        summary.key,
    ]


def _of_members(values: Mapping[str, Value]) -> Value:
    """What all members of a group have; or what each has, where they differ."""
    if len(set(values.values())) > 1:
        return "; ".join(f"{id}: {value}" for id, value in values.items() if value != "")
    return next(iter(values.values()), None)


def _number(value: float | None) -> Value:
    if value is None:
        return None
    rounded = float(f"{value:.6g}")
    return int(rounded) if rounded.is_integer() else rounded
