"""Limits on all uploads of one student together: nothing is written to disk, and sizes are
measured, not believed."""

import csv
import gzip
import io
import re
import resource
import tarfile
from collections.abc import Callable
from pathlib import Path

import corpus
import pytest
from bounce_grader.classroom.intake import handed_in, students
from bounce_grader.common.errors import UsageError
from bounce_grader.grading import record
from bounce_grader.submission import submission
from bounce_grader.submission.entry import LARGEST_SOURCE, MOST_ENTRIES
from bounce_grader.submission.submission import Submission
from classes import grade_class, zipped
from conftest import solution_files
from corpus import Member
from handed_in import limited_memory, packed_tar
from odd_students import bomb, LIES, long_names, zip_that_claims

Uploads = dict[str, bytes]


def read(path: Path, uploads: Uploads) -> Submission:
    """What is read of a student's uploads, with nothing written and little memory."""
    (student,) = students.read(zipped(path / "x.zip", uploads)).students
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (0, before[1]))
    try:
        with limited_memory(400 << 20):
            return handed_in.read(student.path, student.uploads)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


def tars(inner: int = 0) -> Uploads:
    """Ten uploads may hold forty archives of 64 MB each; a hundred kilobytes make one."""
    packed = packed_tar({"large.bin": bytes(60 << 20)})
    if inner:
        packed = corpus.zip_of(Member(b"%d.tar.gz" % i, packed) for i in range(inner))
    ending = "zip" if inner else "tar.gz"
    return {f"doe_1_{i}_hw{i}.{ending}": packed for i in range(1, 11)}


def headers() -> Uploads:
    info = tarfile.TarInfo("folder")
    info.type = tarfile.DIRTYPE
    many = bytes(info.tobuf(tarfile.USTAR_FORMAT)) * 4990
    info.name, info.type = "part2_lcp.cpp", tarfile.REGTYPE
    tar = gzip.compress(many + bytes(info.tobuf(tarfile.USTAR_FORMAT)) + bytes(1024), 1)
    return {f"doe_1_{i}_hw{i}.tar.gz": tar for i in range(1, 11)}


def sources() -> Uploads:
    return {f"doe_1_{i}_hw{i}a.zip": bomb(60).replace(b"helper", b"help_%d" % i) for i in (1, 2)}


def files() -> Uploads:
    half = range(MOST_ENTRIES // 2 + 1)
    return {
        f"doe_1_{i}_hw{i}a.zip": corpus.zip_of(Member(b"%d_%d.txt" % (i, n)) for n in half)
        for i in (1, 2)
    }


@pytest.mark.parametrize(
    "uploads, sentence",
    [
        (tars, "more than 256 MB with the other archives"),
        (lambda: tars(3), "more than 256 MB with the other archives"),
        (headers, "headers"),
        (sources, "more than 100 sources or 8 MB"),
        (files, "more than 5000 files"),
    ],
)
def test_all_uploads_are_counted_together(
    tmp_path: Path, uploads: Callable[[], Uploads], sentence: str
) -> None:
    with pytest.raises(UsageError) as refused:
        read(tmp_path, uploads())
    assert sentence in str(refused.value) and "\n" not in str(refused.value)


def test_bytes_of_all_uploads_are_counted_together(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    zip_of_one = bomb(1)
    monkeypatch.setattr(handed_in, "LARGEST", 2 * len(zip_of_one) - 1)
    assert set(read(tmp_path, {"doe_1_1_a.zip": zip_of_one}).files) == {"helper0.cpp"}
    with pytest.raises(UsageError, match="b.zip is too large: all that is handed in may have"):
        read(tmp_path, {"doe_1_1_a.zip": zip_of_one, "doe_1_2_b.zip": zip_of_one})


LINK = corpus.zip_of([Member(b"part2_lcp.cpp", b"/etc/passwd", attributes=0o120777 << 16)])
TOO_LARGE = b" " * (LARGEST_SOURCE + 1)
SOLUTION = solution_files()


@pytest.mark.parametrize(
    "uploads, taken, refused",
    [
        ({f"doe_1_{i}_{n}": t for i, (n, t) in enumerate(SOLUTION.items())}, SOLUTION, {}),
        (
            {"doe_1_1_hw.zip": corpus.zip_of(Member(n.encode(), t) for n, t in SOLUTION.items())},
            SOLUTION,
            {},
        ),
        *(
            ({"doe_1_1_hw.zip": zip_that_claims(s)}, {"part2_lcp.cpp": b"// odd\n"}, {})
            for s in LIES
        ),
        (
            {"doe_1_1_part2_lcp.cpp": b"// two", "doe_1_2_hw.zip": LINK},
            {"part2_lcp.cpp": b"// two"},
            {},
        ),
        (
            {"doe_1_1_part1_contacts.cpp": TOO_LARGE, "doe_1_2_part2_lcp.cpp": b"// two"},
            {"part2_lcp.cpp": b"// two"},
            {1: "part1_contacts.cpp is 1.0 MB large; a source file may have 1 MB"},
        ),
    ],
)
def test_what_is_taken(
    tmp_path: Path, uploads: Uploads, taken: Uploads, refused: dict[int, str]
) -> None:
    got = read(tmp_path, uploads)
    assert (got.files, got.refused) == (taken, refused)


def test_of_many_files_the_first_are_named(tmp_path: Path) -> None:
    odd = {
        "doe_1_1_part2_lcp.cpp": b"// two\n",
        "doe_1_2_hw.zip": long_names(1900),
        "roe_2_3_hw.zip": long_names(1900),
        "poe_3_4_hw.zip": long_names(90, "/part1_contacts.cpp"),
        "moe_5_9_part2_lcp.cpp": b"// two\n",
    }
    odd |= {f"foe_4_{i}_{'n' * 240}{i}.jpg": b"" for i in range(5, 95)}
    odd |= {f"moe_5_{i}_{'n' * 240}{i}.jpg": b"" for i in range(105, 195)}
    out = tmp_path / "out"
    assert grade_class(zipped(tmp_path / "x.zip", odd), out) == 0
    table, page = (out / "grades.csv").read_text("utf-8-sig"), (out / "class.html").read_text()
    cells = [cell for row in csv.reader(io.StringIO(table)) for cell in row]
    assert max(map(len, [*cells, *re.findall(r"<td[^>]*>(.*?)</td>", page)])) < 8_000
    assert all(file.stat().st_size < 40_000 for file in (out / "feedback").iterdir())
    for words in ("and 1895 more", "and 1890 more", "and 85 more", "is there 90 times"):
        assert words in page
    assert "and 1880 more" in table


@pytest.mark.parametrize("number, more", [(1900, 1800), (100, 0)])
def test_a_record_names_the_first_files_that_were_not_used(
    tmp_path: Path, number: int, more: int
) -> None:
    (tmp_path / "x.zip").write_bytes(long_names(1900))
    taken = submission.read(tmp_path / "x.zip")
    taken = taken._replace(ignored=taken.ignored[:number])
    made = record.whole(taken, [], "full", {"total": 1.0}, "", None)
    assert (len(made["ignored"]), made.get("ignored_more", 0)) == (record.MOST_IGNORED, more)
