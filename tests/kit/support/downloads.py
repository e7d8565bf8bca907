"""Makes downloads as Canvas does, and grades them."""

import zipfile
from pathlib import Path

from bounce_grader.classroom.intake import handed_in
from bounce_grader.classroom.intake.student import Student
from bounce_grader.classroom.work.task import Stamp
from bounce_grader.submission.submission import Submission

STAMP = Stamp("kit", "fixtures", "options")


def download(path: Path, entries: dict[str, bytes]) -> Path:
    with zipfile.ZipFile(path, "w") as archive:
        for name, data in entries.items():
            archive.writestr(name, data)
    return path


def inner_zip(tmp_path: Path, files: dict[str, bytes]) -> bytes:
    return download(tmp_path / "inner.zip", files).read_bytes()


def to_grade(student: Student) -> Submission:
    return handed_in.read(student.path, student.uploads)
