"""Reads OUT/adjustments.csv: what an instructor changes in the points of a student, and why."""

from pathlib import Path
from typing import NamedTuple

from bounce_grader.classroom.intake import instructor_table
from bounce_grader.common.errors import UsageError
from bounce_grader.common.manifest import parts

NAME = "adjustments.csv"
EVERYBODY = "*"
CHANGES = ("points", "percent", "late_days", "cap", "drop")


class Adjustment(NamedTuple):
    """One row of adjustments.csv: what changes for whom, and why."""

    line: int
    student: str  # an id or a name; or EVERYBODY
    points: float = 0.0  # added
    percent: float = 0.0  # of the assignment's points, added
    late_days: int | None = None  # in place of the service's; 0 for an extension
    cap: float | None = None  # the most points
    drop: tuple[str, ...] = ()  # checks whose points are given
    reason: str = ""
    comment: str = ""


def read(out: Path) -> list[Adjustment]:
    """The adjustments; none if there is no such file. Raises UsageError."""
    path = out / NAME
    rows = instructor_table.read(path, ("student", "reason"), (*CHANGES, "comment"))
    return [_adjustment(path, line, cells) for line, cells in rows]


def _adjustment(path: Path, line: int, cells: dict[str, str]) -> Adjustment:
    where = f"{path}, line {line}:"
    for column in ("student", "reason"):
        if not cells[column]:
            raise UsageError(f"{where} the {column} is missing")
    if not any(cells[column] for column in CHANGES):
        raise UsageError(f"{where} it changes nothing; fill in one of {', '.join(CHANGES)}")
    late_days, cap = (_number(where, column, cells) for column in ("late_days", "cap"))
    if late_days is not None and (late_days < 0 or late_days != int(late_days)):
        raise UsageError(f"{where} late_days is a whole number of days, 0 for an extension")
    if cap is not None and cap < 0:
        raise UsageError(f"{where} cap is the most points that are given, and not negative")
    return Adjustment(
        line,
        cells["student"],
        _number(where, "points", cells) or 0.0,
        _number(where, "percent", cells) or 0.0,
        None if late_days is None else int(late_days),
        cap,
        _checks(where, cells["drop"]),
        cells["reason"],
        cells["comment"],
    )


def _number(where: str, column: str, cells: dict[str, str]) -> float | None:
    text = cells[column].replace("\N{MINUS SIGN}", "-").replace(",", ".").removesuffix("%").strip()
    if not text:
        return None
    try:
        number = float(text)
    except ValueError:
        number = float("nan")
    if not abs(number) < 1e6:
        raise UsageError(f"{where} {column} should be a number, and is {cells[column]!r}")
    return number


def _checks(where: str, text: str) -> tuple[str, ...]:
    known = {check.id for part in parts() for check in part.checks}
    names = tuple(filter(None, (name.strip() for name in text.replace(",", ";").split(";"))))
    for name in names:
        if name not in known:
            raise UsageError(f"{where} there is no check {name!r}; grades.csv has their names")
    return names
