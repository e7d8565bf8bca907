"""A student's submission and points, and the class that it belongs to."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from bounce_grader.common.escaping import printable_name

# By the service's id, of each person in the gradebook: the name there, and the roster's of groups.
Names = Mapping[str, Sequence[str]]


class Upload(NamedTuple):
    """One file of a service's download, by its name there; or what the service has instead."""

    entry: str  # its whole name in the download
    name: str  # of the student or group: "doejane"; "" if the assignment is anonymous
    user: str  # the service's id
    file: str  # "" if there is none
    late: bool = False
    number: int = 0  # grows: the id of Canvas's attachment, the time of Blackboard's attempt
    as_named: bool = True  # the file has the student's own name for it, and no other file's
    instead: str = ""  # why it is no file that counts, as "text was typed"
    attempt: int = 0  # grows; files of one attempt belong together


class Adjustment(NamedTuple):
    """One row of adjustments.csv: what changes for whom, and why."""

    where: str  # the file and the line
    student: str  # an id, or "*" for everybody
    points: float = 0.0  # added; or what the points become, or are at least or at most
    sets: str = ""  # "=", "at least" or "at most"; "" if points are added
    late_days: int | None = None  # in place of the service's; 0 for an extension
    drop: tuple[str, ...] = ()  # checks whose points are given
    reason: str = ""
    comment: str = ""


class Comment(NamedTuple):
    """One row of comments.csv: what an instructor says about a line of code."""

    row: int  # the line of the file
    student: str  # an id
    file: str
    line: int
    text: str
    code: str = ""  # the text of that line, when it was first shown
    shown: tuple[tuple[int, str], ...] = ()  # the lines around it, with their numbers


class Member(NamedTuple):
    """A person who gets the points of a submission."""

    id: str
    name: str
    listed: bool = False  # in the instructor's roster
    points: float = 0.0  # in the end
    applied: tuple[Adjustment, ...] = ()  # with the points that each gave
    slip_days: int = 0  # free days late that they have used here


class Student(NamedTuple):
    """One submission: a person's, or a group's."""

    id: str  # the service's, a login, or the name of a folder
    name: str
    path: Path  # the folder or zip; with uploads, the whole download
    uploads: tuple[Upload, ...] = ()  # those that count
    feedback: str = ""  # the name of the feedback page; "" if there is none
    unused: tuple[str, ...] = ()  # a sentence for each file that doesn't count
    person: str = ""  # the name in the gradebook or the roster, as "Doe, Jane"
    seconds_late: int | None = 0  # after the due date; None if it is late, and not said how much
    members: tuple[Member, ...] = ()  # who gets the points
    refused: str = ""  # why nothing can be graded, for the student and the instructor

    @property
    def shown(self) -> str:
        """The name for people to read."""
        return self.person or self.name

    @property
    def who(self) -> str:
        """The name and the id."""
        return self.id if self.shown == self.id else f"{self.shown} ({self.id})"


@dataclass
class Class:
    """All submissions of a class."""

    source: str  # what kind of folder or zip SUBMISSIONS is
    students: list[Student] = field(default_factory=list)
    strays: list[str] = field(default_factory=list)  # sentences, as on each entry that is nobody's
    logins: bool = False  # whether a student's id is a GitHub login, which students choose
    service: str = ""  # "canvas", "moodle" or "blackboard", if that wrote the download

    def add_stray(self, name: str, reason: str) -> None:
        """`reason` continues a sentence that begins with the name."""
        self.strays.append(f"{printable_name(name)!r} {reason}")
