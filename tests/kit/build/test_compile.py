"""Compiling submissions: never a stale object, limits, and whose fault it is if none is made."""

import os
import secrets
import subprocess
import tempfile
from contextlib import suppress
from pathlib import Path

import pytest
from bounce_grader.build import compile as compiling, toolchain
from bounce_grader.build.toolchain import Work
from bounce_grader.common.errors import KitError
from bounce_grader.common.files import temporary_folder
from bounce_grader.common.paths import BUILD, CONTRACT, RUNNER
from bounce_grader.grading.grade import grade as grade_path
from bounce_grader.sandbox import processes
from bounce_grader.sandbox.box import Box, toolchain as toolchain_of_the_box
from bounce_grader.sandbox.processes import run, Result
from bounce_grader.submission.submission import read
from conftest import Grade, Patch, points, solution_files, write

FULL = [30, 30, 30, 10]
HEADERS = ("/usr/include/c++", "/usr/include/linux", "/usr/include/asm-generic", "/usr/lib/gcc")


def _new() -> bytes:
    """A comment that makes the source new to the cache."""
    return f"// {secrets.token_hex(8)}\n".encode()


# --- never a stale object ---


def test_the_header_is_precompiled_anew_after_an_upgrade_of_what_it_reads() -> None:
    """Else clang refuses it, and everything goes the slow way through g++."""
    words = (RUNNER / "graded.pch.d").read_text().split()
    headers = {os.path.realpath(word) for word in words if word.startswith("/usr/")}
    found = subprocess.run(["dpkg", "-S", *headers], capture_output=True, text=True).stdout
    packages = {line.partition(": ")[0] for line in found.splitlines()}
    rules = (BUILD / "build.ninja").read_text().replace("$:", ":")
    assert len(packages) >= 4
    assert [name for name in packages if f"/var/lib/dpkg/info/{name}.list" not in rules] == []


def test_each_header_of_the_system_is_in_the_box() -> None:
    """Some of them are links to elsewhere. A part that includes one would not compile."""
    folders = [*Path("/usr/include").glob("*-linux-gnu"), *map(Path, HEADERS)]
    links = {path for folder in folders for path in folder.rglob("*.h") if path.is_symlink()}
    targets = {path.resolve() for path in links if path.exists()}
    seen = {*map(Path, toolchain_of_the_box())}
    assert [target for target in sorted(targets) if not seen & {*target.parents}] == []


INCLUDES = {
    "plain": b'#include "real.cpp"\n',
    "over two lines": b'#include "re\\\nal.cpp"\n',
    "pasted": b"#define J(a, b) a##b\n#define TEXT_(x) #x\n#define TEXT(x) TEXT_(x)\n"
    b"#include TEXT(J(re, al).cpp)\n",
}


@pytest.mark.parametrize("way", INCLUDES)
def test_a_changed_helper_is_compiled_anew_however_it_is_included(grade: Grade, way: str) -> None:
    part = {"part1_contacts.cpp": b"#define INSIDE\n" + _new() + INCLUDES[way]}
    real = b"#ifndef DONE\n#define DONE\n" + solution_files()["part1_contacts.cpp"] + b"#endif\n"
    assert points(grade({**part, "real.cpp": b"#ifdef INSIDE\n" + real + b"#endif\n"})) == FULL
    assert points(grade({**part, "real.cpp": b"\n"})) == [0, 30, 30, 10]


def test_what_was_compiled_without_a_box_is_not_taken_in_one(tmp_path: Path) -> None:
    seeing = _new() + b'#if !__has_include("/etc/passwd")\n#error boxed\n#endif\n'
    taken = read(write(tmp_path / "s", {"part1_contacts.cpp": seeing}))
    compiled = []
    for kind in ("none", "full"):
        with compiling.compiled(taken, Box(kind)) as work:
            compiled += [bool(work.parts[1].path)]
    assert compiled == [True, False]


def test_a_changed_kit_makes_other_objects(monkeypatch: Patch, tmp_path: Path) -> None:
    for name in ("graded.pch", "solve_lcp.o"):
        (tmp_path / name).write_bytes(b"")
    monkeypatch.setattr(compiling, "RUNNER", tmp_path)
    digest = compiling.toolchain_digest.__wrapped__
    before = digest()
    assert digest() == before
    os.utime(tmp_path / "solve_lcp.o", ns=(1, 1))
    assert digest() != before
    monkeypatch.setattr(os, "access", lambda *_: False)
    with pytest.raises(KitError, match="belongs to .*, who alone can grade with it"):
        digest()


def test_an_object_that_lost_its_content_is_made_anew(tmp_path: Path, monkeypatch: Patch) -> None:
    """As after a loss of power."""
    for module in (compiling, toolchain):
        monkeypatch.setattr(module, "CACHE", tmp_path / "cache")
    write(tmp_path / "s", solution_files())
    assert points(grade_path(tmp_path / "s")) == FULL
    kept = [file for file in (tmp_path / "cache").rglob("*") if file.is_file()]
    assert len(kept) == 4
    for file, damage in zip(kept, (b"", bytes(5000), b"half", kept[3].read_bytes()[:-100])):
        file.write_bytes(damage)
    assert points(grade_path(tmp_path / "s")) == FULL


MORE = [pytest.param(kb, marks=pytest.mark.long) for kb in range(20, 2000, 90)]


@pytest.mark.parametrize("room", [100, *MORE])
def test_a_full_disk_costs_no_points(room: int, tmp_path: Path, monkeypatch: Patch) -> None:
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


# --- limits ---


@pytest.mark.parametrize("size, kept", [(8_000_000, 5), (30_000_000, 0)])
def test_helpers_fill_no_disk(tmp_path: Path, size: int, kept: int) -> None:
    """Neither by what is kept nor by what is refused."""
    zeros = b'asm(".section .data.h,\\"aw\\"\\n.zero %d\\n.text\\n");\n' % size
    files = {f"helper{n}.cpp": _new() + zeros for n in range(8)}
    taken = read(write(tmp_path / "in", {**solution_files(), **files}))
    (tmp_path / "work").mkdir()
    made = compiling.compile_all(Work(taken, tmp_path / "work", Box("none")))
    problems = [built.problem for built in made.helpers if not built.path]
    assert len(problems) == 8 - kept and any("more than" in words for words in problems)
    assert not list((tmp_path / "work").iterdir())
    assert all(built.path for built in made.parts.values())


def test_helpers_have_a_limit_in_common(grade: Grade, monkeypatch: Patch) -> None:
    monkeypatch.setattr(compiling, "HELPERS_SECONDS", 0.02)  # what one of them takes
    monkeypatch.setattr("os.cpu_count", lambda: 1)
    helpers = {f"helper{n}.cpp": _new() + b"int helper%d;\n" % n for n in range(3)}
    missing = b"extern int helper2;\nint use() { return helper2; }\n"
    part = missing + solution_files()["part1_contacts.cpp"]
    record = grade({**helpers, "part1_contacts.cpp": part})
    assert points(record) == [0, 30, 30, 10]
    words = "helper1.cpp wasn't compiled: the compiling of helpers had used its 0.02 s"
    assert words in record["parts"][0]["message"]


# --- whose fault it is ---

ENDED = Result(137, 1.9, b"", "", False, False, cpu_limit=2)
GAVE_UP = "clang: error: clang frontend command failed with exit code 134 (use -v to see it)\n"
ONLY_GCC = b"#ifdef __clang__\n#error not for clang\n#endif\n"
NO_VERDICT = {  # by what ends the command of a compiler
    "a box that isn't made": (".cpp", ENDED._replace(code=1, err="no namespaces\n", boxed=False)),
    "a box that is too slow": (".cpp", ENDED._replace(code=-9, too_long=True, boxed=False)),
    "no memory for a compiler": (".cpp", ENDED._replace(cpu_seconds=0.1, cpu_limit=15)),
    "a g++ that can start nothing": ("/g++", ENDED._replace(code=1)),
}
VERDICTS = {
    "takes more memory to compile": ENDED._replace(cpu_limit=15, peak=toolchain.LARGE),
    "took more than 15 s to compile": ENDED,  # as it was given less, at the end of a grading
    "the compiler gave up on it: it takes more than 2 GB": ENDED._replace(code=134, err=GAVE_UP),
}


@pytest.mark.parametrize("failure", NO_VERDICT)
def test_a_failing_machine_is_no_verdict(monkeypatch: Patch, grade: Grade, failure: str) -> None:
    """Even where clang, which could be asked, finds an error that g++ doesn't."""
    ending, result = NO_VERDICT[failure]

    def fails(command: list[str], *others: object, **more: object) -> Result:
        ends = any(word.endswith(ending) for word in command)
        return result if ends else run(command, *others, **more)  # type: ignore[arg-type]

    part = _new() + ONLY_GCC + solution_files()["part2_lcp.cpp"]
    assert points(grade({"part2_lcp.cpp": part})) == FULL
    monkeypatch.setattr(processes, "run", fails)
    with pytest.raises(KitError, match="box couldn't be made|killed from outside|couldn't start"):
        grade({"part2_lcp.cpp": _new() + part})


@pytest.mark.parametrize("words", VERDICTS)
def test_what_a_submission_makes_of_its_compiler_is_its_own_fault(words: str) -> None:
    toolchain.require_compiler_ran(VERDICTS[words])
    assert words in toolchain.compile_problem(VERDICTS[words], "x.cpp").problem


@pytest.mark.parametrize("kind", ["full", "reduced", "none"])
def test_the_signal_that_ends_a_child_of_gcc_is_known(kind: str, tmp_path: Path) -> None:
    """By the exit status, because a submission can print any text; and its CPU time."""
    text = (
        b"constexpr long f(long n) { long s = 0; while (--n) s += n; return s; }\n"
        b"static_assert(f(1L << 40) == 0);\n"
    )
    endless = ("-fconstexpr-ops-limit=2000000000000", "-fconstexpr-loop-limit=2000000000")
    box, slow = Box(kind), read(write(tmp_path, {"part1_contacts.cpp": text}))
    with temporary_folder() as name:
        work = Path(name)
        slow.write_to(work)
        box.give(work)
        gcc = toolchain.gcc(Work(slow, work, box), "part1_contacts.cpp")
        limits = toolchain.COMPILE._replace(cpu_seconds=1)
        ended = run([*box.to_build(work, [CONTRACT, RUNNER]), *gcc, *endless], limits)
    assert ended.boxed and ended.code == 128 + 9 and ended.cpu_seconds > 0.4, ended
