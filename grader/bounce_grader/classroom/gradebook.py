"""Fills columns of Canvas's exported grade book."""

import difflib
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from bounce_grader.classroom import table as tables
from bounce_grader.classroom.canvas import sanitized
from bounce_grader.classroom.table import Row, Table
from bounce_grader.errors import UsageError

NAME_COLUMNS = ("SIS User ID", "SIS Login ID", "Integration ID")
NEVER_FILLED = ("EX", "N/A")


@dataclass(frozen=True)
class Marks:
    """A student's points: 0 is the whole, n is part n."""

    name: str
    points: Mapping[int, float]
    of_canvas: bool = False  # the name is what Canvas made of a person's, or a group's


@dataclass
class Filled:
    data: bytes
    sentences: list[str] = field(default_factory=list)  # whatever a person should know


class Gradebook:
    """Raises UsageError where the file isn't one that could be filled."""

    def __init__(self, path: Path, columns: Mapping[int, str], most: Mapping[int, float]) -> None:
        try:
            data = path.read_bytes()
        except OSError as error:
            raise UsageError(f"{path} can't be read: {error.strerror}") from error
        self._name = path.name
        self._table = tables.parse(data, path.name)
        self._header = [cell.text.strip() for cell in self._table.rows[0].cells]
        self._require_canvas()
        self._columns = {part: self._column(title) for part, title in columns.items()}
        self._most = most
        self._comma = _has_decimal_comma(self._table)
        self._require_whole_rows()

    def fill(self, marks: Mapping[str, Marks]) -> Filled:
        """`marks` by Canvas's user id, a SIS id, or a login."""
        filled = Filled(b"")
        rows = self._rows_by_id()
        given = {row.line: id for id in marks for row in rows.get(id, [])}
        for row in self._students():
            id = given.get(row.line)
            if id is None:
                nothing = f"{self._who(row)} has no submission: the cell stays as it was"
                filled.sentences.append(nothing)
            elif len(rows[id]) > 1:
                twice = f"{self._name} has {len(rows[id])} rows for {id}: none is filled"
                filled.sentences.append(twice)
            else:
                filled.sentences += self._fill_row(row, marks[id])
        for id in sorted(marks.keys() - set(given.values())):
            unknown = f"{marks[id].name} ({id}) is graded, but isn't in {self._name}"
            filled.sentences.append(unknown)
        filled.sentences = [*self._points_possible(), *dict.fromkeys(filled.sentences)]
        filled.data = self._table.bytes()
        return filled

    def _fill_row(self, row: Row, marks: Marks) -> list[str]:
        said = []
        named = False
        for part, column in self._columns.items():
            cell = row.cells[column]
            if cell.text.strip().upper() in NEVER_FILLED:
                said.append(f"{self._who(row)} stays {cell.text.strip()} in {self._header[column]}")
            else:
                named = marks.of_canvas
                number = f"{marks.points[part]:.2f}"
                text = number.replace(".", ",") if self._comma else number
                cell.put(text, self._table.delimiter)
        if named and sorted(sanitized(_name(row))) != sorted(marks.name):
            said.append(
                f"{self._who(row)} has the points of {marks.name}: if that is a group, give its other "
                "members the same"
            )
        return said

    def _who(self, row: Row) -> str:
        ids = [row.cells[column].text.strip() for column in self._id_columns()]
        return f"{_name(row)} ({next(filter(None, ids), 'without an ID')})"

    def _rows_by_id(self) -> dict[str, list[Row]]:
        """Canvas's own ids first, as its importer does."""
        found: dict[str, list[Row]] = {}
        for column in self._id_columns():
            here: dict[str, list[Row]] = {}
            for row in self._students():
                if row.cells[column].text.strip():
                    here.setdefault(row.cells[column].text.strip(), []).append(row)
            found = {**here, **found}
        return found

    def _students(self) -> list[Row]:
        """The rows that Canvas takes for students."""
        rows = []
        for row in self._table.rows[1:]:
            texts = [cell.text for cell in row.cells]
            posting = all(re.fullmatch(r"\s*(Muted|Manual Posting.*)?\s*", t, re.I) for t in texts)
            if "Points Possible" not in texts[0] and not posting:
                rows.append(row)
        return rows

    def _id_columns(self) -> list[int]:
        others = [self._header.index(name) for name in NAME_COLUMNS if name in self._header]
        return [self._header.index("ID"), *others]

    def _require_canvas(self) -> None:
        if not self._header[0].endswith("Student") or "ID" not in self._header[1:4]:
            raise UsageError(
                f"{self._name} isn't a grade book of Canvas's: its first line has to begin with "
                "Student, ID (in Canvas: Grades, Export)"
            )

    def _require_whole_rows(self) -> None:
        for row in [self._table.rows[0], *self._students()]:
            if len(row.cells) != len(self._header):
                raise UsageError(
                    f"{self._name} has {len(row.cells)} cells in line {row.line}, and "
                    f"{len(self._header)} in its first: export it from Canvas again"
                )

    def _column(self, title: str) -> int:
        found = [i for i, text in enumerate(self._header) if text == title]
        found = found or [i for i, text in enumerate(self._header) if _title(text) == title]
        if len(found) > 1:
            raise UsageError(
                f"{self._name} has {len(found)} columns named {title!r}: name the one you mean "
                "with its number, as in 'HW3 (98765)', and rename the other if they are the same"
            )
        if not found:
            raise UsageError(f"{self._name} has no column {title!r}: {self._suggestion(title)}")
        if any("read only" in row.cells[found[0]].text for row in self._points_rows()):
            raise UsageError(f"Canvas doesn't import {title!r}, which is read only")
        return found[0]

    def _suggestion(self, title: str) -> str:
        titles = [text for text in self._header if re.search(r"\(\d+\)$", text)]
        near = difflib.get_close_matches(title, titles, 3, 0.3) or titles[:3]
        return f"it has {', '.join(map(repr, near))}" if near else "it has no assignment at all"

    def _points_rows(self) -> list[Row]:
        rows = self._table.rows[1:]
        whole = [row for row in rows if len(row.cells) == len(self._header)]
        return [row for row in whole if "Points Possible" in row.cells[0].text]

    def _points_possible(self) -> list[str]:
        said = []
        for row in self._points_rows():
            for part, column in self._columns.items():
                points = _number(row.cells[column].text)
                if points is not None and points != self._most[part]:
                    said.append(
                        f"Canvas has {points:g} points possible for {self._header[column]}, the "
                        f"kit {self._most[part]:g}: change it in Canvas, or scale there"
                    )
        return said


def _name(row: Row) -> str:
    return row.cells[0].text.strip()


def _title(text: str) -> str:
    return re.sub(r"\s\(\d+\)$", "", text)


def _number(text: str) -> float | None:
    try:
        return float(text.strip().replace(",", "."))
    except ValueError:
        return None


def _has_decimal_comma(table: Table) -> bool:
    """Where numbers are written 87,5 and none 87.5."""
    cells = [cell.text.strip() for row in table.rows[1:] for cell in row.cells]
    points = any(re.fullmatch(r"\d+\.\d+", text) for text in cells)
    return not points and any(re.fullmatch(r"\d+,\d+", text) for text in cells)


def plain(marks: Mapping[str, Marks], title: str, most: float) -> bytes:
    """A grade book of its own, where Canvas's wasn't given: Canvas knows the students by ID."""
    from bounce_grader.escape import csv_row

    header = ["Student", "ID", "SIS Login ID", "Section", title]
    rows = [header, ["    Points Possible", "", "", "", f"{most:.2f}"]]
    for id, mark in sorted(marks.items(), key=lambda item: (item[1].name, item[0])):
        canvas, login = (id, "") if id.isdigit() else ("", id)
        rows.append([mark.name, canvas, login, "", f"{mark.points[0]:.2f}"])
    return "".join(map(csv_row, rows)).encode()
