"""Compiling submissions: the objects, their cache, and limits."""

import os
import secrets
import subprocess
import tempfile
from contextlib import suppress
from pathlib import Path

import pytest
from bounce_grader.build import compile as compiling, compiler, linking, object_cache
from bounce_grader.common.errors import KitError
from bounce_grader.common.files import temporary_folder
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import CONTRACT, RUNNER, WORK_FOLDER
from bounce_grader.grading.grade import grade as grade_path
from bounce_grader.sandbox import processes
from bounce_grader.sandbox.box import Box
from bounce_grader.sandbox.processes import run, Limits, Result
from bounce_grader.submission.submission import read
from conftest import SOLUTION, Grade, points, solution_files, write

FULL: list[float] = [part.points for part in parts()]


def _new() -> bytes:
    """A comment that makes the source new to the cache."""
    return f"// {secrets.token_hex(8)}\n".encode()


# --- what names an object ---


def test_a_changed_helper_is_compiled_anew_also_where_it_is_included_as_a_source(
    grade: Grade,
) -> None:
    """A cached object of an earlier grading must never be used for other code."""
    including = b'#include "helper.cpp"\n' + solution_files()["part4_simulate.cpp"]
    assert points(grade({"part4_simulate.cpp": including, "helper.cpp": b"\n"})) == FULL
    broken = grade({"part4_simulate.cpp": including, "helper.cpp": b"#error changed\n"})
    assert points(broken) == [30, 30, 30, 0]


def test_a_changed_object_of_the_kit_makes_other_runners(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def digest() -> bytes:
        return object_cache.toolchain_digest.__wrapped__()

    for name in ("prelude.pch", "solve_lcp.o"):
        (tmp_path / name).write_bytes(b"")
    monkeypatch.setattr(object_cache, "RUNNER", tmp_path)
    before = digest()
    assert digest() == before
    os.utime(tmp_path / "solve_lcp.o", ns=(1, 1))
    assert digest() != before


def test_a_kit_of_another_user_says_whose_it_is(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "access", lambda *_: False)
    with pytest.raises(KitError, match="belongs to .*, who alone can grade with it"):
        object_cache.toolchain_digest.__wrapped__()


def test_objects_of_long_ago_are_forgotten_when_there_are_many(tmp_path: Path) -> None:
    old = [tmp_path / f"old{n}" for n in range(70)]
    for n, file in enumerate(old):
        file.write_bytes(b"")
        os.utime(file, (n, n))
    young = [tmp_path / f"young{n}" for n in range(70)]
    for file in young:
        file.write_bytes(b"")
    object_cache.forget_old(tmp_path)
    assert set(tmp_path.iterdir()) == set(young)
    object_cache.forget_old(tmp_path)
    assert set(tmp_path.iterdir()) == set(young)


def test_files_that_name_each_other_are_compiled_each(grade: Grade) -> None:
    all_names = b"// " + b", ".join(name.encode() for name in solution_files()) + b"\n" + _new()
    named = {name: all_names + text for name, text in solution_files().items()}
    assert points(grade({**named})) == FULL


HIDDEN_INCLUDES = {
    "over two lines": b'#include "re\\\nal.cpp"\n',
    "pasted": b"#define J(a, b) a##b\n#define TEXT_(x) #x\n#define TEXT(x) TEXT_(x)\n"
    b"#include TEXT(J(re, al).cpp)\n",
}


@pytest.mark.parametrize("way", HIDDEN_INCLUDES)
def test_an_object_never_answers_for_a_file_that_it_was_not_made_from(
    grade: Grade, way: str
) -> None:
    """Even if a macro hides the including of a source."""
    including = _new() + HIDDEN_INCLUDES[way]
    real = b"#ifndef DONE\n#define DONE\n" + solution_files()["part1_contacts.cpp"] + b"#endif\n"
    files = {"part1_contacts.cpp": b"#define INSIDE\n" + including}
    inside = b"#ifdef INSIDE\n" + real + b"#endif\n"
    assert points(grade({**files, "real.cpp": inside})) == FULL
    assert points(grade({**files, "real.cpp": b"\n"})) == [0, 30, 30, 10]


def test_a_header_that_only_gcc_has_is_found(grade: Grade) -> None:
    part = b"#include <quadmath.h>\n" + solution_files()["part1_contacts.cpp"]
    assert points(grade({"part1_contacts.cpp": part})) == FULL


def test_what_was_compiled_without_a_box_is_not_taken_in_one() -> None:
    taken = read(SOLUTION)
    names = sorted(taken.files)
    digests = {
        object_cache.name_of(names[0], names, taken, Box(kind), False) for kind in ("full", "none")
    }
    assert len(digests) == 2


# --- what is kept ---


def test_an_object_in_use_is_not_forgotten(tmp_path: Path) -> None:
    files = [tmp_path / f"{n:03}" for n in range(100)]
    object_cache.store(b"x", files[0])
    for n, file in enumerate(files):
        file.touch()
        os.utime(file, (n, n))
    assert object_cache.is_there(files[0]) and not object_cache.is_there(tmp_path / "nothing")
    object_cache.forget_old(tmp_path)
    assert files[0].exists() and not files[1].exists() and files[-1].exists()


def test_large_objects_are_forgotten_earlier(tmp_path: Path) -> None:
    for n in range(8):
        file = tmp_path / str(n)
        file.write_bytes(b"x" * (object_cache.KEPT_BYTES // 4))
        os.utime(file, (n, n))
    object_cache.forget_old(tmp_path)
    assert sorted(file.name for file in tmp_path.iterdir()) == ["4", "5", "6", "7"]


# --- what it may cost ---


def test_an_object_that_is_too_large_costs_its_part_and_is_not_kept(grade: Grade) -> None:
    data = b'asm(".data\\n.fill 50000000,1,7\\n.text");\n'
    part = _new() + data + solution_files()["part1_contacts.cpp"]
    record = grade({"part1_contacts.cpp": part})
    assert points(record) == [0, 30, 30, 10]
    assert "makes an object of more than 8 MB" in record["parts"][0]["message"]


@pytest.mark.parametrize("kind", ["full", "reduced", "none"])
def test_what_a_compiler_takes_is_counted(kind: str) -> None:
    limits = Limits(cpu_seconds=1, wall_seconds=60, memory=1 << 30, file_size=0)
    endless = ["/bin/sh", "-c", "while :; do :; done"]
    assert run([*Box(kind).to_build(RUNNER, [], ("sh",)), *endless], limits).cpu_seconds > 0.4


def test_helpers_have_a_limit_in_common(grade: Grade, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compiling, "HELPERS_SECONDS", 0.02)  # what one of them takes
    monkeypatch.setattr("os.cpu_count", lambda: 1)
    helpers = {f"helper{n}.cpp": _new() + b"int helper%d;\n" % n for n in range(3)}
    missing = b"extern int helper2;\nint use() { return helper2; }\n"
    part = missing + solution_files()["part1_contacts.cpp"]
    record = grade({**helpers, "part1_contacts.cpp": part})
    assert points(record) == [0, 30, 30, 10]
    assert "helper1.cpp wasn't compiled: the helpers took 0.02 s" in record["parts"][0]["message"]


@pytest.mark.parametrize("kind", ["full", "reduced"])
def test_clang_needs_no_help_in_a_box(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, kind: str
) -> None:
    """If clang missed a file, g++ would compile instead, silently and five times as slowly."""
    files = {name: _new() + text for name, text in solution_files().items()}
    with temporary_folder(WORK_FOLDER) as work:
        box = Box(kind)
        box.give(Path(work))
        monkeypatch.setattr(compiler, "gcc", lambda *_: ["/nowhere"])
        built = compiling.compile_all(read(write(tmp_path / "s", files)), Path(work), box, 2)
    assert all(part.path for part in built.parts.values()), built


def test_what_is_timed_is_built_by_gcc_as_a_program_is_too(tmp_path: Path) -> None:
    """For code that clang rejects."""
    only = b"#if !defined NDEBUG || !defined __OPTIMIZE__ || defined __clang__\n#error\n#endif\n"
    write(tmp_path / "s", {"part1_contacts.cpp": _new() + only})
    taken = read(tmp_path / "s")
    built = compiling.compile_all(taken, tmp_path, Box("none"), 1, timed=True)
    assert built.parts[1].path, built.parts[1].problem
    assert not compiling.compile_all(taken, tmp_path, Box("none"), 1).parts[1].path


@pytest.mark.parametrize("size, kept", [(8_000_000, 5), (30_000_000, 0)])
def test_helpers_fill_no_disk(tmp_path: Path, size: int, kept: int) -> None:
    """Neither by what is kept nor by what is refused."""
    zeros = 'asm(".section .data.h,\\"aw\\"\\n.zero %d\\n.text\\n");\n' % size
    files = {f"helper{n}.cpp": f"// {secrets.token_hex()}\n{zeros}".encode() for n in range(8)}
    taken = read(write(tmp_path / "in", {**solution_files(), **files}))
    (tmp_path / "work").mkdir()
    made = compiling.compile_all(taken, tmp_path / "work", Box("none"), 1)
    problems = [built.problem for built in made.helpers.values() if not built.path]
    assert len(problems) == 8 - kept
    assert sum("take more than 32 MB" in problem for problem in problems) == (3 if kept else 6)
    assert not list((tmp_path / "work").iterdir())
    assert all(built.path for built in made.parts.values())


# --- whose fault it is ---

FAILURES = {
    "a box that isn't made": Result(1, 0.0, b"", "no namespaces\n", False, False, boxed=False),
    "a box that is too slow": Result(-9, 0.0, b"", "", True, False, boxed=False),
    "no memory for a compiler": Result(137, 0.1, b"", "", False, False, cpu_limit=15),
}


@pytest.mark.parametrize("failure", FAILURES)
def test_a_box_or_a_machine_that_fails_is_no_verdict(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, failure: str
) -> None:
    def fails(command: list[str], *others: object, **more: object) -> Result:
        compiles = any(word.endswith("part2_lcp.cpp") for word in command)
        return FAILURES[failure] if compiles else run(command, *others, **more)  # type: ignore

    files = {name: _new() + text for name, text in solution_files().items()}
    monkeypatch.setattr(processes, "run", fails)
    with pytest.raises(KitError, match="box couldn't be made|killed from outside"):
        grade_path(write(tmp_path, files))


def test_a_compiler_that_was_given_less_time_is_no_failure_of_the_machine() -> None:
    """Where the grading as a whole had little left: it is ended at that limit."""
    ended = Result(137, 1.9, b"", "", False, False, cpu_limit=2)
    compiler.require_compiler_ran(ended)
    with pytest.raises(KitError, match="killed from outside"):
        compiler.require_compiler_ran(ended._replace(cpu_limit=15))


def test_a_large_compiler_that_is_killed_is_the_submissions_doing() -> None:
    """As the system does where memory is short."""
    python = f"import os; x = b'1' * {compiler.LARGE}; os.kill(os.getpid(), 9)"
    ended = run(["/usr/bin/python3", "-c", python])._replace(cpu_limit=15)
    compiler.require_compiler_ran(ended)
    said = compiler.compile_problem(ended, "x.cpp")
    assert said == "x.cpp takes more memory to compile than there is"


def test_what_a_compiler_says_of_its_own_failure_is_no_reason() -> None:
    err = "clang: error: clang frontend command failed with exit code 134 (use -v to see it)\n"
    said = compiler.compile_problem(Result(134, 3.0, b"", err, False, False), "x.cpp")
    assert said.startswith("x.cpp: the compiler gave up on it: it takes more than 2 GB of memory")


@pytest.mark.parametrize("kind", ["full", "reduced", "none"])
def test_what_a_compiler_holds_in_memory_is_told_from_within_each_box(
    kind: str, tmp_path: Path
) -> None:
    submission, box = read(SOLUTION), Box(kind)
    command = compiler.clang("part2_lcp.cpp", submission, "prelude")
    with temporary_folder(WORK_FOLDER) as work:
        submission.write_to(Path(work), ["part2_lcp.cpp"])
        box.give(Path(work))
        result = compiler.run(command, Path(work), box, tmp_path / "x.o")
    assert result.ok and 100 << 20 < result.peak < compiler.LARGE


@pytest.mark.parametrize("kind", ["full", "reduced", "none"])
def test_a_signal_that_ends_what_gcc_starts_is_told(kind: str, tmp_path: Path) -> None:
    """By the exit status, because a submission can print any text."""
    text = (
        b"constexpr long f(long n) { long s = 0; while (--n) s += n; return s; }\n"
        b"static_assert(f(1L << 40) == 0);\n"
    )
    box, taken = Box(kind), read(write(tmp_path, {"part1_contacts.cpp": text}))
    endless = ("-fconstexpr-ops-limit=2000000000000", "-fconstexpr-loop-limit=2000000000")
    command = compiler.gcc("part1_contacts.cpp", taken, box, flags=endless)
    limits = Limits(cpu_seconds=1, wall_seconds=60, memory=2 << 30, file_size=1 << 20)
    with temporary_folder(WORK_FOLDER) as work:
        taken.write_to(Path(work))
        box.give(Path(work))
        prefix = box.to_build(Path(work), [CONTRACT, RUNNER])
        result = run([*prefix, *command], limits)
    assert result.boxed and result.code == 128 + 9, result


def test_what_an_assembler_prints_is_no_object(grade: Grade) -> None:
    """Neither for the file that prints it nor for another."""
    right = solution_files()
    stolen = object_cache.place(_name_of_part(3, {n: _new() + t for n, t in right.items()}, grade))
    text = "".join(f"\\\\{byte:03o}" for byte in stolen.read_bytes())
    printing = b'asm(".print \\"' + text.encode() + b'\\"");\n'
    files = {"part2_lcp.cpp": printing + _new() + right["part2_lcp.cpp"]}
    record = grade({**files, "part3_step.cpp": _new()})
    assert points(record) == [30, 30, 0, 10]
    assert points(grade({})) == FULL


def _name_of_part(number: int, files: dict[str, bytes], grade: Grade) -> str:
    assert points(grade({**files})) == FULL
    with tempfile.TemporaryDirectory() as folder:
        taken = read(write(Path(folder), files))
    file = taken.parts[number]
    needed = object_cache.needed(file, taken, object_cache.named_sources(taken))
    return object_cache.name_of(file, needed, taken, Box("full"), timed=False)


def test_words_of_a_submission_are_not_the_boxs(grade: Grade) -> None:
    forged = b'#line 1 "bwrap: x"\n#error nothing\n'
    record = grade({"part1_contacts.cpp": _new() + forged})
    assert points(record) == [0, 30, 30, 10]
    assert record["parts"][0]["status"] == "does_not_compile"


@pytest.mark.parametrize(
    "room", [100, *(pytest.param(kb, marks=pytest.mark.long) for kb in range(20, 2000, 30))]
)
def test_a_full_disk_costs_no_points_now_or_later(
    room: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Half of an object was once kept as if it were whole."""
    disk, files = tmp_path / "disk", tmp_path / "files"
    disk.mkdir()
    write(files, {name: _new() + text for name, text in solution_files().items()})
    mount = ["mount", "-t", "tmpfs", "-o", f"size={room}k", "tmpfs", str(disk)]
    if subprocess.run(mount, capture_output=True, check=False).returncode != 0:
        pytest.skip("mounting needs root")
    try:
        with monkeypatch.context() as patch, suppress(OSError):
            patch.setattr(tempfile, "tempdir", str(disk))
            assert points(grade_path(files)) == FULL
    finally:
        subprocess.run(["umount", str(disk)], check=True)
    assert points(grade_path(files)) == FULL


@pytest.mark.parametrize("damage", [b"", bytes(5000), b"half"])
@pytest.mark.usual(1)
def test_an_object_that_lost_its_content_is_made_anew(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, damage: bytes
) -> None:
    """As after a loss of power."""
    monkeypatch.setattr(object_cache, "CACHE", tmp_path / "cache")
    monkeypatch.setattr(linking, "CACHE", tmp_path / "cache")
    write(tmp_path / "s", solution_files())
    assert points(grade_path(tmp_path / "s")) == FULL
    kept = [file for file in (tmp_path / "cache").rglob("*") if file.is_file()]
    assert len(kept) == 4
    for file in kept:
        file.write_bytes(damage)
    assert points(grade_path(tmp_path / "s")) == FULL


def test_a_gcc_that_can_start_nothing_is_a_fault_of_the_machine(tmp_path: Path) -> None:
    """Of what clang rejects and g++ accepts, no error of clang's may be told instead."""
    only = b"#ifdef __clang__\n#error\n#endif\n" + solution_files()["part1_contacts.cpp"]
    taken = read(write(tmp_path / "s", {"part1_contacts.cpp": _new() + only}))
    box = Box("none")
    command = [w.replace(str(box.enter), "/nowhere") for w in compiler.gcc("x", taken, box)]
    with pytest.raises(KitError, match="couldn't start its compiler"):
        compiler.require_gcc_ran(compiler.run(command, tmp_path, box, tmp_path / "o"))
    assert compiling.compile_all(taken, tmp_path, box, 1).parts[1].path
