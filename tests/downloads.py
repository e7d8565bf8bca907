"""Downloads as Canvas makes them, and what is graded of them."""

import zipfile
from pathlib import Path

from bounce_grader import submission
from bounce_grader.classroom import layout, students, task
from bounce_grader.classroom.task import Stamp

STAMP = Stamp("kit", "fixtures", "options")


def download(path: Path, entries: dict[str, bytes]) -> Path:
    with zipfile.ZipFile(path, "w") as archive:
        for name, data in entries.items():
            archive.writestr(name, data)
    return path


def inner_zip(tmp_path: Path, files: dict[str, bytes]) -> bytes:
    return download(tmp_path / "inner.zip", files).read_bytes()


def files_to_grade(student: students.Student, tmp_path: Path) -> dict[str, bytes]:
    folder = tmp_path / "laid out"
    folder.mkdir()
    made = task.task_of(student, STAMP, tmp_path, speed=False, trust=False)
    return submission.read(layout.prepare(made, folder)).files
