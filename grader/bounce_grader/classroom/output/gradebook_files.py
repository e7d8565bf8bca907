"""The grade files of Canvas (its export), Moodle (its offline grading worksheet) and Blackboard:
where each has ids, names and points. Each cell that isn't filled in stays the same.

Moodle's importer (mod/assign/feedback/offline) finds its columns by their titles, in the site's
language, and a student by the number at the end of the first cell.
"""

import difflib
import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.intake import moodle
from bounce_grader.classroom.intake.instructor_files import ROSTER
from bounce_grader.classroom.intake.student import Class
from bounce_grader.classroom.intake.table import Row, Table
from bounce_grader.classroom.output.gradebook import Gradebook, Line, WRITTEN
from bounce_grader.common.errors import UsageError
from bounce_grader.common.files import read_object, write_whole

OTHER_IDS = ("SIS User ID", "SIS Login ID", "Integration ID")  # in Canvas's export
ASSIGNMENT = re.compile(r"\s\(\d+\)$")  # the end of its title there
POSTING = re.compile(r"(Muted|Manual Posting.*)?", re.IGNORECASE)
PARTICIPANT = re.compile(r"[^\W\d].*?\s?\d+", re.DOTALL)  # Moodle's first cell: Participant 12345
BLACKBOARD = re.compile(r"\[Total Pts: ([\d.,]+)[^\]]*\]\s*\|\s*\d+\s*$")  # a column of its file


class File(NamedTuple):
    """A grade file, and the column to fill."""

    book: Gradebook
    table: Table
    column: int


def read(path: Path, title: str) -> File:
    """The file of whichever service wrote it; `title` is that of the column to fill. Raises
    UsageError if none did, or if there is no such column."""
    table = Table(path)
    header, firsts = table.header, (row.text(0) for row in table.rows[1:])
    if "Username" in header and any(map(BLACKBOARD.search, header)):
        return _of_blackboard(table, title)
    if re.fullmatch(r"\W*(Student|LastName)", header[0]) and "ID" in header[1:4]:
        return _of_canvas(table, title)
    if any(map(PARTICIPANT.fullmatch, firsts)):
        return _of_moodle(table, title)
    services = "Canvas (Grades, Export), Moodle (its worksheet) or Blackboard"
    raise UsageError(f"{table.name} holds no grades from {services}: export them again")


def _of_canvas(table: Table, title: str) -> File:
    """Each cell under an assignment's title takes a student's points."""
    header, rows = table.header, table.rows[1:]
    assignments = list(filter(ASSIGNMENT.search, header))
    meant = [text for text in assignments if title in ("", text, ASSIGNMENT.sub("", text))]
    column = _only_column(table, title, meant, assignments)
    ids = [header.index(title) for title in ("ID", *OTHER_IDS) if title in header]
    # Canvas's own row, and not a student with such a name.
    points = [r for r in rows if "Points Possible" in r.text(0) and not r.text(ids[0])]
    lines = [
        Line(
            number,
            [row.text(i) for i in ids],
            ", ".join(row.text(i) for i in range(ids[0])),
            row.text(column),
            f"stays {row.text(column)}" if row.text(column).upper() in ("EX", "N/A") else "",
        )
        for number, row in enumerate(rows, 1)
        # Those that Canvas's importer takes for students.
        if row not in points and not all(map(POSTING.fullmatch, row.texts()))
    ]
    return _file("canvas", table, column, lines, [row.text(column) for row in points])


def _of_moodle(table: Table, title: str) -> File:
    column = _only_column(table, title, [title or "Grade"], table.header)
    status = next((text for text in table.header if text in moodle.STATUS), "")
    locked = "has a grade that Moodle lets nobody change here"
    lines = [
        Line(
            number,
            ["".join(re.findall(r"\d+$", row.text(0)))],
            _person(table, row),
            row.text(column) if row.text(column) != "-" else "",
            locked if _cell(table, row, "Grade can be changed").lower() == "no" else "",
            moodle.days_late(_cell(table, row, status)),
        )
        for number, row in enumerate(table.rows[1:], 1)
    ]
    possible = [_cell(table, row, "Maximum Grade") for row in table.rows[1:]]
    return _file("moodle", table, column, lines, possible, bool(status))


def _of_blackboard(table: Table, title: str) -> File:
    """Points stand in a column whose title tells the total points. Often UTF-16 with tabs."""
    own = list(filter(BLACKBOARD.search, table.header))
    meant = [t for t in own if title in ("", t, t.partition(" [Total Pts")[0].strip())]
    column = _only_column(table, title, meant, own)
    lines = [
        Line(
            number,
            [_cell(table, row, "Username")],
            _person(table, row),
            re.sub(r"(?s)Needs Grading.*", "", row.text(column)),
        )
        for number, row in enumerate(table.rows[1:], 1)
    ]
    possible = BLACKBOARD.findall(table.header[column])
    return _file("blackboard", table, column, lines, possible)


def _file(
    service: str,
    table: Table,
    column: int,
    lines: Sequence[Line],
    possible: Sequence[str],
    tells_lateness: bool = False,
) -> File:
    title = table.header[column]
    table.require_all_cells((table.rows[line.number] for line in lines), "download it again")
    book = Gradebook(service, table.name, title, lines, possible, tells_lateness)
    return File(book, table, column)


def _only_column(table: Table, title: str, meant: list[str], choices: list[str]) -> int:
    """The column whose title is among those that are meant."""
    found = [i for i, text in enumerate(table.header) if text in meant and i > 0]
    if len(found) == 1:
        return found[0]
    near = difflib.get_close_matches(title, choices, 3, 0.3) or choices[:3]
    raise UsageError(
        f"{table.name} has {f'{len(found)} columns' if found else 'no column'}"
        f"{title and f' {title!r}'} to fill: name one by --column, as {', '.join(map(repr, near))}"
    )


def _cell(table: Table, row: Row, title: str) -> str:
    """The text under a title; "" if there is no such column."""
    return row.text(table.header.index(title)) if title in table.header else ""


def _person(table: Table, row: Row) -> str:
    names = [_cell(table, row, title) for title in ("Last Name", "First Name")]
    own = re.findall(r"\d+$", row.text(0)) or [_cell(table, row, "Username")]
    return _cell(table, row, "Full name") or ", ".join(filter(None, names)) or own[0]


def write(
    path: Path, submitted: Class, summaries: Sequence[Summary], file: File, overwrite: bool
) -> list[str]:
    """Fills the grade book in, for everyone who has a score: a missing one must not become a zero. A
    submission that is known by its GitHub login alone gets no points: its student could have chosen
    somebody else's id as a login. Returns sentences for the instructor."""
    finals = [one._replace(name=one.name or s.student.shown) for s in summaries for one in s.finals]
    given = [one for one in finals if one.listed or not submitted.logins]
    written = read_object(path.with_name(WRITTEN))
    lacking = _lacking(file.book, written.get(file.book.title, {}))
    from_canvas = submitted.service == "canvas"
    filled, sentences = file.book.fill(given, from_canvas, written, overwrite)
    has_comma = any("," in points for points in file.book.possible)
    for line, points in filled:
        text = f"{points:.2f}".replace(".", "," if has_comma else ".")
        file.table.rows[line.number].cells[file.column] = text
    write_whole(path, file.table.encoded())
    write_whole(path.with_name(WRITTEN), json.dumps(written, indent=1, sort_keys=True))
    left_out = [one for one in finals if one not in given]
    return [
        *lacking,
        *sentences,
        *(f"{one.id} isn't in {ROSTER}: the points are in grades.csv" for one in left_out),
    ]


def _lacking(book: Gradebook, written: Mapping[str, Sequence[str]]) -> list[str]:
    """Corrections since an earlier run can't be seen in an old file."""
    emptied = sum(line.ids[0] in written and not line.there for line in book.lines)
    return [
        f"{book.name} lacks what an earlier run has filled into {emptied} "
        f"cell{'s' * (emptied > 1)}: if that is imported, export the grades again, or "
        "corrections made there since then are lost"
    ] * bool(emptied)
