"""One student's files cost nobody else anything, whatever is in them: the class is graded, and who
handed them in needs a look."""

import zipfile
from pathlib import Path
from typing import Any

import pytest
import stand_in
from bounce_grader import cli
from bounce_grader.classroom import outputs, similar
from bounce_grader.classroom.students import Student
from classes import column, download, grade_class, points_of
from odd_students import LIES, PART, zip_that_claims


def graded_beside(tmp_path: Path, uploads: dict[str, bytes]) -> str:
    """The class's page, where an honest student got the points that they get alone."""
    out = tmp_path / "out"
    assert grade_class(download(tmp_path / "x.zip", [101], uploads), out) == 0
    assert column(out / "gradebook.csv")["101"] == points_of(101, tmp_path)
    return (out / "class.html").read_text()


def looks(page: str) -> str:
    return page.split("Needs a look")[1].split("Near-copies")[0]


@pytest.mark.parametrize("size", LIES)
@pytest.mark.parametrize("name", [PART, b"notes.txt"])
def test_a_zip_that_lies_about_a_size_costs_nobody_else(
    tmp_path: Path, size: int, name: bytes
) -> None:
    zipped = zip_that_claims(size, name)
    odd = {"roe_301_1_hw.zip": zipped, "roe_301_2_part1_contacts.cpp": b"// 1"}
    graded_beside(tmp_path, {**odd, "poe_302_3_hw.zip": zipped})


@pytest.mark.parametrize("error", [OverflowError("x"), MemoryError(), RecursionError("deep")])
def test_what_nobody_foresaw_in_reading_is_one_students(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, error: Exception
) -> None:
    whole = zipfile.ZipFile.infolist

    def odd(archive: zipfile.ZipFile) -> list[zipfile.ZipInfo]:
        infos = whole(archive)
        if [info.filename for info in infos] == ["odd.cpp"]:
            raise error
        return infos

    monkeypatch.setattr(zipfile.ZipFile, "infolist", odd)
    (tmp_path / "odd.zip").write_bytes(zip_that_claims(1, b"odd.cpp"))
    assert cli.main(["grade", str(tmp_path / "odd.zip")]) == 2


def test_a_submission_that_cannot_be_compared_needs_a_look(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = similar.own_text

    def odd(task: Any) -> str:
        if any(upload.user == "301" for upload in task.uploads):
            raise OverflowError("too large")
        return whole(task)

    monkeypatch.setattr(similar, "own_text", odd)
    page = graded_beside(tmp_path, {"roe_301_1_part2_lcp.cpp": b"// odd"})
    assert "roe (301)" in looks(page) and "can&#x27;t be compared" in looks(page)


def test_a_page_that_cannot_be_written_costs_nobody_elses(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = outputs._page

    def odd(student: Student, *more: Any) -> str:
        if student.id == "301":
            raise UnicodeError("surrogates")
        return whole(student, *more)

    monkeypatch.setattr(outputs, "_page", odd)
    page = graded_beside(tmp_path, {"roe_301_1_part2_lcp.cpp": b"// odd"})
    assert "roe (301)" in looks(page) and "no feedback page" in looks(page)
    pages = {file.name for file in (tmp_path / "out" / "feedback").iterdir()}
    assert pages == {"doejane_101_1010_feedback.html"}


def test_a_full_disk_is_no_students_fault(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*_: Any) -> str:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(outputs, "_page", full)
    source = download(tmp_path / "x.zip", [101])
    assert cli.main(["class", str(source), "--out", str(tmp_path / "out")]) == 3
