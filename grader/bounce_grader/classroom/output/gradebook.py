"""Decides which points go into the grade book, whichever service's: a file that was exported, or what
Canvas's API tells. What a person has entered there stays."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from bounce_grader.classroom.grading.summary import Final
from bounce_grader.classroom.intake.student import Member
from bounce_grader.common.errors import UsageError
from bounce_grader.common.manifest import full_points
from bounce_grader.common.numbers import short

WRITTEN = "written.json"  # the points that runs have filled in: what differs, a person has changed
# A column's title -> the service's id -> all points that runs have filled in there.
Written = dict[str, dict[str, list[str]]]


class Line(NamedTuple):
    """A student's line."""

    number: int
    ids: Sequence[str]  # each "" where there is none; the service's own is the first
    person: str  # the name, as "Doe, Jane"
    there: str  # the points that stand there; "" if none do
    stays: str = ""  # why it takes no points
    late: int | None = 0  # days; None if the words aren't known

    @property
    def who(self) -> str:
        return f"{self.person} ({next(filter(None, self.ids), 'without an ID')})"


@dataclass
class Gradebook:
    """A service's lines, one for each student."""

    service: str
    name: str  # of the file
    title: str  # of the column to fill
    lines: Sequence[Line]
    possible: Sequence[str] = ()  # what the file says of the most points
    tells_lateness: bool = False

    def __post_init__(self) -> None:
        self._by_own_id = self._by_id(1)
        self._by_any_id = self._by_id(max((len(line.ids) for line in self.lines), default=0))

    def _by_id(self, kinds: int) -> dict[str, list[Line]]:
        """The lines of each id, of the first kinds; the service's own take precedence, as in its
        importer."""
        found: dict[str, list[Line]] = {}
        for kind in reversed(range(kinds)):
            of_kind: dict[str, list[Line]] = {}
            for line in self.lines:
                if line.ids[kind]:
                    of_kind.setdefault(line.ids[kind], []).append(line)
            found |= of_kind
        return found

    def days_late(self) -> dict[str, int | None]:
        """How many days each student is late, by id. Empty if the file doesn't tell."""
        lines = self._by_own_id if self.tells_lateness else {}
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
        if members and not any(self._lines_of(member, own_ids_only) for member in members):
            raise UsageError(f"nobody who handed in is in {self.name}: is it of another course?")

    def _lines_of(self, person: Member | Final, own_ids_only: bool) -> Sequence[Line]:
        by_id = self._by_own_id if own_ids_only and not person.listed else self._by_any_id
        return by_id.get(person.id, ())

    def fill(
        self, finals: Sequence[Final], from_canvas: bool, written: Written, overwrite: bool
    ) -> tuple[list[tuple[Line, float]], list[str]]:
        """The lines that take points, which are also noted in `written`; and what the instructor
        should know. `from_canvas` says that the ids are those of a Canvas download, except the
        roster's. Points that already stand in a line are kept, unless earlier runs have `written`
        them, or if `overwrite` is set."""
        whose: dict[int, list[Final]] = {}  # by the line's number
        for final in finals:
            for line in self._lines_of(final, from_canvas):
                whose.setdefault(line.number, []).append(final)
        times = [final.id for finals in whose.values() for final in finals]
        ours = written.setdefault(self.title, {})
        filled, sentences = [], self._other_points_possible()
        for line in filter(lambda line: any(line.ids), self.lines):
            meant, before = whose.get(line.number, []), ours.get(line.ids[0], [])
            why = self._unfilled(line, meant, times) or self._stays(
                line, meant[0], before, overwrite
            )
            if why:
                sentences.append(f"{line.who} {why}")
                continue
            points = f"{meant[0].points:.2f}"
            filled.append((line, float(points)))
            ours[line.ids[0]] = list(dict.fromkeys([*before, points]))
            if from_canvas and not meant[0].listed and meant[0].name != line.person:
                whose_points = (
                    f"has the points of {meant[0].name}: give the others of a group the same"
                )
                sentences.append(f"{line.who} {whose_points}")
        sentences += [
            f"{final.name} ({final.id}) is graded, but isn't in {self.name}"
            for final in sorted(finals, key=lambda final: final.id)
            if final.id not in times
        ]
        return filled, list(dict.fromkeys(sentences))

    def _unfilled(self, line: Line, meant: Sequence[Final], times: Sequence[str]) -> str:
        """Why there are no points for a line; "" if there are."""
        if not meant:
            return "has no score: nothing is filled in"
        if len(meant) > 1:
            several = " and ".join(f"{final.name} ({final.id})" for final in meant)
            return f"is meant by {several}: none is filled in"
        count = times.count(meant[0].id)
        return f"has {count} rows in {self.name}: none is filled" if count > 1 else ""

    def _stays(self, line: Line, final: Final, before: Sequence[str], overwrite: bool) -> str:
        """Why what stands in a line stays; "" if it doesn't."""
        points, there = round(final.points, 2), number_in(line.there)
        if line.stays or overwrite or not line.there or there in (points, *map(number_in, before)):
            return line.stays
        return f"keeps {line.there}, where {points:.2f} is graded; --overwrite replaces it"

    def _other_points_possible(self) -> list[str]:
        return [
            f"{self.service.capitalize()} has {short(points)} points possible for {self.title}, the "
            f"kit {short(full_points())}: if it is the right column, change it there"
            for points in dict.fromkeys(map(number_in, self.possible))
            if points is not None and points != full_points()
        ]


def number_in(text: str) -> float | None:
    try:
        return float(text.strip().replace(",", "."))
    except ValueError:
        return None
