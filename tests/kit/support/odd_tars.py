"""Tars as programs write them, and as nobody should."""

import bz2
import gzip
import io
import tarfile
from collections.abc import Iterator

from bounce_grader.submission.entry import MOST_ENTRIES
from handed_in import packed_tar
from odd_submissions import inside, PARTS
from odd_zips import Archive, ARCHIVES, holding

SOURCE = {"part1_contacts.cpp": b"int x;\n"}
SPARSE = {b"major": b"1", b"minor": b"0", b"name": b"x.cpp", b"realsize": b"10"}
NO_FILES = (tarfile.SYMTYPE, tarfile.LNKTYPE, tarfile.FIFOTYPE, tarfile.CHRTYPE, tarfile.DIRTYPE)


def member(name: str, data: bytes = b"", kind: bytes = tarfile.REGTYPE) -> bytes:
    info = tarfile.TarInfo(name)
    info.size, info.type = len(data), kind
    info.linkname = "/etc/passwd" if kind in NO_FILES else ""
    return bytes(info.tobuf(tarfile.USTAR_FORMAT)) + data + bytes(-len(data) % 512)


def record(key: bytes, value: bytes) -> bytes:
    rest = b" " + key + b"=" + value + b"\n"
    length = len(rest) + 1
    while len(str(length)) + len(rest) != length:
        length += 1
    return str(length).encode() + rest


def pax(data: bytes, kind: bytes = tarfile.XHDTYPE) -> bytes:
    return member("pax", data, kind)


def tar_of(*members: bytes) -> bytes:
    return b"".join([*members, *(member(n, data) for n, data in SOURCE.items()), bytes(1024)])


def written_as(kind: int) -> bytes:
    """As tarfile writes this format, with names that take it all means to do so."""
    data = io.BytesIO()
    names = ["a.cpp", "./" + "d" * 90 + "/" + "n" * 80 + ".cpp", "\u00fc.hpp", "empty.hpp"]
    names += [] if kind == tarfile.USTAR_FORMAT else ["f" * 100 + "/" + "g" * 120 + ".cpp"]
    comment = {"comment": "0123abcd"} if kind == tarfile.PAX_FORMAT else None
    with tarfile.open(fileobj=data, mode="w", format=kind, pax_headers=comment) as archive:
        for number, name in enumerate(names):
            info = tarfile.TarInfo(name)
            info.size = 300 * number if name != "empty.hpp" else 0
            archive.addfile(info, io.BytesIO(b"%d" % number * info.size))
    return data.getvalue()


def tars() -> Iterator[Archive]:
    for ending, kind in (("tar.gz", "gz"), ("TAR.BZ2", "bz2"), ("tar.xz", "xz"), ("tar", "")):
        yield f"a tar as {ending}", f"hw.{ending}", packed_tar(inside("hw"), kind)
    again = packed_tar(PARTS)
    yield "a tar that is handed in again", "hw3.tar-1.gz", again
    yield "a tar that is handed in again, in a zip", "x.zip", holding({"hw3.tar-1.gz": again})
    for name, number in (("ustar", 0), ("GNU", 1), ("pax", 2)):
        yield f"as tarfile writes {name}", "x.tar", written_as(number)
    for what, data in _tars():
        yield what, "x.tar.gz", gzip.compress(data, 1)
    for what, data in _in_pieces():
        yield what, f"x.tar.{'bz2' if data[:2] == b'BZ' else 'gz'}", data
    for ending, packed in (("bz2", bz2.compress(b"x")), ("gz", gzip.compress(b""))):
        yield f"33 MB of {ending}", f"x.tar.{ending}", packed + bytes(33 << 20)
    yield "a RAR archive without end", "x.rar", b"Rar!\x1a\x07\x01\x00" + bytes(100)
    yield from ((what, *archive) for what, archive in ARCHIVES.items())


def _in_pieces() -> Iterator[tuple[str, bytes]]:
    yield "100000 empty pieces of gzip", gzip.compress(b"") * 100_000
    yield "100000 empty pieces of bzip2", bz2.compress(b"") * 100_000
    yield "zeros at the end, as a tape has them", gzip.compress(tar_of()) + bytes(1000)
    yield "cut off", packed_tar(PARTS)[:-100]


def _tars() -> Iterator[tuple[str, bytes]]:
    for name in ("../part1_contacts.cpp", "/etc/part1_contacts.cpp"):
        yield f"outside: {name}", tar_of(member(name))
    yield "links, a pipe, a device and a folder", tar_of(
        *(member(f"{kind.decode()}.cpp", b"", kind) for kind in NO_FILES)
    )
    most = {f"{i}.txt": b"x" for i in range(MOST_ENTRIES - 2)} | {"large.txt": bytes(20 << 20)}
    yield "a large file and 4999 others", packed_tar(most | SOURCE, "")
    yield "5001 files", packed_tar(most | SOURCE | {"a": b""}, "")
    yield "a file of 65 MB", tar_of(member("x.bin", bytes(65 << 20)))
    yield "no member, but 65 MB", bytes(65 << 20)
    size = pax(record(b"size", b"7") + record(b"path", b"y.cpp"))
    text = b"int y;\n" + bytes(505)
    yield "a size in a pax header", tar_of(size, member("short")[:512] + text)
    sparse = b"".join(record(b"GNU.sparse." + key, value) for key, value in SPARSE.items())
    map_of_any_length = member("x.cpp", b"9\n" + b"0\n" * 18)
    yield "a sparse file by pax", tar_of(pax(sparse), map_of_any_length)
    yield "a sparse file of GNU", tar_of(member("x.cpp", b"", tarfile.GNUTYPE_SPARSE))
    many = [member(f"f{i}") for i in range(600)]
    for count in (500_000, 100_000):
        every = b"".join(record(b"%x" % i, b"") for i in range(count))
        yield f"{count} global records", tar_of(pax(every, b"g"), *many)
    yield "60000 pax headers in a row", tar_of(pax(record(b"comment", b"")) * 60_000)
    smallest = record(b"a", b"") * 400_000
    yield "as many records as there may be", tar_of(pax(smallest))
    yield "a name of 9 MB", tar_of(pax(b"n" * (9 << 20), tarfile.GNUTYPE_LONGNAME))
    yield "a size of a million digits", tar_of(pax(record(b"size", b"1" * (1 << 20))))
    yield "a negative size", tar_of(pax(record(b"size", b"-512")))
    yield "a record's length of a million digits", tar_of(pax(b"1" * (1 << 20)))
