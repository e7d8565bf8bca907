"""Fills points into a file that a service exported: what all services have in common.

What a person has entered in the file stays, and each byte that isn't filled in is the same.
"""

import re
from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from bounce_grader.classroom.intake.canvas import is_name_of
from bounce_grader.classroom.output.table import Row, Table
from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import csv_row
from bounce_grader.common.numbers import short


@dataclass(frozen=True)
class Marks:
    """A student's points."""

    name: str
    points: Mapping[int, float]  # key 0 is the total, key n is part n
    from_canvas: bool = False  # the id and the name are those of a Canvas download


# A column's title -> the service's id -> all points that runs have filled in there.
Written = Mapping[str, Mapping[str, list[str]]]


@dataclass
class Filled:
    """A filled-in grade book, as bytes of its file."""

    data: bytes
    sentences: list[str]  # what the instructor should know
    written: Written = field(default_factory=dict)


class Gradebook(ABC):
    """A table of a service with a row for each student. Each service says where its ids, names and
    points are."""

    service: str
    again: str  # what helps if the file is damaged

    def __init__(
        self, table: Table, name: str, columns: Mapping[int, str], max_points: Mapping[int, float]
    ) -> None:
        self._table = table
        self._name = name
        self._header = table.header()
        self._max_points = max_points
        self._columns = {part: self._column(title) for part, title in columns.items()}
        self._comma = self._has_decimal_comma()
        for row in self._students():
            if len(row.cells) != len(self._header):
                raise UsageError(
                    f"{name} has {len(row.cells)} cells in line {row.line}, and "
                    f"{len(self._header)} in its first: {self.again}"
                )

    @abstractmethod
    def _column(self, title: str) -> int:
        """The column to fill. Raises UsageError if there is none."""

    @abstractmethod
    def _students(self) -> list[Row]:
        """The rows of students."""

    @abstractmethod
    def _ids(self, row: Row) -> list[str]:
        """A student's ids, each "" where there is none; the service's own is the first."""

    @abstractmethod
    def _person(self, row: Row) -> str:
        """A student's name, as "Doe, Jane"."""

    @abstractmethod
    def _points_possible(self, part: int) -> set[str]:
        """What the file says of the most points in the column of a part, or of the total (0)."""

    def _points(self, row: Row, column: int) -> str:
        """The points that stand in a cell; "" if none do."""
        return row.cells[column].text.strip()

    def _never_filled(self, row: Row, column: int) -> str:
        """Why a cell takes no points; "" if it does."""
        return ""

    def _score_columns(self) -> set[int]:
        """The columns that show how points are written."""
        return {*self._columns.values()}

    def days_late(self) -> dict[str, int | None]:
        """How many days each student is late, by id; None if the words aren't known. Empty if the
        file doesn't tell."""
        return {}

    def people(self, own_ids_only: bool = True) -> dict[str, str]:
        """The names of students, as "Doe, Jane", by each id that only one has."""
        rows = self._rows_by_id(own_ids_only)
        return {id: self._person(of[0]) for id, of in rows.items() if len(of) == 1}

    def same_person(self) -> dict[str, str]:
        """The student's own id at the service, by each id that only one student has."""
        rows = self._rows_by_id(own_ids_only=False)
        return {id: self._ids(of[0])[0] for id, of in rows.items() if len(of) == 1}

    def require_some_of(self, ids: Iterable[str], own_ids_only: bool) -> None:
        """Raises UsageError if no student with one of these ids is in the file."""
        handed_in = list(ids)
        if handed_in and not self._rows_by_id(own_ids_only).keys() & set(handed_in):
            raise UsageError(
                f"none of the {len(handed_in)} students who handed in is in {self._name}: is it the "
                "file of another assignment or course?"
            )

    def fill(
        self,
        marks: Mapping[str, Marks],
        without: Mapping[str, str] = {},
        written: Written = {},
        overwrite: bool = False,
    ) -> Filled:
        """Fills in the points. The keys of `marks` and `without` are the service's ids, or any that
        the file has; `without` says why a student has no score. Points that already stand in a
        column are kept, unless earlier runs have `written` them, or if `overwrite` is set."""
        rows = self._rows_of(marks, without)
        reasons, graded = _by_line(rows, without), _by_line(rows, marks)
        sentences, emptied = self._other_points_possible(), 0
        now = {
            title: {id: list(points) for id, points in by_id.items()}
            for title, by_id in written.items()
        }
        for row in self._students():
            ids = graded.get(row.line, [])
            if not any(self._ids(row)):
                continue
            if not ids:
                why = [without[id] for id in reasons.get(row.line, [])][:1]
                nothing = f"no score, because {why[0]}" if why else "no submission"
                sentences.append(f"{self._who(row)} has {nothing}: the cell stays as it was")
            elif len(ids) > 1:
                several = " and ".join(f"{marks[i].name} ({i})" for i in ids)
                sentences.append(f"{self._who(row)} is meant by {several}: none is filled in")
            elif len(rows[ids[0]]) > 1:
                count = len(rows[ids[0]])
                sentences.append(f"{self._name} has {count} rows for {ids[0]}: none is filled")
            else:
                emptied += self._emptied(row, now)
                sentences += self._fill_row(row, marks[ids[0]], now, overwrite)
        listed = {id for ids in graded.values() for id in ids}
        sentences += [
            f"{marks[id].name} ({id}) is graded, but isn't in {self._name}"
            for id in sorted(marks.keys() - listed)
        ]
        sentences = [*self._perhaps_old(emptied), *dict.fromkeys(sentences)]
        return Filled(self._table.bytes(), sentences, now)

    def _fill_row(
        self, row: Row, marks: Marks, written: dict[str, dict[str, list[str]]], overwrite: bool
    ) -> list[str]:
        sentences, is_filled, id = [], False, self._ids(row)[0]
        for part, column in self._columns.items():
            title, points = self._header[column], f"{marks.points[part]:.2f}"
            before = written.get(title, {}).get(id, [])
            there = self._points(row, column)
            ours = is_ours(number_in(there), float(points), map(number_in, before))
            if why := self._never_filled(row, column):
                sentences.append(f"{self._who(row)} {why}")
            elif there and not overwrite and not ours:
                sentences.append(f"{self._who(row)} {kept(there, points, title)}")
            else:
                is_filled = True
                written.setdefault(title, {})[id] = list(dict.fromkeys([*before, points]))
                text = points.replace(".", ",") if self._comma else points
                row.cells[column].put(text, self._table.delimiter)
        if is_filled and marks.from_canvas and not is_name_of(self._person(row), marks.name):
            sentences.append(
                f"{self._who(row)} has the points of {marks.name}: if that is a group, give its "
                "other members the same"
            )
        return sentences

    def _emptied(self, row: Row, written: Written) -> int:
        """How many cells lack the points that an earlier run has filled in."""
        id = self._ids(row)[0]
        return sum(
            not self._points(row, column) and id in written.get(self._header[column], {})
            for column in self._columns.values()
        )

    def _perhaps_old(self, emptied: int) -> list[str]:
        """Points that were corrected since an earlier run can't be seen in an old file, and would be
        replaced."""
        cells = f"{emptied} cell{'s' if emptied > 1 else ''}"
        sentence = (
            f"{self._name} lacks what an earlier run has filled into {cells}: if that is imported, "
            "export the grades again, or corrections made there since then are lost"
        )
        return [sentence] * bool(emptied)

    def _rows_of(
        self, marks: Mapping[str, Marks], without: Mapping[str, str]
    ) -> dict[str, list[Row]]:
        """The rows of each id."""
        by_own_id, by_any_id = self._rows_by_id(True), self._rows_by_id(False)
        any_from_canvas = any(mark.from_canvas for mark in marks.values())
        own = {id: any_from_canvas for id in without}
        own |= {id: mark.from_canvas for id, mark in marks.items()}
        return {id: (by_own_id if is_own else by_any_id).get(id, []) for id, is_own in own.items()}

    def _rows_by_id(self, own_ids_only: bool) -> dict[str, list[Row]]:
        """The rows of each id. The service's own ids take precedence, as in its importer. For a
        Canvas download only these count, because any other number in it comes from a student."""
        rows: dict[str, list[Row]] = {}
        ids = [(row, self._ids(row)) for row in self._students()]
        for kind in range(1 if own_ids_only else max((len(of) for _, of in ids), default=0)):
            of_kind: dict[str, list[Row]] = {}
            for row, of_row in ids:
                of_kind.setdefault(of_row[kind], []).append(row)
            rows = {**of_kind, **rows}
        return {id: of for id, of in rows.items() if id}

    def _who(self, row: Row) -> str:
        return f"{self._person(row)} ({next(filter(None, self._ids(row)), 'without an ID')})"

    def _has_decimal_comma(self) -> bool:
        """Whether points are written as 87,5, and none as 87.5."""
        rows = [row for row in self._table.rows[1:] if len(row.cells) == len(self._header)]
        texts = [row.cells[column].text.strip() for row in rows for column in self._score_columns()]
        with_point = any(re.fullmatch(r"\d+\.\d+", text) for text in texts)
        return not with_point and any(re.fullmatch(r"\d+,\d+", text) for text in texts)

    def _other_points_possible(self) -> list[str]:
        sentences = []
        for part, column in self._columns.items():
            most = self._max_points[part]
            there = {number_in(text) for text in self._points_possible(part)} - {None, most}
            sentences += [
                f"{self.service.capitalize()} has {short(points)} points possible for "
                f"{self._header[column]}, the kit {short(most)}: change it there"
                for points in sorted(points for points in there if points is not None)
            ]
        return sentences


def _by_line(rows: Mapping[str, list[Row]], ids: Iterable[str]) -> dict[int, list[str]]:
    """The ids that refer to each row, by its line."""
    lines: dict[int, list[str]] = {}
    for id in ids:
        for row in rows.get(id, []):
            lines.setdefault(row.line, []).append(id)
    return lines


def number_in(text: str) -> float | None:
    try:
        return float(text.strip().replace(",", "."))
    except ValueError:
        return None


def is_ours(there: float | None, points: float, before: Iterable[float | None]) -> bool:
    """Whether these points come from this grading or from an earlier run."""
    return there is not None and there in (points, *before)


def kept(there: str, points: str, title: str = "") -> str:
    """What is said of points that a person has entered, and that stay."""
    place = f" in {title}" if title else ""
    return f"keeps {there}{place}, where the grading gives {points}; --overwrite replaces it"


def of_marks(marks: Mapping[str, Marks], title: str, max_points: float) -> bytes:
    """Makes a grade book that Canvas can import, if none was given; Canvas matches students by
    ID."""
    header = ["Student", "ID", "SIS Login ID", "Section", title]
    rows = [header, ["    Points Possible", "", "", "", f"{max_points:.2f}"]]
    for id, mark in sorted(marks.items(), key=lambda item: (item[1].name, item[0])):
        canvas, login = (id, "") if id.isdigit() else ("", id)
        rows.append([mark.name, canvas, login, "", f"{mark.points[0]:.2f}"])
    return "".join(map(csv_row, rows)).encode()
