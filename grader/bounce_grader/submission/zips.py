"""Lists and reads the files of a zip, in memory, without unpacking what isn't asked for."""

import io
import stat
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO, cast

from bounce_grader.common.errors import UsageError
from bounce_grader.submission.entry import MOST_ENTRIES, Entry, readable, too_many

ENCRYPTED = 0x1
UTF_8 = 0x800
LARGEST_DIRECTORY = 2 * 1024 * 1024  # of a table of contents, or a single read
METHODS = {zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED}  # others may need gigabytes


def entries(path: Path, stream: BinaryIO) -> Iterator[Entry]:
    """The entries of the zip, which can be read while the stream is open. Raises UsageError if they
    can't be listed."""
    with readable(path):
        bounded = _Bounded(cast(io.RawIOBase, stream))
        bounded.path = path
        if not zipfile.is_zipfile(bounded):
            if not isinstance(stream, io.BytesIO) and path.suffix.lower() != ".zip":
                raise UsageError(f"{path} is neither a folder nor a zip")
            raise UsageError(f"{path} is broken, or no zip: make it anew and submit again")
        archive = zipfile.ZipFile(bounded)
    infos = archive.infolist()
    if len(infos) > MOST_ENTRIES:  # folders count, too
        raise too_many(path)
    # Entries that share their bytes would be unpacked from them again and again.
    if sum(info.compress_size for info in infos) > archive.start_dir:
        raise UsageError(f"{path} is broken (its entries overlap): make it anew and submit again")
    for info in infos:
        if not info.filename.endswith(("/", "\\")):
            yield _entry(path, archive, info)


class _Bounded(io.BufferedReader):
    """Limits one read: zipfile reads the table of contents in one piece, of the size that the zip
    claims."""

    path: Path

    def read(self, size: int | None = -1) -> bytes:
        if size is not None and size > LARGEST_DIRECTORY:
            raise too_many(self.path)
        return super().read(size)


def name_of(info: zipfile.ZipInfo) -> str:
    """An entry's name. Canvas and macOS write UTF-8 without saying so; zipfile then takes it for
    code page 437."""
    if info.flag_bits & UTF_8:
        return info.filename
    try:
        return info.filename.encode("cp437").decode("utf-8")
    except UnicodeError:
        return info.filename


def _entry(path: Path, archive: zipfile.ZipFile, info: zipfile.ZipInfo) -> Entry:
    if info.flag_bits & ENCRYPTED:
        raise UsageError(f"{path} is encrypted: submit it without a password")

    def read(limit: int) -> bytes:
        if info.compress_type not in METHODS:
            raise UsageError(f"{path} is compressed in an unusual way: make it anew, as plain zip")
        with readable(path), archive.open(info) as stream:
            return stream.read(limit)

    kind = stat.S_IFMT(info.external_attr >> 16)  # 0 if the zip wasn't made on Unix
    return Entry(name_of(info), kind not in (0, stat.S_IFREG), read)
