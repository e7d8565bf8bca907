"""Fills columns of Canvas's exported grade book."""

import difflib
import re
from collections.abc import Iterable, Mapping
from pathlib import Path

from bounce_grader.classroom.intake.canvas import is_name_of
from bounce_grader.classroom.output import filling, table as tables
from bounce_grader.classroom.output.filling import Filled, Marks, number_in, Written
from bounce_grader.classroom.output.table import Row
from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import csv_row
from bounce_grader.common.numbers import short

NAME_COLUMNS = ("SIS User ID", "SIS Login ID", "Integration ID")
NEVER_FILLED = ("EX", "N/A")
TOTAL = re.compile(r"(Current|Final|Override).*(Score|Points|Grade|Status)")  # computed by Canvas
ASSIGNMENT = re.compile(r"\(\d+\)$")


class Gradebook:
    """A grade book that Canvas exported. Raises UsageError if it can't be filled in."""

    service = "canvas"

    def __init__(
        self, path: Path, columns: Mapping[int, str], max_points: Mapping[int, float]
    ) -> None:
        self._name = path.name
        self._table = tables.parse(filling.read(path), path.name)
        self._header = [cell.text.strip() for cell in self._table.rows[0].cells]
        self._require_canvas()
        self._columns = {part: self._column(title) for part, title in columns.items()}
        self._require_distinct()
        self._max_points = max_points
        self._comma = filling.has_decimal_comma(self._whole_rows(), self._score_columns())
        rows = [self._table.rows[0], *self._students()]
        again = "export it from Canvas again"
        filling.require_whole(rows, len(self._header), self._name, again)

    def require_some_of(self, ids: Iterable[str], canvas_ids_only: bool) -> None:
        """Raises UsageError if no student with one of these ids is in the grade book."""
        known = self._rows_by_id(canvas_ids_only)
        handed_in = list(ids)
        if handed_in and not any(id in known for id in handed_in):
            raise UsageError(
                f"none of the {len(handed_in)} students who handed in is in {self._name}: is it the "
                "grade book of another course?"
            )

    def fill(
        self,
        marks: Mapping[str, Marks],
        without: Mapping[str, str] = {},
        written: Written = {},
        overwrite: bool = False,
    ) -> Filled:
        """Fills in the points. The keys of `marks` and `without` are Canvas's user ids, SIS ids or
        logins; `without` says why a student has no score. Points that already stand in a column
        are kept, unless earlier runs have `written` them, or if `overwrite` is set."""
        rows = self._rows_of(marks, without)
        reasons = _by_line(rows, without)
        graded = _by_line(rows, marks)
        emptied = 0  # cells without the points that an earlier run has filled in
        sentences = self._points_possible()
        now = {
            title: {id: list(points) for id, points in by_id.items()}
            for title, by_id in written.items()
        }
        for row in self._students():
            ids = graded.get(row.line, [])
            id = ids[0] if ids else ""
            if not ids:
                reason = reasons.get(row.line, [])
                why = without[reason[0]] if reason else None
                sentences.append(filling.not_filled(self._who(row), why))
            elif len(ids) > 1:
                several = " and ".join(f"{marks[i].name} ({i})" for i in ids)
                sentences.append(f"{self._who(row)} is meant by {several}: none is filled in")
            elif len(rows[id]) > 1:
                sentences.append(f"{self._name} has {len(rows[id])} rows for {id}: none is filled")
            else:
                emptied += self._emptied(row, now)
                sentences += self._fill_row(row, marks[id], now, overwrite)
        listed = {id for ids in graded.values() for id in ids}
        sentences += filling.not_listed(marks, listed, self._name)
        sentences = [*filling.perhaps_old(self._name, emptied), *dict.fromkeys(sentences)]
        return Filled(self._table.bytes(), sentences, now)

    def _emptied(self, row: Row, written: Written) -> int:
        id = row.cells[self._header.index("ID")].text.strip()
        return sum(
            not row.cells[column].text.strip() and id in written.get(self._header[column], {})
            for column in self._columns.values()
        )

    def _rows_of(
        self, marks: Mapping[str, Marks], without: Mapping[str, str]
    ) -> dict[str, list[Row]]:
        """The rows of each id."""
        by_canvas_id, by_any_id = self._rows_by_id(True), self._rows_by_id(False)
        any_from_canvas = any(mark.from_canvas for mark in marks.values())
        from_canvas = {id: any_from_canvas for id in without}
        from_canvas |= {id: mark.from_canvas for id, mark in marks.items()}
        return {
            id: (by_canvas_id if known else by_any_id).get(id, [])
            for id, known in from_canvas.items()
        }

    def _fill_row(
        self, row: Row, marks: Marks, written: dict[str, dict[str, list[str]]], overwrite: bool
    ) -> list[str]:
        sentences, is_filled = [], False
        id = row.cells[self._header.index("ID")].text.strip()
        for part, column in self._columns.items():
            title = self._header[column]
            text, number = row.cells[column].text.strip(), f"{marks.points[part]:.2f}"
            before = written.get(title, {}).get(id, [])
            if text.upper() in NEVER_FILLED:
                sentences.append(f"{self._who(row)} stays {text} in {title}")
            elif why := filling.why_kept(text, title, number, before, overwrite):
                sentences.append(f"{self._who(row)} {why}")
            else:
                is_filled = True
                if number not in before:
                    written.setdefault(title, {})[id] = [*before, number]
                filling.put(self._table, row, column, number, self._comma)
        if is_filled and marks.from_canvas and not is_name_of(self._person(row), marks.name):
            sentences.append(
                f"{self._who(row)} has the points of {marks.name}: if that is a group, give its "
                "other members the same"
            )
        return sentences

    def _who(self, row: Row) -> str:
        ids = [row.cells[column].text.strip() for column in self._id_columns()]
        return f"{self._person(row)} ({next(filter(None, ids), 'without an ID')})"

    def _person(self, row: Row) -> str:
        """The name in Canvas's order: "Doe, Jane"."""
        names = row.cells[: self._header.index("ID")]
        return ", ".join(cell.text.strip() for cell in names)

    def people(self, canvas_ids_only: bool = True) -> dict[str, str]:
        """The names of all students, as "Doe, Jane", by Canvas's ids; or by every id that only one
        student has."""
        rows = self._rows_by_id(canvas_ids_only)
        rows = {id: of_id for id, of_id in rows.items() if canvas_ids_only or len(of_id) == 1}
        return {id: self._person(of_id[0]) for id, of_id in rows.items()}

    def same_person(self) -> dict[str, str]:
        """The student's Canvas id, by each id that only one student has."""
        column = self._header.index("ID")
        rows = self._rows_by_id(canvas_ids_only=False)
        return {id: of[0].cells[column].text.strip() for id, of in rows.items() if len(of) == 1}

    def _rows_by_id(self, canvas_ids_only: bool) -> dict[str, list[Row]]:
        """The rows of each id. Canvas's own ids take precedence, as in its importer. For a Canvas
        download only these count, because any other number in it comes from a student."""
        rows: dict[str, list[Row]] = {}
        for column in self._id_columns()[: 1 if canvas_ids_only else None]:
            in_column: dict[str, list[Row]] = {}
            for row in self._students():
                in_column.setdefault(row.cells[column].text.strip(), []).append(row)
            rows = {**in_column, **rows}
        return {id: rows[id] for id in rows if id}

    def _students(self) -> list[Row]:
        """The rows that Canvas's importer takes for students."""
        rows = []
        for row in self._table.rows[1:]:
            texts = [cell.text for cell in row.cells]
            posting = all(re.fullmatch(r"\s*(Muted|Manual Posting.*)?\s*", t, re.I) for t in texts)
            if not self._has_points(row) and not posting:
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
        """The first column that can hold points, after those that identify a student; the last of
        these is the section."""
        ids = self._id_columns()
        sections = [i for i, text in enumerate(self._header) if i > ids[0] and "Section" in text]
        return max([*ids, *sections[:1]]) + 1

    def _require_distinct(self) -> None:
        if len(set(self._columns.values())) < len(self._columns):
            raise UsageError(
                "two of the columns to fill are the same: give --column and each --part-column a "
                "column of its own"
            )

    def _score_columns(self) -> set[int]:
        columns = {*self._columns.values()}
        for i, title in enumerate(self._header):
            if ASSIGNMENT.search(title) or TOTAL.search(title):
                columns.add(i)
        return columns

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
        if column < self._first_score():
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

    def _points_rows(self) -> list[Row]:
        return [row for row in self._whole_rows() if self._has_points(row)]

    def _has_points(self, row: Row) -> bool:
        """Whether it is Canvas's own row, and not a student with such a name."""
        id = row.cells[self._header.index("ID")].text.strip()
        return "Points Possible" in row.cells[0].text and not id

    def _whole_rows(self) -> list[Row]:
        return [row for row in self._table.rows[1:] if len(row.cells) == len(self._header)]

    def _points_possible(self) -> list[str]:
        sentences = []
        for row in self._points_rows():
            for part, column in self._columns.items():
                points = number_in(row.cells[column].text)
                if points is not None and points != self._max_points[part]:
                    sentences.append(
                        f"Canvas has {short(points)} points possible for {self._header[column]}, "
                        f"the kit {short(self._max_points[part])}: change it in Canvas, or scale there"
                    )
        return sentences


def _by_line(rows: Mapping[str, list[Row]], ids: Iterable[str]) -> dict[int, list[str]]:
    """The ids that refer to each row, by its line."""
    lines: dict[int, list[str]] = {}
    for id in ids:
        for row in rows.get(id, []):
            lines.setdefault(row.line, []).append(id)
    return lines


def _title(text: str) -> str:
    return re.sub(r"\s\(\d+\)$", "", text)


def of_marks(marks: Mapping[str, Marks], title: str, max_points: float) -> bytes:
    """Makes a grade book that Canvas can import, if none was given; Canvas matches students by
    ID."""
    header = ["Student", "ID", "SIS Login ID", "Section", title]
    rows = [header, ["    Points Possible", "", "", "", f"{max_points:.2f}"]]
    for id, mark in sorted(marks.items(), key=lambda item: (item[1].name, item[0])):
        canvas, login = (id, "") if id.isdigit() else ("", id)
        rows.append([mark.name, canvas, login, "", f"{mark.points[0]:.2f}"])
    return "".join(map(csv_row, rows)).encode()
