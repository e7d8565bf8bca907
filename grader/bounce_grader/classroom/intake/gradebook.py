"""The grade book: a file that Canvas (its export), Moodle (its offline grading worksheet) or
Blackboard wrote, or what Canvas's API tells. Each has ids, names and points.

Moodle's importer (mod/assign/feedback/offline) finds its columns by their titles, in the site's
language, and a student by the number at the end of the first cell. Its worksheet says how late a
submission is, in a cell that is made of pieces (`assign_grading_table::col_status`):

    Submitted for grading - 2 days 3 hours late - Graded - Extension granted until: 20 November 2026

The time is counted from an extension, if there is one. It has the two largest units that aren't 0,
of years, days, hours, minutes and seconds (`format_time`).
"""

import difflib
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from bounce_grader.classroom.intake.table import Table
from bounce_grader.common.errors import UsageError

CANVAS_IDS = ("ID", "SIS User ID", "SIS Login ID", "Integration ID")
ASSIGNMENT = re.compile(r"\s\(\d+\)$")  # how the title of an assignment ends in Canvas's export
POSTING = re.compile(r"(Muted|Manual Posting.*)?", re.IGNORECASE)
PARTICIPANT = re.compile(r"[^\W\d].*?\s?\d+", re.DOTALL)  # Moodle's first cell: Participant 12345
TOTAL = re.compile(r"\s*\[Total Pts: ([\d.,]+)[^\]]*\]\s*\|\s*\d+\s*$")  # and in Blackboard's file
NAMES = ("Student", "Full name", "LastName", "FirstName", "Last Name", "First Name")
STATUS = (  # titles of Moodle's column
    *("Status", "Statut", "Estado", "Estatus", "Estat", "Stato", "Stav", "Tila", "Durum"),
    *("Állapot", "Stare", "Состояние", "Статус", "Стан", "Κατάσταση", "ステータス", "状态", "狀態", "상태"),
)
UNITS = {  # what the words for a unit begin with, by the days in it
    365: "year|jahr|an|añ|jaar|år|rok|vuo|yıl|év|год|рік|年|년",
    1: "day|tag|jour|día|dia|dies|giorn|dag|dzie|dni|den|dn|päiv|gün|nap|zi|день|дн|ημέρ|日|天|일",
    0: "hour|hr|stunde|heure|hora|hore|ora|ore|óra|uur|uren|timm|time|godz|hod|tunti|saat|час|годин"
    "|ώρ|時間|小时|小時|시간|min|мин|хв|λεπτ|perc|dakika|分|분|sec|sek|seg|saniye|сек|δευτ|秒|초",
}


class Line(NamedTuple):
    """A student's line."""

    number: int
    ids: Sequence[str]  # each "" where there is none; the service's own is the first
    person: str  # the name, as "Doe, Jane"
    there: str  # the points that stand there; "" if none do
    stays: str = ""  # why it takes no points

    @property
    def who(self) -> str:
        return f"{self.person} ({next(filter(None, self.ids), 'without an ID')})"


@dataclass
class Gradebook:
    """A service's lines, one for each student; without a grade book, none."""

    service: str = ""
    name: str = ""  # of the file
    title: str = ""  # of the column to fill
    lines: Sequence[Line] = ()
    possible: Sequence[str] = ()  # what the file says of the most points
    late: Mapping[str, int | None] = field(default_factory=dict)  # days, by id, if the file tells
    table: Table | None = None
    column: int = 0

    def __post_init__(self) -> None:
        self.by_own_id = self._by_id(1)
        self.by_any_id = self._by_id(len(CANVAS_IDS))

    def _by_id(self, kinds: int) -> dict[str, list[Line]]:
        """The lines of each id, of the first kinds; the service's own take precedence, as in its
        importer."""
        found: dict[str, list[Line]] = {}
        for kind in reversed(range(kinds)):
            of_kind: dict[str, list[Line]] = {}
            for line in self.lines:
                for id in filter(None, line.ids[kind : kind + 1]):
                    of_kind.setdefault(id, []).append(line)
            found |= of_kind
        return found


def only_one(lines: Mapping[str, Sequence[Line]]) -> dict[str, Line]:
    """The line of each id that only one has."""
    return {id: of[0] for id, of in lines.items() if len(of) == 1}


def read(path: Path, title: str) -> Gradebook:
    """The file of whichever service wrote it; `title` is that of the column to fill. Raises
    UsageError if none did, or if there is no such column."""
    table = Table(path)
    header, firsts = table.header, (row.text(0) for row in table.rows[1:])
    if "Username" in header and any(map(TOTAL.search, header)):
        return _of_blackboard(table, title)
    if re.fullmatch(r"\W*(Student|LastName)", header[0]) and "ID" in header[1:4]:
        return _of_canvas(table, title)
    if any(map(PARTICIPANT.fullmatch, firsts)):
        return _of_moodle(table, title or "Grade")
    services = "Canvas (Grades, Export), Moodle (its worksheet) or Blackboard"
    raise UsageError(f"{table.name} holds no grades from {services}: export them again")


def _of_canvas(table: Table, title: str) -> Gradebook:
    column = _only_column(table, title, ASSIGNMENT)
    lines, possible = [], []
    for number, row in enumerate(table.rows[1:], 1):
        cells, there = table.by_title(row), row.text(column)
        ids = [cells[title] for title in CANVAS_IDS if title in cells]
        if "Points Possible" in row.text(0) and not ids[0]:  # and no student with such a name
            possible.append(there)
        elif not all(map(POSTING.fullmatch, row.texts())):  # as for Canvas's importer
            stays = f"stays {there}" if there.upper() in ("EX", "N/A") else ""
            lines.append(_line(number, ids, cells, there, stays))
    return _book("canvas", table, column, lines, possible)


def _of_moodle(table: Table, title: str) -> Gradebook:
    column = _only_column(table, title, re.compile(""))
    status = next((title for title in table.header if title in STATUS), "")
    lines, possible = [], []
    late: dict[str, int | None] = {}
    for number, row in enumerate(table.rows[1:], 1):
        cells, there = table.by_title(row), row.text(column)
        ids = ["".join(re.findall(r"\d+$", row.text(0)))]
        locked = cells.get("Grade can be changed", "").lower() == "no"
        stays = "has a grade that Moodle lets nobody change here" if locked else ""
        lines.append(_line(number, ids, cells, "" if there == "-" else there, stays))
        possible.append(cells.get("Maximum Grade", ""))
        if status:
            late[ids[0]] = days_late(cells[status])
    return _book("moodle", table, column, lines, possible, late)


def _of_blackboard(table: Table, title: str) -> Gradebook:
    """Often UTF-16 with tabs."""
    column = _only_column(table, title, TOTAL)
    lines = []
    for number, row in enumerate(table.rows[1:], 1):
        cells = table.by_title(row)
        there = re.sub(r"(?s)Needs Grading.*", "", row.text(column))
        lines.append(_line(number, [cells["Username"]], cells, there))
    return _book("blackboard", table, column, lines, TOTAL.findall(table.header[column]))


def _line(
    number: int, ids: Sequence[str], cells: Mapping[str, str], there: str, stays: str = ""
) -> Line:
    names = ", ".join(filter(None, (cells.get(title, "") for title in NAMES)))
    return Line(number, ids, names or ids[0], there, stays)


def _book(
    service: str,
    table: Table,
    column: int,
    lines: Sequence[Line],
    possible: Sequence[str],
    late: Mapping[str, int | None] = {},
) -> Gradebook:
    table.require_all_cells((table.rows[line.number] for line in lines), "download it again")
    title = table.header[column]
    return Gradebook(service, table.name, title, lines, possible, late, table, column)


def _only_column(table: Table, title: str, ending: re.Pattern[str]) -> int:
    """The only column with this title, perhaps without its ending. Any will do for ""."""
    choices = list(filter(ending.search, table.header))
    meant = [text for text in choices if title in ("", text, ending.sub("", text))]
    found = [i for i, text in enumerate(table.header) if text in meant and i > 0]
    if len(found) == 1:
        return found[0]
    near = difflib.get_close_matches(title, choices, 3, 0.3) or choices[:3]
    raise UsageError(
        f"{table.name} has {f'{len(found)} columns' if found else 'no column'}"
        f"{title and f' {title!r}'} to fill: name one by --column, as {', '.join(map(repr, near))}"
    )


def days_late(status: str) -> int | None:
    """How many days are begun after the deadline, by a cell of Moodle's worksheet; None if the words
    aren't known. Full hours count, so that "2 days late" is two days."""
    pieces = status.split(" - ")
    late = pieces[1] if len(pieces) > 1 else ""
    if re.search(r"\d{4}|\d:\d", late):  # the date of an extension
        return 0
    days, begun = 0, False
    for number, word in re.findall(r"(\d+)\s+([^\W\d]+)", late):
        unit = next((d for d, words in UNITS.items() if re.match(words, word.lower())), None)
        if unit is None:
            return None
        days += int(number) * unit
        begun = begun or unit == 0
    return days + begun
