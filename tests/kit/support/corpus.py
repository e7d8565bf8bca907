"""Zips made byte by byte, as other programs write them and as nobody should."""

import struct
import zlib
from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache

STREAMED = 0x8  # sizes and checksum follow the data
UTF8 = 0x800
DEFLATED = 8


@dataclass(frozen=True)
class Member:
    """One entry. A zip stores its properties twice, beside the data and in the directory."""

    name: bytes
    data: bytes = b"int x;"
    method: int = DEFLATED
    flags: int = 0
    attributes: int = 0
    extra: bytes = b""
    local_name: bytes | None = None  # None: the same
    size: int | None = None  # None: the truth
    at: int | None = None  # where it begins, according to the directory


def zip_of(members: Iterable[Member], comment: bytes = b"") -> bytes:
    data, directory, count = b"", b"", 0
    for member in members:
        at = len(data) if member.at is None else member.at
        data += _beside_the_data(member)
        directory += _in_the_directory(member, at)
        count += 1
    return _ended(data, directory, min(count, 0xFFFF), comment)


def _ended(data: bytes, directory: bytes, count: int, comment: bytes = b"") -> bytes:
    counts = struct.pack("<4s4H", b"PK\5\6", 0, 0, count, count)
    where = struct.pack("<LLH", len(directory), len(data), len(comment))
    return data + directory + counts + where + comment


def _packed(member: Member) -> bytes:
    return _deflated(member.data) if member.method == DEFLATED else member.data


@lru_cache(1)  # a bomb's entries have the same data
def _deflated(data: bytes) -> bytes:
    squeeze = zlib.compressobj(9, zlib.DEFLATED, -15)
    return squeeze.compress(data) + squeeze.flush()


def _numbers(member: Member) -> tuple[int, int, int]:
    size = len(member.data) if member.size is None else member.size
    return zlib.crc32(member.data), len(_packed(member)), size


def _beside_the_data(member: Member) -> bytes:
    name = member.name if member.local_name is None else member.local_name
    streamed = bool(member.flags & STREAMED)
    numbers = (0, 0, 0) if streamed else _numbers(member)
    head = struct.pack("<4s5H", b"PK\3\4", 20, member.flags, member.method, 0, 0x21)
    head += struct.pack("<3L2H", *numbers, len(name), 0) + name
    tail = struct.pack("<4s3L", b"PK\7\10", *_numbers(member)) if streamed else b""
    return head + _packed(member) + tail


def _in_the_directory(member: Member, at: int) -> bytes:
    made_by = 0x0314  # Unix
    head = struct.pack("<4s6H", b"PK\1\2", made_by, 20, member.flags, member.method, 0, 0x21)
    head += struct.pack("<3L", *_numbers(member))
    head += struct.pack("<5H", len(member.name), len(member.extra), 0, 0, 0)
    return head + struct.pack("<LL", member.attributes, at) + member.name + member.extra


def streamed(files: dict[str, bytes]) -> bytes:
    return zip_of(Member(n.encode(), data, flags=STREAMED | UTF8) for n, data in files.items())


def zip64(files: dict[str, bytes]) -> bytes:
    """A zip64: sizes are in the extra field, and the directory's place in its own record."""
    plain = zip_of(
        Member(n.encode(), data, extra=struct.pack("<HHQQ", 1, 16, len(data), 0), size=0xFFFFFFFF)
        for n, data in files.items()
    )
    end = plain[-22:]
    count, size, at = struct.unpack("<10xHLL2x", end)
    record = struct.pack("<4sQ2H2L4Q", b"PK\6\6", 44, 45, 45, 0, 0, count, count, size, at)
    locator = struct.pack("<4sLQL", b"PK\6\7", 0, len(plain) - 22, 1)
    unknown = struct.pack("<4s4HLLH", b"PK\5\6", 0, 0, 0xFFFF, 0xFFFF, *[0xFFFFFFFF] * 2, 0)
    return plain[:-22] + record + locator + unknown


def many_entries(count: int) -> bytes:
    """A zip of empty files that share one place."""
    first = Member(b"0", b"", 0)
    directory = b"".join(_in_the_directory(Member(b"%x" % i, b"", 0), 0) for i in range(count))
    return _ended(_beside_the_data(first), directory, count)


def overlapping(count: int, size: int) -> bytes:
    """A zip of stored sources, each inside the one before; the last has `size` bytes."""
    data, places = b" " * size, []
    for i in reversed(range(count)):
        member = Member(b"%05d.cpp" % i, data, method=0)
        data = _beside_the_data(member)
        places.append((member, len(data)))
    directory = b"".join(_in_the_directory(member, len(data) - back) for member, back in places)
    return _ended(data, directory, count)
