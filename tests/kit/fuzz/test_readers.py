"""Tries the readers of submissions, and of text that submissions can influence, on inputs made from
real ones, each from its own number, and on handmade ones that mutation rarely finds. Whatever comes
must be taken within the limits or refused in one sentence. The usual run takes a few thousand
inputs for each reader, ./kit test --long two hundred thousand."""

import json
import os
import random
import re
import signal
import subprocess
import tempfile
from collections.abc import Callable, Iterator
from itertools import product
from pathlib import Path, PurePosixPath
from typing import Any, NamedTuple

import corpus
import pytest
from bounce_grader.build import errors, toolchain
from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import BUILD, WORK_FOLDER
from bounce_grader.grading import judging
from bounce_grader.sandbox.processes import Result
from bounce_grader.submission import entry, submission
from conftest import ROOT
from corpus import Member
from edits import edited
from handed_in import limited_memory, packed_tar
from odd_submissions import inside, PARTS
from odd_zips import RAR, zips

Random = random.Random
INPUTS, CHUNKS = 200_000, 40  # for each reader; the usual run has one chunk
HERE = Path(__file__).parent
MOST_SECONDS = 10  # of CPU time for one input
MOST_MEMORY = 512 << 20  # bytes more than at the start

# --- bytes that are nearly right ---

PIECES = json.loads((HERE / "pieces.json").read_text())
WORDS = [word.replace("WORK", WORK_FOLDER).encode("latin-1") for word in PIECES["words"]]
EDGES = [0, 1, 2, 7, 8, 0x7F, 0x80, 0xFF, 0x7FFF, 0x8000, 0xFFFE, 0xFFFF, 1 << 16, 1 << 20]
EDGES += [(1 << 31) - 1, 1 << 31, (1 << 32) - 1, 1 << 32, (1 << 63) - 1, (1 << 64) - 1]


def mutated(rng: Random, seeds: list[bytes], most: int = 8) -> bytes:
    """One of the seeds with a few changes; now and then with none."""
    data = bytearray(rng.choice(seeds))
    for _ in range(rng.randrange(most)):
        at = rng.randrange(len(data) + 1)
        length = min(rng.choice((1, 2, 4, 8, 40, 400)), len(data) - at)
        size, other = rng.choice((2, 4, 8)), rng.choice(seeds)
        changes = (
            (at + length, rng.randbytes(length)),
            (at + length, b""),
            (at, data[at : at + length] * rng.choice((1, 1, 1, 30))),
            (at, rng.choice(WORDS)),
            (at + size, (rng.choice(EDGES) % (1 << 8 * size)).to_bytes(size, "little")),
            (len(data), other[rng.randrange(len(other) + 1) :]),
        )
        end, new = rng.choice(changes)
        data[at:end] = new
    return bytes(data)


# --- what is handed in ---

MAC = inside("hw") | {f"__MACOSX/hw/._{name}": b"\0\5" for name in PARTS}
ZIPS = [
    corpus.zip_of(Member(name.encode(), text) for name, text in PARTS.items()),
    corpus.zip_of((Member(name.encode(), text) for name, text in MAC.items()), b"a comment"),
    corpus.streamed(PARTS),
    corpus.zip64({"part1_contacts.cpp": b"int x;"}),
    corpus.overlapping(3, 100),
    corpus.many_entries(20),
]
ODD = [data for _, name, data in zips() if name == "x.zip" and len(data) < 20_000]


# --- what must hold, whatever comes ---


def check_file(data: bytes, path: Path) -> bool:
    """Checks that what was taken is within the limits, and that no path leads outside."""
    path.write_bytes(data)
    try:
        taken = submission.read(path)
    except UsageError as refused:
        assert str(refused).isprintable() and len(str(refused)) < 100_000
        return False
    assert len(taken.files) <= submission.MOST_SOURCES
    assert sum(map(len, taken.files.values())) <= submission.MOST_BYTES
    for name, text in taken.files.items():
        own = PurePosixPath(name)
        assert str(own) == name and not own.is_absolute() and ".." not in own.parts
        assert len(name.encode("utf-8")) <= submission.LONGEST_NAME and name[0] not in "-@"
        assert not re.search("[\0-\x1f\x7f\u202e]", name)
        assert own.suffix.lower() in entry.SOURCES | entry.HEADERS
        assert b"\0" not in text and len(text) <= 3 * entry.LARGEST_SOURCE
        assert not any(str(folder) in taken.files for folder in own.parents)
    assert set(taken.parts.values()) <= set(taken.files)
    assert not set(taken.parts) & set(taken.refused)
    assert len(taken.ignored) <= entry.MOST_ENTRIES and len(taken.sha256) == 64
    return True


def check_compiler(data: bytes, _: Path) -> bool:
    printed = Result(1, 0.0, b"", data.decode("utf-8", "replace"), False, False)
    problem = toolchain.compile_problem(printed, "part2_lcp.cpp").problem
    assert problem and "\n" not in problem and "\n" not in errors.of_linker(printed.err).problem
    place = judging.place_in(data)
    assert place is None or len(str(place)) <= 300
    return place is not None or ": " in problem


# --- handmade: half an answer of the judge, and towers of what a compiler may say ---

CRASHED = (HERE / "judges_answer.json").read_bytes()
EDITS = ["checks = null", "checks = []", "checks 0", "checks 0 more = 1"]
HALF = [b"", b"null", b"[]", b"{}", b"\xff", CRASHED[:-9]]
HALF += [json.dumps(edited(json.loads(CRASHED), edit)).encode() for edit in EDITS]

ENDS = ("", "'", ":?", "x", "y.cpp:?", ":1")
TOWERS = [begin + piece * (65536 // len(piece)) for begin, piece in PIECES["towers"]]


@pytest.mark.parametrize("out", HALF, ids=range(len(HALF)))
def test_half_an_answer_of_the_judge_is_a_fault_of_the_kit(out: bytes) -> None:
    with pytest.raises(KitError, match="the judge's"):
        judging.read_answer(out, parts()[3])


def test_a_whole_answer_is_taken_without_checks_that_the_manifest_leaves_out() -> None:
    fewer = parts()[3]._replace(checks=parts()[3].checks[1:])
    verdicts = judging.read_answer(CRASHED, fewer).verdicts
    assert list(verdicts) == [check.id for check in fewer.checks]


# --- the readers ---


class Reader(NamedTuple):
    """`check` returns whether an input was taken, and raises if something doesn't hold."""

    make: Callable[[Random], Any]
    check: Callable[[Any, Path], bool]
    least_taken: float  # the least share of inputs that must be taken, else they test too little
    inputs: int = INPUTS // CHUNKS


TARS = [packed_tar(PARTS, ""), packed_tar(MAC, "")]
SEVEN = subprocess.run(
    ["bsdtar", "--format=7zip", "-cf-", "@-"], input=TARS[0], capture_output=True, check=True
).stdout
EXPECTED = ROOT / "tests" / "kit" / "messages" / "expected"
PRINTED = "\n".join(file.read_text() for file in sorted(EXPECTED.glob("[acl]*.txt")))
SAID = re.split(r"\n->.*\n+", PRINTED.replace("WORK", WORK_FOLDER))
MESSAGES = [text.encode() for text in SAID if text]
READERS = {
    "x.zip": Reader(lambda rng: mutated(rng, ZIPS + ODD, 4), check_file, 0.1),
    # A box for each.
    "x.tar": Reader(lambda rng: mutated(rng, TARS), check_file, 0.2, 100),
    "x.rar": Reader(lambda rng: mutated(rng, [RAR]), check_file, 0.1, 50),
    "x.7z": Reader(lambda rng: mutated(rng, [SEVEN]), check_file, 0.1, 50),
    "compiler": Reader(lambda rng: mutated(rng, MESSAGES), check_compiler, 0.2),
}


@pytest.fixture
def folder() -> Iterator[Path]:
    """A folder in memory, where there is such a place. An input that takes too long or too much
    memory raises an error."""

    def too_long(*_: object) -> None:
        raise TimeoutError("it takes too long, or it waits")

    before = [signal.signal(it, too_long) for it in (signal.SIGALRM, signal.SIGVTALRM)]
    memory = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
    with tempfile.TemporaryDirectory(dir=memory) as made, limited_memory(MOST_MEMORY):
        yield Path(made)
    limit(0)
    for it, handler in zip((signal.SIGALRM, signal.SIGVTALRM), before):
        signal.signal(it, handler)


def limit(seconds: int) -> None:
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds)
    signal.alarm(6 * seconds)


def test_a_tower_of_what_a_compiler_may_print_is_read_in_linear_time(folder: Path) -> None:
    """A submission can put text there by #error, #line and its names."""
    for tower, end in product(TOWERS, ENDS):
        limit(MOST_SECONDS)
        check_compiler((tower + end).replace("WORK", WORK_FOLDER).encode(), folder)


LATER = [pytest.param(i, marks=pytest.mark.long) for i in range(1, CHUNKS)]


@pytest.mark.parametrize("chunk", [0, *LATER])
@pytest.mark.parametrize("name", READERS)
def test_whatever_comes_is_taken_or_refused(name: str, chunk: int, folder: Path) -> None:
    reader, taken = READERS[name], 0
    for number in range(chunk * reader.inputs, (chunk + 1) * reader.inputs):
        made = reader.make(Random(f"{name} {number}"))
        limit(MOST_SECONDS)
        try:
            taken += reader.check(made, folder / name)
        except BaseException as error:
            raise AssertionError(f"input {number}: {made!r}") from error
    assert taken >= reader.least_taken * reader.inputs


@pytest.mark.parametrize("name", ["frames", "terminations"])
def test_the_readers_of_the_judge_keep_their_promises(name: str, tmp_path: Path) -> None:
    """Its fuzzers write their seeds, and end at the first input for which a promise is broken."""
    program, seeds, inputs = BUILD / f"fuzz_{name}", tmp_path / "seeds", tmp_path / "inputs"
    subprocess.run([program, "--seeds", seeds], check=True)
    some = [file.read_bytes() for file in sorted(seeds.iterdir())]
    inputs.mkdir()
    for number in range(2000):
        (inputs / str(number)).write_bytes(mutated(Random(f"{name} {number}"), some))
    subprocess.run([program, seeds, inputs], check=True)
