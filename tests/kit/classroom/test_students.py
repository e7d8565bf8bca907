"""Finding each student's submission, and what happens to everything else in the download."""

import io
import re
import zipfile
from pathlib import Path

import pytest
from bounce_grader.classroom.intake import canvas, students
from bounce_grader.classroom.intake.canvas import Upload
from bounce_grader.classroom.work import task
from bounce_grader.classroom.work.task import Stamp
from bounce_grader.common.errors import UsageError
from bounce_grader.submission import submission
from conftest import solution_files, write
from downloads import STAMP, download, to_grade, inner_zip


@pytest.mark.parametrize(
    "file",
    [
        "part2_lcp.cpp",
        "part2_lcp-1.cpp",
        "part2_lcp-12.cpp",
        "Part2_LCP (1).cpp",
        "part2_lcp(2).CPP",
    ],
)
def test_a_part_is_known_however_often_it_was_handed_in(file: str) -> None:
    assert submission.part_file(file) == "part2_lcp.cpp"


@pytest.mark.parametrize(
    "file", ["part2.cpp", "part2_lcp-b.cpp", "my_part2_lcp.cpp", "part2_lcp.h"]
)
def test_a_file_of_another_name_is_no_part(file: str) -> None:
    assert submission.part_file(file) is None


def test_the_newest_upload_of_a_file_counts(tmp_path: Path) -> None:
    path = download(
        tmp_path / "x.zip",
        {
            "doe_1_30_part1_contacts-1.cpp": b"// the second",
            "doe_1_9_part1_contacts.cpp": b"// the first",
            "doe_1_31_part2_lcp.cpp": b"// two",
        },
    )
    (student,) = students.read(path).students
    assert student.unused == ("part1_contacts.cpp is older than part1_contacts-1.cpp",)
    assert to_grade(student).files == {
        "part1_contacts.cpp": b"// the second",
        "part2_lcp.cpp": b"// two",
    }


def test_a_helper_has_the_name_that_it_is_included_by(tmp_path: Path) -> None:
    """Canvas renames rotation.hpp to rotation-1.hpp where an older assignment had one; but a
    student may have named a file solver-2.hpp."""
    path = download(
        tmp_path / "x.zip",
        {
            "doe_1_1_part1_contacts.cpp": b'#include "rotation.hpp"\n#include "solver-2.hpp"',
            "doe_1_2_rotation-1.hpp": b"// turns",
            "doe_1_3_solver-2.hpp": b"// solves",
        },
    )
    (student,) = students.read(path).students
    names = set(to_grade(student).files)
    assert names == {"part1_contacts.cpp", "rotation.hpp", "solver-2.hpp"}


@pytest.mark.parametrize("renamed", ["solve.lcp-1.hpp", "solve-1.lcp.hpp", "solve.lcp.hpp"])
def test_a_helper_of_several_dots_has_the_name_that_it_is_included_by(
    tmp_path: Path, renamed: str
) -> None:
    """Canvas's number stands before the last dot or, in later versions, before the first."""
    path = download(
        tmp_path / "x.zip",
        {
            "doe_1_1_part1_contacts.cpp": b'#include "solve.lcp.hpp"',
            f"doe_1_2_{renamed}": b"// solves",
        },
    )
    (student,) = students.read(path).students
    assert set(to_grade(student).files) == {"part1_contacts.cpp", "solve.lcp.hpp"}


def test_of_a_zip_that_is_handed_in_again_the_newest_counts(tmp_path: Path) -> None:
    """Nothing of the older one is used: neither its parts nor its helpers."""
    first = {"part1_contacts.cpp": b"// first", "arm.cpp": b"// stale"}
    path = download(
        tmp_path / "x.zip",
        {
            "doe_1_1_homework.zip": inner_zip(tmp_path, first),
            "doe_1_2_homework-1.zip": inner_zip(tmp_path, {"part1_contacts.cpp": b"// second"}),
        },
    )
    (student,) = students.read(path).students
    assert student.unused == ("homework.zip is older than homework-1.zip",)
    assert to_grade(student).files == {"part1_contacts.cpp": b"// second"}


def test_what_a_zip_beside_files_holds_in_vain_is_listed(tmp_path: Path) -> None:
    zipped = inner_zip(tmp_path, {"part1.rar": b"Rar!", "part2_lcp.cpp": b"// two"})
    path = download(
        tmp_path / "x.zip", {"doe_1_1_hw.zip": zipped, "doe_1_2_part1_contacts.cpp": b"// one"}
    )
    (student,) = students.read(path).students
    taken = to_grade(student)
    assert taken.ignored == ("part1.rar",) and taken.parts.keys() == {1, 2}


def test_a_zip_and_a_newer_file_are_one_submission(tmp_path: Path) -> None:
    zipped = inner_zip(
        tmp_path, {"hw/part1_contacts.cpp": b"// zipped", "hw/part2_lcp.cpp": b"// two"}
    )
    path = download(
        tmp_path / "x.zip",
        {"doe_1_1_hw.zip": zipped, "doe_1_2_part1_contacts.cpp": b"// later"},
    )
    (student,) = students.read(path).students
    files = to_grade(student).files
    assert sorted(files.values()) == [b"// later", b"// two"]


def test_a_single_zip_is_graded_as_it_is(tmp_path: Path) -> None:
    path = download(tmp_path / "x.zip", {"doe_1_1_hw.zip": inner_zip(tmp_path, solution_files())})
    (student,) = students.read(path).students
    assert to_grade(student).files == solution_files()


def test_two_users_of_one_name_are_two(tmp_path: Path) -> None:
    entries = {f"doejane_{user}_{user}9_part2_lcp.cpp": b"// x" for user in (1, 2)}
    found = students.read(download(tmp_path / "x.zip", entries))
    assert [s.id for s in found.students] == ["1", "2"]
    assert len({s.feedback for s in found.students}) == 2


class Unflagged(zipfile.ZipInfo):
    """An entry whose name is UTF-8 without saying so, as Canvas and macOS write it."""

    def _encodeFilenameFlags(self) -> tuple[bytes, int]:
        return self.filename.encode(), self.flag_bits & ~0x800


def test_names_that_canvas_writes_in_utf_8_without_saying_so(tmp_path: Path) -> None:
    within = io.BytesIO()
    with zipfile.ZipFile(within, "w") as archive:
        archive.writestr(Unflagged("größe.hpp"), "// x")
        archive.writestr(Unflagged("part2_lcp.cpp"), "// x")
    with zipfile.ZipFile(tmp_path / "x.zip", "w") as archive:
        archive.writestr(Unflagged("weißjürgen_1_2_hw.zip"), within.getvalue())
        archive.writestr(Unflagged("李小明_3_4_part1_contacts.cpp"), "// y")
    found = students.read(tmp_path / "x.zip").students
    assert [(s.name, s.feedback) for s in found] == [
        ("weißjürgen", "weißjürgen_1_2_feedback.html"),
        ("李小明", "李小明_3_4_feedback.html"),
    ]
    assert set(to_grade(found[0]).files) == {"größe.hpp", "part2_lcp.cpp"}
    assert to_grade(found[1]).files == {"part1_contacts.cpp": b"// y"}


def test_nothing_is_dropped_in_silence(tmp_path: Path) -> None:
    entries = {
        "doe_1_1_part2_lcp.cpp": b"// x",
        "roe_2_text.html": b"<p>here you are</p>",
        "poe_3_link.html": b"",
        "foe_4_5_homework.rar": b"Rar!",
        "foe_4_6_photo.jpg": b"",
        "__MACOSX/._doe_1_1_part2_lcp.cpp": b"",
        "folder/moe_9_9_part1_contacts.cpp": b"",
        "readme.txt": b"",
        '=HYPERLINK("http://x")': b"",
    }
    found = students.read(download(tmp_path / "x.zip", entries))
    assert [s.id for s in found.students] == ["1"]
    reasons = {unmatched.name: unmatched.reason for unmatched in found.unmatched}
    assert len(reasons) == 7
    assert "typed into Canvas" in reasons["roe_2_text.html"]
    assert "address" in reasons["poe_3_link.html"]
    assert (
        "homework.rar is a RAR archive, which isn't opened: the parts are needed"
        in reasons["foe_4_6"]
    )
    assert "photo.jpg is no C++ source and no zip" in reasons["foe_4_6"]
    assert "isn't named as Canvas names" in reasons["readme.txt"]
    assert "in a folder" in reasons["folder/moe_9_9_part1_contacts.cpp"]


def test_a_page_goes_back_under_the_ids_of_the_newest_upload(tmp_path: Path) -> None:
    entries = {
        "doejane_LATE_12_345_part1_contacts.cpp": b"// 1",
        "doejane_LATE_12_350_part2_lcp.cpp": b"// 2",
    }
    (student,) = students.read(download(tmp_path / "x.zip", entries)).students
    assert student.late
    assert student.feedback == "doejane_LATE_12_350_feedback.html"
    back = canvas.parse(student.feedback)
    assert isinstance(back, Upload) and (back.user, back.attachment) == ("12", 350)


def test_a_name_too_long_for_a_file_is_cut_and_its_ids_stay(tmp_path: Path) -> None:
    entry = f"{'李' * 200}_LATE_12_345_part2_lcp.cpp"
    (student,) = students.read(download(tmp_path / "x.zip", {entry: b"// x"})).students
    assert re.search(r"李-[0-9a-f]{8}_LATE_12_345_feedback\.html$", student.feedback)
    assert len(student.feedback.encode()) < 240
    folder = write(tmp_path / "all" / ("n" * 255), {"part2_lcp.cpp": b"// x"}).parent
    (student,) = students.read(folder).students
    assert len(student.feedback) < 240


@pytest.mark.parametrize("bytes_kept", [0, 1000])
def test_a_download_that_was_cut_short_is_said(tmp_path: Path, bytes_kept: int) -> None:
    path = download(tmp_path / "x.zip", {"doe_1_1_part2_lcp.cpp": b"// x" * 1000})
    path.write_bytes(path.read_bytes()[:bytes_kept])
    with pytest.raises(UsageError, match="cut short: download it again"):
        students.read(path)


@pytest.mark.parametrize("file", ["part2_lcp.cpp", "hw.zip"])
def test_a_download_that_is_damaged_inside_is_no_students_fault(tmp_path: Path, file: str) -> None:
    path = download(tmp_path / "x.zip", {f"doe_1_1_{file}": b"// to be damaged"})
    path.write_bytes(path.read_bytes().replace(b"to be", b"been "))
    with pytest.raises(UsageError, match="x.zip is damaged .*: download it again"):
        found = students.read(path)
        task.task_of(found.students[0], STAMP, tmp_path, speed=False, trust=False)


@pytest.mark.parametrize(
    "make, sentence",
    [
        (lambda path: path / "nowhere", "there is no file or folder"),
        (lambda path: write(path, {"x.zip": b"PK\x03\x04 and nothing"}) / "x.zip", "cut short"),
        (lambda path: download(path / "x.zip", {"part1.cpp": b""}), "no submission is found"),
        (lambda path: write(path / "empty", {}), "there is no file or folder"),
    ],
)
def test_what_is_no_class_is_said(tmp_path: Path, make: object, sentence: str) -> None:
    assert callable(make)
    with pytest.raises(UsageError, match=sentence) as refused:
        students.read(make(tmp_path))
    assert "\n" not in str(refused.value)


def test_a_result_is_named_by_all_that_it_follows_from(tmp_path: Path) -> None:
    def key(text: bytes, stamp: Stamp = STAMP) -> str:
        folder = write(tmp_path / "all" / "anna", {"part2_lcp.cpp": text}).parent
        (student,) = students.read(folder).students
        return task.task_of(student, stamp, tmp_path, speed=False, trust=False).key

    first = key(b"// x")
    others = [
        key(b"// y"),
        key(b"// x", Stamp("kit 2", "fixtures", "options")),
        key(b"// x", Stamp("kit", "fixtures 2", "options")),
        key(b"// x", Stamp("kit", "fixtures", "options 2")),
    ]
    assert key(b"// x") == first
    assert len({first, *others}) == 5


def test_a_task_can_be_sent_as_json(tmp_path: Path) -> None:
    path = download(tmp_path / "x.zip", {"doe_1_1_part2_lcp.cpp": b"// x"})
    (student,) = students.read(path).students
    made = task.task_of(student, STAMP, tmp_path, speed=True, trust=False)
    import json

    assert task.from_json(json.loads(json.dumps(made.as_json()))) == made


def test_a_file_too_large_keeps_its_size(tmp_path: Path) -> None:
    huge = b" " * (3 << 20)
    path = download(tmp_path / "x.zip", {"doe_1_1_part2_lcp.cpp": huge})
    (student,) = students.read(path).students
    assert (
        to_grade(student).refused[2] == "part2_lcp.cpp is 3.1 MB large; a source file may have 1 MB"
    )


def test_a_student_called_src_stops_no_class(tmp_path: Path) -> None:
    for name in ("jane", "src"):
        write(tmp_path / name, solution_files())
    assert [student.id for student in students.read(tmp_path).students] == ["jane", "src"]
