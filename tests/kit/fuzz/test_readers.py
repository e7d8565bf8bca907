"""Tries the readers of submissions, and of text that submissions can influence, on inputs made from
real ones, each from its own number. Whatever comes must be taken within the limits or refused in
one sentence. The usual run takes a few thousand inputs for each reader, ./kit test --long a
million."""

import json
import os
import random
import re
import shutil
import signal
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path, PurePosixPath
from typing import Any, NamedTuple

import corpus
import pytest
from bounce_grader.build import compiler, linking
from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import WORK_FOLDER
from bounce_grader.grading import judging, speed
from bounce_grader.sandbox.processes import Result
from bounce_grader.submission import entry, submission
from conftest import ROOT
from corpus import Member
from handed_in import limited_memory, packed_tar
from odd_submissions import inside, MISLEADING, PARTS

Random = random.Random
Source = tuple[str, str, bytes]  # a name, a kind and a text
INPUTS, CHUNKS = 1_000_000, 200  # for each reader; the usual run has one chunk
MOST_SECONDS = 10  # of CPU time for one input
MOST_MEMORY = 512 << 20  # bytes more than at the start
SEEDS = Path(__file__).parent / "seeds"
MESSAGES = ROOT / "tests" / "kit" / "messages" / "expected"

# --- bytes that are nearly right ---

WORDS = [b"PK\1\2", b"PK\3\4", b"PK\5\6", b"PK\6\6", b"PK\6\7", b"PK\7\10", b"../", b"\\", b"\0"]
WORDS += [b"__MACOSX/", b"\xff\xfe", b"\x1b[2J", b".cpp", b'"', b"{", b"[", b"]", b"}", b"1e999"]
WORDS += [b"null", b"NaN", b"-1", b"true", b"\\ud800", b":1:1: error: ", b"undefined symbol: "]
WORDS += [b"\n", f"/{WORK_FOLDER}".encode(), b"/", b":12", b"\n>>> referenced by ", b"9 size=-1\n"]
EDGES = [0, 1, 2, 7, 8, 0x7F, 0x80, 0xFF, 0x7FFF, 0x8000, 0xFFFE, 0xFFFF, 1 << 16, 1 << 20]
EDGES += [(1 << 31) - 1, 1 << 31, (1 << 32) - 1, 1 << 32, (1 << 63) - 1, (1 << 64) - 1]


def mutated(rng: Random, seeds: list[bytes], most: int = 8) -> bytes:
    """One of the seeds with a few changes; now and then with none."""
    data = bytearray(rng.choice(seeds))
    for _ in range(rng.randrange(most)):
        at = rng.randrange(len(data) + 1)
        length = min(rng.choice((1, 2, 4, 8, 40, 400)), len(data) - at)
        size = rng.choice((2, 4, 8))
        other = rng.choice(seeds)
        end, new = rng.choice(
            (
                (at + length, rng.randbytes(length)),
                (at + length, b""),
                (at, data[at : at + length] * rng.choice((1, 1, 1, 30))),
                (at, rng.choice(WORDS)),
                (at + size, (rng.choice(EDGES) % (1 << 8 * size)).to_bytes(size, "little")),
                (len(data), other[rng.randrange(len(other) + 1) :]),
            )
        )
        data[at:end] = new
    return bytes(data)


# --- names, and what stands under them ---

PIECES = ["src", "hw", "__MACOSX", "build", "include", "bounce", ".git", "a", "A", "é", "e\u0301"]
PIECES += ["part1_contacts.cpp", "part2_lcp.cpp", "PART1_CONTACTS.CPP", "part3_step.cpp", "h.hpp"]
PIECES += ["helper.cpp", "._part1_contacts.cpp", "main.cpp", "x.o", "inner.zip", "h.hpp", "a.cpp"]
ODD = [*MISLEADING, "..", ".", "", "C:", "a b.cpp", "\0.cpp", "a\\b.cpp", "CON.cpp", "\udcff.cpp"]
TEXTS = [b"", b"int x;\n", b"\xff\xfei\0;\0", b"\xfe\xff\xd8\0", b"\0", b"\xff" * 9, b" " * 3000]
MODES = [0, 0, 0, 0, 0, 0o100644, 0o100755, 0o120777, 0o010644, 0o020666, 0o060666, 0o140777]
KINDS = ("file", "file", "file", "file", "file", "folder", "link", "pipe")


def some_name(rng: Random) -> str:
    pieces = rng.choices(PIECES, k=rng.choice((1, 1, 1, 2, 2, 3)))
    if rng.random() < 0.1:
        pieces[rng.randrange(len(pieces))] = rng.choice(ODD)
    return rng.choice(("/", "/", "/", "/", "\\", "//")).join(pieces)


def some_member(rng: Random) -> Member:
    odd = rng.random() < 0.15
    return Member(
        name=some_name(rng).encode("utf-8", "surrogateescape"),
        data=b" " * entry.LARGEST_SOURCE if rng.random() < 0.0005 else rng.choice(TEXTS),
        method=rng.choice((0, 8, 8, 8, 9, 12, 14, 99) if odd else (0, 8)),
        flags=rng.choice((0, 1, 8, 32, 64, 0x800) if odd else (0, 8, 0x800)),
        attributes=rng.choice(MODES) << 16,
        extra=rng.randbytes(rng.randrange(30)) if odd and rng.random() < 0.3 else b"",
        local_name=b"other.cpp" if rng.random() < 0.01 else None,
        size=rng.choice(EDGES) % (1 << 32) if rng.random() < 0.02 else None,
        at=rng.randrange(200) if rng.random() < 0.01 else None,
    )


MAC = inside("hw") | {f"__MACOSX/hw/._{name}": b"\0\5" for name in PARTS}
ZIPS = [
    corpus.zip_of(Member(name.encode(), text) for name, text in PARTS.items()),
    corpus.zip_of((Member(name.encode(), text) for name, text in MAC.items()), b"a comment"),
    corpus.streamed(PARTS),
    corpus.zip64({"part1_contacts.cpp": b"int x;"}),
    corpus.overlapping(3, 100),
    corpus.many_entries(20),
]
TARS = [packed_tar(PARTS, ""), packed_tar(MAC, "")]


def some_zip(rng: Random) -> bytes:
    if rng.random() < 0.3:
        return mutated(rng, ZIPS)
    count = 130 if rng.random() < 0.002 else rng.randrange(7)
    made = corpus.zip_of(some_member(rng) for _ in range(count))
    return mutated(rng, [made], 3) if rng.random() < 0.2 else made


def some_sources(rng: Random) -> list[Source]:
    return [
        (some_name(rng), rng.choice(KINDS), rng.choice(TEXTS)) for _ in range(rng.randrange(1, 9))
    ]


def put(top: Path, source: Source) -> None:
    name, kind, text = source
    pieces = [piece for piece in name.split("/") if piece not in ("", ".", "..")]
    path = top.joinpath(*pieces)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        if kind == "file":
            with path.open("xb") as stream:  # never into a pipe, which would wait
                stream.write(text)
        elif kind == "folder":
            path.mkdir()
        elif kind == "link":
            path.symlink_to(f"/etc/{path.name}" if len(pieces) > 1 else "..")
        else:
            os.mkfifo(path)
    except (OSError, ValueError):
        pass  # there can't be such a name, or it is taken


# --- what must hold, whatever comes ---


def check_file(data: bytes, path: Path) -> bool:
    path.write_bytes(data)
    return is_taken(lambda: submission.read(path))


def check_folder(sources: list[Source], path: Path) -> bool:
    path = path.with_suffix("")
    path.mkdir()
    for source in sources:
        put(path, source)
    taken = is_taken(lambda: submission.read(path))
    shutil.rmtree(path)
    return taken


def is_taken(read: Callable[[], submission.Submission]) -> bool:
    """Checks that what was taken is within the limits, and that no path leads outside."""
    try:
        taken = read()
    except UsageError as refused:
        assert str(refused).isprintable() and len(str(refused)) < 100_000
        return False
    assert len(taken.files) <= submission.MOST_SOURCES
    assert sum(map(len, taken.files.values())) <= submission.MOST_BYTES
    for name, text in taken.files.items():
        path = PurePosixPath(name)
        assert str(path) == name and not path.is_absolute() and ".." not in path.parts
        assert len(name.encode("utf-8")) <= submission.LONGEST_NAME and name[0] not in "-@"
        assert not re.search("[\0-\x1f\x7f\u202e]", name)
        assert path.suffix.lower() in submission.SOURCES | submission.HEADERS
        assert b"\0" not in text and len(text) <= 3 * entry.LARGEST_SOURCE
        assert not any(str(folder) in taken.files for folder in path.parents)
    assert set(taken.parts.values()) <= set(taken.files)
    assert not set(taken.parts) & set(taken.refused)
    assert len(taken.ignored) <= entry.MOST_ENTRIES and len(taken.sha256) == 64
    return True


def check_judge(data: bytes, _: Path) -> bool:
    def is_read(reader: Callable[..., Any], *arguments: Any) -> bool:
        try:
            json.dumps(reader(*arguments), allow_nan=False)
        except KitError:
            return False
        return True

    return any([is_read(judging.read_answer, data, parts()[3]), is_read(speed.read, data)])


def check_compiler(data: bytes, _: Path = Path()) -> bool:
    said = Result(1, 0.0, b"", data.decode("utf-8", "replace"), False, False)
    problem, link = compiler.compile_problem(said, "part2_lcp.cpp"), linking.link_problem(said)
    assert problem and "\n" not in problem and "\n" not in link
    place = judging.place_in(data)
    assert place is None or len(place) <= 300
    return place is not None or ": " in problem


# --- the readers ---


class Reader(NamedTuple):
    """`check` returns whether an input was taken, and raises if something doesn't hold."""

    make: Callable[[Random], Any]
    check: Callable[[Any, Path], bool]
    least_taken: float  # the least share of inputs that must be taken, else they test too little


ANSWERS = [file.read_bytes() for file in sorted(SEEDS.glob("*.json"))] + [b"[" * 3000]
SAID = "\n".join(file.read_text() for file in sorted(MESSAGES.glob("[acl]*.txt")))
MESSAGE_SEEDS = [
    said.replace("WORK", WORK_FOLDER).encode() for said in re.split(r"\n->.*\n+", SAID) if said
]
READERS = {
    "x.zip": Reader(some_zip, check_file, 0.2),
    "x.tar": Reader(lambda rng: mutated(rng, TARS), check_file, 0.2),
    "folder": Reader(some_sources, check_folder, 0.5),
    "judge": Reader(lambda rng: mutated(rng, ANSWERS, 4), check_judge, 0.1),
    "compiler": Reader(lambda rng: mutated(rng, MESSAGE_SEEDS), check_compiler, 0.2),
}


@pytest.fixture
def folder() -> Iterator[Path]:
    """A folder in memory, where there is such a place. An input that waits, or that takes too much
    memory, raises an error."""

    def too_long(*_: object) -> None:
        raise TimeoutError("it takes too long, or it waits")

    before = signal.signal(signal.SIGALRM, too_long)
    memory = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
    with tempfile.TemporaryDirectory(dir=memory) as made, limited_memory(MOST_MEMORY):
        yield Path(made)
    signal.alarm(0)
    signal.signal(signal.SIGALRM, before)


@pytest.mark.usual(len(READERS))
@pytest.mark.parametrize("chunk", range(CHUNKS))
@pytest.mark.parametrize("name", READERS)
def test_whatever_comes_is_taken_within_the_limits_or_refused(
    name: str, chunk: int, folder: Path
) -> None:
    reader, taken = READERS[name], 0
    count = INPUTS // CHUNKS // (10 if name == "folder" else 1)  # those are made on disk
    for number in range(chunk * count, (chunk + 1) * count):
        made = reader.make(Random(f"{name} {number}"))
        start = time.process_time()
        signal.alarm(6 * MOST_SECONDS)
        try:
            taken += reader.check(made, folder / name)
            assert time.process_time() - start < MOST_SECONDS
        except BaseException as error:
            raise AssertionError(f"input {number}: {made!r}") from error
    assert taken >= reader.least_taken * count
