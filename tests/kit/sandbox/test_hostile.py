"""What hostile submissions must never do, beside losing their points: have a compiler bring a
secret out of a box. What a running program can reach is tried by the doctor's probe, and what a
link in a submission leads to is told by tests/kit/odd_submissions/.

Secrets are random marks. A mark must be in no record, report or cached object; without a box the
same submissions do bring it out, which shows that the search works.
"""

import io
import json
import secrets
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import CACHE
from bounce_grader.formats import terminal
from bounce_grader.grading import fixtures
from bounce_grader.grading.grade import grade as grade_path
from bounce_grader.sandbox import box as boxes
from bounce_grader.sandbox.box import Box
from conftest import Grade, points, write
from hostile import part


@dataclass(frozen=True)
class World:
    """Secrets with one mark, where a submission might look for them."""

    mark: str
    files: list[Path]
    submission: Path


@pytest.fixture
def world(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[World]:
    mark = secrets.token_hex(16)
    hidden = fixtures.hidden_folder() / f"canary-{secrets.token_hex(4)}.txt"
    files = [
        tmp_path / "solution" / "src" / "part1_contacts.cpp",
        hidden,
        tmp_path / "home" / ".bash_history",
        tmp_path / "submissions" / "another" / "part1_contacts.cpp",
    ]
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    monkeypatch.setenv("BOUNCE_CANARY", mark)
    for file in files:
        file.parent.mkdir(parents=True, exist_ok=True)
        # However it is read, as a string or in an error, the mark shows.
        file.write_text(f'"{mark}"\n')
    yield World(mark, files, tmp_path / "submissions" / "mine")
    hidden.unlink()


def everything_said(submission: Path) -> str:
    """The record, the report, and the cached objects and runners."""
    before = set(CACHE.rglob("*"))
    record = grade_path(submission)
    stream = io.StringIO()
    terminal.show(record, stream)
    kept = [file.read_bytes() for file in set(CACHE.rglob("*")) - before if file.is_file()]
    return json.dumps(record) + stream.getvalue() + b"".join(kept).decode("latin-1")


def quoted(path: Path | str) -> str:
    return json.dumps(str(path))


def including(world: World) -> dict[str, bytes]:
    """Each part includes a secret as a string that would become its exception's text."""
    return {
        parts()[i].file: part(
            i + 1,
            "#include <stdexcept>\n"
            f"static const char* stolen =\n#include {quoted(file)}\n;\n"
            "static void attack() { throw std::runtime_error(stolen); }",
        )
        for i, file in enumerate(world.files)
    }


def embedding(world: World) -> dict[str, bytes]:
    """The assembler reads all of them, into the object."""
    lines = "".join(f".incbin {json.dumps(quoted(file))[1:-1]}\\n" for file in world.files)
    attack = f'asm(".data\\n.globl stolen\\nstolen: {lines}.byte 0\\n.text\\n");\n'
    attack += 'extern "C" const char stolen[];\n#include <stdexcept>\n'
    attack += "static void attack() { throw std::runtime_error(stolen); }"
    return {"part1_contacts.cpp": part(1, attack)}


def erring(world: World) -> dict[str, bytes]:
    """Compile errors with a secret as their text; that of the second part only with g++."""
    attack = (
        f"static_assert(false,\n#include {quoted(world.files[0])}\n);\nstatic void attack() {{}}"
    )
    for_gcc = "#ifdef __clang__\n#error not for clang\n#endif\n" + attack
    return {"part1_contacts.cpp": part(1, attack), "part2_lcp.cpp": part(2, for_gcc)}


@pytest.mark.parametrize("boxed", [True, False], ids=["boxed", "without a box it would"])
@pytest.mark.parametrize("way", [including, embedding, erring], ids=lambda way: way.__name__)
def test_a_compiler_brings_no_secret_out(
    world: World,
    way: Callable[[World], dict[str, bytes]],
    boxed: bool,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    if not boxed:
        monkeypatch.setattr(boxes, "choose", lambda trust: Box("none"))
    write(world.submission, way(world))
    assert (world.mark in everything_said(world.submission)) is not boxed


ODD_SIZES = {
    "65k lines": (b"// long\n" * 65536, "defines no bounce::get_contacts"),
    "a long line": (b"// " + b"x" * 1_000_000 + b"\n", "defines no bounce::get_contacts"),
    "10 MB": (b"// ten megabytes\n" * 600_000, "10.2 MB large"),
    "a long word": (b"x" * 60_000, "part1_contacts.cpp:1:1"),
    "brackets": (b"(" * 60_000, "part1_contacts.cpp"),
    "no text": (b"\xff\xfe\xff" * 1000, "part1_contacts.cpp"),
    "NUL": (b"int x;\r\n\0", "isn't a text file"),
}


@pytest.mark.parametrize("what", ODD_SIZES)
def test_sources_of_odd_sizes_cost_their_own_part(grade: Grade, what: str) -> None:
    text, sentence = ODD_SIZES[what]
    record = grade({"part1_contacts.cpp": text})
    assert points(record) == [0, 30, 30, 10]
    assert record["parts"][0]["status"] == "does_not_compile"
    assert sentence in record["parts"][0]["message"]
