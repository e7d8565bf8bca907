"""Reads OUT/roster.csv, which says whose a submission is: the student behind a GitHub login, or the
members of a group."""

from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from bounce_grader.classroom.intake import instructor_table
from bounce_grader.classroom.intake.canvas import sanitized
from bounce_grader.classroom.intake.student import Student
from bounce_grader.common.errors import UsageError

NAME = "roster.csv"
COLUMNS = ("submission", "id")  # a login, or the name of a folder or group; a student's id


class Member(NamedTuple):
    """One person who gets the points of a submission."""

    id: str
    name: str


class Roster:
    """The members of each submission, by its id or name."""

    def __init__(
        self, members: dict[str, list[Member]], same_person: Mapping[str, str] = {}
    ) -> None:
        self._members = members
        self._same_person = same_person
        self._by_name = {name.casefold(): of for name, of in members.items()}
        self._as_in_canvas = {sanitized(name): of for name, of in members.items()}

    def __bool__(self) -> bool:
        return bool(self._members)

    def members_of(self, student: Student) -> list[Member]:
        """The members of a submission; none if the roster doesn't have it. The roster may have the
        submission's id or its name. Students choose that name, so it counts only if the student who
        handed in is one of the members."""
        own = self._by_name.get(student.id.casefold(), [])
        if own:
            return own
        named = self._by_name.get(student.name.casefold(), [])
        if not named and student.uploads:
            named = self._as_in_canvas.get(student.name, [])
        ids = {self._same_person.get(member.id, member.id) for member in named}
        return named if self._same_person.get(student.id, student.id) in ids else []

    def people(self) -> dict[str, str]:
        """The names of the members that have one, by id."""
        return {m.id: m.name for of in self._members.values() for m in of if m.name}

    def named(self, people: Mapping[str, str], same_person: Mapping[str, str]) -> "Roster":
        """This roster, with the grade book's names where it has none of its own; `same_person` is
        the grade book's id for each other id of a person."""
        return Roster(
            {
                submission: [m._replace(name=m.name or people.get(m.id, "")) for m in members]
                for submission, members in self._members.items()
            },
            same_person,
        )


def read(out: Path) -> Roster:
    """The roster; an empty one if there is no such file. Raises UsageError."""
    path = out / NAME
    members: dict[str, list[Member]] = {}
    seen: dict[str, int] = {}
    for line, cells in instructor_table.read(path, COLUMNS, ("name",)):
        submission, id = cells["submission"], cells["id"]
        if not submission or not id:
            raise UsageError(f"{path} lacks the submission or the id in line {line}: fill it in")
        if id in seen:
            raise UsageError(
                f"{path} has the id {id} in lines {seen[id]} and {line}: a person's points come "
                "from one submission, so keep one of them"
            )
        seen[id] = line
        members.setdefault(submission, []).append(Member(id, cells["name"]))
    return Roster(members)
