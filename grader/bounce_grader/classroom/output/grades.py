"""Writes grades.csv: every submission with its points by part and check."""

from collections.abc import Iterable

from bounce_grader.classroom.work.summary import Summary
from bounce_grader.common.escaping import csv_row, first_few, Value
from bounce_grader.common.manifest import parts
from bounce_grader.formats.html import MOST_UNUSED


def table(summaries: Iterable[Summary]) -> str:
    return csv_row(_header()) + "".join(csv_row(_row(summary)) for summary in summaries)


def _header() -> list[str]:
    return [
        *("student", "id", "late", "state", "score"),
        *(part.stem for part in parts()),
        *(check.id for part in parts() for check in part.checks),
        *("times the solution's time", "largest error", "needs a look", "not used", "result"),
    ]


def _row(summary: Summary) -> list[Value]:
    student = summary.student
    points = [summary.parts.get(part.number) for part in parts()]
    checks = [summary.checks.get(check.id) for part in parts() for check in part.checks]
    return [
        student.name,
        student.id,
        "late" if student.late else "",
        summary.state,
        *map(_number, [summary.score, *points, *checks, summary.ratio, summary.error]),
        "; ".join(summary.needs_a_look),
        first_few([*student.unused, *summary.ignored], MOST_UNUSED, "; ", summary.ignored_more),
        summary.key,
    ]


def _number(value: float | None) -> Value:
    if value is None:
        return None
    rounded = float(f"{value:.6g}")
    return int(rounded) if rounded.is_integer() else rounded
