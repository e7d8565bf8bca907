"""What a service's download holds of one student: which uploads count, and what is said of the
rest."""

import os
from collections.abc import Iterable, Sequence

from bounce_grader.classroom.intake.archive import Archive, Damaged
from bounce_grader.classroom.intake.student import Class, Student, Unmatched, Upload
from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import first_few, printable_name
from bounce_grader.common.manifest import parts
from bounce_grader.submission.entry import LARGEST_SOURCE
from bounce_grader.submission.intake import NOT_USED, is_archive
from bounce_grader.submission.submission import HEADERS, MOST_BYTES, SOURCES

MOST_UPLOADS = 100  # of a student's
HAND_IN = f"Hand in the parts, {parts()[0].file} to {parts()[-1].file}, as files or as one zip."


def may_count(file: str) -> bool:
    is_of_cases = file.startswith("examples") and file.endswith(".txt")  # Canvas adds numbers
    return is_source(file) or is_archive(file) or is_of_cases


def is_source(file: str) -> bool:
    return os.path.splitext(file)[1].lower() in SOURCES | HEADERS


def texts_of(archive: Archive, uploads: Iterable[Upload]) -> list[bytes]:
    """The text of the sources, as far as they may be read. One that can't be read is reported
    later, by the grading."""
    texts, room = [], MOST_BYTES
    for upload in uploads:
        if is_source(upload.file):
            try:
                texts.append(archive.read(upload.entry, min(room, LARGEST_SOURCE)))
                room -= len(texts[-1])
            except Damaged:
                raise
            except UsageError:
                continue
    return texts


def take(
    intake: Class, archive: Archive, id: str, name: str, uploads: list[Upload], page: str
) -> None:
    """Adds a student whose uploads all count."""
    if len(uploads) > MOST_UPLOADS:
        reason = f"is {len(uploads)} files; a submission may have {MOST_UPLOADS}"
        intake.unmatched.append(refused(name, reason, id, page))
        return
    usable = [upload for upload in uploads if may_count(upload.file)]
    unused = tuple(
        f"{printable_name(upload.file)} {NOT_USED}" for upload in uploads if upload not in usable
    )
    if usable:
        student = Student(id, name, archive.path, tuple(usable), feedback=page, unused=unused)
        intake.students.append(student)
        return
    intake.unmatched.append(of_no_use(name, unused, id, page))


def refused(name: str, reason: str, user: str, page: str) -> Unmatched:
    return Unmatched(name, reason, user, page, f"What you handed in {reason}. {HAND_IN}")


def of_no_use(name: str, unused: Sequence[str], user: str, page: str) -> Unmatched:
    """`unused` has a sentence for each upload."""
    reason = f"holds nothing that can be graded: {first_few(unused, separator='; ')}"
    page_text = f"{first_few(unused, separator='. ')}. {HAND_IN}"
    return Unmatched(name, reason, user, page, page_text)


def typed_elsewhere(intake: Class, name: str, service: str, user: str, page: str) -> None:
    what = f"is text typed into {service}"
    reason = f"{what}, with no file to grade: ask for the files of the parts"
    intake.unmatched.append(Unmatched(name, reason, user, page, f"It {what}. {HAND_IN}"))


def not_named(service: str, name: str) -> str:
    if name.startswith("__MACOSX") or name.endswith(".DS_Store"):
        return "was made by macOS, and is no submission"
    return f"isn't named as {service} names submissions"
