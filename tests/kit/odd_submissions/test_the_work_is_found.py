"""A student's work is found where it lies, and what can't be used is said with what to do next."""

import io
import warnings
import zipfile
from pathlib import Path

import pytest
from bounce_grader.common.errors import UsageError
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import STUBS
from bounce_grader.submission import submission
from bounce_grader.submission.submission import Submission
from conftest import solution_files, write
from handed_in import packed_tar

SOLVED = solution_files()
STUB_FILES = {file.name: file.read_bytes() for file in STUBS.glob("*.cpp")}
PART_1 = "part1_contacts.cpp"


def at(folder: str, files: dict[str, bytes]) -> dict[str, bytes]:
    return {f"{folder}/{name}": text for name, text in files.items()}


def read(folder: Path, files: dict[str, bytes]) -> Submission:
    return submission.read(write(folder / "handed in", files))


def solved(read: Submission) -> list[int]:
    return [n for n, name in read.parts.items() if read.files[name] == SOLVED[parts()[n - 1].file]]


def test_untouched_stubs_hide_nothing_that_was_filled_in(tmp_path: Path) -> None:
    nearer = at("src", STUB_FILES) | at("my solution/src", SOLVED)
    assert solved(read(tmp_path / "1", nearer)) == [1, 2, 3, 4]
    copy = STUB_FILES | {"part1_contacts (1).cpp": SOLVED[PART_1]}
    assert solved(read(tmp_path / "2", copy)) == [1]
    both = read(tmp_path / "4", SOLVED | {"part1_contacts (1).cpp": SOLVED[PART_1] + b"//"})
    one = "part1_contacts (1).cpp (part1_contacts.cpp is judged: keep the one that counts)"
    assert solved(both) == [1, 2, 3, 4] and both.ignored == (one,)
    assert read(tmp_path / "3", STUB_FILES).parts.keys() == {1, 2, 3, 4}


def test_folders_of_a_student_are_a_students_whatever_their_names(tmp_path: Path) -> None:
    helpers = {"methods/a.hpp": b"//", "study/b.hpp": b"//", "exact/c.cpp": b"//"}
    found = read(tmp_path, at("src", SOLVED) | helpers)
    assert {*helpers} <= found.files.keys()


def test_an_archive_that_was_handed_in_again_is_opened(tmp_path: Path) -> None:
    again = tmp_path / "hw3.tar-1.gz"
    again.write_bytes(packed_tar(SOLVED))
    assert solved(submission.read(again)) == [1, 2, 3, 4]
    inside = write(tmp_path / "folder", {"hw3.tar-1.gz": packed_tar(SOLVED)})
    assert solved(submission.read(inside)) == [1, 2, 3, 4]


def zip_with_twice(path: Path, name: str) -> Path:
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as archive, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for file, text in [*SOLVED.items(), (name, b"1"), (name, b"2")]:
            archive.writestr(file, text)
    path.write_bytes(data.getvalue())
    return path


def test_two_entries_of_one_name_matter_only_for_a_source(tmp_path: Path) -> None:
    assert solved(submission.read(zip_with_twice(tmp_path / "a.zip", ".DS_Store"))) == [1, 2, 3, 4]
    with pytest.raises(UsageError, match="holds helper.hpp twice: make it anew"):
        submission.read(zip_with_twice(tmp_path / "b.zip", "helper.hpp"))


@pytest.mark.parametrize("name", ["all.cpp", "part1_contacts.hpp", "part1_contacts.cpp.txt"])
def test_what_may_hold_a_missing_part_is_said(name: str, tmp_path: Path) -> None:
    rest = {file: text for file, text in SOLVED.items() if file != PART_1}
    found = read(tmp_path, rest | {name: SOLVED[PART_1]})
    told = f"; {name} may hold it: hand that in as {PART_1}, a part in a file"
    assert found.instead_of(parts()[0]) == told
    assert found.instead_of(parts()[0]._replace(function="nothing", stem="none")) == ""
