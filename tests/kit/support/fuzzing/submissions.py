"""Fuzzes zips, folders and sources, and checks what is taken from them."""

import os
import shutil
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path, PurePosixPath

import corpus
from bounce_grader.common.errors import UsageError
from bounce_grader.common.paths import ROOT
from bounce_grader.submission import entry, submission
from bounce_grader.submission.entry import Entry
from bounce_grader.submission.submission import Submission
from corpus import Member
from fuzzing.mutation import EDGES, Random, mutated

PIECES = ["src", "hw", "__MACOSX", "build", "include", "bounce", ".git", "a", "A", "é", "e\u0301"]
PIECES += ["part1_contacts.cpp", "part2_lcp.cpp", "PART1_CONTACTS.CPP", "part3_step.cpp", "h.hpp"]
PIECES += ["helper.cpp", "._part1_contacts.cpp", "main.cpp", "x.o", "inner.zip", "h.hpp", "a.cpp"]
ODD_PIECES = ["..", ".", "", "-o.cpp", "@x.cpp", "C:", "a\nb.cpp", "\x1b[2J.cpp", "\u202e.hpp"]
ODD_PIECES += [
    "n" * 300 + ".cpp",
    "a b.cpp",
    "\0.cpp",
    "a\\b.cpp",
    "CON.cpp",
    "\udcff.cpp",
    "d/" * 99,
]
TEXTS = [b"", b"int x;\n", b"\xff\xfei\0;\0", b"\xfe\xff\xd8\0", b"\0", b"\xff" * 9, b" " * 3000]
KINDS = [0, 0, 0, 0, 0, 0o100644, 0o100755, 0o120777, 0o010644, 0o020666, 0o060666, 0o140777]


def some_name(rng: Random) -> str:
    pieces = rng.choices(PIECES, k=rng.choice((1, 1, 1, 2, 2, 3)))
    if rng.random() < 0.1:
        pieces[rng.randrange(len(pieces))] = rng.choice(ODD_PIECES)
    return rng.choice(("/", "/", "/", "/", "\\", "//")).join(pieces)


# --- zips ---


def some_member(rng: Random) -> Member:
    odd = rng.random() < 0.15
    return Member(
        name=some_name(rng).encode("utf-8", "surrogateescape"),
        data=rng.choice(TEXTS),
        method=rng.choice((0, 8, 8, 8, 9, 12, 14, 99) if odd else (0, 8)),
        flags=rng.choice((0, 1, 8, 32, 64, 0x800) if odd else (0, 8, 0x800)),
        attributes=rng.choice(KINDS) << 16,
        extra=rng.randbytes(rng.randrange(30)) if odd and rng.random() < 0.3 else b"",
        local_name=b"other.cpp" if rng.random() < 0.01 else None,
        size=rng.choice(EDGES) % (1 << 32) if rng.random() < 0.02 else None,
        at=rng.randrange(200) if rng.random() < 0.01 else None,
    )


@cache
def zip_seeds() -> list[bytes]:
    files = {path.name: path.read_bytes() for path in (ROOT / "student" / "src").glob("*.cpp")}
    mac = {f"hw/{n}": t for n, t in files.items()} | {f"__MACOSX/hw/._{n}": b"\0\5" for n in files}
    return [
        corpus.zip_of(Member(n.encode(), t) for n, t in files.items()),
        corpus.zip_of((Member(n.encode(), t) for n, t in mac.items()), b"a comment"),
        corpus.streamed(files),
        corpus.zip64({"part1_contacts.cpp": b"int x;"}),
        corpus.overlapping(3, 100),
        corpus.many_entries(20),
    ]


def some_zip(rng: Random) -> bytes:
    if rng.random() < 0.3:
        return mutated(rng, zip_seeds())
    made = corpus.zip_of(some_member(rng) for _ in range(rng.randrange(7)))
    return mutated(rng, [made], 3) if rng.random() < 0.2 else made


def check_zip(data: bytes) -> bool:
    path = scratch() / f"{os.getpid()}.zip"
    path.write_bytes(data)
    return _taken_or_refused(lambda: submission.read(path))


# --- folders ---


@dataclass(frozen=True)
class Thing:
    """In a folder: a file with a text, a folder, a link to another name, or a pipe."""

    name: str
    kind: str
    text: bytes


def some_tree(rng: Random) -> list[Thing]:
    kinds = ("file", "file", "file", "file", "file", "folder", "link", "pipe")
    return [
        Thing(some_name(rng).replace("\0", ""), rng.choice(kinds), rng.choice(TEXTS))
        for _ in range(rng.randrange(1, 7))
    ]


def check_tree(tree: list[Thing]) -> bool:
    top = scratch() / f"{os.getpid()}"
    top.mkdir()
    try:
        for thing in tree:
            _put(top, thing)
        return _taken_or_refused(lambda: submission.read(top))
    finally:
        shutil.rmtree(top)


def _put(top: Path, thing: Thing) -> None:
    parts = [part for part in thing.name.split("/") if part not in ("", ".", "..")]
    path = top.joinpath(*parts)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        if thing.kind == "file":
            with path.open("xb") as stream:  # never into a pipe, which would wait
                stream.write(thing.text)
        elif thing.kind == "folder":
            path.mkdir()
        elif thing.kind == "link":
            path.symlink_to(f"/etc/{path.name}" if len(parts) > 1 else "..")
        else:
            os.mkfifo(path)
    except OSError:
        pass  # there can't be such a name, or it is taken


# --- sources ---


def some_entries(rng: Random) -> list[Entry]:
    """What a folder or a zip may hold, with sizes that need not be true."""
    return [_some_entry(rng, i) for i in range(130 if rng.random() < 0.01 else rng.randrange(1, 9))]


def _some_entry(rng: Random, number: int) -> Entry:
    raw = PurePosixPath(some_name(rng).replace("\\", "/").replace("..", "").lstrip("/"))
    name = (
        str(raw) if raw.parts and rng.random() < 0.8 else f"{number}.{rng.choice(('hpp', 'txt'))}"
    )
    large = rng.random() < 0.002
    text = b" " * rng.choice((1 << 20, (1 << 20) + 1)) if large else rng.choice(TEXTS)
    size = rng.choice(EDGES) if rng.random() < 0.05 else len(text)
    return Entry(name, size, rng.random() < 0.05, lambda most: text[:most])


def check_entries(entries: list[Entry]) -> bool:
    return _taken_or_refused(lambda: submission.take(Path("x"), entries))


# --- what is taken ---


@cache
def scratch() -> Path:
    """In memory, where there is such a place."""
    memory = Path("/dev/shm")
    folder = tempfile.TemporaryDirectory(dir=memory if os.access(memory, os.W_OK) else None)
    _kept.append(folder)
    return Path(folder.name)


_kept: list[tempfile.TemporaryDirectory[str]] = []


def _taken_or_refused(read: Callable[[], Submission]) -> bool:
    try:
        taken = read()
    except UsageError as refused:
        sentence = str(refused)
        assert sentence.isprintable() and len(sentence) < 100_000, sentence
        return False
    check_submission(taken)
    return True


def check_submission(taken: Submission) -> None:
    """Checks that what was taken is within the limits, and that no path leads outside."""
    assert len(taken.files) <= submission.MOST_SOURCES
    assert sum(map(len, taken.files.values())) <= submission.MOST_BYTES
    for name, text in taken.files.items():
        path = PurePosixPath(name)
        assert str(path) == name and not path.is_absolute() and ".." not in path.parts
        assert len(name.encode("utf-8")) <= submission.LONGEST_NAME
        assert not any(c < " " or c == "\x7f" or c == "\u202e" for c in name)
        assert (
            name[0] not in "-@" and path.suffix.lower() in submission.SOURCES | submission.HEADERS
        )
        assert b"\0" not in text and len(text) <= 3 * entry.LARGEST_SOURCE
        assert not any(str(folder) in taken.files for folder in path.parents)
    assert set(taken.parts.values()) <= set(taken.files)
    assert not set(taken.parts) & set(taken.refused)
    assert len(taken.ignored) <= entry.MOST_ENTRIES and len(taken.sha256) == 64
