"""The grade files of Canvas (its export), Moodle (its offline grading worksheet) and Blackboard:
where each has ids, names and points.

Moodle's importer (mod/assign/feedback/offline) finds its columns by their titles, in the site's
language, and a student by the number at the end of the first cell.
"""

import difflib
import re
from collections.abc import Iterable
from pathlib import Path

from bounce_grader.classroom.intake import moodle
from bounce_grader.classroom.output.gradebook import Gradebook, TOTAL
from bounce_grader.classroom.output.table import Row, Table
from bounce_grader.common.errors import UsageError

OTHER_IDS = ("SIS User ID", "SIS Login ID", "Integration ID")  # in Canvas's export
ASSIGNMENT = re.compile(r"\s\(\d+\)$")  # the end of its title there
POSTING = re.compile(r"(Muted|Manual Posting.*)?", re.IGNORECASE)
PARTICIPANT = re.compile(r"[^\W\d].*?\s?\d+", re.DOTALL)  # Moodle's first cell: Participant 12345
BLACKBOARD = re.compile(r"\[Total Pts: ([\d.,]+)[^\]]*\]\s*\|\s*\d+\s*$")  # a column of its file


def read(path: Path, title: str) -> Gradebook:
    """The grade book of whichever service wrote the file. Raises UsageError if none did."""
    table = Table(path)
    firsts = (row.text(0) for row in table.rows[1:])
    if "Username" in table.header and any(map(BLACKBOARD.search, table.header)):
        return BlackboardWorksheet(table, title)
    of_canvas = re.match(r"\W*(Student|LastName)\b", table.header[0])
    if not of_canvas and any(map(PARTICIPANT.fullmatch, firsts)):
        return MoodleWorksheet(table, title)
    return CanvasGradebook(table, title)


class CanvasGradebook(Gradebook):
    """Each cell under an assignment's title takes a student's points."""

    service = "canvas"
    again = "export it from Canvas again"

    def __init__(self, table: Table, title: str) -> None:
        header = table.header
        one = header[0].endswith("Student") and "ID" in header[1:4]
        two = header[0].endswith("LastName") and header[1:3] == ["FirstName", "ID"]
        if not one and not two:
            raise UsageError(
                f"{table.name} isn't a grade book of Canvas's: its first line has to begin with "
                "Student, ID (in Canvas: Grades, Export)"
            )
        if not title:
            raise UsageError("--gradebook needs --column, the title of the column to fill")
        self._id_columns = [header.index(title) for title in ("ID", *OTHER_IDS) if title in header]
        super().__init__(table, title)

    def _ids(self, row: Row) -> list[str]:
        return [row.text(column) for column in self._id_columns]

    def _person(self, row: Row) -> str:
        return ", ".join(row.text(column) for column in range(self._id_columns[0]))

    def _never_filled(self, row: Row) -> str:
        text = row.text(self._column)
        return f"stays {text}" if text.upper() in ("EX", "N/A") else ""

    def _students(self) -> list[Row]:
        """The rows that Canvas's importer takes for students."""
        return [
            row
            for row in super()._students()
            if not self._is_of_points(row)
            and not all(POSTING.fullmatch(row.text(i)) for i in range(len(row.cells)))
        ]

    def _is_of_points(self, row: Row) -> bool:
        """Whether it is Canvas's own row, and not a student with such a name."""
        return "Points Possible" in row.text(0) and not self._ids(row)[0]

    def _points_possible(self) -> list[str]:
        return self._beside_points(self._column)

    def _beside_points(self, column: int) -> list[str]:
        return [row.text(column) for row in filter(self._is_of_points, super()._students())]

    def _find_column(self, title: str) -> int:
        name, header = self.table.name, self.table.header
        columns = [i for i, text in enumerate(header) if text == title]
        columns = columns or [i for i, t in enumerate(header) if ASSIGNMENT.sub("", t) == title]
        if len(columns) > 1:
            raise UsageError(
                f"{name} has {len(columns)} columns named {title!r}: name the one you mean with "
                "its number, as in 'HW3 (98765)', and rename the other if they are the same"
            )
        if not columns:
            raise UsageError(f"{name} has no column {title!r}: {self._suggestion(title)}")
        column = columns[0]
        # The last of the columns that identify a student is the section.
        sections = [i for i, t in enumerate(header) if i > self._id_columns[0] and "Section" in t]
        if column <= max([*self._id_columns, *sections[:1]]):
            raise UsageError(
                f"{title!r} in {name} says who a student is, and takes no points: "
                f"{self._suggestion(title)}"
            )
        read_only = any("read only" in text for text in self._beside_points(column))
        if read_only or TOTAL.search(header[column]):
            raise UsageError(f"Canvas doesn't import {title!r}, which is read only")
        return column

    def _suggestion(self, title: str) -> str:
        titles = list(filter(ASSIGNMENT.search, self.table.header))
        near = difflib.get_close_matches(title, titles, 3, 0.3) or titles[:3]
        return f"it has {', '.join(map(repr, near))}" if near else "it has no assignment at all"


class Worksheet(Gradebook):
    """One column takes the total."""

    again = "download it again"

    def _only_column(self, title: str, meant: list[str], choices: list[str]) -> int:
        """The column whose title is among those that are meant."""
        found = [i for i, text in enumerate(self.table.header) if text in meant and i > 0]
        if len(found) == 1:
            return found[0]
        raise UsageError(
            f"{self.table.name} has {len(found) or 'no'} column{'s' * (len(found) != 1)} "
            f"{title or 'that is meant'!r}: give --column one of {', '.join(map(repr, choices))}"
        )

    def _cell(self, row: Row, title: str) -> str:
        """The text under a title; "" if there is no such column."""
        header = self.table.header
        return row.text(header.index(title)) if title in header else ""

    def _person(self, row: Row) -> str:
        names = [self._cell(row, title) for title in ("Last Name", "First Name")]
        return self._cell(row, "Full name") or ", ".join(filter(None, names)) or self._ids(row)[0]


class MoodleWorksheet(Worksheet):
    """Finds points under "Grade", and how late a student is under "Status"."""

    service = "moodle"
    no_points = "-"

    def _ids(self, row: Row) -> list[str]:
        number = re.search(r"\d+$", row.text(0))
        return [number.group() if number else ""]

    def _find_column(self, title: str) -> int:
        return self._only_column(title, [title or "Grade"], self.table.header)

    def _never_filled(self, row: Row) -> str:
        if self._cell(row, "Grade can be changed").lower() != "no":
            return ""
        return "has a grade that Moodle lets nobody change here: the cell stays as it was"

    def _points_possible(self) -> Iterable[str]:
        return (self._cell(row, "Maximum Grade") for row in self._students())

    def days_late(self) -> dict[str, int | None]:
        titles = [title for title in self.table.header if title in moodle.STATUS]
        rows = self._by_own_id if titles else {}
        return {id: moodle.days_late(self._cell(of[0], titles[0])) for id, of in rows.items()}


class BlackboardWorksheet(Worksheet):
    """Finds points in a column whose title tells the total points; often UTF-16 with tabs."""

    service = "blackboard"
    no_points = r"(?s)Needs Grading.*"

    def _ids(self, row: Row) -> list[str]:
        return [self._cell(row, "Username")]

    def _find_column(self, title: str) -> int:
        own = list(filter(BLACKBOARD.search, self.table.header))
        meant = [t for t in own if title in ("", t, t.partition(" [Total Pts")[0].strip())]
        return self._only_column(title, meant, own)

    def _points_possible(self) -> list[str]:
        return BLACKBOARD.findall(self._title)
