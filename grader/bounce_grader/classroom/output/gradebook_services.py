"""The grade files of Canvas (its export), Moodle (its offline grading worksheet) and Blackboard:
where each has ids, names and points.

Moodle's importer (mod/assign/feedback/offline) finds its columns by their titles, in the site's
language, and a student by the number at the end of the first cell.
"""

import difflib
import re
from collections.abc import Sequence
from pathlib import Path

from bounce_grader.classroom.intake import moodle
from bounce_grader.classroom.output.gradebook import Gradebook, Line, TOTAL
from bounce_grader.classroom.output.table import Row, Table
from bounce_grader.common.errors import UsageError

OTHER_IDS = ("SIS User ID", "SIS Login ID", "Integration ID")  # in Canvas's export
ASSIGNMENT = re.compile(r"\s\(\d+\)$")  # the end of its title there
POSTING = re.compile(r"(Muted|Manual Posting.*)?", re.IGNORECASE)
PARTICIPANT = re.compile(r"[^\W\d].*?\s?\d+", re.DOTALL)  # Moodle's first cell: Participant 12345
BLACKBOARD = re.compile(r"\[Total Pts: ([\d.,]+)[^\]]*\]\s*\|\s*\d+\s*$")  # a column of its file


def read(path: Path, title: str) -> Gradebook:
    """The grade book of whichever service wrote the file; `title` is that of the column to fill.
    Raises UsageError if none did, or if there is no such column."""
    table = Table(path)
    firsts = (row.text(0) for row in table.rows[1:])
    if "Username" in table.header and any(map(BLACKBOARD.search, table.header)):
        return _of_blackboard(table, title)
    of_canvas = re.match(r"\W*(Student|LastName)\b", table.header[0])
    if not of_canvas and any(map(PARTICIPANT.fullmatch, firsts)):
        return _of_moodle(table, title)
    return _of_canvas(table, title)


# --- Canvas: each cell under an assignment's title takes a student's points ---


def _of_canvas(table: Table, title: str) -> Gradebook:
    header, rows = table.header, table.rows[1:]
    one = header[0].endswith("Student") and "ID" in header[1:4]
    two = header[0].endswith("LastName") and header[1:3] == ["FirstName", "ID"]
    if not one and not two:
        raise UsageError(
            f"{table.name} isn't a grade book of Canvas's: its first line has to begin with "
            "Student, ID (in Canvas: Grades, Export)"
        )
    if not title:
        raise UsageError("--gradebook needs --column, the title of the column to fill")
    ids = [header.index(title) for title in ("ID", *OTHER_IDS) if title in header]
    # Canvas's own row, and not a student with such a name.
    points = [r for r in rows if "Points Possible" in r.text(0) and not r.text(ids[0])]
    column = _canvas_column(table, title, ids, points)
    lines = [
        Line(
            row,
            [row.text(i) for i in ids],
            ", ".join(row.text(i) for i in range(ids[0])),
            f"stays {text}" if (text := row.text(column)).upper() in ("EX", "N/A") else "",
        )
        for row in rows
        # Those that Canvas's importer takes for students.
        if row not in points
        and not all(POSTING.fullmatch(row.text(i)) for i in range(len(row.cells)))
    ]
    possible = [row.text(column) for row in points]
    return Gradebook("canvas", table, column, lines, possible, "export it from Canvas again")


def _canvas_column(table: Table, title: str, ids: Sequence[int], points: Sequence[Row]) -> int:
    name, header = table.name, table.header
    assignments = list(filter(ASSIGNMENT.search, header))
    near = difflib.get_close_matches(title, assignments, 3, 0.3) or assignments[:3]
    has = f"it has {', '.join(map(repr, near))}" if near else "it has no assignment at all"
    columns = [i for i, text in enumerate(header) if text == title]
    columns = columns or [i for i, t in enumerate(header) if ASSIGNMENT.sub("", t) == title]
    if len(columns) > 1:
        raise UsageError(
            f"{name} has {len(columns)} columns named {title!r}: name the one you mean with "
            "its number, as in 'HW3 (98765)', and rename the other if they are the same"
        )
    if not columns:
        raise UsageError(f"{name} has no column {title!r}: {has}")
    column = columns[0]
    # The last of the columns that identify a student is the section.
    sections = [i for i, t in enumerate(header) if i > ids[0] and "Section" in t]
    if column <= max([*ids, *sections[:1]]):
        raise UsageError(f"{title!r} in {name} says who a student is, and takes no points: {has}")
    if TOTAL.search(header[column]) or any("read only" in row.text(column) for row in points):
        raise UsageError(f"Canvas doesn't import {title!r}, which is read only")
    return column


# --- worksheets: one column takes the points ---


def _of_moodle(table: Table, title: str) -> Gradebook:
    column = _only_column(table, title, [title or "Grade"], table.header)
    status = next((text for text in table.header if text in moodle.STATUS), "")
    locked = "has a grade that Moodle lets nobody change here: the cell stays as it was"
    lines = [
        Line(
            row,
            ["".join(re.findall(r"\d+$", row.text(0)))],
            _person(table, row),
            locked if _cell(table, row, "Grade can be changed").lower() == "no" else "",
            moodle.days_late(_cell(table, row, status)),
        )
        for row in table.rows[1:]
    ]
    possible = [_cell(table, row, "Maximum Grade") for row in table.rows[1:]]
    tells = bool(status)
    return Gradebook("moodle", table, column, lines, possible, no_points="-", tells_lateness=tells)


def _of_blackboard(table: Table, title: str) -> Gradebook:
    """Points stand in a column whose title tells the total points. Often UTF-16 with tabs."""
    own = list(filter(BLACKBOARD.search, table.header))
    meant = [t for t in own if title in ("", t, t.partition(" [Total Pts")[0].strip())]
    column = _only_column(table, title, meant, own)
    lines = [
        Line(row, [_cell(table, row, "Username")], _person(table, row)) for row in table.rows[1:]
    ]
    possible, no_points = BLACKBOARD.findall(table.header[column]), r"(?s)Needs Grading.*"
    return Gradebook("blackboard", table, column, lines, possible, no_points=no_points)


def _only_column(table: Table, title: str, meant: list[str], choices: list[str]) -> int:
    """The column whose title is among those that are meant."""
    found = [i for i, text in enumerate(table.header) if text in meant and i > 0]
    if len(found) == 1:
        return found[0]
    raise UsageError(
        f"{table.name} has {len(found) or 'no'} column{'s' * (len(found) != 1)} "
        f"{title or 'that is meant'!r}: give --column one of {', '.join(map(repr, choices))}"
    )


def _cell(table: Table, row: Row, title: str) -> str:
    """The text under a title; "" if there is no such column."""
    return row.text(table.header.index(title)) if title in table.header else ""


def _person(table: Table, row: Row) -> str:
    names = [_cell(table, row, title) for title in ("Last Name", "First Name")]
    own = re.findall(r"\d+$", row.text(0)) or [_cell(table, row, "Username")]
    return _cell(table, row, "Full name") or ", ".join(filter(None, names)) or own[0]
