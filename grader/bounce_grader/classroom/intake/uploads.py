"""A service's download, a zip or the folder that it was unpacked to, and what it holds of one
student: which uploads count, what is said of the rest, and all of them as one submission.

Everything is read into memory, up to a limit on the total. Nothing is written, and no claimed size
is trusted.
"""

import os
import zipfile
import zlib
from collections.abc import Sequence
from contextlib import ExitStack
from functools import lru_cache
from pathlib import Path

from bounce_grader.classroom.intake.student import Student, Upload
from bounce_grader.common.errors import about_one_submission, UsageError
from bounce_grader.common.escaping import first_few, printable_name
from bounce_grader.common.manifest import parts
from bounce_grader.submission import intake, submission
from bounce_grader.submission.entry import Entry, HEADERS, LARGEST_SOURCE, of_bytes, SAFELY, SOURCES
from bounce_grader.submission.intake import checked, is_archive, name_in_zip, NOT_USED, UnpackLimits
from bounce_grader.submission.submission import COPY, part_file, Submission

FAILURES = (zipfile.BadZipFile, zlib.error, EOFError, OSError, ValueError, RuntimeError, KeyError)
MOST_ZIPS = 10
LARGEST = 64 * 1024 * 1024  # bytes of all uploads together
WHOLE = Path("the submission")  # its name in messages
MOST_UPLOADS = 100  # of a student's
HAND_IN = f"hand in the parts, {parts()[0].file} to {parts()[-1].file}, as files or as one zip"


def is_file(path: Path) -> bool:
    """Whether it is an ordinary file, and no link to one."""
    return os.path.isfile(path) and not os.path.islink(path)


def is_folder(path: Path) -> bool:
    return os.path.isdir(path) and not os.path.islink(path)


def of_macos(name: str) -> bool:
    """Whether macOS has added this file beside others: it is nobody's, and nothing is said of it."""
    return "__MACOSX" in name.split("/") or name.split("/")[-1].startswith((".DS_Store", "._"))


class Damaged(UsageError):
    """The whole download is damaged, which is no student's fault."""


class Archive:
    """Reads entries by name, at most `limit` bytes of each. Raises UsageError."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._zip: zipfile.ZipFile | None = None
        if path.is_dir():
            files = (file for file in path.rglob("*") if not is_folder(file))
            names = sorted(str(file.relative_to(path)) for file in files)
        else:
            try:
                self._zip = zipfile.ZipFile(path)
                infos = self._zip.infolist()
            except FAILURES as error:
                raise Damaged(f"{path} is broken ({error}): download it again") from error
            self._infos = {name_in_zip(info): info for info in infos if not info.is_dir()}
            names = list(self._infos)
        self.names = [name for name in names if not of_macos(name)]

    def read(self, name: str, limit: int) -> bytes:
        try:
            if self._zip:
                with self._zip.open(self._infos[name]) as stream:
                    return stream.read(limit)
            path = self.path / name
            if not is_file(path):
                raise ValueError("it is a link" if path.is_symlink() else "it is no ordinary file")
            with open(os.open(path, SAFELY), "rb") as file:
                return file.read(limit)
        except FAILURES as error:
            if not self._zip:
                raise UsageError(f"{name} can't be read from {self.path.name}: {error}") from error
            damaged = f"{self.path} is damaged ({name}: {error})"
            raise Damaged(f"{damaged}: download it again") from error


def opened(path: Path) -> Archive:
    """Opens an archive, and caches it until the file changes: its list of entries may be long."""
    status = path.stat()
    return _opened(path, (status.st_mtime_ns, status.st_ino))


_opened = lru_cache(maxsize=2)(lambda path, _status: Archive(path))


# --- of one student ---


def may_count(file: str) -> bool:
    is_of_cases = file.startswith("examples") and file.endswith(".txt")  # Canvas adds numbers
    return _ending(file) in SOURCES | HEADERS or is_archive(file) or is_of_cases


def _ending(file: str) -> str:
    return os.path.splitext(file)[1].lower()


def student_of(download: Path, uploads: Sequence[Upload], page: str) -> Student:
    """The student who has uploaded these, with the name of their feedback page."""
    last = max(uploads, key=lambda upload: upload.number)
    late = None if any(upload.late for upload in uploads) else 0
    counted, unused = _counted(uploads)
    why = "" if counted else f"{first_few(unused, separator='; ')}: {HAND_IN}"
    number = sum(not u.instead and u.attempt == last.attempt for u in uploads)
    if number > MOST_UPLOADS:
        why = f"{number} files are handed in; a submission may have {MOST_UPLOADS}: {HAND_IN}"
    student = Student(last.user, last.name or last.user, download, counted, page, seconds_late=late)
    return student._replace(unused=() if why else unused, refused=why)


def _counted(uploads: Sequence[Upload]) -> tuple[tuple[Upload, ...], tuple[str, ...]]:
    """The newest upload of each file, and a sentence for each upload that isn't used."""
    newest: dict[str, Upload] = {}
    unused, attempt = [], max(upload.attempt for upload in uploads)
    for upload in sorted(uploads, key=lambda upload: -upload.number):
        shown, file = printable_name(upload.file), names_of(upload)[0]
        if upload.instead:
            unused.append(upload.instead)
        elif upload.attempt < attempt:
            unused.append(f"{shown} is of an older attempt")
        elif not may_count(file):
            unused.append(f"{shown} {NOT_USED}")
        elif file in newest:
            unused.append(f"{shown} is older than {printable_name(newest[file].file)}")
        else:
            newest[file] = upload
    return tuple(sorted(newest.values(), key=lambda upload: upload.number)), tuple(unused)


def names_of(upload: Upload) -> list[str]:
    """The names of a file in the submission. Canvas adds a number to a file that is handed in
    again: rotation-1.hpp is rotation.hpp. A number may also be the student's, so a header keeps
    both names."""
    file = upload.file
    dots = [dot for dot in (file.rfind("."), file.find(".")) if dot > 0]
    plain = [COPY.sub("", file[:dot]) + file[dot:] for dot in dots]
    if upload.as_named:
        return [file]
    without_number: str = next((name for name in plain if name != file), file)
    own = part_file(file) or without_number
    return list({file: "", own: ""}) if _ending(file) in HEADERS else [own]


# --- as one submission ---


def read(student: Student) -> Submission:
    """Reads what a student has handed in. Raises UsageError."""
    if student.refused:
        raise UsageError(student.refused)
    if not student.uploads:
        return submission.read(student.path)
    with about_one_submission(f"{WHOLE} can't be read"), ExitStack() as open_zips:
        merged = _merged(opened(student.path), student.uploads, open_zips)
        taken = submission.take(WHOLE, list(merged.values()))
    return taken


def _merged(archive: Archive, uploads: Sequence[Upload], open_zips: ExitStack) -> dict[str, Entry]:
    """The files of all uploads, oldest first. A newer file replaces an older one of its name or
    part. Raises UsageError if all together are too large."""
    merged: dict[str, Entry] = {}
    left, room = UnpackLimits(), LARGEST
    if sum(is_archive(upload.file) for upload in uploads) > MOST_ZIPS:
        raise UsageError(f"{WHOLE} holds more than {MOST_ZIPS} zips: hand in one")
    for upload in uploads:
        packed = is_archive(upload.file)
        # One byte more than a source may have is enough to see that it is too large.
        data = archive.read(upload.entry, 1 + (room if packed else min(room, LARGEST_SOURCE)))
        room -= len(data)
        if room < 0:
            most = f"all that is handed in may have {LARGEST >> 20} MB"
            raise UsageError(f"{upload.file} is too large: {most}")
        if packed:
            name = Path(upload.file) if len(uploads) > 1 else WHOLE
            newer = open_zips.enter_context(intake.opened(name, data, left))
        else:
            newer = list(checked(WHOLE, (of_bytes(name, data) for name in names_of(upload))))
        links = {entry.name: entry for entry in newer if entry.link}  # links replace no file
        files = {entry.name: entry for entry in newer if not entry.link}
        replaced = set() if upload.as_named else {*map(_part, files)} - {None}
        older = {name: e for name, e in merged.items() if _part(name) not in replaced}
        merged = links | older | files
    return merged


def _part(name: str) -> str | None:
    return part_file(os.path.basename(name))
