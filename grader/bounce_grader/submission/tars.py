"""Lists and reads the files of a tar, compressed or not, in memory. Nothing is extracted to
disk."""

import bz2
import gzip
import io
import lzma
import tarfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import printable_text
from bounce_grader.submission.entry import MOST_ENTRIES, Entry, inside_name

LARGEST = 64 * 1024 * 1024  # bytes, unpacked
MEMORY = 128 * 1024 * 1024  # of xz, which may ask for gigabytes


@contextmanager
def opened(path: Path, packed: bytes) -> Iterator[Iterator[Entry]]:
    """The entries of a tar. Raises UsageError if they can't be listed."""
    try:
        data = _unpacked(packed)
        if len(data) > LARGEST:
            raise UsageError(
                f"{path} unpacks to more than {LARGEST >> 20} MB: submit the parts alone"
            )
        with tarfile.open(fileobj=io.BytesIO(data), mode="r:") as archive:
            yield _entries(path, archive)
    except UsageError:
        raise
    except Exception as error:  # a broken one raises a dozen kinds
        reason = printable_text(str(error) or type(error).__name__, 200)
        raise UsageError(f"{path} is broken ({reason}): make it anew and submit again") from error


def _unpacked(packed: bytes) -> bytes:
    """At most one byte more than allowed."""
    if packed.startswith(b"\x1f\x8b"):
        return gzip.open(io.BytesIO(packed)).read(LARGEST + 1)
    if packed.startswith(b"BZh"):
        return bz2.open(io.BytesIO(packed)).read(LARGEST + 1)
    if packed.startswith(b"\xfd7zXZ"):
        return lzma.LZMADecompressor(memlimit=MEMORY).decompress(packed, LARGEST + 1)
    return packed


def _entries(path: Path, archive: tarfile.TarFile) -> Iterator[Entry]:
    names: set[str] = set()
    for seen, info in enumerate(archive):
        if seen >= MOST_ENTRIES:
            raise UsageError(f"{path} holds more than {MOST_ENTRIES} files: submit the parts alone")
        if info.isdir():
            continue
        name = inside_name(path, info.name)
        if name in names:
            raise UsageError(f"{path} holds two entries of the same name: make it anew")
        names.add(name)
        yield Entry(name, info.size, not info.isreg(), _reader(archive, info))


def _reader(archive: tarfile.TarFile, info: tarfile.TarInfo) -> Callable[[int], bytes]:
    def read(most: int) -> bytes:
        stream = archive.extractfile(info)
        return stream.read(most) if stream else b""

    return read
