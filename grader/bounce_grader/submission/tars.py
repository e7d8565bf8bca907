"""Lists and reads the files of a tar, compressed or not, in memory. Nothing is extracted to
disk.

Python's tarfile follows whatever a header asks for: it copies every global header into each entry,
and reads a sparse file's map of any length. So the headers are walked here. Only what names a plain
file is understood: ustar, the records "path" and "size" of a pax header, and GNU's long names.
"""

import bz2
import lzma
import re
import tarfile
import zlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple, Protocol

from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import printable_text
from bounce_grader.submission.entry import MOST_ENTRIES, Entry, inside_name
from bounce_grader.submission.unpack_limits import UnpackLimits

RECORDS_WEIGH = 4  # times a header of the same length: a record may have five bytes
LARGEST_SLOW = 8 * 1024 * 1024  # packed by bzip2 or xz, which unpack a tenth as fast as gzip
MEMORY = 128 * 1024 * 1024  # of xz, which may ask for gigabytes
BLOCK = tarfile.BLOCKSIZE
ENCODING = ("utf-8", "surrogateescape")
RECORD = re.compile(rb"(\d{1,8}) ([^=]{1,200})=")  # its length and its key


class _Member(NamedTuple):
    name: str
    size: int
    start: int  # of its bytes
    regular: bool


class _Decompressor(Protocol):
    def decompress(self, data: bytes, max_length: int, /) -> bytes:
        ...

    @property
    def eof(self) -> bool:
        ...

    @property
    def unused_data(self) -> bytes:
        ...


@contextmanager
def opened(path: Path, packed: bytes, left: UnpackLimits) -> Iterator[Iterator[Entry]]:
    """The entries of a tar. Raises UsageError if they can't be listed."""
    try:
        yield _entries(path, _unpacked(path, packed, left), left)
    except UsageError:
        raise
    except Exception as error:  # a broken one raises a dozen kinds
        reason = printable_text(str(error) or type(error).__name__, 200)
        raise UsageError(f"{path} is broken ({reason}): make it anew and submit again") from error


def _unpacked(path: Path, packed: bytes, left: UnpackLimits) -> bytes:
    stream = _decompressor(path, packed)
    data = stream.decompress(packed, left.for_one + 1) if stream else packed
    left.take(path, len(data))
    if stream and not stream.eof:
        raise EOFError("it is cut short")
    # Each of a million empty pieces would cost as much as a decompressor.
    if stream and stream.unused_data.strip(b"\0"):
        raise UsageError(f"{path} is packed in several pieces: make it anew and submit again")
    return data


def _decompressor(path: Path, packed: bytes) -> _Decompressor | None:
    if packed.startswith(b"\x1f\x8b"):
        return zlib.decompressobj(zlib.MAX_WBITS | 16)  # with gzip's header
    if not packed.startswith((b"BZh", b"\xfd7zXZ")):
        return None
    if len(packed) > LARGEST_SLOW:
        raise UsageError(f"{path} is larger than {LARGEST_SLOW >> 20} MB: submit the parts alone")
    if packed.startswith(b"BZh"):
        return bz2.BZ2Decompressor()
    return lzma.LZMADecompressor(memlimit=MEMORY)


def _entries(path: Path, data: bytes, left: UnpackLimits) -> Iterator[Entry]:
    names: set[str] = set()
    for seen, member in enumerate(_members(path, data, left)):
        if seen >= MOST_ENTRIES:
            raise UsageError(f"{path} holds more than {MOST_ENTRIES} files: submit the parts alone")
        if member is None:
            continue
        name = inside_name(path, member.name)
        if name in names:
            raise UsageError(f"{path} holds two entries of the same name: make it anew")
        names.add(name)
        yield Entry(name, member.size, not member.regular, _reader(data, member))


def _members(path: Path, data: bytes, left: UnpackLimits) -> Iterator[_Member | None]:
    """All that the tar holds; None for a folder."""
    if not data:
        raise EOFError("it is empty")
    at = 0
    long_name, records = "", dict[str, str]()
    while at < len(data) and data[at : at + BLOCK].strip(b"\0"):
        info = tarfile.TarInfo.frombuf(data[at : at + BLOCK], *ENCODING)
        extends = info.type in (b"L", b"K", b"x", b"X", b"g")
        size = info.size if extends else int(records.get("size", "")[:20] or info.size)
        at += BLOCK
        left.headers -= BLOCK + (RECORDS_WEIGH * size if extends else 0)
        if left.headers < 0 or info.type == tarfile.GNUTYPE_SPARSE:
            raise UsageError(
                f"{path} holds headers of a kind that a submission doesn't need: make it anew"
            )
        has_data = info.isreg() or info.type not in tarfile.SUPPORTED_TYPES
        end = at + (size if has_data or extends else 0)
        if not at <= end <= len(data):
            raise EOFError("it is cut short")
        if info.type == b"L":
            long_name = data[at:end].partition(b"\0")[0].decode(*ENCODING)
        elif info.type in (b"x", b"X"):
            records = _pax_records(data[at:end])
        elif not extends:
            name = records.get("path") or long_name or info.name
            regular = info.isreg() and "sparse" not in records
            yield None if info.isdir() else _Member(name, end - at, at, regular)
            long_name, records = "", {}
        at = end + -end % BLOCK


def _pax_records(header: bytes) -> dict[str, str]:
    """The records "path" and "size" of a pax header, and "sparse" if it is a sparse file's."""
    records = {}
    at = 0
    while at < len(header) and header[at]:
        match = RECORD.match(header, at)
        end = at + int(match[1]) if match else 0
        if not match or end <= match.end() or header[end - 1 : end] != b"\n":
            raise tarfile.HeaderError("invalid header")
        if match[2] in (b"path", b"size"):
            records[match[2].decode()] = header[match.end() : end - 1].decode(*ENCODING)
        elif match[2].startswith(b"GNU.sparse."):
            records["sparse"] = "yes"
        at = end
    return records


def _reader(data: bytes, member: _Member) -> Callable[[int], bytes]:
    def read(limit: int) -> bytes:
        size = min(limit, member.size) if member.regular else 0
        return data[member.start : member.start + size]

    return read
