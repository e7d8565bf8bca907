"""Whatever one student's files contain, nobody else loses anything: the class is graded, and that
student is listed as needing a look."""

import csv
import io
import json
import re
import subprocess
import time
import zipfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
import stand_in
from bounce_grader import cli
from bounce_grader.classroom.output import outputs
from bounce_grader.classroom.work import engine_local, near_copies
from bounce_grader.classroom.work.summary import Summary
from bounce_grader.classroom.work.task import Task
from bounce_grader.classroom.work.unit import Outcome
from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.submission import submission
from bounce_grader.submission.submission import Submission

from classes import column, download, grade_class, points_of
from conftest import write
from odd_students import FOLDERS, LIES, PART, UPLOADS, ZIPS, zip_that_claims


def graded_beside(tmp_path: Path, uploads: dict[str, bytes]) -> str:
    """Grades an honest student beside this one, checks the honest one's points, and returns the
    class's page."""
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
    whole = near_copies.own_texts

    def odd(path: Path, uploads: Any) -> dict[int, str]:
        if any(upload.user == "301" for upload in uploads):
            raise OverflowError("too large")
        return whole(path, uploads)

    monkeypatch.setattr(near_copies, "own_texts", odd)
    page = graded_beside(tmp_path, {"roe_301_1_part2_lcp.cpp": b"// odd"})
    assert "roe (301)" in looks(page) and "can&#x27;t be compared" in looks(page)


def test_a_page_that_cannot_be_written_costs_nobody_elses(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = outputs._page

    def odd(summary: Summary, *more: Any) -> str:
        if summary.student.id == "301":
            raise UnicodeError("surrogates")
        return whole(summary, *more)

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


# --- classes with one oddity each ---


@pytest.fixture
def here(monkeypatch: pytest.MonkeyPatch) -> None:
    """Grades in this process, which is quicker; these tests are about the code around it."""

    def run(tasks: list[Task], jobs: int, unit: Any) -> Iterator[tuple[Task, Outcome]]:
        yield from ((task, unit(task)) for task in tasks)

    monkeypatch.setattr(engine_local, "run", run)


@pytest.mark.usefixtures("here")
@pytest.mark.parametrize("error", [KitError("x: No space left on device"), OSError(28, "full")])
def test_what_is_full_is_told_by_no_text(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, error: Exception
) -> None:
    """A failure of the kit on one submission may quote its texts; a full disk ends the run."""
    whole = stand_in.grade

    def grade(taken: Submission, task: Task, seconds: float) -> dict[str, Any]:
        if b"// odd" in taken.files.values():
            raise error
        return whole(taken, task, seconds)

    monkeypatch.setattr(stand_in, "grade", grade)
    source = download(tmp_path / "x.zip", [101, 102], {"roe_001_1_part2_lcp.cpp": b"// odd"})
    if error.args[0] == 28:
        with pytest.raises(KitError, match="is full"):
            grade_class(source, tmp_path / "out")
    else:
        assert grade_class(source, tmp_path / "out") == 3
        assert row(tmp_path / "out", "101")["score"]


def row(out: Path, id: str) -> dict[str, str]:
    rows = csv.DictReader(io.StringIO((out / "grades.csv").read_text("utf-8-sig")))
    return next(row for row in rows if row["id"] == id)


def check_class(source: Path, alone: Path, honest: str, odd: str, tmp_path: Path) -> None:
    """The honest one's results are the same as alone; the other is named."""
    start = time.process_time()
    assert grade_class(source, tmp_path / "out") == 0
    assert time.process_time() - start < 10
    assert grade_class(alone, tmp_path / "alone") == 0
    assert row(tmp_path / "out", honest) == row(tmp_path / "alone", honest)
    page = (tmp_path / "out" / "class.html").read_text()
    named = re.sub(r'<td class="who">(?:<a [^>]*>)?|<td>&#x27;', "<td>", page)
    assert f"<td>{odd}" in named and len(page) < 100_000
    for line in (tmp_path / "out" / "log.jsonl").read_bytes().splitlines():
        json.loads(line)


@pytest.mark.parametrize("uploads", UPLOADS.values(), ids=UPLOADS)
@pytest.mark.usual(11)
def test_no_upload_costs_anybody_else(
    tmp_path: Path, here: None, uploads: dict[str, bytes]
) -> None:
    source = download(tmp_path / "x.zip", [101], uploads)
    check_class(source, download(tmp_path / "alone.zip", [101]), "101", "roe", tmp_path)


def test_an_upload_that_is_there_twice_costs_nobody_else(tmp_path: Path, here: None) -> None:
    source = download(tmp_path / "x.zip", [101], {"roe_301_1_part2_lcp.cpp": b"// one"})
    with zipfile.ZipFile(source, "a") as archive, pytest.warns(UserWarning, match="Duplicate"):
        archive.writestr("roe_301_1_part2_lcp.cpp", b"// two")
    check_class(source, download(tmp_path / "alone.zip", [101]), "101", "roe", tmp_path)
    assert row(tmp_path / "out", "301")["not used"] == ""


@pytest.mark.parametrize("make", FOLDERS.values(), ids=FOLDERS)
@pytest.mark.usual(7)
def test_no_folder_costs_anybody_else(
    tmp_path: Path, here: None, make: Callable[[Path], object]
) -> None:
    for top in ("all", "alone"):
        write(tmp_path / f"{top}_" / "anna", {"part2_lcp.cpp": b"// anna"})
    odd = tmp_path / "all_" / "zoe"
    odd.mkdir()
    make(odd)
    try:
        check_class(tmp_path / "all_", tmp_path / "alone_", "anna", "zoe", tmp_path)
        assert not Path("/tmp/was-run").exists()
    finally:
        if not odd.is_symlink():
            odd.chmod(0o755)
        subprocess.run(["rm", "-rf", str(odd)], check=True)  # however deep


@pytest.mark.parametrize("data", ZIPS.values(), ids=ZIPS)
def test_no_zip_ends_a_grading_without_a_sentence(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], data: bytes
) -> None:
    """Zips that hold something usable are graded for real elsewhere."""
    (tmp_path / "x.zip").write_bytes(data)
    try:
        submission.read(tmp_path / "x.zip")
    except UsageError:
        assert cli.main(["grade", str(tmp_path / "x.zip")]) == 2
        assert len(capsys.readouterr().err.splitlines()) == 1
