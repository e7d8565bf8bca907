"""Reads OUT/roster.csv: whose a submission is. It names the students behind logins of GitHub's, and
the members of groups."""

from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from bounce_grader.classroom.intake import own_table
from bounce_grader.classroom.intake.canvas import sanitized
from bounce_grader.classroom.intake.student import Student
from bounce_grader.common.errors import UsageError

NAME = "roster.csv"
COLUMNS = ("submission", "id")  # a login or a name of a folder or group; and an id of the course's


class Member(NamedTuple):
    """One person who gets the points of a submission."""

    id: str
    name: str


class Roster:
    def __init__(self, members: dict[str, list[Member]]) -> None:
        self._members = members
        self._by_name = {name.casefold(): of for name, of in members.items()}
        self._as_in_canvas = {sanitized(name): of for name, of in members.items()}

    def __bool__(self) -> bool:
        return bool(self._members)

    def of(self, student: Student) -> list[Member]:
        """The members of a submission; none if the roster doesn't name it."""
        for name in (student.id, student.name):
            found = self._by_name.get(name.casefold())
            if not found and student.uploads:
                found = self._as_in_canvas.get(name)
            if found:
                return found
        return []

    def named(self, people: Mapping[str, str]) -> "Roster":
        """The same, with the names of the grade book where it has none of its own."""
        return Roster(
            {
                submission: [m._replace(name=m.name or people.get(m.id, "")) for m in members]
                for submission, members in self._members.items()
            }
        )


def read(out: Path) -> Roster:
    """The roster; an empty one if there is no such file. Raises UsageError."""
    path = out / NAME
    members: dict[str, list[Member]] = {}
    seen: dict[str, int] = {}
    for line, cells in own_table.read(path, COLUMNS, ("name",)):
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
