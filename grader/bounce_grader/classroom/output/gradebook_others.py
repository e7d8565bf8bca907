"""The grade files of Moodle (its offline grading worksheet) and of Blackboard.

Moodle's importer (mod/assign/feedback/offline) finds its columns by their titles, in the site's
language, and a student by the number at the end of the first cell.
"""

import re
from collections.abc import Mapping

from bounce_grader.classroom.intake import moodle
from bounce_grader.classroom.output.gradebook import Gradebook
from bounce_grader.classroom.output.table import Row, Table
from bounce_grader.common.errors import UsageError

PARTICIPANT = re.compile(r"[^\W\d].*?\s?\d+", re.DOTALL)  # Moodle's first cell: Participant 12345
TOTAL = re.compile(r"\[Total Pts: ([\d.,]+)[^\]]*\]\s*\|\s*\d+\s*$")  # of a Blackboard column


class Worksheet(Gradebook):
    """One column takes the total."""

    again = "download it again"

    def __init__(
        self, table: Table, name: str, columns: Mapping[int, str], max_points: Mapping[int, float]
    ) -> None:
        if columns.keys() - {0}:
            raise UsageError("--part-column fills Canvas's export alone: leave it out")
        super().__init__(table, name, columns or {0: ""}, max_points)

    def _students(self) -> list[Row]:
        return self._table.rows[1:]

    def _choices(self) -> list[str]:
        """The titles of columns that take points."""
        return self._header

    def _meant(self, title: str) -> list[str]:
        """The titles that a person may mean by this one."""
        return [title or "Grade"]

    def _column(self, title: str) -> int:
        titles = self._meant(title)
        found = [i for i, text in enumerate(self._header) if text in titles and i > 0]
        if len(found) == 1:
            return found[0]
        raise UsageError(
            f"{self._name} has {len(found) or 'no'} column{'s' * (len(found) != 1)} "
            f"{title or 'that is meant'!r}: give --column one of "
            f"{', '.join(map(repr, self._choices()))}"
        )

    def _person(self, row: Row) -> str:
        names = [self._cell(row, title) for title in ("Last Name", "First Name")]
        return ", ".join(filter(None, names)) or self._ids(row)[0]

    def _cell(self, row: Row, title: str) -> str:
        """The text under a title; "" if there is no such column."""
        there = title in self._header
        return row.cells[self._header.index(title)].text.strip() if there else ""


class MoodleWorksheet(Worksheet):
    """Finds points under "Grade", and how late a student is under "Status"."""

    service = "moodle"

    def _ids(self, row: Row) -> list[str]:
        number = re.search(r"\d+$", row.cells[0].text.strip())
        return [number.group() if number else ""]

    def _person(self, row: Row) -> str:
        return self._cell(row, "Full name") or super()._person(row)

    def _points(self, row: Row, column: int) -> str:
        text = super()._points(row, column)
        return "" if text == "-" else text

    def _never_filled(self, row: Row, column: int) -> str:
        if self._cell(row, "Grade can be changed").lower() != "no":
            return ""
        return "has a grade that Moodle lets nobody change here: the cell stays as it was"

    def _points_possible(self, part: int) -> set[str]:
        return {self._cell(row, "Maximum Grade") for row in self._students()}

    def _score_columns(self) -> set[int]:
        maximum = {i for i, title in enumerate(self._header) if title == "Maximum Grade"}
        return super()._score_columns() | maximum

    def days_late(self) -> dict[str, int | None]:
        column = next((i for i, title in enumerate(self._header) if title in moodle.STATUS), None)
        if column is None:
            return {}
        rows = self._rows_by_id(own_ids_only=True)
        return {id: moodle.days_late(of_id[0].cells[column].text) for id, of_id in rows.items()}


class BlackboardWorksheet(Worksheet):
    """Finds points in a column whose title tells the total points; often UTF-16 with tabs."""

    service = "blackboard"

    def _ids(self, row: Row) -> list[str]:
        return [self._cell(row, "Username")]

    def _points(self, row: Row, column: int) -> str:
        text = super()._points(row, column)
        return "" if text.startswith("Needs Grading") else text

    def _points_possible(self, part: int) -> set[str]:
        total = TOTAL.search(self._header[self._columns[part]])
        return {total.group(1)} if total else set()

    def _choices(self) -> list[str]:
        return list(filter(TOTAL.search, self._header))

    def _meant(self, title: str) -> list[str]:
        own = self._choices()
        return [t for t in own if not title or title in (t, t.partition(" [Total Pts")[0].strip())]


def is_blackboard(table: Table) -> bool:
    header = table.header()
    return "Username" in header and any(map(TOTAL.search, header))


def is_moodle(table: Table) -> bool:
    first = table.header()[0]
    of_canvas = re.match(r"\W*(Student|LastName)\b", first)
    firsts = (row.cells[0].text.strip() for row in table.rows[1:])
    return not of_canvas and any(map(PARTICIPANT.fullmatch, firsts))
