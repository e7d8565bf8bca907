"""The results of a class, from which its outputs are made: what is known of each submission, graded or
not, and its row of grades.csv."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any
from urllib.parse import quote

from bounce_grader.classroom.intake.student import Comment, Member, Student
from bounce_grader.common.escaping import first_few, Value
from bounce_grader.common.manifest import full_points, named_together, parts
from bounce_grader.grading.report import NO_REPORT, Report
from bounce_grader.submission.submission import JUDGED

# Files that are handed in beside parts, and are none under another name.
NO_PART = re.compile(r"(\S*/)?(readme|cmakelists|makefile|\.ds_store|\._|__macosx)", re.IGNORECASE)
COLUMNS = [*(part.stem for part in parts()), *(c.id for part in parts() for c in part.checks)]
MOST_UNUSED = 20  # names of unused files in a cell
MEMBERS = "members"  # the folder of their pages
ODD = {"timed_out", "out_of_memory", "no_answer", "crashed", "does_not_compile"}  # ends of a part


@dataclass
class Summary:
    """One submission with its record, and what follows from it."""

    student: Student
    state: str  # "graded", "unreadable", or "failed" (the kit)
    message: str = ""  # why it isn't graded
    key: str = ""  # of the result
    record: Report = field(default_factory=lambda: NO_REPORT)  # empty unless it is graded
    beside: tuple[str, ...] = ()  # sources that aren't parts
    notes: list[str] = field(default_factory=list)  # what else a person should look at
    attempt: str = ""  # which one it is, if there are several
    comments: list[Comment] = field(default_factory=list)  # the instructor's
    finals: list[Member] = field(default_factory=list)  # with their points, if it is graded

    def __post_init__(self) -> None:
        self.score: float | None = self.record.get("score")
        self.has_all_points = (self.score or 0.0) >= full_points()
        self.parts: list[dict[str, Any]] = self.record.get("parts", [])
        self.checks = {check["id"]: check for part in self.parts for check in part["checks"]}
        mistakes = (mistake for part in self.parts for mistake in part["mistakes"])
        self.mistakes: dict[str, str] = {m["name"]: m["title"] for m in mistakes}  # their titles
        self.speed: dict[str, Any] = self.record.get("speed") or {}
        ignored = [f"{name} wasn't used" for name in self.record.get("ignored", [])]
        self.unused = [*self.student.unused, *ignored]
        self.unused_more = int(self.record.get("ignored_more", 0))  # the number of others

    @property
    def needs_a_look(self) -> str:
        """The reasons for which a person should look at it; "" if there are none."""
        reasons = [] if self.state == "graded" else [self.message]
        for part in self.parts:
            name = f"part {part['part']}"
            reasons += [f"{name}: {part['status'].replace('_', ' ')}"] * (part["status"] in ODD)
            reasons += [f"{name}: {remark}" for remark in part["remarks"]]
        twice = [name for name in self.unused if JUDGED in name]
        reasons += [*(self._misnamed() or twice), *self.notes]
        if (box := self.record.get("box")) in ("none", "reduced"):
            reasons.append(f"graded with {'no' if box == 'none' else 'a reduced'} box")
        return "; ".join(dict.fromkeys(reasons))

    def _misnamed(self) -> list[str]:
        """A missing part may be there under another name, or in a file that can't be read."""
        missing = [part["part"] for part in self.parts if part["status"] == "not_submitted"]
        others = [*self.unused, *(f"{name} is no part by its name" for name in self.beside)]
        others = [other for other in others if not NO_PART.match(other)]
        there = first_few(others, separator="; ", more=self.unused_more)
        return [f"{named_together(missing)} not there, but {there}"] if missing and others else []

    def page_of(self, member: Member) -> str:
        """The name of a member's page: in a group, each has one of their own."""
        own = f"{MEMBERS}/{quote(member.id, safe='')}.html"
        return own if len(self.student.members) > 1 else self.student.feedback

    def row(self) -> dict[str, Value]:
        """The row of grades.csv, by column."""
        student, finals, speed = self.student, self.finals, self.speed
        points = {part["stem"]: part["score"] for part in self.parts}
        points |= {id: check["score"] for id, check in self.checks.items()}
        return {
            "student": student.shown,
            "id": student.id,
            "late": "" if student.seconds_late == 0 else "late",
            "state": self.state,
            "score": _number(self.score),
            "final": _of_members({one.id: _number(round(one.points, 2)) for one in finals}),
            "adjustments": _of_members({one.id: _changes(one) for one in finals}) or "",
            **{column: _number(points.get(column)) for column in COLUMNS},
            "mistakes": "; ".join(self.mistakes.values()),
            "times the solution's time": _number(speed.get("ratio")),
            "largest error": _number(speed.get("largest_error")),
            "needs a look": self.needs_a_look,
            "not used": first_few(self.unused, MOST_UNUSED, "; ", self.unused_more),
            "result": self.key,
        }


def _of_members(values: Mapping[str, Value]) -> Value:
    """What all members of a group have; or what each has, where they differ."""
    if len(set(values.values())) > 1:
        return "; ".join(f"{id}: {value}" for id, value in values.items() if value != "")
    return next(iter(values.values()), None)


def _changes(member: Member) -> str:
    return ", ".join(f"{a.reason} {a.points:+g}" if a.points else a.reason for a in member.applied)


def _number(value: float | None) -> Value:
    if value is None:
        return None
    rounded = float(f"{value:.6g}")
    return int(rounded) if rounded.is_integer() else rounded
