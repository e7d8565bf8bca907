"""Zips as other programs write them, and as nobody should."""

import base64
import io
import json
import random
import struct
import zipfile
from collections.abc import Iterator

import corpus
from bounce_grader.submission import entry
from corpus import Member, zip_of
from handed_in import packed_tar
from odd_submissions import PARTS, TABLES

Archive = tuple[str, str, bytes]  # what is odd about it, its file's name, and its bytes

# Archives that no program of ours makes.
ARCHIVES = {
    what: (name, base64.b64decode(data))
    for what, (name, data) in json.loads((TABLES / "archives.json").read_text()).items()
}
RAR = ARCHIVES["a RAR 5 of the parts"][1]


def holding(files: dict[str, bytes]) -> bytes:
    return zip_of(Member(name.encode(), text) for name, text in files.items())


def member(
    name: str, data: str = "int x;", mode: str = "0", method: int = corpus.DEFLATED, flags: int = 0
) -> Member:
    return Member(name.encode(), data.encode(), method, flags, int(mode, 8) << 16)


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


PLAIN = zip_of([Member(b"part2_lcp.cpp", b"// odd\n")])
DIRECTORY, END, DESCRIPTOR = b"PK\1\2", b"PK\5\6", b"PK\7\10"
LIES = [2**31, 2**32 + 1, 2**62, 2**63, 2**64 - 1]  # of a size, in bytes


def claiming(size: int) -> bytes:
    """A zip whose table of contents claims these sizes, in the fields for large files."""
    extra = struct.pack("<HHQ", 1, 8, size)
    return zip_of([Member(b"part2_lcp.cpp", b"// odd\n", size=0xFFFFFFFF, extra=extra)])


def bomb(sources: int, name: str = "helper") -> bytes:
    """Sources of 1 MB of spaces: a thousandth of that as they are handed in."""
    text = b" " * (1 << 20)
    return zip_of(Member(f"{name}{i}.cpp".encode(), text) for i in range(sources))


def changed(at: bytes, offset: int, field: bytes, data: bytes = PLAIN) -> bytes:
    """A zip in which a field of a record is another."""
    start = data.index(at) + offset
    return data[:start] + field + data[start + len(field) :]


def zips() -> Iterator[Archive]:
    for what, data in _zips():
        yield what, "x.zip", data
    for name in ("x.tar.gz", "x.7z"):
        yield f"a zip named {name}", name, holding(PARTS)
    for name in ("x.zip", "x.rar", "x.7z"):
        yield f"a RAR archive named {name}", name, RAR


def _zips() -> Iterator[tuple[str, bytes]]:
    yield "empty", b""
    yield "no zip", b"Rar!"
    yield "only its beginning", b"PK\x03\x04 and then nothing"
    yield "cut short", PLAIN[:-30]
    yield "a picture, too", b"GIF89a" + PLAIN
    yield "a source, too", b"int x; //" + PLAIN
    yield "65535 entries that aren't there", changed(END, 8, b"\xff" * 4)
    yield "a directory before the start", changed(END, 16, b"\xff\xff\xff\x7f")
    yield "a directory of 4 GB", changed(END, 12, b"\xfe\xff\xff\xff")
    yield "a ZIP64 record that isn't there", changed(END, 8, b"\xff" * 12)
    yield "a wrong checksum", changed(DIRECTORY, 16, b"\0" * 4)
    streamed = corpus.streamed({"part2_lcp.cpp": b"// odd\n"})
    yield "a wrong data descriptor", changed(DESCRIPTOR, 4, b"\xff" * 12, streamed)
    short = struct.pack("<HHB", 1, 8, 1)
    yield "a ZIP64 field cut short", zip_of([Member(b"a.cpp", size=0xFFFFFFFF, extra=short)])
    yield "an entry beyond the end", zip_of([Member(b"part2_lcp.cpp", at=10**6)])
    yield "a name that isn't UTF-8", zip_of([Member(b"\xff\xfe.cpp", flags=corpus.UTF8)])
    yield "a name of 65,000 bytes", zip_of([Member(b"n" * 65_000 + b".cpp")])
    yield "20000 folders deep", zip_of([Member(b"d/" * 20_000 + b"part2_lcp.cpp")])
    yield "a bomb", bomb(400)
    large = bytes(22 << 20) + PLAIN
    yield "zips inside, large together", holding({f"{i}.zip": large for i in range(3)})
    for size in LIES:
        yield f"claims {size} bytes", claiming(size)
    yield "damaged in the middle", damaged()
    for what, members in json.loads((TABLES / "zips.json").read_text()).items():
        yield what, zip_of(member(**properties) for properties in members)
    yield "5000 folders", zip_of(member(f"{i}/") for i in range(entry.MOST_ENTRIES + 1))
    yield "zip64", corpus.zip64({"part1_contacts.cpp": b"int x;"})
    yield "a size that is a lie", zip_of([Member(b"a.cpp", b" " * (2 << 20), size=100)])
    yield "65535 entries, as many as there can be without zip64", corpus.many_entries(65535)
    yield "sources that hold one another", corpus.overlapping(90, entry.LARGEST_SOURCE // 2)
    yield "sources that share their bytes", sharing()
    inner, tar = holding(PARTS), holding({"inner.tgz": packed_tar(PARTS), "notes.txt": b""})
    yield "a zip inside", holding({"a/inner.zip": inner})
    yield "a tar inside", tar
    yield "an old zip beside the parts", holding(PARTS | {"old.zip": inner})
    yield "an archive in an archive in an archive", holding({"x.zip": tar})
