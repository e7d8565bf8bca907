"""Several parts compiled by one start of clang: their objects are those that each would get alone."""

import secrets
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from bounce_grader import build, compiler, kept, together
from bounce_grader.box import Box
from bounce_grader.classroom.synthetic import gallery, made
from bounce_grader.paths import WORK_FOLDER
from bounce_grader.submission import read
from conftest import ROOT, Grade, points, solution_files, write

GALLERY = gallery(("accepted", "mistakes"))
FULL_BOX = Box("full")
ACCEPTED = ROOT / "tests" / "submissions" / "accepted"


def new(files: dict[str, bytes]) -> dict[str, bytes]:
    """With a line that no earlier compiler has seen."""
    return {name: b"// %s\n" % secrets.token_hex(8).encode() + t for name, t in files.items()}


@contextmanager
def work_folder(box: Box) -> Iterator[Path]:
    with tempfile.TemporaryDirectory(prefix=WORK_FOLDER) as name:
        box.give(Path(name))
        yield Path(name)


def code(objects: build.Objects, folder: Path) -> dict[int, bytes]:
    """All of the objects but for what only a debugger reads."""
    found = {}
    for number, built in objects.parts.items():
        assert built.path, built.problem
        bare = folder / f"{number}.o"
        subprocess.run(["strip", "--strip-debug", "-o", bare, built.path], check=True)
        found[number] = bare.read_bytes()
    return found


def compiled(files: dict[str, bytes], tmp_path: Path, cache: Path) -> dict[int, bytes]:
    taken = read(write(tmp_path / "submission", files))
    with pytest.MonkeyPatch.context() as patch, work_folder(FULL_BOX) as work:
        patch.setattr(kept, "CACHE", cache)
        return code(build.compile_all(taken, work, FULL_BOX, 1), work)


def objects_are_the_same(files: dict[str, bytes], tmp_path: Path) -> bool:
    """Made together, and made alone."""
    with pytest.MonkeyPatch.context() as patch:
        many = compiled(files, tmp_path, tmp_path / "together")
        patch.setattr(together, "compile_missing", lambda *_: None)
        return many == compiled(files, tmp_path, tmp_path / "alone")


def test_objects_are_those_that_each_part_gets_alone(tmp_path: Path) -> None:
    assert objects_are_the_same(solution_files(), tmp_path)


@pytest.mark.long
@pytest.mark.parametrize(
    "folder", GALLERY, ids=lambda folder: f"{folder.parent.name}-{folder.name}"
)
def test_objects_of_the_gallery_are_those_that_each_part_gets_alone(
    tmp_path: Path, folder: Path
) -> None:
    assert objects_are_the_same(made(folder, 1, "A, B").files, tmp_path)


@pytest.mark.parametrize("kind", ["full", "reduced", "none"])
@pytest.mark.parametrize("jobs", [1, 2])
def test_it_comes_about_in_every_box(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, kind: str, jobs: int
) -> None:
    """Where clang missed something there, each part alone would save the grading, and cost time."""
    taken, box = read(write(tmp_path, new(solution_files()))), Box(kind)
    monkeypatch.setattr(compiler, "clang", lambda *_: ["/nowhere"])
    monkeypatch.setattr(compiler, "gcc", lambda *_: ["/nowhere"])
    with work_folder(box) as work:
        built = build.compile_all(taken, work, box, jobs)
    assert all(part.path for part in built.parts.values()), built


# --- what takes no part in it ---

APART = {
    "a warning is turned off": b'#pragma clang diagnostic ignored "-Wall"\n',
    "by an operator": b'_Pragma("clang diagnostic push")\n',
    "a file whose name is made up": b"#include NAME\n",
    "a directive over two lines": b'#in\\\nclude "a.hpp"\n',
    "over two lines, with a blank": b'#in\\ \nclude "a.hpp"\n',
    "a directive in other letters": b'%:include "a.hpp"\n',
    "another way to include": b'#import "a.hpp"\n',
    "the next of that name": b'#include_next "a.hpp"\n',
    "asking for a file": b"#if __has_include(NAME)\n#endif\n",
    "the assembler": b'asm(".incbin \\"a.hpp\\"");\n',
    "the assembler, as others spell it": b'__asm__(".incbin \\"a.hpp\\"");\n',
    "another file's name": b'#line 1 "a.cpp"\n',
}
TOGETHER = {
    "headers": b'#include <cmath>\n # include "own.hpp"\n',
    "a guard": b"#ifndef A_HPP\n#define A_HPP\n#else\n#endif\n#pragma once\n",
    "conditions": b"#if 1\n#elif 2\n#endif\n#ifdef A\n#undef A\n#endif\n",
}


@pytest.mark.parametrize("text", APART.values(), ids=APART)
def test_what_could_reach_another_file_is_compiled_alone(text: bytes) -> None:
    assert together.APART.search(text)


@pytest.mark.parametrize("text", [*TOGETHER.values(), *solution_files().values()])
def test_what_most_parts_are_made_of_is_compiled_together(text: bytes) -> None:
    assert not together.APART.search(text)


def test_a_part_does_not_see_the_others(grade: Grade) -> None:
    """By whatever way; else its object would stand for what depends on them."""
    asking = (
        b"#define J(a, b) a##b\n#define TEXT_(x) #x\n#define TEXT(x) TEXT_(x)\n"
        b"#if __has_include(TEXT(J(part2,_lcp).cpp))\n#error seen\n#endif\n"
    )
    files = new(solution_files())
    files["part1_contacts.cpp"] = asking + files["part1_contacts.cpp"]
    assert points(grade(files)) == [30, 30, 30, 10]


def test_a_part_that_does_not_compile_costs_no_other(grade: Grade) -> None:
    files = new(solution_files())
    files["part2_lcp.cpp"] += b"int x = ;\n"
    record = grade(files)
    assert points(record) == [30, 0, 30, 10]
    assert "part2_lcp.cpp:" in record["parts"][1]["message"]


# --- objects in a row ---


def an_object(sections: int, size: int = 64) -> bytes:
    head = bytearray(64)
    head[:6] = b"\x7fELF\2\1"
    head[40:48] = (64).to_bytes(8, "little")
    head[58:62] = size.to_bytes(2, "little") + sections.to_bytes(2, "little")
    return bytes(head) + b"s" * size * sections


def test_objects_in_a_row_are_told_apart() -> None:
    several = [an_object(n) for n in (3, 1, 7)]
    assert together.apart(b"".join(several)) == several
    assert together.apart(b"") == []


@pytest.mark.parametrize(
    "row",
    [
        an_object(3)[:-1],
        an_object(3) + b"\x7fELF",
        an_object(3) + b"x" * 100,
        b"\x7fELF\1\1" + an_object(2)[6:],
        an_object(2)[:40] + b"\xff" * 8 + an_object(2)[48:],
        an_object(2)[:40] + bytes(24) + an_object(2)[64:],
        an_object(2)[:50],
    ],
)
def test_what_is_no_row_of_objects_is_none(row: bytes) -> None:
    assert together.apart(row) == []


def test_decompositions_and_matrices_of_any_size_are_there_already(tmp_path: Path) -> None:
    """Made anew, their code would fill the parts' own objects, for seconds."""
    objects = made(ACCEPTED / "objects_and_virtual_functions", 1, "x").files
    dynamic = made(ACCEPTED / "dynamic_matrices_and_lu", 1, "x").files
    for name, (files, part) in enumerate([(objects, 3), (dynamic, 2)]):
        folder = tmp_path / str(name)
        known = compiled(files, folder, folder / "known")
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(compiler, "header_of", lambda *_: "prelude")
            anew = compiled(files, folder, folder / "anew")
        assert len(known[part]) < len(anew[part]) / 4
        assert objects_are_the_same(files, folder / "same")


def test_parts_against_either_header_are_linked(grade: Grade) -> None:
    changes: dict[str, bytes | None] = {}
    for kind in ("objects_and_virtual_functions", "dynamic_matrices_and_lu"):
        changes |= {f.name: f.read_bytes() for f in (ACCEPTED / kind).glob("part[123]*.cpp")}
    del changes["part1_contacts.cpp"]
    assert points(grade(dict(new({k: v for k, v in changes.items() if v})))) == [30, 30, 30, 10]


@pytest.mark.parametrize(
    "text, header",
    [
        ("A.llt().solve(b)", "solvers"),
        ("Eigen::LDLT<Eigen::Matrix3d> a(A);", "solvers"),
        ("M.partialPivLu().solve(b)", "solvers"),
        ("M.colPivHouseholderQr().solve(b)", "solvers"),
        ("Eigen::FullPivLU<Matrix3> lu(M);", "solvers"),
        ("Eigen::MatrixXd A(3, 3);", "solvers"),
        ("solve_lcp(lcp.V, lcp.p); // wilt, flu, value, ALL", "prelude"),
        ("Eigen::Matrix3Xd q; params.M().inverse() * b", "prelude"),
    ],
)
def test_the_text_says_which_header_a_part_needs(text: str, header: str, tmp_path: Path) -> None:
    taken = read(write(tmp_path, {"part3_step.cpp": text.encode(), "a.hpp": b"llt()"}))
    assert compiler.header_of(["part3_step.cpp"], taken) == header
    assert compiler.header_of(["a.hpp", "part3_step.cpp"], taken) == "solvers"
