"""A task: one submission to grade, and the key of its result."""

import hashlib
import os
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from bounce_grader.classroom.intake import handed_in
from bounce_grader.classroom.intake.archive import Damaged
from bounce_grader.classroom.intake.student import Student, Upload
from bounce_grader.common.errors import UsageError


@dataclass(frozen=True)
class Stamp:
    """Digests of all that a result depends on, except the submission."""

    kit: str
    fixtures: str
    options: str


@dataclass(frozen=True)
class Task:
    """Everything that a worker needs, in plain values that can be sent to any machine."""

    key: str
    submission: str  # digest
    stamp: Stamp
    path: str
    uploads: tuple[Upload, ...]
    results: str  # folder
    speed: bool
    trust: bool


def task_of(student: Student, stamp: Stamp, results: Path, speed: bool, trust: bool) -> Task:
    submission = digest(student)
    key = _key(submission, stamp, speed)
    path = str(student.path)
    return Task(key, submission, stamp, path, student.uploads, str(results), speed, trust)


def with_times(task: Task) -> Task:
    return replace(task, key=_key(task.submission, task.stamp, True), speed=True)


def _key(submission: str, stamp: Stamp, speed: bool) -> str:
    data = [submission, stamp.kit, stamp.fixtures, stamp.options, *(["timed"] if speed else [])]
    return hashlib.sha256("\0".join(data).encode()).hexdigest()


def digest(student: Student) -> str:
    """A digest of all that is used of a submission, or of the reason if it can't be read. Raises
    Damaged if the class's download is damaged."""
    data: list[Any] = [os.path.isdir(student.path)]
    try:
        taken = handed_in.read(student.path, student.uploads)
        data += [taken.sha256, taken.parts, taken.refused, taken.ignored]
    except Damaged:
        raise
    except UsageError as error:
        data.append(str(error).replace(str(student.path), ""))
    return hashlib.sha256(repr(data).encode()).hexdigest()
