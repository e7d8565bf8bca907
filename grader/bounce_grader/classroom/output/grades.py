"""Writes grades.csv: every submission with its points by part and check."""

from collections.abc import Iterable, Mapping

from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.common.escaping import csv_row, first_few, Value
from bounce_grader.common.manifest import parts
from bounce_grader.formats.html import MOST_UNUSED


def table(summaries: Iterable[Summary]) -> str:
    header: list[Value] = [
        *("student", "id", "late", "state", "score", "final", "adjustments"),
        *(part.stem for part in parts()),
        *(check.id for part in parts() for check in part.checks),
        *("mistakes", "times the solution's time", "largest error", "needs a look", "not used"),
        "result",
    ]
    return "".join(map(csv_row, [header, *map(_row, summaries)]))


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
        _of_members({one.id: _number(round(one.points, 2)) for one in summary.finals}),
        _of_members({one.id: one.changes for one in summary.finals}) or "",
        *map(_number, [*points, *checks]),
        "; ".join(summary.mistakes.values()),
        *map(_number, [summary.ratio, summary.error]),
        "; ".join(summary.needs_a_look),
        first_few([*student.unused, *summary.ignored], MOST_UNUSED, "; ", summary.ignored_more),
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
