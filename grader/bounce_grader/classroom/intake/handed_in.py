"""Reads what a student submitted (a folder, a zip, or uploads in a Canvas download) as one
submission.

Everything is read into memory, up to a limit on the total. Nothing is written, and no claimed size
is trusted.
"""

import os
from collections.abc import Iterable, Iterator
from contextlib import ExitStack
from pathlib import Path

from bounce_grader.classroom.intake.archive import opened, Archive
from bounce_grader.classroom.intake.student import Upload
from bounce_grader.classroom.intake.uploads import own_name, texts_of
from bounce_grader.common.errors import about_one_submission, UsageError
from bounce_grader.submission import intake, submission
from bounce_grader.submission.entry import LARGEST_SOURCE, MOST_ENTRIES, Entry, UnpackLimits
from bounce_grader.submission.intake import is_archive
from bounce_grader.submission.submission import Submission

MOST_ZIPS = 10
LARGEST = 64 * 1024 * 1024  # bytes of all uploads together
WHOLE = Path("the submission")  # its name in messages


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
            newer = [_entry(own_name(upload, texts), archive.size(upload.entry), data)]
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


def _entry(name: str, size: int, data: bytes) -> Entry:
    return Entry(name, size, False, lambda limit: data[:limit])


def _part(name: str) -> str | None:
    return submission.part_file(os.path.basename(name))
