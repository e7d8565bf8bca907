"""The grade book that Canvas exports."""

import difflib
import re
from collections.abc import Mapping

from bounce_grader.classroom.output.gradebook import Gradebook
from bounce_grader.classroom.output.table import Row, Table
from bounce_grader.common.errors import UsageError

NAME_COLUMNS = ("SIS User ID", "SIS Login ID", "Integration ID")
NEVER_FILLED = ("EX", "N/A")
TOTAL = re.compile(r"(Current|Final|Override).*(Score|Points|Grade|Status)")  # computed by Canvas
ASSIGNMENT = re.compile(r"\(\d+\)$")
POSTING = re.compile(r"\s*(Muted|Manual Posting.*)?\s*", re.IGNORECASE)


class CanvasGradebook(Gradebook):
    """Each cell under an assignment's title takes a student's points."""

    service = "canvas"
    again = "export it from Canvas again"

    def __init__(
        self, table: Table, name: str, columns: Mapping[int, str], max_points: Mapping[int, float]
    ) -> None:
        header = table.header()
        one = header[0].endswith("Student") and "ID" in header[1:4]
        two = header[0].endswith("LastName") and header[1:3] == ["FirstName", "ID"]
        if not one and not two:
            raise UsageError(
                f"{name} isn't a grade book of Canvas's: its first line has to begin with "
                "Student, ID (in Canvas: Grades, Export)"
            )
        if 0 not in columns:
            raise UsageError("--gradebook needs --column, the title of the column to fill")
        ids = [header.index("ID"), *(header.index(n) for n in NAME_COLUMNS if n in header)]
        self._id_columns = ids
        super().__init__(table, name, columns, max_points)
        if len(set(self._columns.values())) < len(self._columns):
            raise UsageError(
                "two of the columns to fill are the same: give --column and each --part-column a "
                "column of its own"
            )

    def _ids(self, row: Row) -> list[str]:
        return [row.cells[column].text.strip() for column in self._id_columns]

    def _person(self, row: Row) -> str:
        return ", ".join(cell.text.strip() for cell in row.cells[: self._id_columns[0]])

    def _never_filled(self, row: Row, column: int) -> str:
        text = self._points(row, column)
        return f"stays {text} in {self._header[column]}" if text.upper() in NEVER_FILLED else ""

    def _students(self) -> list[Row]:
        """The rows that Canvas's importer takes for students."""
        return [
            row
            for row in self._table.rows[1:]
            if not self._is_of_points(row)
            and not all(POSTING.fullmatch(cell.text) for cell in row.cells)
        ]

    def _is_of_points(self, row: Row) -> bool:
        """Whether it is Canvas's own row, and not a student with such a name."""
        return "Points Possible" in row.cells[0].text and not self._ids(row)[0]

    def _points_rows(self) -> list[Row]:
        whole = (row for row in self._table.rows[1:] if len(row.cells) == len(self._header))
        return [row for row in whole if self._is_of_points(row)]

    def _points_possible(self, part: int) -> set[str]:
        return {row.cells[self._columns[part]].text for row in self._points_rows()}

    def _score_columns(self) -> set[int]:
        titles = enumerate(self._header)
        scores = {i for i, title in titles if ASSIGNMENT.search(title) or TOTAL.search(title)}
        return {*self._columns.values(), *scores}

    def _column(self, title: str) -> int:
        columns = [i for i, text in enumerate(self._header) if text == title]
        columns = columns or [i for i, text in enumerate(self._header) if _title(text) == title]
        if len(columns) > 1:
            raise UsageError(
                f"{self._name} has {len(columns)} columns named {title!r}: name the one you mean "
                "with its number, as in 'HW3 (98765)', and rename the other if they are the same"
            )
        if not columns:
            raise UsageError(f"{self._name} has no column {title!r}: {self._suggestion(title)}")
        column = columns[0]
        # The last of the columns that identify a student is the section.
        sections = [
            i for i, t in enumerate(self._header) if i > self._id_columns[0] if "Section" in t
        ]
        if column <= max([*self._id_columns, *sections[:1]]):
            raise UsageError(
                f"{title!r} in {self._name} says who a student is, and takes no points: "
                f"{self._suggestion(title)}"
            )
        read_only = any("read only" in row.cells[column].text for row in self._points_rows())
        if read_only or TOTAL.search(self._header[column]):
            raise UsageError(f"Canvas doesn't import {title!r}, which is read only")
        return column

    def _suggestion(self, title: str) -> str:
        titles = [text for text in self._header if ASSIGNMENT.search(text)]
        near = difflib.get_close_matches(title, titles, 3, 0.3) or titles[:3]
        return f"it has {', '.join(map(repr, near))}" if near else "it has no assignment at all"


def _title(text: str) -> str:
    return re.sub(r"\s\(\d+\)$", "", text)
