"""What a service's download holds of one student: which uploads count, what is said of the rest, and
all of them as one submission.

Everything is read into memory, up to a limit on the total. Nothing is written, and no claimed size
is trusted.
"""

import os
from collections.abc import Iterable, Iterator, Sequence
from contextlib import ExitStack
from pathlib import Path

from bounce_grader.classroom.intake.archive import Archive, Damaged, opened
from bounce_grader.classroom.intake.student import Class, Student, Unmatched, Upload
from bounce_grader.common.errors import about_one_submission, UsageError
from bounce_grader.common.escaping import first_few, printable_name
from bounce_grader.common.manifest import parts
from bounce_grader.submission import intake, submission
from bounce_grader.submission.entry import (
    LARGEST_SOURCE,
    MOST_ENTRIES,
    Entry,
    of_bytes,
    UnpackLimits,
)
from bounce_grader.submission.intake import NOT_USED, is_archive
from bounce_grader.submission.submission import COPY, HEADERS, MOST_BYTES, part_file, SOURCES
from bounce_grader.submission.submission import Submission

MOST_ZIPS = 10
LARGEST = 64 * 1024 * 1024  # bytes of all uploads together
WHOLE = Path("the submission")  # its name in messages
MOST_UPLOADS = 100  # of a student's
HAND_IN = f"Hand in the parts, {parts()[0].file} to {parts()[-1].file}, as files or as one zip."


def may_count(file: str) -> bool:
    is_of_cases = file.startswith("examples") and file.endswith(".txt")  # Canvas adds numbers
    return _is_source(file) or is_archive(file) or is_of_cases


def _is_source(file: str) -> bool:
    return os.path.splitext(file)[1].lower() in SOURCES | HEADERS


def take(to: Class, archive: Archive, uploads: Sequence[Upload], page: str) -> None:
    """Adds the student who has uploaded these, with the name of their feedback page."""
    newest = max(uploads, key=lambda upload: upload.number)
    id, name = newest.user, newest.name or newest.user
    try:
        with about_one_submission("can't be read"):
            counted, unused = _counted(archive, uploads)
    except Damaged:
        raise
    except UsageError as error:
        shown = f"{name} ({id})"
        text = f"What you handed in {error}. {HAND_IN}"
        to.unmatched.append(Unmatched(shown, str(error), id, page, text))
        return
    if counted:
        late = any(upload.late for upload in uploads)
        student = Student(id, name, archive.path, tuple(counted), late, page, tuple(unused))
        to.students.append(student)
    else:
        reason = f"holds nothing that can be graded: {first_few(unused, separator='; ')}"
        text = f"{first_few(unused, separator='. ')}. {HAND_IN}"
        to.unmatched.append(Unmatched(f"{name} ({id})", reason, id, page, text))


def _counted(archive: Archive, uploads: Sequence[Upload]) -> tuple[list[Upload], list[str]]:
    """The newest upload of each file, and a sentence for each upload that isn't used. Raises
    UsageError if they can't be read."""
    number = sum(not upload.old for upload in uploads)
    if number > MOST_UPLOADS:
        raise UsageError(f"is {number} files; a submission may have {MOST_UPLOADS}")
    texts = texts_of(archive, uploads)
    newest: dict[str, Upload] = {}
    unused = []
    for upload in sorted(uploads, key=lambda upload: -upload.number):
        shown, file = printable_name(upload.file), own_name(upload, texts)
        if upload.typed:
            unused.append(f"{upload.typed} was typed, too")
        elif upload.old:
            unused.append(f"{shown} is of an older attempt")
        elif not may_count(file):
            unused.append(f"{shown} {NOT_USED}")
        elif file in newest:
            unused.append(f"{shown} is older than {printable_name(newest[file].file)}")
        else:
            newest[file] = upload
    return sorted(newest.values(), key=lambda upload: upload.number), unused


def texts_of(archive: Archive, uploads: Iterable[Upload]) -> list[bytes]:
    """The text of the sources, as far as they may be read. One that can't be read is reported
    later, by the grading."""
    texts, room = [], MOST_BYTES
    for upload in uploads:
        if _is_source(upload.file):
            try:
                texts.append(archive.read(upload.entry, min(room, LARGEST_SOURCE)))
                room -= len(texts[-1])
            except Damaged:
                raise
            except UsageError:
                continue
    return texts


def own_name(upload: Upload, texts: Iterable[bytes]) -> str:
    """The student's own name for a file, without the number that Canvas adds: rotation-1.hpp becomes
    rotation.hpp, unless the sources themselves mention "rotation-1.hpp"."""
    file = upload.file
    if upload.as_named:
        return file
    names = [file]
    for dot in (file.find("."), file.rfind(".")):  # the number is before either
        plain = COPY.sub("", file[:dot]) + file[dot:]
        names += [plain] if dot > 0 and plain != file else []
    named = [name for name in names if any(name.encode() in text for text in texts)]
    return part_file(file) or (named or names[-1:])[0]


def without_files(name: str, what: str, user: str, page: str) -> Unmatched:
    """Somebody who has handed in no file. `what` continues a sentence that begins with "It"."""
    reason = f"{what}, so nothing can be graded: ask for the files of the parts"
    return Unmatched(name, reason, user, page, f"It {what}. {HAND_IN}")


# --- as one submission ---


def read(path: Path, uploads: tuple[Upload, ...]) -> Submission:
    """Reads a submission. `path` is its folder or zip; or, with `uploads`, the download that holds
    them. Raises UsageError."""
    if not uploads:
        return submission.read(path)
    with about_one_submission(f"{WHOLE} can't be read"), ExitStack() as open_zips:
        entries = _merged(opened(path), uploads, open_zips)
        taken = submission.take(WHOLE, list(entries.values()))
    return taken


def _contents(archive: Archive, uploads: Iterable[Upload]) -> Iterator[tuple[Upload, bytes]]:
    """Each upload with its bytes. Of a source, at most one byte more than allowed is read, which is
    enough to see that it is too large. Raises UsageError if all together are too large."""
    room = LARGEST
    for upload in uploads:
        limit = room if is_archive(upload.file) else min(room, LARGEST_SOURCE)
        data = archive.read(upload.entry, limit + 1)
        room -= len(data)
        if room < 0:
            raise UsageError(
                f"{upload.file} is too large: all that is handed in may have {LARGEST >> 20} MB"
            )
        yield upload, data


def _merged(
    archive: Archive, uploads: tuple[Upload, ...], open_zips: ExitStack
) -> dict[str, Entry]:
    """The files of all uploads, which are given oldest first. A newer file replaces an older one of
    the same name or the same part."""
    texts = texts_of(archive, uploads)
    merged: dict[str, Entry] = {}
    left, listed = UnpackLimits(), 0
    if sum(is_archive(upload.file) for upload in uploads) > MOST_ZIPS:
        raise UsageError(f"{WHOLE} holds more than {MOST_ZIPS} zips: hand in one")
    for upload, data in _contents(archive, uploads):
        if is_archive(upload.file):
            name = Path(upload.file) if len(uploads) > 1 else WHOLE
            newer = open_zips.enter_context(intake.opened(name, data, left))
        else:
            newer = [of_bytes(own_name(upload, texts), data)]
        listed += len(newer)
        if listed > MOST_ENTRIES:
            raise UsageError(
                f"{WHOLE} holds more than {MOST_ENTRIES} files: hand in the parts alone"
            )
        links = {entry.name: entry for entry in newer if entry.link}  # links replace no file
        files = {entry.name: entry for entry in newer if not entry.link}
        replaced = set() if upload.as_named else {*map(_part, files)} - {None}
        older = {name: e for name, e in merged.items() if _part(name) not in replaced}
        merged = links | older | files
    return merged


def _part(name: str) -> str | None:
    return part_file(os.path.basename(name))
