"""What the grade book, the tables and the class's page need of a result; a record is large."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from bounce_grader import speed
from bounce_grader.classroom.students import Student


@dataclass(frozen=True)
class Summary:
    student: Student
    key: str
    state: str  # "graded", "unreadable", "failed" (the kit), or "waiting"
    message: str = ""
    score: float | None = None
    parts: Mapping[int, float] = field(default_factory=dict)
    checks: Mapping[str, float] = field(default_factory=dict)  # points, by id
    statuses: Mapping[int, str] = field(default_factory=dict)  # where not "graded"
    mistakes: Mapping[str, str] = field(default_factory=dict)  # titles, by name
    box: str = ""
    ratio: float | None = None  # time of a step, beside the solution's
    error: float | None = None
    curves: Mapping[str, tuple[speed.Point, ...]] = field(default_factory=dict)
    ignored: tuple[str, ...] = ()

    @property
    def needs_a_look(self) -> list[str]:
        """Why a person should look at it."""
        reasons = [] if self.state == "graded" else [self.message]
        odd = {"timed_out", "out_of_memory", "no_answer", "crashed"}
        for number, status in self.statuses.items():
            if status in odd:
                reasons.append(f"part {number}: {status.replace('_', ' ')}")
        if self.box in ("none", "reduced"):
            reasons.append(f"graded with {'no' if self.box == 'none' else 'a reduced'} box")
        return reasons


def of_result(student: Student, key: str, result: dict[str, Any]) -> Summary:
    record = result["record"]
    if not record:
        return Summary(student, key, result["state"], result["message"])
    checks = [check for part in record["parts"] for check in part["checks"]]
    found = record.get("speed") or {}
    return Summary(
        student,
        key,
        result["state"],
        score=record["score"],
        parts={part["part"]: part["score"] for part in record["parts"]},
        checks={check["id"]: check["score"] for check in checks},
        statuses={p["part"]: p["status"] for p in record["parts"] if p["status"] != "graded"},
        mistakes={m["name"]: m["title"] for part in record["parts"] for m in part["mistakes"]},
        box=record["box"],
        ratio=found.get("ratio"),
        error=found.get("largest_error"),
        curves={whose: tuple(speed.curve(found, whose)) for whose in speed.CURVES},
        ignored=tuple(record["ignored"]),
    )
