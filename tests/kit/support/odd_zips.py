"""Zips as other programs write them, and as nobody should."""

import io
import random
import zipfile
from collections.abc import Iterator

import corpus
from bounce_grader.submission import entry
from corpus import Member, zip_of
from handed_in import packed_tar
from odd_submissions import PARTS

Archive = tuple[str, str, bytes]  # what is odd about it, its file's name, and its bytes

PART = b"part1_contacts.cpp"
OUTSIDE = ["/etc/x.cpp", "../x.cpp", "a/../../x.cpp", "..\\x.cpp", "C:/x.cpp"]
SPELLED_AGAIN = ["a//x.cpp", "a/./x.cpp", "./a/x.cpp", "a\\x.cpp"]
NAMELESS = ["\0x.cpp", ".", "./."]
RAR = b"Rar!\x1a\x07\x01\x00" + bytes(100)


def holding(files: dict[str, bytes]) -> bytes:
    return zip_of(Member(name.encode(), text) for name, text in files.items())


def named(*names: str) -> bytes:
    return zip_of(Member(name.encode()) for name in names)


def of_method(method: int) -> bytes:
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", method) as archive:
        archive.writestr("part1_contacts.cpp", "int x;")
    return data.getvalue()


def damaged() -> bytes:
    data = bytearray(holding(PARTS))
    data[50:60] = bytes(10)  # inside the first entry's compressed bytes
    return bytes(data)


def sharing() -> bytes:
    """Entries that would be unpacked from the same bytes: a small zip that takes minutes."""
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("part1_contacts.cpp", random.Random(1).randbytes(5000))
        first = archive.infolist()[0]
        for n in range(3):
            again = zipfile.ZipInfo(f"helper{n}.cpp")
            for field in ("compress_type", "compress_size", "file_size", "CRC", "header_offset"):
                setattr(again, field, getattr(first, field))
            archive.filelist.append(again)
    return data.getvalue()


def zips() -> Iterator[Archive]:
    for what, data in _zips():
        yield what, "x.zip", data
    for name in ("x.tar.gz", "x.7z"):
        yield f"a zip named {name}", name, holding(PARTS)
    for name in ("x.zip", "x.rar", "x.7z"):
        yield f"a RAR archive named {name}", name, RAR


def _zips() -> Iterator[tuple[str, bytes]]:
    yield "only its beginning", b"PK\x03\x04 and then nothing"
    yield "damaged in the middle", damaged()
    yield "encrypted", zip_of([Member(PART, flags=1)])
    yield from ((f"outside: {name}", named(name)) for name in OUTSIDE)
    yield from ((f"a/x.cpp and {name}", named("a/x.cpp", name)) for name in SPELLED_AGAIN)
    yield from ((f"the name {name!r}", named(name)) for name in NAMELESS)
    yield "a file that is a folder, too", named("a.hpp", "a.hpp/b/c.hpp")
    yield "5000 folders", named(*(f"{i}/" for i in range(entry.MOST_ENTRIES)), "a.cpp")
    yield "sizes after the data, as of Java", corpus.streamed({"part1_contacts.cpp": b"int x;"})
    yield "zip64", corpus.zip64({"part1_contacts.cpp": b"int x;"})
    link = Member(PART, b"/etc/passwd", attributes=0o120777 << 16)
    yield "a link", zip_of([link, Member(b"part2_lcp.cpp")])
    yield "a size that is a lie", zip_of([Member(PART, b" " * (2 << 20), size=100)])
    yield "bzip2", of_method(zipfile.ZIP_BZIP2)
    yield "LZMA, which allocates what its header asks for", of_method(zipfile.ZIP_LZMA)
    yield "65535 entries, as many as there can be without zip64", corpus.many_entries(65535)
    yield "sources that hold one another", corpus.overlapping(90, entry.LARGEST_SOURCE // 2)
    yield "sources that share their bytes", sharing()
    inner, tar = holding(PARTS), holding({"inner.tgz": packed_tar(PARTS), "notes.txt": b""})
    yield "a zip inside", holding({"a/inner.zip": inner})
    yield "a tar inside", tar
    yield "an old zip beside the parts", holding(PARTS | {"old.zip": inner})
    yield "an archive in an archive in an archive", holding({"x.zip": tar})
