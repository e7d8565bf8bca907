"""Fills columns of Canvas's exported grade book."""

import difflib
import re
import unicodedata
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from bounce_grader.classroom.intake.canvas import sanitized
from bounce_grader.classroom.output import table as tables
from bounce_grader.classroom.output.table import Row
from bounce_grader.common.errors import UsageError

NAME_COLUMNS = ("SIS User ID", "SIS Login ID", "Integration ID")
NEVER_FILLED = ("EX", "N/A")
TOTAL = re.compile(r"(Current|Final|Override).*(Score|Points|Grade|Status)")  # worked out by Canvas
ASSIGNMENT = re.compile(r"\(\d+\)$")


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
        self._require_distinct()
        self._most = most
        self._comma = self._has_decimal_comma()
        self._require_whole_rows()

    def fill(self, marks: Mapping[str, Marks], without: Mapping[str, str] = {}) -> Filled:
        """`marks` by Canvas's user id, a SIS id, or a login; `without` says, by the same, why there
        is no score."""
        filled = Filled(b"")
        reasons = self._by_line(without)
        rows = self._rows_by_id()
        given = self._by_line(marks)
        for row in self._students():
            id = given.get(row.line)
            if id is None:
                reason = reasons.get(row.line)
                nothing = f"no score, because {without[reason]}" if reason else "no submission"
                nothing = f"{self._who(row)} has {nothing}: the cell stays as it was"
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
        if named and not _same_name(self._person(row), marks.name):
            said.append(
                f"{self._who(row)} has the points of {marks.name}: if that is a group, give its other "
                "members the same"
            )
        return said

    def _who(self, row: Row) -> str:
        ids = [row.cells[column].text.strip() for column in self._id_columns()]
        return f"{self._person(row)} ({next(filter(None, ids), 'without an ID')})"

    def _person(self, row: Row) -> str:
        """As Canvas sorts it: "Doe, Jane"."""
        names = [cell.text.strip() for cell in row.cells[: self._header.index("ID")]]
        return ", ".join(names)

    def _by_line(self, ids: Iterable[str]) -> dict[int, str]:
        rows = self._rows_by_id()
        return {row.line: id for id in ids for row in rows.get(id, [])}

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
        one = self._header[0].endswith("Student") and "ID" in self._header[1:4]
        two = self._header[0].endswith("LastName") and self._header[1:3] == ["FirstName", "ID"]
        if not one and not two:
            raise UsageError(
                f"{self._name} isn't a grade book of Canvas's: its first line has to begin with "
                "Student, ID (in Canvas: Grades, Export)"
            )

    def _first_score(self) -> int:
        """The column after those that say who a student is, the last of which is the section."""
        ids = self._id_columns()
        sections = [i for i, text in enumerate(self._header) if i > ids[0] and "Section" in text]
        return max([*ids, *sections[:1]]) + 1

    def _require_distinct(self) -> None:
        if len(set(self._columns.values())) < len(self._columns):
            raise UsageError(
                "two of the columns to fill are the same: give --column and each --part-column a "
                "column of its own"
            )

    def _has_decimal_comma(self) -> bool:
        """Where scores are written 87,5 and none 87.5."""
        scores = {
            i
            for i, text in enumerate(self._header)
            if ASSIGNMENT.search(text) or TOTAL.search(text)
        }
        scores |= {*self._columns.values()}
        rows = [row for row in self._table.rows[1:] if len(row.cells) == len(self._header)]
        cells = [row.cells[column].text.strip() for row in rows for column in scores]
        points = any(re.fullmatch(r"\d+\.\d+", text) for text in cells)
        return not points and any(re.fullmatch(r"\d+,\d+", text) for text in cells)

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
        if found[0] < self._first_score():
            raise UsageError(
                f"{title!r} in {self._name} says who a student is, and takes no points: "
                f"{self._suggestion(title)}"
            )
        worked_out = TOTAL.search(self._header[found[0]])
        if worked_out or any("read only" in r.cells[found[0]].text for r in self._points_rows()):
            raise UsageError(f"Canvas doesn't import {title!r}, which is read only")
        return found[0]

    def _suggestion(self, title: str) -> str:
        titles = [text for text in self._header if ASSIGNMENT.search(text)]
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


def _same_name(person: str, canvas_name: str) -> bool:
    """Letter for letter, in whichever order and however an accent is written."""
    names = (sanitized(person), canvas_name)
    one, other = (sorted(unicodedata.normalize("NFC", name)) for name in names)
    return one == other


def _title(text: str) -> str:
    return re.sub(r"\s\(\d+\)$", "", text)


def _number(text: str) -> float | None:
    try:
        return float(text.strip().replace(",", "."))
    except ValueError:
        return None


def plain(marks: Mapping[str, Marks], title: str, most: float) -> bytes:
    """A grade book of its own, where Canvas's wasn't given: Canvas knows the students by ID."""
    from bounce_grader.common.escaping import csv_row

    header = ["Student", "ID", "SIS Login ID", "Section", title]
    rows = [header, ["    Points Possible", "", "", "", f"{most:.2f}"]]
    for id, mark in sorted(marks.items(), key=lambda item: (item[1].name, item[0])):
        canvas, login = (id, "") if id.isdigit() else ("", id)
        rows.append([mark.name, canvas, login, "", f"{mark.points[0]:.2f}"])
    return "".join(map(csv_row, rows)).encode()
