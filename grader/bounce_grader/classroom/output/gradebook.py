"""Fills points into a file that a service exported: what all services have in common.

What a person has entered in the file stays, and each byte that isn't filled in is the same.
"""

import re
from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from bounce_grader.classroom.grading.summary import Final
from bounce_grader.classroom.output.table import Row, Table
from bounce_grader.common.errors import UsageError
from bounce_grader.common.manifest import full_points, parts
from bounce_grader.common.numbers import short

TOTAL = re.compile(r"(Current|Final|Override).*(Score|Points|Grade|Status)")  # computed by Canvas
# Titles of columns that show how points are written.
SCORES = re.compile(rf"\(\d+\)$|^Maximum Grade$|{TOTAL.pattern}")
# A column's title -> the service's id -> all points that runs have filled in there.
Written = dict[str, dict[str, list[str]]]


class Filled(NamedTuple):
    """A filled-in grade book, as bytes of its file."""

    data: bytes
    sentences: list[str]  # what the instructor should know
    written: Written


class Gradebook(ABC):
    """A table of a service with a row for each student. Each service says where its ids, names and
    points are."""

    service: str
    again: str  # what helps if the file is damaged
    no_points = ""  # a pattern for what a cell without points may say

    def __init__(self, table: Table, columns: Mapping[int, str]) -> None:
        """`columns` are the titles of those to fill: of the total under 0, of part n under n."""
        self.table = table
        self._columns = {part: self._column(title) for part, title in columns.items()}
        for row in self._students():
            if len(row.cells) != len(table.header):
                raise UsageError(
                    f"{table.name} has {len(row.cells)} cells in line {row.line}, and "
                    f"{len(table.header)} in its first: {self.again}"
                )
        self._comma = self._has_decimal_comma()
        self._by_own_id, self._by_any_id = self._rows_by_id()

    @abstractmethod
    def _column(self, title: str) -> int:
        """The column to fill. Raises UsageError if there is none."""

    @abstractmethod
    def _ids(self, row: Row) -> list[str]:
        """A student's ids, each "" where there is none; the service's own is the first."""

    @abstractmethod
    def _person(self, row: Row) -> str:
        """A student's name, as "Doe, Jane"."""

    @abstractmethod
    def _points_possible(self, part: int) -> Iterable[str]:
        """What the file says of the most points in the column of a part, or of the total (0)."""

    def _students(self) -> list[Row]:
        return self.table.rows[1:]

    def _never_filled(self, row: Row, column: int) -> str:
        """Why a cell takes no points; "" if it does."""
        return ""

    def days_late(self) -> dict[str, int | None]:
        """How many days each student is late, by id; None if the words aren't known. Empty if the
        file doesn't tell."""
        return {}

    def people(self, own_ids_only: bool = True) -> dict[str, str]:
        """The names of students, as "Doe, Jane", by each id that only one has. For a Canvas download
        only the service's own ids count, because any other number in it comes from a student."""
        rows = self._by_own_id if own_ids_only else self._by_any_id
        return {id: self._person(of[0]) for id, of in rows.items() if len(of) == 1}

    def same_person(self) -> dict[str, str]:
        """The student's own id at the service, by each id that only one student has."""
        return {id: self._ids(of[0])[0] for id, of in self._by_any_id.items() if len(of) == 1}

    def require_some_of(self, ids: Sequence[str], own_ids_only: bool) -> None:
        """Raises UsageError if no student with one of these ids is in the file."""
        rows = self._by_own_id if own_ids_only else self._by_any_id
        if ids and not rows.keys() & set(ids):
            raise UsageError(
                f"none of the {len(ids)} students who handed in is in {self.table.name}: is it the "
                "file of another assignment or course?"
            )

    def fill(
        self,
        finals: Sequence[Final],
        without: Mapping[str, str],
        from_canvas: bool,
        written: Written,
        overwrite: bool,
    ) -> Filled:
        """Fills in the points. `without` says by id why somebody has no score; `from_canvas`, that
        the ids are those of a Canvas download, except the roster's. Points that already stand in a
        column are kept, unless earlier runs have `written` them, or if `overwrite` is set."""
        own, any_id = self._by_own_id, self._by_any_id
        whose: dict[int, list[Final]] = {}  # by the row's line
        for final in finals:
            for row in (own if from_canvas and not final.listed else any_id).get(final.id, []):
                whose.setdefault(row.line, []).append(final)
        reasons: dict[int, str] = {}
        for id, reason in without.items():
            for row in (own if from_canvas else any_id).get(id, []):
                reasons.setdefault(row.line, reason)
        times = [final.id for finals in whose.values() for final in finals]
        sentences, emptied = self._other_points_possible(), 0
        for row in filter(lambda row: any(self._ids(row)), self._students()):
            meant = whose.get(row.line, [])
            if not meant:
                why = f"score, because {reasons[row.line]}" if row.line in reasons else "submission"
                sentences.append(f"{self._who(row)} has no {why}: the cell stays as it was")
            elif len(meant) > 1:
                several = " and ".join(f"{final.name} ({final.id})" for final in meant)
                sentences.append(f"{self._who(row)} is meant by {several}: none is filled in")
            elif (count := times.count(meant[0].id)) > 1:
                whole = f"{self.table.name} has {count} rows for {meant[0].id}: none is filled"
                sentences.append(whole)
            else:
                emptied += self._emptied(row, written)
                sentences += self._fill_row(row, meant[0], from_canvas, written, overwrite)
        sentences += [
            f"{final.name} ({final.id}) is graded, but isn't in {self.table.name}"
            for final in sorted(finals, key=lambda final: final.id)
            if final.id not in times
        ]
        sentences = [*self._perhaps_old(emptied), *dict.fromkeys(sentences)]
        return Filled(self.table.encoded(), sentences, written)

    def _fill_row(
        self, row: Row, final: Final, from_canvas: bool, written: Written, overwrite: bool
    ) -> list[str]:
        sentences, is_filled, who, id = [], False, self._who(row), self._ids(row)[0]
        for part, column in self._columns.items():
            title, points = self.table.header[column], f"{final.points[part]:.2f}"
            there = self._points(row, column)
            before = written.get(title, {}).get(id, [])
            ours = is_ours(number_in(there), float(points), map(number_in, before))
            if why := self._never_filled(row, column):
                sentences.append(f"{who} {why}")
            elif there and not overwrite and not ours:
                sentences.append(f"{who} {kept(there, points, title)}")
            else:
                is_filled = True
                written.setdefault(title, {})[id] = list(dict.fromkeys([*before, points]))
                text = points.replace(".", ",") if self._comma else points
                row.put(column, text, self.table.delimiter)
        is_group = from_canvas and not final.listed and final.name != self._person(row)
        if is_filled and is_group:
            sentences.append(
                f"{who} has the points of {final.name}: if that is a group, give its other members "
                "the same"
            )
        return sentences

    def _points(self, row: Row, column: int) -> str:
        """The points that stand in a cell; "" if none do."""
        text = row.text(column)
        return "" if re.fullmatch(self.no_points, text) else text

    def _emptied(self, row: Row, written: Written) -> int:
        """How many cells lack the points that an earlier run has filled in."""
        id, titles = self._ids(row)[0], self.table.header
        return sum(
            not self._points(row, column) and id in written.get(titles[column], {})
            for column in self._columns.values()
        )

    def _perhaps_old(self, emptied: int) -> list[str]:
        """Points that were corrected since an earlier run can't be seen in an old file, and would be
        replaced."""
        cells = f"{emptied} cell{'s' if emptied > 1 else ''}"
        sentence = (
            f"{self.table.name} lacks what an earlier run has filled into {cells}: if that is "
            "imported, export the grades again, or corrections made there since then are lost"
        )
        return [sentence] * bool(emptied)

    def _rows_by_id(self) -> tuple[dict[str, list[Row]], dict[str, list[Row]]]:
        """The rows of each of the service's own ids, and of each id; the service's own take
        precedence, as in its importer."""
        kinds: list[dict[str, list[Row]]] = []
        for row in self._students():
            for kind, id in enumerate(self._ids(row)):
                if kind == len(kinds):
                    kinds.append({})
                if id:
                    kinds[kind].setdefault(id, []).append(row)
        every: dict[str, list[Row]] = {}
        for of_kind in kinds:
            every = of_kind | every
        return (kinds[0] if kinds else {}), every

    def _who(self, row: Row) -> str:
        return f"{self._person(row)} ({next(filter(None, self._ids(row)), 'without an ID')})"

    def _has_decimal_comma(self) -> bool:
        """Whether points are written as 87,5, and none as 87.5."""
        scores = {i for i, title in enumerate(self.table.header) if SCORES.search(title)}
        columns = scores | {*self._columns.values()}
        texts = [row.text(column) for row in self.table.rows[1:] for column in columns]
        with_point = any(re.fullmatch(r"\d+\.\d+", text) for text in texts)
        return not with_point and any(re.fullmatch(r"\d+,\d+", text) for text in texts)

    def _other_points_possible(self) -> list[str]:
        most = {0: full_points(), **{p.number: p.points for p in parts()}}
        return [
            f"{self.service.capitalize()} has {short(points)} points possible for "
            f"{self.table.header[column]}, the kit {short(most[part])}: if it is the right column, "
            "change it there"
            for part, column in self._columns.items()
            for points in dict.fromkeys(map(number_in, self._points_possible(part)))
            if points is not None and points != most[part]
        ]


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
