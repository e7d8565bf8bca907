"""Finds each student's submission in a download from Canvas, Moodle or Blackboard, in a folder of
folders or zips, or in a checkout of repositories. What matches nobody is listed with the reason."""

import os
import zipfile
from collections.abc import Sequence
from pathlib import Path

from bounce_grader.classroom.intake.services import CANVAS, Service, SERVICES
from bounce_grader.classroom.intake.student import Class, Names, Student, Upload
from bounce_grader.classroom.intake.uploads import Archive, is_file, is_folder, of_macos
from bounce_grader.classroom.intake.uploads import opened, student_of
from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import printable_name
from bounce_grader.common.files import fitting
from bounce_grader.submission import submission
from bounce_grader.submission.intake import archive_stem, is_archive
from bounce_grader.submission.submission import part_file


def read(path: Path, people: Names = {}, best: bool = False) -> Class:
    """Reads a class; if the `best` attempt counts, with all attempts that are there. Raises
    UsageError if there is no submission in `path`."""
    path = path.absolute()
    if path.is_dir():
        children = sorted(child for child in path.iterdir() if not of_macos(child.name))
        files = [child.name for child in children if is_file(child)]
        folders = [f"{child.name}/x" for child in children if is_folder(child)]
        if service := _service([*files, *folders]):
            intake = _of_download(service, opened(path), people, best)
        else:
            intake = _of_folder(path, children)
    elif not path.exists():
        raise UsageError(f"there is no file or folder {printable_name(str(path))}")
    elif zipfile.is_zipfile(path):
        archive = opened(path)
        intake = _of_download(_service(archive.names) or CANVAS, archive, people, best)
    else:
        as_it_is = "give the download as it is, or anew"
        raise UsageError(f"{path} is no folder and no whole zip: {as_it_is}")
    if not intake.students:
        seen = f"the first entry, {intake.strays[0]}" if intake.strays else "it is empty"
        raise UsageError(f"no submission is found in {path}: {seen}")
    return intake


def _service(names: Sequence[str]) -> Service | None:
    """The service whose download has such files, or None.

    Students choose how their files' names end, so every name that looks like some service's has to
    look like this one's. Blackboard's begin with any title, so a student could imitate one in
    another service's download. But Canvas gives each file its own id, and Blackboard's names for
    the user 12345 and an assignment "HW_3" repeat one."""
    known = [name for name in names if any(service.parse(name) for service in SERVICES)]
    for service in SERVICES:
        parsed = list(map(service.parse, known))
        ids = [upload.number for upload in parsed if upload and not upload.instead]
        if known and all(parsed) and (service is not CANVAS or len(set(ids)) == len(ids)):
            return service
    return CANVAS if known else None


def _of_download(service: Service, archive: Archive, people: Names, best: bool) -> Class:
    intake = Class(f"a {service.title} download", service=service.title.lower())
    users: dict[tuple[str, int], list[Upload]] = {}
    for name, found in service.read(archive, people).items():
        if isinstance(found, str):
            intake.add_stray(name, found)
        else:
            users.setdefault((found.user, found.attempt * best), []).append(found)
    for _, uploads in sorted(users.items()):
        intake.students.append(student_of(archive.path, uploads, service.page_of(uploads)))
    return intake


# --- a folder of folders or zips, or a checkout of repositories ---


def _of_folder(path: Path, children: list[Path]) -> Class:
    intake = Class("a folder of submissions")
    taken = [child for child in children if not _no_submission(child)]
    cloned = [child for child in taken if os.path.exists(child / ".git")]
    cut = 0
    if 2 * len(cloned) > len(taken):
        cut = _common_prefix(path, cloned)
        before = f", named {cloned[0].name[:cut]!r} and a login" if cut else ""
        intake.source = f"a checkout of repositories{before}"
        intake.logins = True
        taken = cloned
    by_name: dict[str, list[Path]] = {}
    for child in taken:
        name = child.name[cut:] if is_folder(child) else archive_stem(child.name)
        by_name.setdefault(name, []).append(child)
    for name, (first, *others) in by_name.items():
        names = " and ".join(printable_name(path.name) for path in (first, *others))
        twice = f"it could be {names}: keep one of them" if others else ""
        page = "" if others else f"{fitting(name)}.html"
        intake.students.append(Student(name, name, first, feedback=page, refused=twice))
    for child in children:
        if child not in taken:
            why = _no_submission(child) or "is no repository, as the others are"
            intake.add_stray(child.name, why)
    _require_a_class(path, children, intake.students)
    return intake


def _require_a_class(path: Path, children: list[Path], students: list[Student]) -> None:
    """Raises UsageError if the folder holds no submission, or is one itself, perhaps with its parts
    in src. A student may also be called src."""
    is_one = any(part_file(child.name) and is_file(child) for child in children)
    others = (student.path for student in students if student.name != "src")
    if is_one or not any(map(_has_a_part, others)):
        if is_one or _has_a_part(path):
            raise UsageError(f"{path} is one submission, and no class: ./kit grade {path}")
        expected = "a service's download, or a folder with one folder or zip a student"
        raise UsageError(f"nothing in {path} holds a part: it should be {expected}")


def _no_submission(child: Path) -> str:
    """Why a child can't be a submission; "" if it can."""
    if child.name.startswith("."):
        return "is no submission"
    if not is_folder(child):
        return "" if is_file(child) and is_archive(child.name) else "is neither a folder nor a zip"
    written = os.path.exists(child / "results" / "set.json")
    return "was written by ./kit class, and is no submission" if written else ""


def _has_a_part(path: Path) -> bool:
    try:
        return bool(submission.read(path).parts)
    except UsageError:
        return False


def _common_prefix(path: Path, folders: list[Path]) -> int:
    """The length of the assignment's name, which is before the login in each repository's."""
    named = path.name.removesuffix("-submissions") + "-"
    if all(folder.name.startswith(named) for folder in folders):
        return len(named)
    common = os.path.commonprefix([folder.name for folder in folders])
    return common.rfind("-") + 1 if len(folders) > 1 else 0
