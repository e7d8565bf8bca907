"""Whatever one student's files contain, nobody else loses anything: the class is graded, and that
student is named."""

import csv
import io
import json
import os
import re
import subprocess
import time
import zipfile
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import pytest
from bounce_grader import cli
from bounce_grader.classroom.output import outputs
from bounce_grader.classroom.work import engine_local, near_copies
from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.formats import github
from bounce_grader.submission import submission
from classes import download, grade_class
from conftest import write
from odd_students import FOLDERS, nested, PART, UPLOADS, zip_that_claims, ZIPS


@pytest.fixture(autouse=True)
def in_this_process(monkeypatch: pytest.MonkeyPatch) -> None:
    """Grades here, which is quicker: these tests are about the code around it."""
    monkeypatch.setattr(
        engine_local, "run", lambda tasks, _, worker: ((task, worker(task)) for task in tasks)
    )


def row(out: Path, id: str) -> dict[str, str]:
    rows = csv.DictReader(io.StringIO((out / "grades.csv").read_text("utf-8-sig")))
    return next(row for row in rows if row["id"] == id)


def check_class(source: Path, alone: Path, honest: str, odd: str) -> None:
    """The honest one's results are the same as alone; the other is named."""
    out, start = source.parent / "out", time.process_time()
    assert grade_class(source, out) == 0
    assert time.process_time() - start < 10
    assert grade_class(alone, source.parent / "alone") == 0
    assert row(out, honest) == row(source.parent / "alone", honest)
    page = (out / "class.html").read_text()
    named = re.sub(r'<td class="who">(?:<a [^>]*>)?|<td>&#x27;', "<td>", page)
    assert f"<td>{odd}" in named and len(page) < 100_000
    for line in (out / "log.jsonl").read_bytes().splitlines():
        json.loads(line)


@pytest.mark.parametrize("uploads", UPLOADS.values(), ids=UPLOADS)
@pytest.mark.usual(11)
def test_no_upload_costs_anybody_else(tmp_path: Path, uploads: dict[str, bytes]) -> None:
    source = download(tmp_path / "x.zip", [101], uploads)
    check_class(source, download(tmp_path / "alone.zip", [101]), "101", "roe")


def test_an_upload_that_is_there_twice_costs_nobody_else(tmp_path: Path) -> None:
    source = download(tmp_path / "x.zip", [101], {"roe_301_1_part2_lcp.cpp": b"// one"})
    with zipfile.ZipFile(source, "a") as archive, pytest.warns(UserWarning, match="Duplicate"):
        archive.writestr("roe_301_1_part2_lcp.cpp", b"// two")
    check_class(source, download(tmp_path / "alone.zip", [101]), "101", "roe")
    assert row(tmp_path / "out", "301")["not used"] == ""


@pytest.mark.parametrize("make", FOLDERS.values(), ids=FOLDERS)
@pytest.mark.usual(7)
def test_no_folder_costs_anybody_else(tmp_path: Path, make: Callable[[Path], object]) -> None:
    for top in ("all", "alone"):
        write(tmp_path / f"{top}_" / "anna", {"part2_lcp.cpp": b"// anna"})
    odd = tmp_path / "all_" / "zoe"
    odd.mkdir()
    make(odd)
    try:
        check_class(tmp_path / "all_", tmp_path / "alone_", "anna", "zoe")
        assert not Path("/tmp/was-run").exists()
    finally:
        if not odd.is_symlink():
            odd.chmod(0o755)
        subprocess.run(["rm", "-rf", str(odd)], check=True)  # however deep


def test_names_that_are_no_text_are_names_all_the_same(tmp_path: Path) -> None:
    odd, long, out = os.fsdecode(b"ann\xe4"), "n" * 255, tmp_path / "out"
    files = {f"{odd}/part2_lcp.cpp": b"// x", f"{odd}/notes\udcfc.txt": b""}
    write(tmp_path / "all", {**files, f"{long}/part2_lcp.cpp": b"// y"})
    assert grade_class(tmp_path / "all", out) == 0
    pages = sorted((file.name for file in (out / "feedback").iterdir()), key=len)
    assert pages[0] == f"{odd}.html" and len(pages[1]) < 240
    assert "ann\ufffd" in (out / "class.html").read_text()
    assert "notes\ufffd.txt" in (out / "grades.csv").read_text()


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


def test_a_deep_repository_is_no_obstacle_to_an_annotation(tmp_path: Path) -> None:
    """Deeper than Python's limit on recursion."""
    write(tmp_path, {"hw/a.cpp": b""})
    nested(tmp_path, 1500)
    try:
        assert github._in_repository("a.cpp", github._files(tmp_path)) == "hw/a.cpp"
    finally:
        subprocess.run(["rm", "-rf", str(tmp_path / "d")], check=True)


# --- what nobody foresaw ---


def fails(error: Exception, *_: Any, **__: Any) -> Any:
    raise error


@pytest.mark.parametrize("error", [OverflowError("x"), MemoryError(), RecursionError("deep")])
def test_in_reading_it_is_one_students(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, error: Exception
) -> None:
    (tmp_path / "odd.zip").write_bytes(zip_that_claims(1, PART))
    monkeypatch.setattr(zipfile.ZipFile, "infolist", partial(fails, error))
    assert cli.main(["grade", str(tmp_path / "odd.zip")]) == 2


def test_who_cannot_be_compared_needs_a_look(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = near_copies.own_texts

    def odd(path: Path, uploads: Any) -> dict[int, str]:
        if any(upload.user == "301" for upload in uploads):
            raise OverflowError("too large")
        return whole(path, uploads)

    monkeypatch.setattr(near_copies, "own_texts", odd)
    uploads = {"roe_301_1_part2_lcp.cpp": b"// odd"}
    assert grade_class(download(tmp_path / "x.zip", [101, 102], uploads), tmp_path / "out") == 0
    assert "can't be compared" in row(tmp_path / "out", "301")["needs a look"]
    assert not row(tmp_path / "out", "101")["needs a look"]


def test_a_page_for_which_there_is_no_room_is_no_students_fault(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(outputs, "_page", partial(fails, OSError(28, "No space left on device")))
    with pytest.raises(KitError, match="is full"):
        grade_class(download(tmp_path / "x.zip", [101]), tmp_path / "out")
