"""Reads the tables that an instructor writes by hand into the output folder: roster.csv, which says
whose a submission is; adjustments.csv, with what is changed in the points of a student, and why; and
comments.csv, with what is said about lines of a student's code."""

import re
from collections.abc import Iterator
from pathlib import Path

from bounce_grader.classroom.intake.student import Adjustment, Comment, Member
from bounce_grader.classroom.intake.table import number_in, rows_of
from bounce_grader.common.errors import UsageError
from bounce_grader.common.manifest import parts

ROSTER, ADJUSTMENTS, COMMENTS = "roster.csv", "adjustments.csv", "comments.csv"
EVERYBODY = "*"
CHANGES = ("points", "late_days", "drop")
MOVED = {"cap": "in place of cap, write 'at most 60' under points"}  # columns that are no more
# How many points: added, or with one of these words, set.
POINTS = re.compile(r"(=|exactly|at least|at most)?\s*(.*)", re.IGNORECASE | re.DOTALL)
FORMS = "a number that is added, as -5, or '= 85', 'at least 85' or 'at most 85'"


def roster(out: Path) -> Iterator[tuple[str, Member]]:
    """Each member with a submission: a login, or the name of a folder or group. Raises UsageError."""
    path = out / ROSTER
    seen: dict[str, int] = {}
    for line, row in rows_of(path, ("submission", "id"), ("name",)):
        submission, id = row["submission"], row["id"]
        if not submission or not id:
            raise UsageError(f"{path} lacks the submission or the id in line {line}: fill it in")
        if id in seen:
            raise UsageError(f"{path} has {id} in lines {seen[id]} and {line}: keep one of them")
        seen[id] = line
        yield submission, Member(id, row["name"], True)


def adjustments(out: Path) -> list[Adjustment]:
    """Raises UsageError."""
    rows = rows_of(out / ADJUSTMENTS, ("student", "reason"), (*CHANGES, "comment"), MOVED)
    return [_adjustment(out / ADJUSTMENTS, line, row) for line, row in rows]


def _adjustment(path: Path, line: int, row: dict[str, str]) -> Adjustment:
    where = f"{path}, line {line}:"
    if not (row["student"] and row["reason"] and any(row[column] for column in CHANGES)):
        raise UsageError(f"{where} fill in student, reason and one of {', '.join(CHANGES)}")
    word, number = POINTS.findall(row["points"])[0]
    sets = word.lower().replace("exactly", "=")
    points = number_in(number.replace("\N{MINUS SIGN}", "-"))
    is_right = points is not None and abs(points) < 1e6 and (points >= 0 or not sets)
    if row["points"] and not is_right:
        raise UsageError(f"{where} points should be {FORMS}, and is {row['points']!r}")
    if not re.fullmatch(r"\d{0,4}", row["late_days"]):
        raise UsageError(f"{where} late_days is a whole number, and no {row['late_days']!r}")
    late_days = int(row["late_days"]) if row["late_days"] else None
    change = (points or 0.0, sets, late_days, _checks(where, row["drop"]))
    short = f"{ADJUSTMENTS}, line {line}:"
    return Adjustment(short, row["student"], *change, row["reason"], row["comment"])


def _checks(where: str, text: str) -> tuple[str, ...]:
    known = {check.id for part in parts() for check in part.checks}
    names = tuple(filter(None, map(str.strip, text.replace(",", ";").split(";"))))
    for name in names:
        if name not in known:
            raise UsageError(f"{where} there is no check {name!r}; grades.csv has their names")
    return names


def comments(out: Path) -> list[Comment]:
    """Raises UsageError."""
    found, needed = [], ("student", "file", "line", "text")
    for line, row in rows_of(out / COMMENTS, needed, ("code",)):
        where = f"{out / COMMENTS}, line {line}:"
        if not all(row[column] for column in needed):
            raise UsageError(f"{where} fill in {', '.join(needed)}")
        if not re.fullmatch("0*[1-9][0-9]{0,8}", row["line"]):
            raise UsageError(f"{where} line should be the number of a line, and is {row['line']!r}")
        words = (row["student"], row["file"], int(row["line"]), row["text"], row["code"])
        found.append(Comment(line, *words))
    return found
