"""Fills points into the grade book, a file that a service exported: what all services have in common.

What a person has entered in the file stays, and each byte that isn't filled in is the same.
"""

import json
import re
from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from bounce_grader.classroom.grading.summary import Final, Summary
from bounce_grader.classroom.intake.instructor_files import ROSTER
from bounce_grader.classroom.intake.student import Class
from bounce_grader.classroom.output.table import Row, Table
from bounce_grader.common.errors import UsageError
from bounce_grader.common.files import read_object, write_whole
from bounce_grader.common.manifest import full_points
from bounce_grader.common.numbers import short

WRITTEN = "written.json"  # the points that runs have filled in: what differs, a person has changed
TOTAL = re.compile(r"(Current|Final|Override).*(Score|Points|Grade|Status)")  # computed by Canvas
# Titles of columns that show how points are written.
SCORES = re.compile(rf"\(\d+\)$|^Maximum Grade$|{TOTAL.pattern}")
# A column's title -> the service's id -> all points that runs have filled in there.
Written = dict[str, dict[str, list[str]]]


class Gradebook(ABC):
    """A table of a service with a row for each student. Each service says where its ids, names and
    points are."""

    service: str
    again: str  # what helps if the file is damaged
    no_points = ""  # a pattern for what a cell without points may say

    def __init__(self, table: Table, title: str) -> None:
        """`title` is that of the column to fill; "" where there is only one."""
        self.table = table
        self._column = self._find_column(title)
        self._title = table.header[self._column]
        for row in self._students():
            if len(row.cells) != len(table.header):
                raise UsageError(
                    f"{table.name} has {len(row.cells)} cells in line {row.line}, and "
                    f"{len(table.header)} in its first: {self.again}"
                )
        self._comma = self._has_decimal_comma()
        self._by_own_id, self._by_any_id = self._rows_by_id()

    @abstractmethod
    def _find_column(self, title: str) -> int:
        """The column to fill. Raises UsageError if there is none."""

    @abstractmethod
    def _ids(self, row: Row) -> list[str]:
        """A student's ids, each "" where there is none; the service's own is the first."""

    @abstractmethod
    def _person(self, row: Row) -> str:
        """A student's name, as "Doe, Jane"."""

    @abstractmethod
    def _points_possible(self) -> Iterable[str]:
        """What the file says of the most points in the column."""

    def _students(self) -> list[Row]:
        return self.table.rows[1:]

    def _never_filled(self, row: Row) -> str:
        """Why the cell takes no points; "" if it does."""
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
    ) -> list[str]:
        """Fills in the points, also into `written`, and returns what the instructor should know. `without` says by id why somebody has no score; `from_canvas`, that
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
                is_known = self._ids(row)[0] in written.get(self._title, {})
                emptied += is_known and not self._points(row)
                sentences += self._fill_row(row, meant[0], from_canvas, written, overwrite)
        sentences += [
            f"{final.name} ({final.id}) is graded, but isn't in {self.table.name}"
            for final in sorted(finals, key=lambda final: final.id)
            if final.id not in times
        ]
        return [*self._perhaps_old(emptied), *dict.fromkeys(sentences)]

    def _fill_row(
        self, row: Row, final: Final, from_canvas: bool, written: Written, overwrite: bool
    ) -> list[str]:
        who, id, points, there = (
            self._who(row),
            self._ids(row)[0],
            f"{final.points:.2f}",
            self._points(row),
        )
        before = written.get(self._title, {}).get(id, [])
        if why := self._never_filled(row):
            return [f"{who} {why}"]
        if there and not overwrite:
            if not is_ours(number_in(there), float(points), map(number_in, before)):
                return [f"{who} {kept(there, points)}"]
        written.setdefault(self._title, {})[id] = list(dict.fromkeys([*before, points]))
        text = points.replace(".", ",") if self._comma else points
        row.put(self._column, text, self.table.delimiter)
        if from_canvas and not final.listed and final.name != self._person(row):
            return [
                f"{who} has the points of {final.name}: if that is a group, give its other members "
                "the same"
            ]
        return []

    def _points(self, row: Row) -> str:
        """The points that stand in the cell; "" if none do."""
        text = row.text(self._column)
        return "" if re.fullmatch(self.no_points, text) else text

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
        columns = scores | {self._column}
        texts = [row.text(column) for row in self.table.rows[1:] for column in columns]
        with_point = any(re.fullmatch(r"\d+\.\d+", text) for text in texts)
        return not with_point and any(re.fullmatch(r"\d+,\d+", text) for text in texts)

    def _other_points_possible(self) -> list[str]:
        return [
            f"{self.service.capitalize()} has {short(points)} points possible for {self._title}, the "
            f"kit {short(full_points())}: if it is the right column, change it there"
            for points in dict.fromkeys(map(number_in, self._points_possible()))
            if points is not None and points != full_points()
        ]


def write(
    path: Path, submitted: Class, summaries: Sequence[Summary], book: Gradebook, overwrite: bool
) -> list[str]:
    """Fills the grade book in, for everyone who has a score: a missing one must not become a zero. A
    submission that is known by its GitHub login alone gets no points: its student could have chosen
    somebody else's id as a login. Returns sentences for the instructor."""
    given: list[Final] = []
    left_out = []
    for summary in summaries:
        for one in summary.finals:
            if submitted.logins and not one.listed:
                left_out.append(f"{one.id} isn't in {ROSTER}: the points are in grades.csv")
            else:
                given.append(one._replace(name=one.name or summary.student.shown))
    without = {u.user: f"{u.name} {u.reason}" for u in submitted.unmatched if u.user}
    without |= {s.student.id: s.message for s in summaries if s.score is None}
    written = read_object(path.with_name(WRITTEN))
    sentences = book.fill(given, without, submitted.service == "canvas", written, overwrite)
    write_whole(path, book.table.encoded())
    write_whole(path.with_name(WRITTEN), json.dumps(written, indent=1, sort_keys=True))
    return [*sentences, *left_out]


def number_in(text: str) -> float | None:
    try:
        return float(text.strip().replace(",", "."))
    except ValueError:
        return None


def is_ours(there: float | None, points: float, before: Iterable[float | None]) -> bool:
    """Whether these points come from this grading or from an earlier run."""
    return there is not None and there in (points, *before)


def kept(there: str, points: str) -> str:
    """What is said of points that a person has entered, and that stay."""
    return f"keeps {there}, where the grading gives {points}; --overwrite replaces it"
