"""Submissions that are hard to read, for classes in which the others are honest."""

import os
import struct
from collections.abc import Callable
from functools import partial
from pathlib import Path

import corpus
from conftest import write
from corpus import Member

PART = b"part2_lcp.cpp"
LIES = [2**31, 2**32 + 1, 2**62, 2**63, 2**64 - 1]  # of a size, in bytes


def zip_that_claims(size: int, name: bytes = PART) -> bytes:
    """A zip whose table of contents claims these sizes, in the fields for large files."""
    extra = struct.pack("<HHQ", 1, 8, size)
    return corpus.zip_of([Member(name, b"// odd\n", size=0xFFFFFFFF, extra=extra)])


def bomb(sources: int, megabytes: int = 1) -> bytes:
    """Sources of nothing but spaces: a thousandth of their size as they are handed in."""
    text = b" " * (megabytes << 20)
    return corpus.zip_of(Member(b"helper%d.cpp" % i, text) for i in range(sources))


def repetitive(length: int, unit: bytes = b"{") -> bytes:
    """A text whose comparison with another like it takes time quadratic in its length."""
    return (unit * length)[:length]


def long_names(number: int, suffix: str = ".o") -> bytes:
    """A zip of this many files, each with a name of the greatest length."""
    names = (f"{i:04}{'n' * (251 - len(suffix))}{suffix}" for i in range(number))
    return corpus.zip_of(Member(name.encode(), b"") for name in names)


def _with(data: bytes, at: bytes, offset: int, field: bytes) -> bytes:
    """A zip in which a field of a record is another."""
    start = data.index(at) + offset
    return data[:start] + field + data[start + len(field) :]


PLAIN = corpus.zip_of([Member(PART, b"// odd\n")])
DIRECTORY, END = b"PK\1\2", b"PK\5\6"
ZIPS = {
    "empty": b"",
    "no zip": b"Rar!",
    "cut short": PLAIN[:-30],
    "nothing in it": corpus.zip_of([]),
    "claims 65,535 entries": _with(PLAIN, END, 8, b"\xff" * 4),
    "has 65,535 entries": corpus.many_entries(65535),
    "a directory before the start": _with(PLAIN, END, 16, b"\xff\xff\xff\x7f"),
    "a directory of 4 GB": _with(PLAIN, END, 12, b"\xfe\xff\xff\xff"),
    "a ZIP64 record that isn't there": _with(PLAIN, END, 8, b"\xff" * 12),
    "sizes of ZIP64": corpus.zip64({"part2_lcp.cpp": b"// odd\n"}),
    "a ZIP64 field cut short": corpus.zip_of(
        [Member(PART, b"// odd\n", size=0xFFFFFFFF, extra=struct.pack("<HHB", 1, 8, 1))]
    ),
    "an entry beyond the end": corpus.zip_of([Member(PART, b"// odd\n", at=10**6)]),
    "entries in each other": corpus.overlapping(90, 1 << 19),
    "encrypted": corpus.zip_of([Member(PART, b"// odd\n", flags=1)]),
    "a wrong data descriptor": _with(
        corpus.streamed({"part2_lcp.cpp": b"// odd\n"}), b"PK\7\10", 4, b"\xff" * 12
    ),
    "a wrong checksum": _with(PLAIN, DIRECTORY, 16, b"\0" * 4),
    "a name that isn't UTF-8": corpus.zip_of([Member(b"\xff\xfe.cpp", flags=corpus.UTF8)]),
    "a name with NUL": corpus.zip_of([Member(b"part2_lcp.cpp\0.txt")]),
    "a name with line ends": corpus.zip_of([Member(b"a\nb\r\x1b[2J.cpp")]),
    "a name outside": corpus.zip_of([Member(b"../" * 50 + PART)]),
    "a name of 65,000 bytes": corpus.zip_of([Member(b"n" * 65_000 + b".cpp")]),
    "two of a name": corpus.zip_of([Member(PART), Member(PART)]),
    "a link": corpus.zip_of([Member(PART, b"/etc/passwd", attributes=0o120777 << 16)]),
    "an unknown compression": corpus.zip_of([Member(PART, method=97)]),
    "deeply nested": corpus.zip_of([Member(b"d/" * 20_000 + PART)]),
    "a zip in a zip": corpus.zip_of([Member(b"inner.zip", PLAIN)]),
    "a picture, too": b"GIF89a" + PLAIN,
    "a source, too": b"int x; //" + PLAIN,
    "a bomb": bomb(400),
    "many long names": long_names(4900),
    "names as Canvas's": corpus.zip_of(
        [Member(b"doe_1_2_part1_contacts.cpp"), Member(b"roe_301_text.html"), Member(PART)]
    ),
    **{f"claims {size} bytes": zip_that_claims(size) for size in LIES},
}


def _canvas(*files: str, data: bytes = b"// odd\n") -> dict[str, bytes]:
    return {f"roe_301_{number}_{file}": data for number, file in enumerate(files, 11)}


UPLOADS = {
    **{f"zip: {name}": _canvas("hw.zip", data=data) for name, data in ZIPS.items()},
    **{
        f"zip beside a file: {name}": {**_canvas("hw.zip", data=data), "roe_301_9_a.hpp": b""}
        for name, data in ZIPS.items()
    },
    "many": _canvas(*(f"helper{i}.cpp" for i in range(3000))),
    "many large ones": _canvas(*(f"h{i}.cpp" for i in range(99)), data=b" " * (1 << 20)),
    "an attachment of 5,000 digits": {f"roe_301_{'9' * 5000}_part2_lcp.cpp": b""},
    "a user of 5,000 digits": {f"roe_{'301' * 2000}_1_part2_lcp.cpp": b""},
    "an anonymous user without end": {f"roe_anon_{'301' * 9000}_1_part2_lcp.cpp": b""},
    "digits of another script": {"roe_\u0663\u0660\u0661_\u0661_part2_lcp.cpp": b"", "roe_x": b""},
    "nothing but numbers": {"roe_301_" + "1_" * 9000: b""},
    "a name with line ends": _canvas("part2\n_lcp\r\x1b[2J.cpp"),
    "a name as an option": _canvas("-o.cpp", "@x.cpp", "..cpp", ".cpp", "-1.cpp", " (1).zip"),
    "backslashes": _canvas("..\\..\\part2_lcp.cpp"),
    "two bytes a letter": _canvas("part2_lcp.cpp", data=b"\xff\xfe\x00\xd8" * 1000),
    "no text": _canvas("part2_lcp.cpp", data=bytes(range(256)) * 100),
    "repetitive": _canvas("part2_lcp.cpp", data=repetitive(60_000)),
    "line ends alone": _canvas("part2_lcp.cpp", data=b"\n" * (1 << 20)),
    "typed": {"roe_301_text.html": b"", "roe_301_link.html": b""},
}


def _sparse(path: Path, size: int) -> None:
    path.touch()
    os.truncate(path, size)


def nested(top: Path, depth: int) -> None:
    for _ in range(depth):
        top = top / "d"
        top.mkdir()


def _closed(path: Path) -> None:
    path.write_bytes(b"// odd\n")
    path.chmod(0)


def _listed_alone(top: Path) -> None:
    _closed(top / "part2_lcp.cpp")
    top.chmod(0o444)


def _link(top: Path, target: str) -> None:
    top.rmdir()
    top.symlink_to(target)


def _links_inside(top: Path) -> None:
    for number, target in enumerate(("/etc/passwd", "nowhere", "/proc/self/mem", "/"), 1):
        (top / f"{number}.cpp").symlink_to(target)


def _zip(top: Path, data: bytes) -> None:
    write(top, {"hw.zip": data})


def _git(top: Path) -> None:
    hooks = ("post-checkout", "pre-commit")
    write(top, {".git/config": b"[core]\n\tfsmonitor = touch /tmp/was-run\n"})
    write(top / ".git" / "hooks", {name: b"#!/bin/sh\ntouch /tmp/was-run\n" for name in hooks})
    for name in hooks:
        (top / ".git" / "hooks" / name).chmod(0o755)


ODD_NAMES = (b"\xff.cpp", b"a\nb.cpp", b"\x1b[2J")
FOLDERS: dict[str, Callable[[Path], object]] = {
    "empty": lambda top: None,
    "closed": lambda top: top.chmod(0),
    "to be listed alone": _listed_alone,
    "a closed source": lambda top: _closed(top / "part2_lcp.cpp"),
    "a closed zip": lambda top: _closed(top / "hw.zip"),
    "a closed folder": lambda top: (top / "src").mkdir(mode=0),
    "a pipe": lambda top: os.mkfifo(top / "part2_lcp.cpp"),
    "a pipe as its zip": lambda top: os.mkfifo(top / "hw.zip"),
    "a link that leads nowhere": lambda top: _link(top, "nowhere"),
    "a link to itself": lambda top: _link(top, top.name),
    "a link to all": lambda top: _link(top, "/"),
    "a link too long": lambda top: _link(top, "n" * 300),
    "links inside": _links_inside,
    "deeply nested": lambda top: nested(top, 1200),
    "a repository with hooks": _git,
    "a folder as a part": lambda top: (top / "part2_lcp.cpp").mkdir(),
    "a terabyte of zip": lambda top: _sparse(top / "hw.zip", 1 << 40),
    "a terabyte of source": lambda top: _sparse(top / "part2_lcp.cpp", 1 << 40),
    "an output's files": lambda top: write(top, {"results/set.json": b"{", "log.jsonl": b"{"}),
    "odd names": lambda top: write(top, {os.fsdecode(name): b"x" for name in ODD_NAMES}),
    "many files": lambda top: write(top, {f"{number}.o": b"" for number in range(6000)}),
    **{f"zip: {name}": partial(_zip, data=data) for name, data in ZIPS.items()},
}
