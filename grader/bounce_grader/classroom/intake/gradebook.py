"""The gradebook: a file that Canvas (its export), Moodle (its offline grading worksheet), Blackboard
or Brightspace wrote, or what Canvas's API tells. Each has ids, names and points.

Moodle's importer (mod/assign/feedback/offline) finds its columns by their titles, in the site's
language, and a student by the number at the end of the first cell. Their order is always the same:
the name is the second, and after the grade come the most points and whether it can be changed. The
worksheet says how late a submission is, in a cell of pieces (`assign_grading_table::col_status`):

    Submitted for grading - 2 days 3 hours late - Graded - Extension granted until: 20 November 2026

The time is counted from an extension, if there is one. It has the two largest units that aren't 0,
of years, days, hours, minutes and seconds (`format_time`).
"""

import difflib
import json
import re
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from bounce_grader.classroom.intake.table import number_in, Row, Table
from bounce_grader.common.errors import UsageError

CANVAS_IDS = ("ID", "SIS User ID", "SIS Login ID", "Integration ID")
ASSIGNMENT = re.compile(r"\s\(\d+\)$")  # how the title of an assignment ends in Canvas's export
POSTING = re.compile(r"(Muted|Manual Posting.*)?", re.IGNORECASE)
PARTICIPANT = re.compile(r"[^\W\d].*?\s?\d+", re.DOTALL)  # Moodle's first cell: Participant 12345
TOTAL = re.compile(r"\s*\[Total Pts: ([\d.,]+)[^\]]*\]\s*\|\s*\d+\s*$")  # and in Blackboard's file
MOST = re.compile(r"\s+Points Grade(?:\s+<\w+ MaxPoints:([\d.,]+)[^>]*>)?$")  # and in Brightspace's
NAMES = ("Student", "Full name", "LastName", "FirstName", "Last Name", "First Name")
# In Moodle's languages: titles of the column, and what words begin with, by the seconds in a unit.
WORDS = json.loads(Path(__file__).with_name("moodle_words.json").read_text("utf-8"))


class Line(NamedTuple):
    """A student's line."""

    number: int
    ids: Sequence[str]  # each "" where there is none; the service's own is the first
    person: str  # the name, as "Doe, Jane"
    there: str  # the points that stand there; "" if none do
    stays: str = ""  # why it takes no points


@dataclass
class Gradebook:
    """A service's lines, one for each student; without a gradebook, none."""

    service: str = ""
    name: str = ""  # of the file
    title: str = ""  # of the column to fill
    lines: list[Line] = field(default_factory=list)
    possible: list[str] = field(default_factory=list)  # what the file says of the most points
    late: dict[str, int | None] = field(default_factory=dict)  # seconds, by id, if the file tells
    table: Table | None = None
    column: int = 0

    def by_id(self, own: bool = False) -> dict[str, list[Line]]:
        """The lines of each id, or of the service's own, which its importer looks at first."""
        found: dict[str, list[Line]] = {}
        for kind in range(1 if own else len(CANVAS_IDS))[::-1]:
            of_kind: dict[str, list[Line]] = {}
            for line in self.lines:
                for id in filter(None, line.ids[kind : kind + 1]):
                    of_kind.setdefault(id, []).append(line)
            found |= of_kind
        return found

    def people(self, own: bool = False) -> dict[str, Line]:
        """The line of each id that only one has."""
        return {id: of[0] for id, of in self.by_id(own).items() if len(of) == 1}


def read(path: Path, title: str) -> Gradebook:
    """Reads a gradebook of any service; `title` names the column to fill. Raises UsageError."""
    table = Table(path)
    header, firsts = table.header, (row.text(0) for row in table.rows[1:])
    if "Username" in header and any(map(TOTAL.search, header)):
        service, column = "blackboard", _only_column(table, title, TOTAL)
    elif header[0] in ("OrgDefinedId", "Username") and any(map(MOST.search, header)):
        service, column = "brightspace", _only_column(table, title, MOST)
    elif re.fullmatch(r"\W*(Student|LastName)", header[0]) and "ID" in header[1:4]:
        service, column = "canvas", _only_column(table, title, ASSIGNMENT)
    elif any(map(PARTICIPANT.fullmatch, firsts)):
        service, column = "moodle", _column_of_grades(table, title)
    else:
        services = "Canvas (Grades, Export), Moodle (its worksheet), Blackboard or Brightspace"
        raise UsageError(f"{table.name} holds no grades from {services}: export them again")
    book = Gradebook(service, table.name, header[column], table=table, column=column)
    named = service == "moodle" and header[1] not in WORDS["status"]
    titles = [header[0], "Full name", *header[2:]] if named else header
    for number, row in enumerate(table.rows[1:], 1):
        cells = {title: row.text(i) for i, title in enumerate(titles)}
        _add(book, number, defaultdict(str, cells), row)
    table.require_all_cells((table.rows[line.number] for line in book.lines), "download it again")
    return book


def _add(book: Gradebook, number: int, cells: Mapping[str, str], row: Row) -> None:
    """Adds a student's line; or notes what a row says of the most points."""
    first, there, stays = row.text(0), row.text(book.column), ""
    if book.service == "canvas":
        ids = [cells[title] for title in CANVAS_IDS if title in cells]
        if "Points Possible" in first and not ids[0]:  # and no student with such a name
            book.possible.append(there)
            return
        if all(map(POSTING.fullmatch, row.texts())):  # no student for Canvas's importer
            return
        stays = f"stays {there}" if there.upper() in ("EX", "N/A") else ""
    elif book.service == "moodle":
        ids, there = ["".join(re.findall(r"\d+$", first))], "" if there == "-" else there
        if {row.text(book.column + n).lower() for n in (2, 3)} & set(WORDS["no"]):
            stays = "has a grade that Moodle lets nobody change here"
        book.possible.append(row.text(book.column + 1))
        for title in filter(cells.__contains__, WORDS["status"]):
            book.late[ids[0]] = seconds_late(cells[title])
    elif book.service == "brightspace":
        ids = [cells[t].removeprefix("#") for t in ("OrgDefinedId", "Username") if t in cells]
        book.possible += MOST.findall(book.title)
    else:
        ids, there = [cells["Username"]], re.sub(r"(?s)Needs Grading.*", "", there)
        book.possible += TOTAL.findall(book.title)
    name = ", ".join(filter(None, (cells[title] for title in NAMES)))
    book.lines.append(Line(number, ids, name or ids[0], there, stays))


def _column_of_grades(table: Table, title: str) -> int:
    """Moodle's, by its title; or as the column of numbers before the same number in all rows, the
    most points, which has words behind it."""
    columns = list(zip(*(row.texts() for row in table.rows[1:] if any(row.texts()))))
    numbers = [[number_in(cell) for cell in column] for column in columns]
    for i in range(1, len(columns) - 2):
        points = (n is not None or cell in ("", "-") for n, cell in zip(numbers[i], columns[i]))
        most, words = set(numbers[i + 1]), set(numbers[i + 2])
        if not title and all(points) and len(most - {None}) == len(most) == 1 and words == {None}:
            return i
    if not title and "Grade" not in table.header:
        why = "has no column of points, as of an assignment that is graded by a scale"
        raise UsageError(f"{table.name} {why}: name one by --column")
    return _only_column(table, title or "Grade", re.compile(""))


def _only_column(table: Table, title: str, ending: re.Pattern[str]) -> int:
    """The only column with this title, perhaps without its ending. Any will do for ""."""
    choices = list(filter(ending.search, table.header))
    meant = [text for text in choices if title in ("", text, ending.sub("", text))]
    found = [i for i, text in enumerate(table.header) if text in meant and i > 0]
    if len(found) == 1:
        return found[0]
    near = difflib.get_close_matches(title, choices, 3, 0.3) or choices[:3]
    columns = f"{len(found)} columns" if found else "no column"
    name = f"name one by --column, as {', '.join(map(repr, near))}"
    raise UsageError(f"{table.name} has {columns}{title and f' {title!r}'} to fill: {name}")


def seconds_late(status: str) -> int | None:
    """How long after the deadline, by a cell of Moodle's worksheet; None if the words aren't known."""
    late = [*status.split(" - "), ""][1]
    if re.search(r"\d{4}|\d:\d", late):  # the date of an extension
        return 0
    seconds = 0
    for number, word in re.findall(r"(\d+)\s+([^\W\d]+)", late):
        units = [int(s) for s, of in WORDS["units"].items() if word.lower().startswith(tuple(of))]
        if not units:
            return None
        seconds += int(number) * units[0]
    return seconds
