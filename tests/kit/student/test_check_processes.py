"""What ./check does besides printing: it prepares a build, watches, waits for another one, and says
what it lacks."""

import os
import re
import subprocess
from pathlib import Path

import pytest
from conftest import ROOT
from handed_out import SUBMISSIONS, SYSTEM, check, put, run, unzipped

of_home = pytest.mark.xdist_group("student")
PIPE = subprocess.PIPE
CLOCKWISE = "mistakes/part1_turned_clockwise"


# ---- the gallery ----


# Of accepted ones, those that replace part 3 or 4, bring parts alone, and have no main().
ACCEPTED = {
    f"accepted/{folder.name}": {
        file.name[:5] for file in folder.iterdir() if file.suffix != ".json"
    }
    for folder in sorted((SUBMISSIONS / "accepted").iterdir())
    if "main_" not in folder.name
}
PARTS = {"part1", "part2", "part3", "part4"}
RIGHT = [name for name, made in ACCEPTED.items() if made <= PARTS and made & {"part3", "part4"}]
POINTS = [30, 30, 30, 10]


def points(printed: str) -> list[int]:
    return [int(got) for got in re.findall(r"^Part \d  .*?(\d+) / \d+$", printed, re.M)]


@of_home
@pytest.mark.long
@pytest.mark.parametrize("right", RIGHT)
def test_a_right_part_loses_nothing_beside_stubs(home: Path, right: str) -> None:
    put(home, right, "stub 1", "stub 2")
    beside = [8, 10] if right == "accepted/relative_to_the_start" else [30, 10]
    assert points(check(home).stdout)[2:] == beside


# ---- building ----


@of_home
def test_only_a_part_that_changed_is_compiled(home: Path) -> None:
    put(home)
    check(home, "2")
    built = {file: file.stat().st_mtime_ns for file in home.rglob("*.o")}
    part2 = home / "src/part2_lcp.cpp"
    part2.write_text(part2.read_text() + "// one line more\n")
    assert points(check(home, "2").stdout) == [30]
    anew = [file.parent.parent.name for file in built if file.stat().st_mtime_ns != built[file]]
    assert anew == ["part2_lcp.dir"]


@of_home
def test_an_older_file_that_comes_back_is_built(home: Path) -> None:
    """As from a backup or a zip, with the time that it had."""
    put(home)
    part1 = home / "src/part1_contacts.cpp"
    right = part1.read_bytes()
    for time, text, score in [(1, b"", 0), (2, right, 30)]:
        part1.write_bytes(text)
        os.utime(part1, (time, time))
        assert points(check(home, "1").stdout) == [score]


@of_home
def test_checks_at_the_same_time_give_one_score(home: Path) -> None:
    put(home, CLOCKWISE)
    command = ["./check"]
    several = [
        subprocess.Popen(command, cwd=home, env=SYSTEM, stdout=PIPE, stderr=PIPE, text=True)
        for _ in range(3)
    ]
    printed = [process.communicate() for process in several]
    assert len({out for out, _ in printed}) == 1 and points(printed[0][0])[1:] == POINTS[1:]
    assert sum("this one waits for it" in err for _, err in printed) == 2, printed


# ---- watching ----


@of_home
def test_watches_until_it_is_stopped_and_goes_on_to_the_next_part(home: Path) -> None:
    put(home, "stub 2")
    command = ["./check", "1", "--watch"]
    watch = subprocess.Popen(command, cwd=home, env=SYSTEM, stdout=PIPE, text=True)

    def until_it_waits() -> str:
        lines: list[str] = []
        while not (lines and "Waiting" in lines[-1]):
            lines.append(watch.stdout.readline())  # type: ignore[union-attr]
            assert lines[-1], "".join(lines)
        return "".join(lines)

    try:
        first = until_it_waits()
        assert points(first) == [30, 0] and "Now part 2:" in first and "Part 3" not in first
        put(home, CLOCKWISE)
        right = until_it_waits()
        assert "Now part 4:" in right and "First: " in right.partition("Now all parts")[2]
    finally:
        watch.terminate()
        watch.communicate()


# ---- what is missing ----


@pytest.mark.long
@pytest.mark.parametrize(
    "name", ["-HW #3 [2] 100% $HOME it's ~a & b (c), {d}=e@f@+^:!`x` Ü  ", "  a_windows"]
)
def test_a_folder_may_have_any_name(tmp_path: Path, name: str) -> None:
    folder = unzipped(tmp_path).rename(tmp_path / name)
    put(folder)
    done = check(folder, "1")
    assert points(done.stdout) == [30], done.stderr
    put(folder, edits={"part1_contacts": [["{", "{ int x = ;"]]})
    assert re.search(r"src/part1_contacts.cpp:\d+: ", check(folder, "1").stdout)


@pytest.mark.parametrize(
    "name", ["a;b", '"a"', "a\\b", "a|b", "<a>", "a*", "a?", "$(HOME)", "${HOME}", "a\nb"]
)
def test_a_name_that_cmake_cannot_hold_is_refused(tmp_path: Path, name: str) -> None:
    folder = tmp_path / name
    folder.mkdir()
    (folder / "check").write_bytes((ROOT / "student/check").read_bytes())
    done = run(folder, "sh", "./check")
    assert done.returncode == 3 and not (folder / "build").exists()
    assert re.fullmatch("check: CMake cannot build in a folder whose path has .*\n", done.stderr)


def test_what_cmake_says_is_shown_where_the_build_cannot_be_prepared(tmp_path: Path) -> None:
    fresh = unzipped(tmp_path)
    (fresh / "CMakeLists.txt").write_text("message(FATAL_ERROR reached)\n")
    done = check(fresh)
    assert done.returncode == 3 and "building for the first time" in done.stderr
    assert "reached" in done.stderr and "CMake could not prepare the build" in done.stderr
