"""Finds each student's submission in a folder of folders or zips, or in a checkout of
repositories."""

import os
from pathlib import Path

from bounce_grader.classroom.intake.archive import is_file, is_folder, zip_alone
from bounce_grader.classroom.intake.student import Class, Student, Unmatched
from bounce_grader.common.errors import UsageError
from bounce_grader.common.files import fitting
from bounce_grader.common.manifest import parts
from bounce_grader.submission import submission
from bounce_grader.submission.intake import archive_stem, is_archive
from bounce_grader.submission.submission import part_file


def read(path: Path, children: list[Path]) -> Class:
    _require_a_folder_of_submissions(path, children)
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
    for child in taken:
        name = child.name[cut:] if is_folder(child) else archive_stem(child.name)
        submitted = zip_alone(child) or child
        intake.students.append(Student(name, name, submitted, feedback=f"{fitting(name)}.html"))
    other = "is no repository, as the others are"
    left = [child for child in children if child not in taken]
    intake.unmatched += [Unmatched(child.name, _no_submission(child) or other) for child in left]
    intake.set_duplicates_aside()
    if intake.students and not any(_has_a_part(student.path) for student in intake.students):
        raise UsageError(
            f"no folder or zip in {path} holds a part, as {parts()[0].file}: it should be "
            "Canvas's download, or a folder with one folder or zip a student"
        )
    return intake


def _require_a_folder_of_submissions(path: Path, children: list[Path]) -> None:
    """Raises UsageError if the folder is itself a submission. A student may be called src."""
    own = (path / "src").iterdir() if (path / "src").is_dir() else ()
    others = [c for c in children if c.name != "src" and (is_folder(c) or is_archive(c.name))]
    in_src = any(map(_is_part, own)) and not any(map(_has_a_part, others))
    if in_src or any(map(_is_part, children)):
        raise UsageError(f"{path} is one submission, and no class: ./kit grade {path}")


def _is_part(child: Path) -> bool:
    return part_file(child.name) is not None and is_file(child)


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
    """The length of the assignment's name, with which each repository's name begins; the login
    follows."""
    named = path.name.removesuffix("-submissions") + "-"
    if all(folder.name.startswith(named) for folder in folders):
        return len(named)
    common = os.path.commonprefix([folder.name for folder in folders])
    return common.rfind("-") + 1 if len(folders) > 1 else 0
