"""Reads what an instructor writes by hand into the output folder: course.toml, with the assignment's
title and what lateness costs; roster.csv, which says whose a submission is; and adjustments.csv,
with what is changed in the points of a student, and why."""

import sys
from collections.abc import Iterator, Sequence
from importlib import import_module
from pathlib import Path
from typing import NamedTuple

from bounce_grader.classroom.intake.student import Adjustment, Member
from bounce_grader.classroom.intake.table import number_in, Table
from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.manifest import parts

COURSE, ROSTER, ADJUSTMENTS = "course.toml", "roster.csv", "adjustments.csv"
LATE = ("percent_per_day", "at_most_percent")
EVERYBODY = "*"
Words = Sequence[str]
CHANGES = ("points", "late_days", "cap", "drop")


class Course(NamedTuple):
    """The course's title and its policy on lateness, from course.toml."""

    title: str = ""
    percent_per_day: float = 0.0  # of the assignment's points, for each day begun
    at_most_percent: float = 100.0


def course(out: Path) -> Course:
    """The course's policy; without such a file, lateness costs nothing. Raises UsageError."""
    path = out / COURSE
    if not path.exists():
        return Course()
    try:  # Python has a reader of TOML from 3.11 on, which was made from tomli
        toml = import_module("tomllib" if sys.version_info >= (3, 11) else "tomli")
        data = toml.loads(path.read_text("utf-8"))
    except ModuleNotFoundError as error:
        raise KitError(f"{COURSE} can't be read here: apt-get install python3-tomli") from error
    except (OSError, ValueError) as error:
        raise UsageError(f"{path} can't be read as TOML: {error}") from error
    title, late = data.pop("title", ""), data.pop("late", {})
    known = isinstance(title, str) and isinstance(late, dict) and late.keys() <= set(LATE)
    numbers = known and all(type(x) in (int, float) and 0 <= x <= 100 for x in late.values())
    if data or not numbers:
        late = f"{' and '.join(LATE)}, numbers from 0 to 100"
        raise UsageError(f"{path} takes a title, and under [late] {late}")
    return Course(title, **late)


def roster(out: Path) -> Iterator[tuple[str, Member]]:
    """Each member with a submission: a login, or the name of a folder or group. Raises UsageError."""
    path = out / ROSTER
    seen: dict[str, int] = {}
    for line, row in _rows(path, ("submission", "id"), ("name",)):
        submission, id = row["submission"], row["id"]
        if not submission or not id:
            raise UsageError(f"{path} lacks the submission or the id in line {line}: fill it in")
        if id in seen:
            raise UsageError(f"{path} has {id} in lines {seen[id]} and {line}: keep one of them")
        seen[id] = line
        yield submission, Member(id, row["name"], True)


def adjustments(out: Path) -> list[Adjustment]:
    """Raises UsageError."""
    rows = _rows(out / ADJUSTMENTS, ("student", "reason"), (*CHANGES, "comment"))
    return [_adjustment(out / ADJUSTMENTS, line, row) for line, row in rows]


def _adjustment(path: Path, line: int, row: dict[str, str]) -> Adjustment:
    where = f"{path}, line {line}:"
    if not (row["student"] and row["reason"] and any(row[column] for column in CHANGES)):
        raise UsageError(f"{where} fill in student, reason and one of {', '.join(CHANGES)}")
    points, late_days, cap = (_number(where, column, row) for column in CHANGES[:3])
    if min(late_days or 0, cap or 0) < 0 or (late_days or 0) % 1:
        raise UsageError(f"{where} late_days is a whole number, and neither it nor cap is negative")
    drop, why = _checks(where, row["drop"]), (row["reason"], row["comment"])
    short = f"{ADJUSTMENTS}, line {line}:"
    return Adjustment(short, row["student"], points or 0.0, late_days, cap, drop, *why)


def _number(where: str, column: str, row: dict[str, str]) -> float | None:
    number = number_in(row[column].replace("\N{MINUS SIGN}", "-"))
    if row[column] and not (number is not None and abs(number) < 1e6):
        raise UsageError(f"{where} {column} should be a number, and is {row[column]!r}")
    return number


def _checks(where: str, text: str) -> tuple[str, ...]:
    known = {check.id for part in parts() for check in part.checks}
    names = tuple(filter(None, map(str.strip, text.replace(",", ";").split(";"))))
    for name in names:
        if name not in known:
            raise UsageError(f"{where} there is no check {name!r}; grades.csv has their names")
    return names


def _rows(path: Path, needed: Words, more: Words) -> list[tuple[int, dict[str, str]]]:
    """The line and the cells, by column, of each row that isn't empty; none without such a file.
    Columns may be in any order. Raises UsageError."""
    if not path.exists():
        return []
    table = Table(path)
    header = [title.lower() for title in table.header]
    if not set(needed) <= set(header) <= {*needed, *more} or len(set(header)) < len(header):
        takes = f"it takes {' and '.join(needed)}, and any of {', '.join(more)}, each once"
        raise UsageError(f"{path} has the columns {', '.join(header)}: {takes}")
    rows = [row for row in table.rows[1:] if any(row.texts())]
    table.require_all_cells(rows, "put texts with commas into quotation marks")
    empty = dict.fromkeys(more, "")
    return [(row.line, empty | dict(zip(header, row.texts()))) for row in rows]
