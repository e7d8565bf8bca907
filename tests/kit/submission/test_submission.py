"""Which files of a submission are used: parts and helpers by their names, if they are text."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from bounce_grader.submission import submission
from conftest import ROOT, solution_files, write
from handed_in import PARTS, refusal, zip_of


def test_takes_the_four_parts_of_a_folder(tmp_path: Path) -> None:
    taken = submission.read(write(tmp_path, solution_files()))
    assert set(taken.files) == PARTS and set(taken.parts) == {1, 2, 3, 4}


def test_a_zip_gives_the_same_as_its_folder(tmp_path: Path) -> None:
    folder = submission.read(write(tmp_path / "folder", solution_files()))
    for inside in ("", "my homework/", "a/b/"):
        files = {inside + name: text for name, text in solution_files().items()}
        zipped = submission.read(zip_of(tmp_path / "x.zip", files))
        assert zipped.parts.keys() == folder.parts.keys()
        assert sorted(zipped.files.values()) == sorted(folder.files.values())


def test_the_name_of_a_submission_is_its_content(tmp_path: Path) -> None:
    first = submission.read(write(tmp_path / "a", solution_files()))
    again = submission.read(write(tmp_path / "b", solution_files()))
    other = submission.read(write(tmp_path / "c", {**solution_files(), "part2_lcp.cpp": b"\n"}))
    assert first.sha256 == again.sha256 != other.sha256


HELPERS = {"helpers/rotation.cpp", "helpers/rotation.hpp", "methods/rotation.hpp"}


def test_helpers_are_taken_and_what_the_kit_gives_is_not(tmp_path: Path) -> None:
    extra = {
        "src/helpers/rotation.cpp": b"int one();",
        "src/helpers/rotation.hpp": b"#pragma once",
        "src/methods/rotation.hpp": b"#pragma once",
        "include/bounce/types.hpp": b"#error not the kit's",
        "given/solve_lcp.cpp": b"#error not the kit's",
        "given/check/run.cpp": b"#error not the kit's",
        "given/study/tables.hpp": b"#error not the kit's",
        "main.cpp": b"int main() {}",
        "CMakeLists.txt": b"message(FATAL_ERROR)",
        "src/part1_contacts.o": b"\x7fELF",
        "libstudent.a": b"!<arch>",
        "evil.so": b"\x7fELF",
        "bounce/types.hpp.gch": b"gpch",
        "build/CMakeFiles/part1_contacts.cpp": b"#error a stale copy",
        "__MACOSX/._part1_contacts.cpp": b"\0\5\x16\7",
    }
    files = {f"src/{name}": text for name, text in solution_files().items()}
    taken = submission.read(write(tmp_path, {**files, **extra}))
    helpers = {f"src/{name}" for name in HELPERS}
    assert set(taken.files) == {f"src/{name}" for name in PARTS} | helpers
    assert taken.helpers == ["src/helpers/rotation.cpp"]
    assert set(taken.ignored) == set(extra) - helpers


def test_own_tests_are_left_out_under_any_name(tmp_path: Path) -> None:
    tests = (
        b"#include <bounce/part1_contacts.hpp>\n#include <gtest/gtest.h>\n"
        b"TEST(Own, IsRight) { EXPECT_NEAR(1, 1, 1e-9); }\n"
    )
    helper = (
        b"// TEST(Own, IsRight) is in checks.cpp, with <gtest/gtest.h>\nint one() { return 1; }\n"
    )
    more = {"checks.cpp": tests, "helper.cpp": helper}
    taken = submission.read(write(tmp_path / "x", {**solution_files(), **more}))
    assert "helper.cpp" in taken.files and "checks.cpp" not in taken.files
    assert [name for name in taken.ignored if "checks.cpp" in name] == [
        "checks.cpp (holds GoogleTest tests, which aren't run here)"
    ]
    part = {"part1_contacts.cpp": tests}  # a part is never left out
    assert 1 in submission.read(write(tmp_path / "y", {**solution_files(), **part})).parts


def test_the_part_nearest_to_the_top_counts(tmp_path: Path) -> None:
    old = {"old/part1_contacts.cpp": b"// last week's"}
    taken = submission.read(write(tmp_path, {**solution_files(), **old}))
    assert taken.parts[1] == "part1_contacts.cpp"
    assert "old/part1_contacts.cpp" in taken.ignored


def test_two_candidates_for_a_part_are_refused_by_name(tmp_path: Path) -> None:
    files = {"a/part1_contacts.cpp": b"", "b/part1_contacts.cpp": b""}
    sentence = refusal(write(tmp_path, files))
    assert "a/part1_contacts.cpp, b/part1_contacts.cpp" in sentence and "keep one" in sentence


@pytest.mark.parametrize("copy", ["part1_contacts (1).cpp", "part1_contacts-1.cpp"])
def test_a_part_under_the_name_of_a_copy_is_taken_where_it_is_the_only_one(
    tmp_path: Path, copy: str
) -> None:
    taken = submission.read(write(tmp_path / "one", {f"a/{copy}": b"// x"}))
    assert taken.parts == {1: copy} and not taken.ignored
    both = write(tmp_path / "both", {copy: b"no C++", "part1_contacts.cpp": b"// x"})
    taken = submission.read(both)
    assert taken.parts == {1: "part1_contacts.cpp"} and taken.ignored == (copy,)
    assert not taken.helpers


def test_two_copies_without_the_part_itself_are_refused(tmp_path: Path) -> None:
    copies = {f"part2_lcp-{number}.cpp": b"// x" for number in (1, 2)}
    assert "part2_lcp.cpp is there 2 times" in refusal(write(tmp_path, copies))


def test_a_part_named_in_capitals_is_taken(tmp_path: Path) -> None:
    taken = submission.read(write(tmp_path, {"PART1_CONTACTS.CPP": b"int x;", "H.CPP": b""}))
    assert taken.parts == {1: "PART1_CONTACTS.CPP"} and taken.helpers == ["H.CPP"]


def test_a_missing_path_is_said(tmp_path: Path) -> None:
    assert "there is no file or folder" in refusal(tmp_path / "nowhere")


def test_a_file_that_is_neither_is_said(tmp_path: Path) -> None:
    path = tmp_path / "part1_contacts.cpp"
    path.write_text("int x;")
    assert "neither a folder nor a zip" in refusal(path)


def test_a_huge_part_is_refused_and_the_others_stay(tmp_path: Path) -> None:
    folder = write(tmp_path, solution_files())
    with (folder / "part2_lcp.cpp").open("wb") as stream:
        stream.truncate(1_000_000_000)
    taken = submission.read(folder)
    assert set(taken.parts) == {1, 3, 4}
    assert taken.refused[2] == "part2_lcp.cpp is 1.0 GB large; a source file may have 1 MB"


def test_utf16_is_read_and_binary_is_refused(tmp_path: Path) -> None:
    text = "// Höhe\nint x;\n"
    files = {"part1_contacts.cpp": text.encode("utf-16"), "part2_lcp.cpp": b"int\0x;"}
    taken = submission.read(write(tmp_path, files))
    assert taken.files["part1_contacts.cpp"].decode() == text
    assert "isn't a text file" in taken.refused[2]


@pytest.mark.parametrize(
    "name",
    ["-o.cpp", "@options.cpp", "a\nb.hpp", "\x1b[2J.cpp", "a\u202eppc.hpp", f"{'a' * 300}.cpp"]
    + ["/".join(["a"] * 200) + ".cpp"],
)
def test_a_name_that_could_mislead_a_compiler_or_a_reader_is_not_used(
    tmp_path: Path, name: str
) -> None:
    files = {**solution_files(), name: b"int x;"}
    taken = submission.read(zip_of(tmp_path / "x.zip", files))
    assert set(taken.files) == PARTS and taken.ignored == (name,)


def test_an_odd_blank_in_a_name_is_used_but_not_shown(tmp_path: Path) -> None:
    files = {"a\u00a0b/part1_contacts.cpp": b"", "a\u3000b/part1_contacts.cpp": b""}
    assert refusal(zip_of(tmp_path / "x.zip", files)).isprintable()
    del files["a\u3000b/part1_contacts.cpp"]
    taken = submission.read(zip_of(tmp_path / "x.zip", {**files, "README": b""}))
    assert taken.parts == {1: "a\u00a0b/part1_contacts.cpp"}


def test_a_name_that_is_no_utf8_is_not_used(tmp_path: Path) -> None:
    write(tmp_path, solution_files())
    (tmp_path / os.fsdecode(b"L\xf6sung.hpp")).write_bytes(b"")
    taken = submission.read(tmp_path)
    assert set(taken.files) == PARTS and len(taken.sha256) == 64
    assert taken.ignored == ("L\udcf6sung.hpp",)
    used = taken._replace(files={**taken.files, taken.ignored[0]: b""})
    assert len({taken.sha256, used.sha256, used._replace(files={}).sha256}) == 3


def test_a_long_name_in_an_error_is_cut_and_moves_no_cursor(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "bounce_grader", "grade", f"{tmp_path}/\x1b[2J\n::error::x\udcff"],
        env={**os.environ, "PYTHONPATH": str(ROOT / "grader")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2 and done.stdout == ""
    assert done.stderr.startswith("kit: there is no file or folder")
    assert "\x1b" not in done.stderr and "\n::" not in done.stderr


def test_a_helper_that_is_too_large_is_left_out_with_the_reason(tmp_path: Path) -> None:
    files = {**solution_files(), "table.hpp": b" " * (2 << 20), "notes.txt": b""}
    taken = submission.read(zip_of(tmp_path / "x.zip", files))
    reason = "table.hpp (is 2.1 MB large; a source file may have 1 MB)"
    assert taken.ignored == ("notes.txt", reason)
