"""Lays out the files of a submission, as they are graded."""

import errno
import os
from pathlib import Path

from bounce_grader import intake, submission
from bounce_grader.classroom import canvas
from bounce_grader.classroom.archive import Archive, opened
from bounce_grader.classroom.canvas import Upload
from bounce_grader.classroom.students import is_source, is_zip
from bounce_grader.classroom.task import LARGEST_ZIP, Task
from bounce_grader.entry import LARGEST_SOURCE
from bounce_grader.errors import UsageError


def prepare(task: Task, folder: Path) -> Path:
    """The path to grade. Uploads of a Canvas download are laid out in `folder`; a single zip stays
    one. Raises UsageError."""
    path = Path(task.path)
    if not task.uploads:
        return path
    archive = opened(path)
    if len(task.uploads) == 1 and is_zip(task.uploads[0].file):
        return _zip(archive, task.uploads[0], folder)
    return _lay_out(archive, task.uploads, folder)


def _zip(archive: Archive, upload: Upload, folder: Path) -> Path:
    size = archive.size(upload.entry)
    if size > LARGEST_ZIP:
        raise UsageError(f"{upload.file} is {size >> 20} MB large; a zip may have 64 MB")
    path = folder / f"{upload.attachment}.zip"
    path.write_bytes(archive.read(upload.entry, LARGEST_ZIP))
    return path


def _lay_out(archive: Archive, uploads: tuple[Upload, ...], folder: Path) -> Path:
    """Oldest first, so that the newest upload of a part is the one that stays."""
    top = folder / "submission"
    top.mkdir()
    texts = [archive.read(u.entry, LARGEST_SOURCE) for u in uploads if is_source(u.file)]
    for upload in uploads:
        if is_zip(upload.file):
            _unpack(_zip(archive, upload, folder), top)
        else:
            name = canvas.plain_file(upload.file, texts)
            _drop_part(_files(top), name)
            data = archive.read(upload.entry, LARGEST_SOURCE)
            _write(top / name, data, archive.size(upload.entry))
    return top


def _unpack(zipped: Path, top: Path) -> None:
    older = _files(top)
    with intake.opened(zipped) as entries:
        for entry in entries:
            if not is_source(entry.name):
                _write(top / entry.name, b"", 0)  # so that it is listed as not used
            elif not entry.link:
                _drop_part(older, os.path.basename(entry.name))
                _write(top / entry.name, entry.read(LARGEST_SOURCE), entry.size)


def _files(top: Path) -> list[Path]:
    return [path for path in top.rglob("*") if path.is_file()]


def _drop_part(older: list[Path], name: str) -> None:
    """An older upload of the same part makes room."""
    part = submission.part_file(name)
    for path in older:
        if part and submission.part_file(path.name) == part:
            path.unlink(missing_ok=True)


def _write(path: Path, data: bytes, size: int) -> None:
    """A file too large keeps its size, without its bytes, so that the grader can name it."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
        if size > len(data):
            os.truncate(path, size)
    except (FileExistsError, NotADirectoryError, IsADirectoryError) as error:
        raise UsageError(f"{path.name} is a file and a folder at once: rename one") from error
    except OSError as error:
        if error.errno == errno.ENAMETOOLONG:
            raise UsageError(f"the name {path.name[:40]}… is too long: shorten it") from error
        raise
