"""A summary of a result, with what the grade book, the tables and the class page need; a whole
record is large."""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

from bounce_grader.classroom.intake.student import Student
from bounce_grader.common.escaping import first_few
from bounce_grader.common.manifest import full_points, named_together
from bounce_grader.grading import speed

# Files that are handed in beside parts, and are none under another name.
NO_PART = re.compile(r"(\S*/)?(readme|cmakelists|makefile|\.ds_store|\._|__macosx)", re.IGNORECASE)


class Applied(NamedTuple):
    """A change of a person's points after the grading."""

    points: float
    reason: str
    comment: str = ""


class Final(NamedTuple):
    """A person's points in the end."""

    id: str
    name: str
    points: float
    applied: tuple[Applied, ...] = ()
    listed: bool = False  # in the instructor's roster

    @property
    def changes(self) -> str:
        return ", ".join(
            f"{a.reason} {a.points:+g}" if a.points else a.reason for a in self.applied
        )


@dataclass(frozen=True)
class Summary:
    """What is known of one submission, graded or not: what the class's outputs are made of."""

    student: Student
    key: str
    state: str  # "graded", "unreadable", or "failed" (the kit)
    message: str = ""
    score: float | None = None
    parts: Mapping[int, float] = field(default_factory=dict)
    checks: Mapping[str, float] = field(default_factory=dict)  # points, by id
    most: Mapping[str, float] = field(default_factory=dict)  # points that a check gives
    passed: frozenset[str] = frozenset()  # checks
    statuses: Mapping[int, str] = field(default_factory=dict)  # only those that aren't "graded"
    mistakes: Mapping[str, str] = field(default_factory=dict)  # titles, by name
    caught: frozenset[str] = frozenset()  # wrong programs, by the cases that were handed in
    box: str = ""
    ratio: float | None = None  # time of a step over the solution's
    error: float | None = None
    curves: Mapping[str, tuple[speed.Point, ...]] = field(default_factory=dict)
    ignored: tuple[str, ...] = ()
    ignored_more: int = 0  # the number of others
    beside: tuple[str, ...] = ()  # sources that aren't parts
    notes: tuple[str, ...] = ()  # what else a person should look at
    finals: tuple[Final, ...] = ()  # of each member, if it is graded

    @property
    def unused(self) -> list[str]:
        return [*self.student.unused, *(f"{name} wasn't used" for name in self.ignored)]

    @property
    def has_all_points(self) -> bool:
        return (self.score or 0.0) >= full_points()

    @property
    def is_adjusted(self) -> bool:
        return any(final.applied for final in self.finals)

    @property
    def needs_a_look(self) -> list[str]:
        """The reasons for which a person should look at it."""
        reasons = [] if self.state == "graded" else [self.message]
        odd = {"timed_out", "out_of_memory", "no_answer", "crashed", "does_not_compile"}
        for number, status in self.statuses.items():
            if status in odd:
                reasons.append(f"part {number}: {status.replace('_', ' ')}")
        reasons += [*self._misnamed(), *self.notes]
        if self.box in ("none", "reduced"):
            reasons.append(f"graded with {'no' if self.box == 'none' else 'a reduced'} box")
        return reasons

    def with_note(self, note: str) -> "Summary":
        return replace(self, notes=(*self.notes, note))

    def with_finals(self, finals: Iterable[Final]) -> "Summary":
        return replace(self, finals=tuple(finals))

    def _misnamed(self) -> list[str]:
        """A missing part may be there under another name, or in a file that can't be read."""
        missing = [number for number, status in self.statuses.items() if status == "not_submitted"]
        others = [*self.unused, *(f"{name} is no part by its name" for name in self.beside)]
        others = [other for other in others if not NO_PART.match(other)]
        there = first_few(others, separator="; ", more=self.ignored_more)
        return [f"{named_together(missing)} not there, but {there}"] if missing and others else []


def of_result(student: Student, key: str, result: dict[str, Any]) -> Summary:
    record = result["record"]
    if not record:
        return Summary(student, key, result["state"], result["message"])
    checks = [check for part in record["parts"] for check in part["checks"]]
    measured = record.get("speed") or {}
    return Summary(
        student,
        key,
        result["state"],
        score=record["score"],
        parts={part["part"]: part["score"] for part in record["parts"]},
        checks={check["id"]: check["score"] for check in checks},
        most={check["id"]: check["max_score"] for check in checks},
        passed=frozenset(check["id"] for check in checks if check["passed"]),
        statuses={p["part"]: p["status"] for p in record["parts"] if p["status"] != "graded"},
        mistakes={m["name"]: m["title"] for part in record["parts"] for m in part["mistakes"]},
        caught=frozenset(record.get("examples", {}).get("caught", ())),
        box=record["box"],
        ratio=measured.get("ratio"),
        error=measured.get("largest_error"),
        curves={whose: tuple(speed.curve(measured, whose)) for whose in speed.CURVES},
        ignored=tuple(record["ignored"]),
        ignored_more=record.get("ignored_more", 0),
        beside=tuple(result.get("beside", ())),
        notes=tuple(
            f"part {part['part']}: {remark}"
            for part in record["parts"]
            for remark in part.get("remarks", [])
        ),
    )
