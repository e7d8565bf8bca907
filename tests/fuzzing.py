"""Inputs without number for what reads a submission, or what a submission can put words into.

    PYTHONPATH=grader:tests python3 -m fuzzing READER COUNT

COUNT inputs, made from real ones, each from its own number, so that a run can be repeated. Whatever
comes must be taken within the limits or refused in one sentence. An input at which that fails is
written to build/fuzz/inputs/, and named.
"""

import json
import os
import random
import resource
import shutil
import signal
import sys
import tempfile
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import cache
from pathlib import Path, PurePosixPath
from typing import Any

import corpus
from bounce_grader import build, entry, judging, speed, submission
from bounce_grader.entry import Entry
from bounce_grader.errors import KitError, UsageError
from bounce_grader.manifest import parts
from bounce_grader.paths import ROOT, WORK_FOLDER
from bounce_grader.processes import Result
from bounce_grader.submission import Submission
from corpus import Member

Random = random.Random
MOST_SECONDS = 10  # of CPU time, for one input
MOST_MEMORY = 512 << 20  # more than the program has at its start
CHUNK = 2000


@dataclass(frozen=True)
class Reader:
    make: Callable[[Random], Any]
    check: Callable[[Any], bool]  # whether the input was taken; raises AssertionError
    least_taken: float  # of the inputs: else they don't get far enough to show anything


# --- bytes ---

WORDS = [b"PK\1\2", b"PK\3\4", b"PK\5\6", b"PK\6\6", b"PK\6\7", b"PK\7\10", b"../", b"\\", b"\0"]
WORDS += [b"__MACOSX/", b"\xff\xfe", b"\x1b[2J", b".cpp", b'"', b"{", b"[", b"]", b"}", b"1e999"]
WORDS += [
    b"null",
    b"NaN",
    b"-1",
    b"true",
    b"\\ud800",
    b":1:1: error: ",
    b"\n",
    b"undefined symbol: ",
]
WORDS += [f"/{WORK_FOLDER}".encode(), b"/", b":12", b"\n>>> referenced by "]
EDGES = [0, 1, 2, 7, 8, 0x7F, 0x80, 0xFF, 0x7FFF, 0x8000, 0xFFFE, 0xFFFF, 1 << 16, 1 << 20]
EDGES += [(1 << 31) - 1, 1 << 31, (1 << 32) - 1, 1 << 32, (1 << 63) - 1, (1 << 64) - 1]


def mutated(rng: Random, seeds: list[bytes], most: int = 8) -> bytes:
    """One of the seeds with a few changes; now and then with none."""
    data = bytearray(rng.choice(seeds))
    for _ in range(rng.randrange(most)):
        at = rng.randrange(len(data) + 1)
        length = min(rng.choice((1, 2, 4, 8, 40, 400)), len(data) - at)
        change = rng.randrange(7)
        if change == 0 and at < len(data):
            data[at] ^= 1 << rng.randrange(8)
        elif change == 1:
            data[at : at + length] = rng.randbytes(length)
        elif change == 2:
            del data[at : at + length]
        elif change == 3:
            data[at:at] = data[at : at + length] * rng.choice((1, 1, 1, 30))
        elif change == 4:
            data[at:at] = rng.choice(WORDS)
        elif change == 5:
            size = rng.choice((2, 4, 8))
            data[at : at + size] = (rng.choice(EDGES) % (1 << 8 * size)).to_bytes(size, "little")
        else:
            other = rng.choice(seeds)
            data[at:] = other[rng.randrange(len(other) + 1) :]
    return bytes(data)


# --- submissions ---

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


@cache
def scratch() -> Path:
    """In memory, where there is such a place."""
    memory = Path("/dev/shm")
    folder = tempfile.TemporaryDirectory(dir=memory if os.access(memory, os.W_OK) else None)
    _kept.append(folder)
    return Path(folder.name)


_kept: list[tempfile.TemporaryDirectory[str]] = []


def check_zip(data: bytes) -> bool:
    path = scratch() / f"{os.getpid()}.zip"
    path.write_bytes(data)
    return _taken_or_refused(lambda: submission.read(path))


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
    """Within the limits, and nowhere but inside."""
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


# --- what the judge and the compiler say ---


SHOWN = {
    "name": "a bounce",
    "input": "q = (1, 2, 3)",
    "sentence": "column 2 is the first wrong one",
    "contact": "corner 2 touches and sticks",
    "quantities": [
        {"name": "p", "unit": "m/s", "got": [[1, "nan"]], "right": [[True, False]]}
        | {"expected": [[1, 2.5]]}
    ],
    "scene": {"l": 0.2, "m": 0.3, "g": [0, -9.81, 0], "dt": 0.01, "delta": 0.001}
    | {"q": [0, 0.1, 0], "v": [1, 0, 0]},
    "path": {
        "first": 1,
        "got": [[0, 1, 2], ["inf", 0, 0]],
        "columns": [0],
        "expected": [[0, 1, 2]],
    },
}
POINTS = [{"dt": 0.01, "ns": 25000, "error": 0.12}, {"dt": 0.003, "ns": 81000, "error": None}]
TIMES = {
    "dt": [0.01, 0.003],
    "cut": "at dt = 0.001 s: the program crashed",
    "scenes": [
        {"scene": "tumble", "title": "Tumble", "seconds": 0.4}
        | {"submission": POINTS, "solution": POINTS, "least": POINTS[:1]}
    ],
}


@cache
def judge_seeds() -> list[bytes]:
    check = {"passed": True, "status": "graded", "stack": "", "message": ""}
    check |= {"shown": None, "revealed": None}
    wrong = {"passed": False, "status": "crashed", "stack": " 0x40 0x41", "message": "1 of 2\n got"}
    wrong |= {"shown": SHOWN, "revealed": {"message": "1 of 2", "shown": SHOWN}}
    ids = [check.id for check in parts()[3].checks]
    told = {"mistakes": ["part4_transposed"], "patterns": ["Column 0 is the first wrong one."]}
    return [
        json.dumps(
            {"checks": [{**verdict, "id": id} for id in ids], "largest_error": error, **told}
        ).encode()
        for verdict, error in ((check, 1e-13), (wrong, None))
    ] + [json.dumps(TIMES).encode(), b"[" * 3000]


def check_judge(data: bytes) -> bool:
    return any([_read(judging.read_answer, data, parts()[3]), _read(speed.read, data)])


def _read(reader: Callable[..., Any], *arguments: Any) -> bool:
    try:
        json.dumps(reader(*arguments), allow_nan=False)
    except KitError:
        return False
    return True


COMPILER_SEEDS = [
    b"part2_lcp.cpp:7:3: warning: x\npart2_lcp.cpp:9:1: error: expected expression\n",
    b"In file included from a b/h.hpp:1:\na b/h.hpp:3:9: fatal error: 'x' file not found\n",
    b'/usr/include/eigen3/Eigen/src/Core/Product.h:1:2: error: static_assert "INVALID_PRODUCT"\n'
    b"part2_lcp.cpp:11:30: note: in instantiation of function template\n",
    b"ld.lld: error: undefined symbol: r(double)\n>>> referenced by part3_step.cpp:12 (/tmp/x:12)\n",
    b"ld.lld: error: duplicate symbol: main\n",
    f"??:0\n/tmp/{WORK_FOLDER}x1/sources/src/part1_contacts.cpp:12 (discriminator 3)\n".encode(),
]


def check_compiler(data: bytes) -> bool:
    said = Result(1, 0.0, b"", data.decode("utf-8", "replace"), False, False)
    problem = build.compile_problem(said, "part2_lcp.cpp")
    link = build.link_problem(said)
    place = judging.place_in(data)
    assert problem and "\n" not in problem and "\n" not in link
    assert place is None or len(place) <= 300
    return place is not None or ": " in problem


READERS = {
    "zip": Reader(some_zip, check_zip, 0.2),
    "folder": Reader(some_tree, check_tree, 0.5),
    "sources": Reader(some_entries, check_entries, 0.2),
    "judge": Reader(lambda rng: mutated(rng, judge_seeds(), 4), check_judge, 0.1),
    "compiler": Reader(lambda rng: mutated(rng, COMPILER_SEEDS), check_compiler, 0.2),
}


# --- running ---


def run(name: str, first: int, count: int) -> int:
    """How many of the inputs first, first + 1, ... were taken."""
    reader, taken = READERS[name], 0
    signal.signal(signal.SIGPROF, _too_slow)
    signal.signal(signal.SIGALRM, _too_slow)
    for number in range(first, first + count):
        made = reader.make(random.Random(f"{name} {number}"))
        _set_timers(MOST_SECONDS)
        try:
            taken += reader.check(made)
        except BaseException as error:
            raise AssertionError(f"{_kept_as(name, number, made)}: {error!r}") from error
        finally:
            _set_timers(0)
    return taken


def _set_timers(seconds: int) -> None:
    """Of CPU time; and more of the wall clock, for what only waits."""
    signal.setitimer(signal.ITIMER_PROF, seconds)
    signal.setitimer(signal.ITIMER_REAL, 6 * seconds)


def _too_slow(*_: object) -> None:
    raise TimeoutError(f"more than {MOST_SECONDS} s of CPU time, or it waits")


def plain(made: Any) -> bytes:
    """An input as bytes, whatever it is."""
    if isinstance(made, bytes):
        return made
    told = [(x.name, x.size, x.link, x.read(99)) if isinstance(x, Entry) else x for x in made]
    return repr(told).encode()


def _kept_as(name: str, number: int, made: Any) -> Path:
    path = ROOT / "build" / "fuzz" / "inputs" / f"{name}-{number}"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(plain(made))
    return path


def limit_memory() -> None:
    pages = int(Path("/proc/self/statm").read_text().split()[0])
    most = pages * resource.getpagesize() + MOST_MEMORY
    resource.setrlimit(resource.RLIMIT_AS, (most, most))


def main(name: str, count: int) -> None:
    start = time.monotonic()
    firsts = range(0, count, CHUNK)
    with ProcessPoolExecutor(initializer=limit_memory) as pool:
        try:
            taken = sum(pool.map(run, [name] * len(firsts), firsts, [CHUNK] * len(firsts)))
        except AssertionError as error:
            pool.shutdown(cancel_futures=True)
            sys.exit(f"{name}: {error}")
    count = len(firsts) * CHUNK
    seconds = time.monotonic() - start
    print(f"   {name}: {count} inputs, {taken / count:.0%} of them taken, in {seconds:.0f} s")
    if taken < READERS[name].least_taken * count:
        sys.exit(f"{name}: too few inputs were taken for this to show anything")


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
