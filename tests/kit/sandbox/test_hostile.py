"""What hostile submissions must never do, beside losing their points (the gallery sees to those):
bring a secret out of a box, or read what isn't theirs.

Secrets are random marks. A mark must be in no record, report or cached object; without a box the
same submissions do bring it out, which shows that the search works.
"""

import io
import json
import os
import secrets
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import CACHE
from bounce_grader.formats import terminal
from bounce_grader.grading import fixtures
from bounce_grader.grading.grade import grade
from bounce_grader.sandbox import box as boxes
from bounce_grader.sandbox.box import Box
from conftest import points, solution_files, write
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
    """The record as JSON, the report, and the cached objects and runners."""
    before = set(CACHE.rglob("*"))
    record = grade(submission)
    stream = io.StringIO()
    terminal.show(record, stream)
    kept = [file.read_bytes() for file in set(CACHE.rglob("*")) - before if file.is_file()]
    return json.dumps(record) + stream.getvalue() + b"".join(kept).decode("latin-1")


def quoted(path: Path | str) -> str:
    return json.dumps(str(path))


# --- secrets, while compiling ---


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


COMPILING = {"include": including, "incbin": embedding, "errors": erring}


@pytest.mark.parametrize("way", COMPILING)
def test_a_compiler_brings_no_secret_out(world: World, way: str) -> None:
    write(world.submission, COMPILING[way](world))
    assert world.mark not in everything_said(world.submission)


@pytest.mark.parametrize("way", COMPILING)
def test_without_a_box_a_compiler_would(
    world: World, way: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(boxes, "choose", lambda trust: Box("none"))
    write(world.submission, COMPILING[way](world))
    assert world.mark in everything_said(world.submission)


# --- secrets, while running ---


def looking(world: World) -> dict[str, bytes]:
    """Part 1 opens the secrets, part 2 reads the environment, in every way there is; part 3 looks
    for descriptors, and part 4 at what other processes hold."""
    places = ", ".join(quoted(file) for file in world.files)
    reader = r"""
    #include <fstream>
    #include <stdexcept>
    #include <string>
    static void tell(const std::string& path) {
      std::ifstream file(path);
      const std::string text((std::istreambuf_iterator<char>(file)), {});
      if (!text.empty()) throw std::runtime_error(text.substr(0, 150));
    }
    """
    own = f"static void attack() {{ for (const char* p : {{{places}}}) tell(p); }}"
    environment = r"""
    #include <cstdlib>
    #include <unistd.h>
    static void attack() {
      if (const char* canary = std::getenv("BOUNCE_CANARY")) throw std::runtime_error(canary);
      for (char** e = environ; e && *e; ++e) {
        if (std::string(*e) != "PWD=/") throw std::runtime_error(*e);
      }
      for (const char* p : {"/proc/self/environ", "/proc/1/environ", "/proc/2/environ"}) tell(p);
    }
    """
    descriptors = r"""
    #include <unistd.h>
    static void attack() {
      char text[150] = {};
      for (int fd = 5; fd < 1024; ++fd) {
        if (read(fd, text, sizeof text - 1) > 0) throw std::runtime_error(text);
      }
      for (int fd = 0; fd < 64; ++fd) tell("/proc/self/fd/" + std::to_string(fd));
    }
    """
    others = r"""
    static void attack() {
      for (int pid = 1; pid < 100; ++pid) {
        for (const char* name : {"/environ", "/cmdline", "/maps"}) {
          tell("/proc/" + std::to_string(pid) + name);
        }
      }
    }
    """
    attacks = [own, environment, descriptors, others]
    return {p.file: part(p.number, reader + a) for p, a in zip(parts(), attacks)}


def test_a_running_program_brings_no_secret_out(world: World) -> None:
    write(world.submission, looking(world))
    record = grade(world.submission)
    assert world.mark not in everything_said(world.submission)
    assert points(record) == [0, 0, 0, 1]  # it ran, and found nothing to throw
    assert {p["status"] for p in record["parts"]} == {"graded"}
    assert all("threw" not in c["message"] for p in record["parts"] for c in p["checks"])


def test_without_a_box_a_running_program_would(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(boxes, "choose", lambda trust: Box("none"))
    write(world.submission, looking(world))
    checks = [p["checks"] for p in grade(world.submission)["parts"]]
    assert world.mark in checks[0][0]["message"]
    assert world.mark not in checks[1][0]["message"]  # what we start has no variable of ours


# --- files that are none ---


def test_links_and_pipes_in_a_submission_are_not_read(world: World) -> None:
    """If it followed a link, the grader itself would carry a secret into the box."""
    folder = write(world.submission, solution_files())
    (folder / "part1_contacts.cpp").unlink()
    (folder / "part1_contacts.cpp").symlink_to(world.files[0])
    (folder / "helper.hpp").symlink_to(world.files[1])
    (folder / "homes").symlink_to(world.files[2].parent, target_is_directory=True)
    os.mkfifo(folder / "fifo.cpp")
    said = everything_said(folder)
    assert world.mark not in said
    record = grade(folder)
    assert points(record) == [0, 30, 30, 10]
    assert record["parts"][0]["status"] == "not_submitted"
    odd = {"part1_contacts.cpp", "helper.hpp", "homes", "fifo.cpp"}
    assert set(record["ignored"]) == odd


def test_names_of_files_move_no_cursor_and_break_no_record(tmp_path: Path) -> None:
    odd = {
        "\x1b[2J\x1b[1;1HScore 100.cpp": b"#error \x1b[31mred\n",
        "<img src=x onerror=alert(1)>.cpp": b"int x = ;\n",
        '=HYPERLINK("http:").hpp': b"",
        "a\nb\u202e.txt": b"",
    }
    record = grade(write(tmp_path / "submission", {**solution_files(), **odd}))
    assert points(record) == [30, 30, 30, 10]
    stream = io.StringIO()
    terminal.show(record, stream)
    assert "\x1b" not in stream.getvalue() and "\u202e" not in stream.getvalue()


@pytest.mark.parametrize(
    "text, status, sentence",
    [
        (b"// long\n" * 65536, "does_not_compile", "defines no bounce::get_contacts"),
        (b"// " + b"x" * 1_000_000 + b"\n", "does_not_compile", "defines no bounce::get_contacts"),
        (b"// ten megabytes\n" * 600_000, "does_not_compile", "10.2 MB large"),
        (b"x" * 60_000, "does_not_compile", "part1_contacts.cpp:1:1"),
        (b"(" * 60_000, "does_not_compile", "part1_contacts.cpp"),
        (b"\xff\xfe\xff" * 1000, "does_not_compile", "part1_contacts.cpp"),
        (b"int x;\r\n\0", "does_not_compile", "isn't a text file"),
    ],
    ids=["65k lines", "a long line", "10 MB", "a long word", "brackets", "no text", "NUL"],
)
@pytest.mark.usual(4)
def test_sources_of_odd_sizes_cost_their_own_part(
    grade: Callable[..., dict[str, Any]], text: bytes, status: str, sentence: str
) -> None:
    record = grade({"part1_contacts.cpp": text})
    assert points(record) == [0, 30, 30, 10]
    assert record["parts"][0]["status"] == status
    assert sentence in record["parts"][0]["message"]
