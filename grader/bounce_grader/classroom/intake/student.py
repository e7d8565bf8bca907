"""A student's submission, what can't be graded, and a class of both."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from bounce_grader.common.escaping import printable_name


# Of each person in the grade book, by the service's id: that name there, and the roster's of the group.
Names = Mapping[str, Sequence[str]]


class Upload(NamedTuple):
    """One file of a service's download, by its name there; or what was typed into the service."""

    entry: str  # its whole name in the download
    name: str  # of the student or group: "doejane"; "" if the assignment is anonymous
    user: str  # the service's id
    file: str  # "" if it is typed
    late: bool = False
    number: int = 0  # grows: the id of Canvas's attachment, the time of Blackboard's attempt
    as_named: bool = True  # the file has the student's own name for it, and no other file's
    typed: str = ""  # "text" or "an address"
    old: bool = False  # of an attempt that doesn't count any more


class Member(NamedTuple):
    """A person who gets the points of a submission."""

    id: str
    name: str
    listed: bool = False  # in the instructor's roster


@dataclass(frozen=True)
class Student:
    """One submission: a person's, or a group's."""

    id: str  # the service's, a login, or the name of a folder
    name: str
    path: Path  # the folder or zip; with uploads, the whole download
    uploads: tuple[Upload, ...] = ()  # those that count
    late: bool = False
    feedback: str = ""  # the name of the feedback page
    unused: tuple[str, ...] = ()  # a sentence for each file that doesn't count
    person: str = ""  # the name in the grade book or the roster, as "Doe, Jane"
    late_days: int = 0  # days begun after the due date, where that is known
    members: tuple[Member, ...] = ()  # who gets the points

    @property
    def shown(self) -> str:
        """The name for people to read."""
        return self.person or self.name


@dataclass(frozen=True)
class Unmatched:
    """Something in SUBMISSIONS that can't be graded."""

    name: str
    reason: str  # continues a sentence that begins with the name
    user: str = ""  # the user's id, if known
    feedback: str = ""  # the name of the feedback page
    page_text: str = ""  # the text of that page


@dataclass
class Class:
    """All submissions of a class, and the entries that can't be graded."""

    source: str  # what kind of folder or zip SUBMISSIONS is
    students: list[Student] = field(default_factory=list)
    unmatched: list[Unmatched] = field(default_factory=list)
    logins: bool = False  # whether a student's id is a GitHub login, which students choose
    service: str = ""  # "canvas", "moodle" or "blackboard", if that wrote the download
    tells_lateness: bool = False  # whether it is known who was late

    @property
    def handed_in(self) -> int:
        """How many students or groups submitted something, whatever it is."""
        return len({s.id for s in self.students} | {u.user for u in self.unmatched if u.user})

    def set_duplicates_aside(self) -> None:
        """Moves submissions with one id to the unmatched ones: it isn't clear which counts."""
        by_id: dict[str, list[Student]] = {}
        for student in self.students:
            by_id.setdefault(student.id, []).append(student)
        self.students = [same[0] for same in by_id.values() if len(same) == 1]
        for id, same in by_id.items():
            if len(same) > 1:
                files = " and ".join(printable_name(student.path.name) for student in same)
                self.unmatched.append(Unmatched(id, f"could be {files}: keep one of them", id))
