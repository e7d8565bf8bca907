"""One grading of a class: what is graded, and the name of its result."""

import hashlib
import os
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from bounce_grader import intake
from bounce_grader.classroom import handed_in
from bounce_grader.classroom.archive import Damaged, opened
from bounce_grader.classroom.canvas import Upload
from bounce_grader.classroom.students import Student, is_source
from bounce_grader.entry import LARGEST_SOURCE
from bounce_grader.errors import UsageError, about_one_submission


@dataclass(frozen=True)
class Stamp:
    """What a result follows from, but for the submission."""

    kit: str
    fixtures: str
    options: str


@dataclass(frozen=True)
class Task:
    """Everything that a worker needs, as words and numbers: it can be sent anywhere."""

    key: str
    submission: str  # digest
    stamp: Stamp
    path: str
    uploads: tuple[Upload, ...]
    results: str  # folder
    speed: bool
    trust: bool

    def as_json(self) -> dict[str, Any]:
        return asdict(self)


def from_json(words: dict[str, Any]) -> Task:
    stamp = Stamp(**words["stamp"])
    uploads = tuple(Upload(**upload) for upload in words["uploads"])
    rest = {name: words[name] for name in words.keys() - {"stamp", "uploads"}}
    return Task(stamp=stamp, uploads=uploads, **rest)


def task_of(student: Student, stamp: Stamp, results: Path, speed: bool, trust: bool) -> Task:
    submission = digest(student)
    key = _key(submission, stamp, speed)
    path = str(student.path)
    return Task(key, submission, stamp, path, student.uploads, str(results), speed, trust)


def with_times(task: Task) -> Task:
    return replace(task, key=_key(task.submission, task.stamp, True), speed=True)


def _key(submission: str, stamp: Stamp, speed: bool) -> str:
    words = [submission, stamp.kit, stamp.fixtures, stamp.options, *(["timed"] if speed else [])]
    return hashlib.sha256("\0".join(words).encode()).hexdigest()


def digest(student: Student) -> str:
    """Of every byte that could be used. One that can't be read is named by its reason. Raises
    Damaged where the class's download is."""
    found = hashlib.sha256()
    try:
        with about_one_submission("it can't be read"):
            _digest(student, found)
    except Damaged:
        raise
    except UsageError as error:
        found.update(os.fsencode(f"\0{error}"))
    return found.hexdigest()


def _digest(student: Student, found: "hashlib._Hash") -> None:
    if student.uploads:
        _digest_uploads(student.path, student.uploads, found)
    elif student.path.is_dir():
        _digest_folder(student.path, found)
    else:
        with student.path.open("rb") as stream:
            while chunk := stream.read(1 << 20):
                found.update(chunk)


def _digest_uploads(path: Path, uploads: tuple[Upload, ...], found: "hashlib._Hash") -> None:
    archive = opened(path)
    for upload, data in handed_in.contents(archive, uploads):
        heading = f"{upload.file}\0{archive.size(upload.entry)}\0"
        found.update(os.fsencode(heading) + data)


def _digest_folder(path: Path, found: "hashlib._Hash") -> None:
    with intake.opened(path) as entries:
        for entry in entries:
            found.update(os.fsencode(f"{entry.name}\0{entry.size}\0{entry.link}\0"))
            if is_source(entry.name) and not entry.link:
                found.update(entry.read(LARGEST_SOURCE + 1))
