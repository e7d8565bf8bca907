"""Finds each student's submission in a download from Canvas, Moodle or Blackboard, in a folder of
folders or zips, or in a checkout of repositories. What can't be matched is listed, with the
reason."""

import zipfile
from collections.abc import Sequence
from pathlib import Path
from types import ModuleType

from bounce_grader.classroom.intake import blackboard, canvas, from_folder, moodle
from bounce_grader.classroom.intake.archive import Archive, is_file, is_folder, of_macos, opened
from bounce_grader.classroom.intake.student import Class, Names, Unmatched, Upload
from bounce_grader.classroom.intake.uploads import take, without_files
from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import printable_name
from bounce_grader.submission.intake import is_archive

# Each has its title, `parse` for the name of one entry, `read` for all entries of a download, and
# `page_of` for the name of a feedback page.
SERVICES = (moodle, canvas, blackboard)


def read(path: Path, people: Names = {}) -> Class:
    """Reads a class. Raises UsageError if there is no submission in `path`."""
    path = path.absolute()
    if path.is_dir():
        children = sorted(child for child in path.iterdir() if not of_macos(child.name))
        service = _service([child.name for child in children if is_file(child)])
        if service:
            intake = _of_download(service, opened(path), people)
            beside = "is a folder beside a download's files, and isn't read"
            intake.unmatched += [Unmatched(c.name, beside) for c in children if is_folder(c)]
        elif any(is_folder(child) and moodle.parse(f"{child.name}/x") for child in children):
            intake = _of_download(moodle, opened(path, deep=True), people)
        else:
            intake = from_folder.read(path, children)
    elif not path.exists():
        raise UsageError(f"there is no file or folder {printable_name(str(path))}")
    elif zipfile.is_zipfile(path):
        archive = opened(path)
        intake = _of_download(_service(archive.names()) or canvas, archive, people)
    else:
        cut = is_archive(path.name) or not path.stat().st_size
        reason = "is broken, or was cut short: download it again"
        other = "is neither a folder nor a zip: give Canvas's download as it is"
        raise UsageError(f"{path} {reason if cut else other}")
    if not intake.students:
        raise UsageError(f"no submission is found in {path}: {_expected(intake)}")
    intake.students.sort(key=lambda student: (student.name, student.id))
    return intake


def _service(names: Sequence[str]) -> ModuleType | None:
    """The service whose download has such files; None if there is no such service.

    Students choose how the names of their files end, so one name proves nothing: every name that
    looks like some service's has to look like this one's. Moodle and Canvas are tried first,
    because they write the beginning of each name themselves. Blackboard's names begin with the
    assignment's title, which may be anything. So in a download of another service, a student could
    give a file a name that looks like Blackboard's. But Canvas gives each file an id of its own; what
    Blackboard writes of the user 12345 and an assignment "HW_3" looks like one file, several times.
    """
    known = [name for name in names if any(service.parse(name) for service in SERVICES)]
    for service in SERVICES:
        parsed = list(map(service.parse, known))
        ids = [upload.number for upload in parsed if upload and not upload.typed]
        if known and all(parsed) and (service is not canvas or len(set(ids)) == len(ids)):
            return service
    return canvas if known else None


def _of_download(service: ModuleType, archive: Archive, people: Names) -> Class:
    title = service.TITLE
    intake = Class(f"a {title} download", service=title.lower(), tells_lateness=service is canvas)
    users: dict[str, list[Upload]] = {}
    typed: list[Upload] = []
    for name, found in service.read(archive, people).items():
        if isinstance(found, str):
            intake.unmatched.append(Unmatched(name, found))
        elif found.typed:
            typed.append(found)
        else:
            users.setdefault(found.user, []).append(found)
    for one in typed:
        if one.user in users:
            users[one.user].append(one)
        else:
            what = f"is {one.typed} typed into {title}"
            page = service.page_of([one])
            intake.unmatched.append(without_files(one.entry, what, one.user, page))
    for uploads in users.values():
        take(intake, archive, uploads, service.page_of(uploads))
    return intake


def _expected(intake: Class) -> str:
    first = intake.unmatched[0] if intake.unmatched else None
    seen = f"the first entry, {first.name!r}, {first.reason}" if first else "it is empty"
    return (
        f"{seen}; it should be the download of Canvas, Moodle or Blackboard, or a folder with one "
        "folder or zip a student"
    )
