"""Fills points into the grade book, a file that a service exported: what all services have in common.

What a person has entered in the file stays, and each byte that isn't filled in is the same.
"""

import json
import re
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from bounce_grader.classroom.grading.summary import Final, Summary
from bounce_grader.classroom.intake.instructor_files import ROSTER
from bounce_grader.classroom.intake.student import Class, Member
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


class Line(NamedTuple):
    """A student's row."""

    row: Row
    ids: Sequence[str]  # each "" where there is none; the service's own is the first
    person: str  # the name, as "Doe, Jane"
    stays: str = ""  # why the cell takes no points
    late: int | None = 0  # days; None if the words aren't known

    @property
    def who(self) -> str:
        return f"{self.person} ({next(filter(None, self.ids), 'without an ID')})"


class Gradebook:
    """A service's table with a row for each student."""

    def __init__(
        self,
        service: str,
        table: Table,
        column: int,
        lines: Sequence[Line],
        possible: Iterable[str],
        again: str = "download it again",
        no_points: str = "",
        tells_lateness: bool = False,
    ) -> None:
        """`column` is the one to fill; `possible`, what the file says of the most points there;
        `again` helps if the file is damaged; `no_points` is a pattern for what a cell without
        points may say."""
        self.service, self.table, self.lines = service, table, lines
        self._column, self._title = column, table.header[column]
        self._possible, self._no_points, self._tells_lateness = possible, no_points, tells_lateness
        for row in (line.row for line in lines):
            if len(row.cells) != len(table.header):
                raise UsageError(
                    f"{table.name} has {len(row.cells)} cells in line {row.line}, and "
                    f"{len(table.header)} in its first: {again}"
                )
        self._comma = self._has_decimal_comma()
        self._by_own_id, self._by_any_id = self._lines_by_id()

    def days_late(self) -> dict[str, int | None]:
        """How many days each student is late, by id. Empty if the file doesn't tell."""
        lines = self._by_own_id if self._tells_lateness else {}
        return {id: of[0].late for id, of in lines.items()}

    def people(self, own_ids_only: bool = True) -> dict[str, str]:
        """The names of students, as "Doe, Jane", by each id that only one has. For a Canvas download
        only the service's own ids count, because any other number in it comes from a student."""
        lines = self._by_own_id if own_ids_only else self._by_any_id
        return {id: of[0].person for id, of in lines.items() if len(of) == 1}

    def same_person(self) -> dict[str, str]:
        """The student's own id at the service, by each id that only one student has."""
        return {id: of[0].ids[0] for id, of in self._by_any_id.items() if len(of) == 1}

    def require_some_of(self, members: Sequence[Member], own_ids_only: bool) -> None:
        """Raises UsageError if none of these is in the file."""
        of = {True: self._by_any_id, False: self._by_own_id if own_ids_only else self._by_any_id}
        if members and not any(member.id in of[member.listed] for member in members):
            raise UsageError(
                f"nobody who handed in is in {self.table.name}: is it the file of another "
                "assignment or course?"
            )

    def fill(
        self,
        finals: Sequence[Final],
        without: Mapping[str, str],
        from_canvas: bool,
        written: Written,
        overwrite: bool,
    ) -> list[str]:
        """Fills in the points, also into `written`, and returns what the instructor should know.
        `without` says by id why somebody has no score; `from_canvas`, that the ids are those of a
        Canvas download, except the roster's. Points that already stand in a cell are kept, unless
        earlier runs have `written` them, or if `overwrite` is set."""
        own, any_id = self._by_own_id, self._by_any_id
        whose: dict[int, list[Final]] = {}  # by the row's line
        for final in finals:
            for line in (own if from_canvas and not final.listed else any_id).get(final.id, []):
                whose.setdefault(line.row.line, []).append(final)
        reasons: dict[int, str] = {}
        for id, reason in without.items():
            for line in (own if from_canvas else any_id).get(id, []):
                reasons.setdefault(line.row.line, reason)
        times = [final.id for finals in whose.values() for final in finals]
        sentences, emptied = self._other_points_possible(), 0
        for line in filter(lambda line: any(line.ids), self.lines):
            number, meant = line.row.line, whose.get(line.row.line, [])
            if not meant:
                why = f"score, because {reasons[number]}" if number in reasons else "submission"
                sentences.append(f"{line.who} has no {why}: the cell stays as it was")
            elif len(meant) > 1:
                several = " and ".join(f"{final.name} ({final.id})" for final in meant)
                sentences.append(f"{line.who} is meant by {several}: none is filled in")
            elif (count := times.count(meant[0].id)) > 1:
                whole = f"{self.table.name} has {count} rows for {meant[0].id}: none is filled"
                sentences.append(whole)
            else:
                is_known = line.ids[0] in written.get(self._title, {})
                emptied += is_known and not self._points(line)
                sentences += self._fill_line(line, meant[0], from_canvas, written, overwrite)
        sentences += [
            f"{final.name} ({final.id}) is graded, but isn't in {self.table.name}"
            for final in sorted(finals, key=lambda final: final.id)
            if final.id not in times
        ]
        if emptied:  # corrections since an earlier run can't be seen in an old file
            sentences.insert(
                0,
                f"{self.table.name} lacks what an earlier run has filled into {emptied} "
                f"cell{'s' * (emptied > 1)}: if that is imported, export the grades again, or "
                "corrections made there since then are lost",
            )
        return list(dict.fromkeys(sentences))

    def _fill_line(
        self, line: Line, final: Final, from_canvas: bool, written: Written, overwrite: bool
    ) -> list[str]:
        points, there = f"{final.points:.2f}", self._points(line)
        before = written.get(self._title, {}).get(line.ids[0], [])
        if line.stays:
            return [f"{line.who} {line.stays}"]
        if there and not overwrite:
            if not is_ours(number_in(there), float(points), map(number_in, before)):
                return [f"{line.who} {kept(there, points)}"]
        written.setdefault(self._title, {})[line.ids[0]] = list(dict.fromkeys([*before, points]))
        text = points.replace(".", ",") if self._comma else points
        line.row.put(self._column, text, self.table.delimiter)
        if from_canvas and not final.listed and final.name != line.person:
            return [
                f"{line.who} has the points of {final.name}: if that is a group, give its other "
                "members the same"
            ]
        return []

    def _points(self, line: Line) -> str:
        """The points that stand in the cell; "" if none do."""
        text = line.row.text(self._column)
        return "" if re.fullmatch(self._no_points, text) else text

    def _lines_by_id(self) -> tuple[dict[str, list[Line]], dict[str, list[Line]]]:
        """The lines of each of the service's own ids, and of each id; the service's own take
        precedence, as in its importer."""
        own: dict[str, list[Line]] = {}
        others: dict[str, list[Line]] = {}
        for kind in range(max((len(line.ids) for line in self.lines), default=0)):
            of_kind = {} if kind else own
            for line in self.lines:
                if line.ids[kind]:
                    of_kind.setdefault(line.ids[kind], []).append(line)
            others = of_kind | others
        return own, others

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
            for points in dict.fromkeys(map(number_in, self._possible))
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
