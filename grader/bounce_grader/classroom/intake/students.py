"""Finds each student's submission in a download from Canvas, Moodle or Blackboard, in a folder of
folders or zips, or in a checkout of repositories. What can't be matched is listed, with the
reason."""

import zipfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from bounce_grader.classroom.intake import blackboard, canvas, from_folder, moodle
from bounce_grader.classroom.intake.archive import is_file, opened
from bounce_grader.classroom.intake.student import Class
from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import printable_name
from bounce_grader.submission.intake import is_archive


def read(path: Path, people: Mapping[str, str] = {}) -> Class:
    """Reads a class. `people` are the names in the grade book, by Canvas's ids. Raises UsageError
    if there is no submission in `path`."""
    path = path.absolute()
    if path.is_dir():
        children = sorted(path.iterdir())
        names = [child.name for child in children if is_file(child)]
        service = _service(names)
        if service:
            intake = service(path, people)
        elif any(moodle.parse_folder(child.name) for child in children):
            intake = moodle.read_folders(children)
        else:
            intake = from_folder.read(path, children)
    elif not path.exists():
        raise UsageError(f"there is no file or folder {printable_name(str(path))}")
    elif zipfile.is_zipfile(path):
        service = _service(opened(path).names()) or canvas.read
        intake = service(path, people)
    else:
        cut = is_archive(path.name) or not path.stat().st_size
        reason = "is broken, or was cut short: download it again"
        other = "is neither a folder nor a zip: give Canvas's download as it is"
        raise UsageError(f"{path} {reason if cut else other}")
    if not intake.students:
        raise UsageError(f"no submission is found in {path}: {_expected(intake)}")
    intake.students.sort(key=lambda student: (student.name, student.id))
    return intake


def _service(names: Sequence[str]) -> Callable[[Path, Mapping[str, str]], Class] | None:
    """The reader for the service whose download has such files; None if there is no such service.

    Students choose how the names of their files end, so one name proves nothing: every name that
    looks like some service's has to look like this one's. Moodle and Canvas are tried first,
    because they write the beginning of each name themselves. Blackboard's names begin with the
    assignment's title, which may be anything. So in a download of another service, a student could
    give a file a name that looks like Blackboard's.
    """
    services = (moodle, canvas, blackboard)
    known = [name for name in names if any(service.parse(name) for service in services)]
    for service in services:
        if known and service.wrote_all(known):
            return service.read
    return canvas.read if known else None


def _expected(intake: Class) -> str:
    first = intake.unmatched[0] if intake.unmatched else None
    seen = f"the first entry, {first.name!r}, {first.reason}" if first else "it is empty"
    return (
        f"{seen}; it should be the download of Canvas, Moodle or Blackboard, or a folder with one "
        "folder or zip a student"
    )
