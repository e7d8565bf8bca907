"""Limits on all uploads of one student together: nothing is written to disk, and sizes are
measured, not believed."""

import csv
import gzip
import io
import re
import resource
import subprocess
import tarfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import corpus
import pytest
from bounce_grader.classroom.intake import handed_in, students
from bounce_grader.classroom.work import task
from bounce_grader.common.errors import UsageError
from bounce_grader.formats import github
from bounce_grader.grading import record
from bounce_grader.submission import submission
from bounce_grader.submission.entry import LARGEST_SOURCE, MOST_ENTRIES
from classes import grade_class
from conftest import solution_files, write
from corpus import Member
from downloads import STAMP, download, to_grade
from handed_in import limited_memory, packed_tar
from odd_students import LIES, bomb, long_names, zip_that_claims


@contextmanager
def nothing_is_written() -> Iterator[None]:
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (0, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


def refusal(path: Path) -> str:
    (student,) = students.read(path).students
    with nothing_is_written(), pytest.raises(UsageError) as refused:
        to_grade(student)
    assert "\n" not in str(refused.value)
    return str(refused.value)


def test_uploads_are_read_without_writing_anything(tmp_path: Path) -> None:
    files = solution_files()
    first = download(tmp_path / "hw.zip", {"part2_lcp.cpp": files.pop("part2_lcp.cpp")})
    uploads = {"doe_1_1_hw.zip": first.read_bytes()}
    uploads |= {f"doe_1_{i}_{name}": text for i, (name, text) in enumerate(files.items(), 2)}
    (student,) = students.read(download(tmp_path / "x.zip", uploads)).students
    with nothing_is_written():
        assert to_grade(student).files == solution_files()


@pytest.mark.parametrize("inner", [0, 3])
def test_archives_of_all_uploads_are_counted_together(tmp_path: Path, inner: int) -> None:
    """Ten uploads may hold forty archives of 64 MB each; a hundred kilobytes make one."""
    tar = packed_tar({"large.bin": bytes(60 << 20)})
    files = {f"{i}.tar.gz": tar for i in range(inner)}
    packed = download(tmp_path / "inner.zip", files).read_bytes() if inner else tar
    ending = "zip" if inner else "tar.gz"
    uploads = {f"doe_1_{i}_hw{i}.{ending}": packed for i in range(1, 11)}
    path = download(tmp_path / "x.zip", uploads)
    with limited_memory(400 << 20):
        assert "more than 256 MB with the other archives" in refusal(path)


def test_headers_of_all_tars_are_counted_together(tmp_path: Path) -> None:
    folder = tarfile.TarInfo("folder")
    folder.type = tarfile.DIRTYPE
    headers = bytes(folder.tobuf(tarfile.USTAR_FORMAT)) * 4990
    folder.name, folder.type = "part2_lcp.cpp", tarfile.REGTYPE
    tar = gzip.compress(headers + bytes(folder.tobuf(tarfile.USTAR_FORMAT)) + bytes(1024), 1)
    uploads = {f"doe_1_{i}_hw{i}.tar.gz": tar for i in range(1, 11)}
    assert "headers" in refusal(download(tmp_path / "x.zip", uploads))


def test_sources_of_all_uploads_are_counted_together(tmp_path: Path) -> None:
    two = {f"doe_1_{i}_hw{i}a.zip": bomb(60).replace(b"helper", b"help_%d" % i) for i in (1, 2)}
    assert "more than 100 sources or 8 MB" in refusal(download(tmp_path / "x.zip", two))


def test_files_of_all_uploads_are_counted_together(tmp_path: Path) -> None:
    half = MOST_ENTRIES // 2 + 1
    zipped = {
        f"doe_1_{i}_hw{i}a.zip": corpus.zip_of(Member(b"%d_%d.txt" % (i, n)) for n in range(half))
        for i in (1, 2)
    }
    assert "more than 5000 files" in refusal(download(tmp_path / "x.zip", zipped))


def test_bytes_of_all_uploads_are_counted_together(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    zipped = bomb(1)
    monkeypatch.setattr(handed_in, "LARGEST", 2 * len(zipped) - 1)
    one = download(tmp_path / "one.zip", {"doe_1_1_a.zip": zipped})
    (student,) = students.read(one).students
    assert set(to_grade(student).files) == {"helper0.cpp"}
    two = download(tmp_path / "two.zip", {"doe_1_1_a.zip": zipped, "doe_1_2_b.zip": zipped})
    assert "b.zip is too large: all that is handed in may have" in refusal(two)
    (student,) = students.read(two).students
    task.task_of(student, STAMP, tmp_path, speed=False, trust=False)


@pytest.mark.parametrize("size", LIES)
def test_a_size_is_the_one_that_is_read(tmp_path: Path, size: int) -> None:
    (tmp_path / "hw.zip").write_bytes(zip_that_claims(size))
    assert submission.read(tmp_path / "hw.zip").files == {"part2_lcp.cpp": b"// odd\n"}


def test_a_link_in_a_zip_takes_no_uploads_place(tmp_path: Path) -> None:
    link = Member(b"part2_lcp.cpp", b"/etc/passwd", attributes=0o120777 << 16)
    uploads = {"doe_1_1_part2_lcp.cpp": b"// two", "doe_1_2_hw.zip": corpus.zip_of([link])}
    (student,) = students.read(download(tmp_path / "x.zip", uploads)).students
    assert to_grade(student).files == {"part2_lcp.cpp": b"// two"}


def test_a_source_larger_than_it_may_be_is_named(tmp_path: Path) -> None:
    zipped = bomb(1, 3)
    large = {"doe_1_1_part1_contacts.cpp": b" " * (LARGEST_SOURCE + 1), "doe_1_2_hw.zip": zipped}
    (student,) = students.read(download(tmp_path / "x.zip", large)).students
    refused = to_grade(student).refused
    assert refused == {1: "part1_contacts.cpp is 1.0 MB large; a source file may have 1 MB"}


# --- what is said of it ---


def cells(out: Path) -> list[str]:
    rows = csv.reader(io.StringIO((out / "grades.csv").read_text("utf-8-sig")))
    on_the_page = re.findall(r"<td[^>]*>(.*?)</td>", (out / "class.html").read_text())
    return [*(cell for row in rows for cell in row), *on_the_page]


def test_of_many_files_the_first_are_named(tmp_path: Path) -> None:
    odd = {
        "doe_1_1_part2_lcp.cpp": b"// two\n",
        "doe_1_2_hw.zip": long_names(1900),
        "roe_2_3_hw.zip": long_names(1900),
        "poe_3_4_hw.zip": long_names(90, "/part1_contacts.cpp"),
    }
    odd |= {f"foe_4_{i}_{'n' * 240}{i}.jpg": b"" for i in range(5, 95)}
    odd |= {f"moe_5_{i}_{'n' * 240}{i}.jpg": b"" for i in range(105, 195)}
    odd |= {"moe_5_9_part2_lcp.cpp": b"// two\n"}
    out = tmp_path / "out"
    assert grade_class(download(tmp_path / "x.zip", odd), out) == 0
    assert max(map(len, cells(out))) < 8_000
    assert all(page.stat().st_size < 40_000 for page in (out / "feedback").iterdir())
    text = (out / "class.html").read_text()
    for words in ("and 1895 more", "and 1890 more", "and 85 more", "is there 90 times"):
        assert words in text
    assert "and 1880 more" in (out / "grades.csv").read_text()


def test_a_record_names_the_first_files_that_were_not_used(tmp_path: Path) -> None:
    (tmp_path / "x.zip").write_bytes(long_names(1900))
    taken = submission.read(tmp_path / "x.zip")
    made = record.whole(taken, [], "full", {"total": 1.0}, "", None)
    assert (len(made["ignored"]), made["ignored_more"]) == (record.MOST_IGNORED, 1800)
    few = taken._replace(ignored=taken.ignored[: record.MOST_IGNORED])
    made = record.whole(few, [], "full", {"total": 1.0}, "", None)
    assert len(made["ignored"]) == record.MOST_IGNORED and "ignored_more" not in made


def test_a_repository_nested_deeply_is_no_obstacle_to_an_annotation(tmp_path: Path) -> None:
    """Deeper than Python's limit on recursion."""
    folder = tmp_path / "x"
    folder.mkdir()
    for _ in range(1500):
        folder = folder / "d"
        folder.mkdir()
    try:
        assert github._in_repository(
            "a.cpp", github._files(write(tmp_path, {"hw/a.cpp": b""}))
        ) == ("hw/a.cpp")
    finally:
        subprocess.run(["rm", "-rf", str(tmp_path / "x")], check=True)
