"""Limits on all uploads of one student together: nothing is written to disk, and sizes are
measured, not believed."""

import resource
from pathlib import Path

import pytest
from bounce_grader.classroom.intake import students, uploads
from bounce_grader.common.errors import UsageError
from bounce_grader.submission.entry import LARGEST_SOURCE
from bounce_grader.submission.submission import Submission
from corpus import Member, zip_of
from handed_in import limited_memory, packed_tar, zipped
from odd_zips import bomb, claiming, LIES

Uploads = dict[str, bytes]


def read(path: Path, files: Uploads) -> Submission:
    """What is read of a student's uploads, with nothing unpacked to disk and little memory."""
    (student,) = students.read(zipped(path / "x.zip", files)).students
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 20, before[1]))
    try:
        with limited_memory(400 << 20):
            return uploads.read(student)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


def numbered(archives: dict[int, bytes], ending: str = "zip") -> Uploads:
    return {f"doe_1_{i}_hw{i}a.{ending}": data for i, data in archives.items()}


def test_all_uploads_are_counted_together(tmp_path: Path) -> None:
    large = packed_tar({"large.bin": bytes(60 << 20)})  # of sixty kilobytes
    three = zip_of(Member(b"%d.tar.gz" % i, large) for i in range(3))
    ten = range(10)
    bombs = {i: bomb(60, f"help_{i}_") for i in (1, 2)}
    for uploads, sentence in (
        (numbered(dict.fromkeys(ten, large), "tar.gz"), "more than 64 MB unpacked, alone or with"),
        (numbered(dict.fromkeys(ten, three)), "more than 64 MB unpacked, alone or with the other"),
        (numbered(bombs), "more than 100 sources or 8 MB"),
    ):
        with pytest.raises(UsageError) as refused:
            read(tmp_path, uploads)
        assert sentence in str(refused.value) and "\n" not in str(refused.value)


def test_bytes_of_all_uploads_are_counted_together(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    one = bomb(1)
    monkeypatch.setattr(uploads, "LARGEST", 2 * len(one) - 1)
    assert set(read(tmp_path, {"doe_1_1_a.zip": one}).files) == {"helper0.cpp"}
    with pytest.raises(UsageError, match="b.zip is too large: all that is handed in may have"):
        read(tmp_path, {"doe_1_1_a.zip": one, "doe_1_2_b.zip": one})


def test_what_is_taken_has_its_own_size(tmp_path: Path) -> None:
    for size in LIES:
        taken = read(tmp_path, {"doe_1_1_hw.zip": claiming(size)})
        assert taken.files == {"part2_lcp.cpp": b"// odd\n"}
    link = zip_of([Member(b"part2_lcp.cpp", b"/etc/passwd", attributes=0o120777 << 16)])
    two = {"doe_1_2_part2_lcp.cpp": b"// two"}
    assert read(tmp_path, {"doe_1_3_hw.zip": link, **two}).files == {"part2_lcp.cpp": b"// two"}
    taken = read(tmp_path, {"doe_1_1_part1_contacts.cpp": b" " * (LARGEST_SOURCE + 1), **two})
    assert set(taken.files) == {"part2_lcp.cpp"}
    sentence = "part1_contacts.cpp is larger than 1 MB, the most that a source file may have"
    assert taken.refused == {1: sentence}
