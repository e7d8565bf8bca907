"""Lists and reads the files of a zip, in memory. Nothing is extracted to disk."""

import io
import stat
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import cast

from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import printable_text
from bounce_grader.submission.entry import MOST_ENTRIES, Entry, inside_name

ENCRYPTED = 0x1
UTF_8 = 0x800
LARGEST_DIRECTORY = 2 * 1024 * 1024  # of a table of contents, or a single read
METHODS = {zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED}  # others may need gigabytes


@contextmanager
def opened(path: Path, zipped: bytes | None = None) -> Iterator[Iterator[Entry]]:
    """The entries of the zip at `path`, or of the bytes `zipped`; they can be read while this is
    open. Raises UsageError if they can't be listed."""
    with _readable(path):
        raw = io.FileIO(path) if zipped is None else cast(io.RawIOBase, io.BytesIO(zipped))
        stream = _Bounded(raw)
    with stream:
        with _readable(path):
            is_zip = zipfile.is_zipfile(stream)
        if is_zip:
            with _readable(path):
                archive = zipfile.ZipFile(stream)
            yield _entries(path, archive)
        elif zipped is not None or path.suffix.lower() == ".zip":
            raise UsageError(f"{path} is broken, or no zip: make it anew and submit again")
        else:
            raise UsageError(f"{path} is neither a folder nor a zip")


class _Bounded(io.BufferedReader):
    """Limits one read: zipfile reads the table of contents in one piece, of the size that the zip
    claims."""

    def read(self, size: int | None = -1) -> bytes:
        if size is not None and size > LARGEST_DIRECTORY:
            raise _TooMany
        return super().read(size)


class _TooMany(Exception):
    pass


def name_of(info: zipfile.ZipInfo) -> str:
    """An entry's name. Canvas and macOS write UTF-8 without saying so; zipfile then takes it for
    code page 437."""
    if info.flag_bits & UTF_8:
        return info.filename
    try:
        return info.filename.encode("cp437").decode("utf-8")
    except UnicodeError:
        return info.filename


def _entries(path: Path, archive: zipfile.ZipFile) -> Iterator[Entry]:
    names: set[str] = set()
    if len(archive.infolist()) > MOST_ENTRIES:  # folders count, too
        raise _too_many(path)
    # Entries that share their bytes would be unpacked from them again and again.
    if sum(info.compress_size for info in archive.infolist()) > archive.start_dir:
        raise UsageError(f"{path} is broken (its entries overlap): make it anew and submit again")
    for info in archive.infolist():
        if info.filename.endswith(("/", "\\")):
            continue
        name = inside_name(path, name_of(info))
        if name in names:
            raise UsageError(f"{path} holds two entries of the same name: make it anew")
        names.add(name)
        yield _entry(path, archive, info, name)


def _entry(path: Path, archive: zipfile.ZipFile, info: zipfile.ZipInfo, name: str) -> Entry:
    if info.flag_bits & ENCRYPTED:
        raise UsageError(f"{path} is encrypted: submit it without a password")

    def read(limit: int) -> bytes:
        if info.compress_type not in METHODS:
            raise UsageError(f"{path} is compressed in an unusual way: make it anew, as plain zip")
        with _readable(path), archive.open(info) as stream:
            return stream.read(limit)

    kind = stat.S_IFMT(info.external_attr >> 16)  # 0 if the zip wasn't made on Unix
    return Entry(name, info.file_size, kind not in (0, stat.S_IFREG), read)


@contextmanager
def _readable(path: Path) -> Iterator[None]:
    try:
        yield
    except _TooMany as error:
        raise _too_many(path) from error
    except OSError as error:
        raise UsageError(f"{path} can't be read: {error.strerror or error}") from error
    except Exception as error:  # a broken zip makes zipfile raise a dozen kinds
        reason = printable_text(str(error) or type(error).__name__, 200)
        raise UsageError(f"{path} is broken ({reason}): make it anew and submit again") from error


def _too_many(path: Path) -> UsageError:
    return UsageError(f"{path} holds more than {MOST_ENTRIES} files: submit the parts alone")
