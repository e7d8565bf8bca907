"""Writes grades.csv: every submission with its points by part and check."""

from collections.abc import Iterable, Mapping

from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.intake.student import Member
from bounce_grader.common.escaping import csv_row, first_few, Value
from bounce_grader.common.manifest import parts
from bounce_grader.formats.html import MOST_UNUSED

POINTS = [*(part.stem for part in parts()), *(c.id for part in parts() for c in part.checks)]


def table(summaries: Iterable[Summary]) -> str:
    rows = list(map(_row, summaries))
    return "".join(map(csv_row, [rows[0].keys(), *(row.values() for row in rows)]))


def _row(summary: Summary) -> dict[str, Value]:
    student, finals, speed = summary.student, summary.finals, summary.speed
    points = {part["stem"]: part["score"] for part in summary.parts}
    points |= {id: check["score"] for id, check in summary.checks.items()}
    return {
        "student": student.shown,
        "id": student.id,
        "late": "" if student.late_days == 0 else "late",
        "state": summary.state,
        "score": _number(summary.score),
        "final": _of_members({one.id: _number(round(one.points, 2)) for one in finals}),
        "adjustments": _of_members({one.id: _changes(one) for one in finals}) or "",
        **{column: _number(points.get(column)) for column in POINTS},
        "mistakes": "; ".join(summary.mistakes.values()),
        "times the solution's time": _number(speed.get("ratio")),
        "largest error": _number(speed.get("largest_error")),
        "needs a look": summary.needs_a_look,
        "not used": first_few(summary.unused, MOST_UNUSED, "; ", summary.unused_more),
        "result": summary.key,
    }


def _of_members(values: Mapping[str, Value]) -> Value:
    """What all members of a group have; or what each has, where they differ."""
    if len(set(values.values())) > 1:
        return "; ".join(f"{id}: {value}" for id, value in values.items() if value != "")
    return next(iter(values.values()), None)


def _changes(member: Member) -> str:
    return ", ".join(f"{a.reason} {a.points:+g}" if a.points else a.reason for a in member.applied)


def _number(value: float | None) -> Value:
    if value is None:
        return None
    rounded = float(f"{value:.6g}")
    return int(rounded) if rounded.is_integer() else rounded
