"""Finds each student's submission in Canvas's download, packed or unpacked."""

from collections.abc import Mapping
from pathlib import Path

from bounce_grader.classroom.intake import canvas
from bounce_grader.classroom.intake.archive import Archive, Damaged, is_folder, opened
from bounce_grader.classroom.intake.canvas import TextEntry, Upload
from bounce_grader.classroom.intake.student import Class, Student, Unmatched
from bounce_grader.classroom.intake.uploads import (
    HAND_IN,
    may_count,
    MOST_UPLOADS,
    of_no_use,
    refused,
    texts_of,
)
from bounce_grader.common.errors import about_one_submission, UsageError
from bounce_grader.common.escaping import printable_name
from bounce_grader.common.files import fitting
from bounce_grader.submission.intake import NOT_USED

EITHER = (
    "could be one of several users', by its name: look in Canvas who handed it in, and grade it by "
    "itself with ./kit grade"
)


def read(path: Path, people: Mapping[str, str]) -> Class:
    archive = opened(path)
    intake = Class("a Canvas download", service="canvas")
    if path.is_dir():
        folders = [child.name for child in sorted(path.iterdir()) if is_folder(child)]
        intake.unmatched += [
            Unmatched(f, "is a folder; Canvas's download has none") for f in folders
        ]
    users: dict[str, list[Upload]] = {}
    entries = archive.names()
    read_as = canvas.read_all((name for name in entries if "/" not in name), people)
    for name in entries:
        parsed = read_as.get(name)
        if isinstance(parsed, Upload):
            users.setdefault(parsed.user, []).append(parsed)
        elif parsed:
            intake.unmatched.append(_typed(name, parsed))
        else:
            either = canvas.parse(name) and "/" not in name
            intake.unmatched.append(Unmatched(name, EITHER if either else _no_name(name)))
    take_uploads(intake, archive, users)
    return intake


def take_uploads(intake: Class, archive: Archive, users: Mapping[str, list[Upload]]) -> None:
    """Adds the students who submitted these uploads to Canvas."""
    for user, uploads in users.items():
        page = canvas.feedback_name(tuple(uploads))
        name = page.removesuffix("_feedback.html")
        try:
            student = _student(archive, user, uploads)
        except Damaged:
            raise
        except UsageError as error:
            intake.unmatched.append(refused(name, str(error), user, page))
            continue
        if student.uploads:
            intake.students.append(student)
        else:
            intake.unmatched.append(of_no_use(name, student.unused, user, page))


def _student(archive: Archive, user: str, uploads: list[Upload]) -> Student:
    """The student who submitted these uploads. Raises UsageError if they can't be read."""
    if len(uploads) > MOST_UPLOADS:
        raise UsageError(f"is {len(uploads)} files; a submission may have {MOST_UPLOADS}")
    with about_one_submission("can't be read"):
        counted, unused = _newest(archive, uploads)
    newest = max(uploads, key=lambda upload: upload.attachment)
    return Student(
        id=user,
        name=newest.name or user,
        path=archive.path,
        uploads=tuple(counted),
        late=any(upload.late for upload in uploads),
        feedback=canvas.feedback_name(tuple(uploads)),
        unused=tuple(unused),
    )


def _newest(archive: Archive, uploads: list[Upload]) -> tuple[list[Upload], list[str]]:
    """The newest upload of each file, and a sentence for each upload that isn't used."""
    texts = texts_of(archive, uploads)
    newest: dict[str, Upload] = {}
    unused = []
    for upload in sorted(uploads, key=lambda u: -u.attachment):
        file = canvas.plain_file(upload.file, texts)
        if not may_count(file):
            unused.append(f"{printable_name(upload.file)} {NOT_USED}")
        elif file in newest:
            newer = printable_name(newest[file].file)
            unused.append(f"{printable_name(upload.file)} is older than {newer}")
        else:
            newest[file] = upload
    return sorted(newest.values(), key=lambda u: u.attachment), unused


def _typed(name: str, entry: TextEntry) -> Unmatched:
    """A text entry or address, which can't be graded. Canvas can't import its feedback page, whose
    name would need the id of an attachment."""
    what = "text typed into Canvas" if entry.kind == "text" else "an address typed into Canvas"
    reason = f"is {what}, with no file to grade: ask for the files of the parts"
    page = f"{fitting(name.removesuffix('.html'))}_feedback.html"
    return Unmatched(name, reason, entry.user, page, f"It is {what}. {HAND_IN}")


def _no_name(name: str) -> str:
    if name.startswith("__MACOSX/") or name.endswith(".DS_Store"):
        return "was made by macOS, and is no submission"
    if "/" in name:
        return "is in a folder; Canvas's download has none"
    return "isn't named as Canvas names submissions (name_user_attachment_file)"
