"""Zips as other programs write them, and as nobody should: what is read, and what is refused."""

import secrets
import time
import zipfile
from pathlib import Path

import corpus
import pytest
from bounce_grader.common.errors import UsageError
from bounce_grader.submission import entry, submission
from conftest import solution_files
from handed_in import limited_memory, packed_tar, PARTS, refusal, zip_of


def test_a_broken_zip_is_said(tmp_path: Path) -> None:
    path = tmp_path / "x.zip"
    path.write_bytes(b"PK\x03\x04 and then nothing")
    assert "broken" in refusal(path)
    zip_of(path, solution_files())
    data = bytearray(path.read_bytes())
    data[60:90] = bytes(30)  # inside the first entry's compressed bytes
    path.write_bytes(data)
    assert "broken" in refusal(path)


def test_an_encrypted_zip_is_said(tmp_path: Path) -> None:
    path = zip_of(tmp_path / "x.zip", {"part1_contacts.cpp": b"int x;"})
    data = bytearray(path.read_bytes())
    for header, flags in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        data[data.index(header) + flags] |= 1
    path.write_bytes(data)
    assert "encrypted" in refusal(path)


@pytest.mark.parametrize(
    "name", ["/etc/x.cpp", "../x.cpp", "a/../../x.cpp", "..\\x.cpp", "C:/x.cpp"]
)
def test_an_entry_that_points_outside_is_refused(tmp_path: Path, name: str) -> None:
    assert "outside" in refusal(zip_of(tmp_path / "x.zip", {name: b"int x;"}))


def test_a_bomb_is_refused_without_unpacking_it(tmp_path: Path) -> None:
    bomb = {f"helper{i}.cpp": b" " * entry.LARGEST_SOURCE for i in range(64)}
    assert "submit the parts" in refusal(zip_of(tmp_path / "x.zip", bomb))


def test_too_many_files_are_refused(tmp_path: Path) -> None:
    files = {f"{i}.txt": b"" for i in range(entry.MOST_ENTRIES + 1)}
    assert "more than" in refusal(zip_of(tmp_path / "x.zip", files))


def test_too_many_folders_are_refused_too(tmp_path: Path) -> None:
    files = {f"{i}/": b"" for i in range(entry.MOST_ENTRIES)}
    assert "more than" in refusal(zip_of(tmp_path / "x.zip", {**files, "part1_contacts.cpp": b""}))


def test_a_zip_that_lies_about_a_size_is_no_source(tmp_path: Path) -> None:
    path = zip_of(tmp_path / "x.zip", {"part1_contacts.cpp": b" " * 2 * entry.LARGEST_SOURCE})
    data = bytearray(path.read_bytes())
    for header, size in ((b"PK\x03\x04", 22), (b"PK\x01\x02", 24)):
        at = data.index(header) + size
        data[at : at + 4] = (100).to_bytes(4, "little")
    path.write_bytes(data)
    taken = None
    try:
        taken = submission.read(path)
    except UsageError as refused:
        assert "broken" in str(refused)
    assert taken is None or 1 not in taken.parts or len(taken.files[taken.parts[1]]) <= 100


def test_a_mac_zip_of_a_folder_is_read(tmp_path: Path) -> None:
    files = {f"hw/{name}": text for name, text in solution_files().items()}
    mac = {f"__MACOSX/hw/._{name}": b"\0\5\x16\7" for name in PARTS}
    taken = submission.read(zip_of(tmp_path / "x.zip", {**files, **mac, "hw/.DS_Store": b"\0"}))
    assert set(taken.files) == PARTS and set(taken.ignored) == {*mac, ".DS_Store"}


def test_a_zip_written_as_a_stream_is_read(tmp_path: Path) -> None:
    """Sizes follow the data, in a descriptor, as Java and macOS write it; and as zip64."""
    (tmp_path / "x.zip").write_bytes(corpus.streamed({"part1_contacts.cpp": b"int x;"}))
    assert submission.read(tmp_path / "x.zip").files == {"part1_contacts.cpp": b"int x;"}
    (tmp_path / "x.zip").write_bytes(corpus.zip64({"part1_contacts.cpp": b"int x;"}))
    assert submission.read(tmp_path / "x.zip").files == {"part1_contacts.cpp": b"int x;"}


@pytest.mark.parametrize("again", ["a//x.cpp", "a/./x.cpp", "./a/x.cpp", "a\\x.cpp"])
def test_one_name_spelled_in_two_ways_is_refused(tmp_path: Path, again: str) -> None:
    files = {"a/x.cpp": b"int a;", again: b"int b;"}
    assert "two entries of the same name" in refusal(zip_of(tmp_path / "x.zip", files))


def test_a_file_that_is_a_folder_too_is_refused(tmp_path: Path) -> None:
    files = {"part1_contacts.cpp": b"", "a.hpp": b"", "a.hpp/b/c.hpp": b""}
    assert "a.hpp as a file and as a folder" in refusal(zip_of(tmp_path / "x.zip", files))


@pytest.mark.parametrize("name", ["\0x.cpp", ".", "./."])
def test_an_entry_without_a_name_is_refused(tmp_path: Path, name: str) -> None:
    (tmp_path / "x.zip").write_bytes(corpus.renamed(name))
    assert "without a name" in refusal(tmp_path / "x.zip")


@pytest.mark.parametrize("method", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_an_unusual_compression_is_refused(tmp_path: Path, method: int) -> None:
    """LZMA allocates what its header asks for: 4 GB for one byte."""
    with zipfile.ZipFile(tmp_path / "x.zip", "w", method) as archive:
        archive.writestr("part1_contacts.cpp", "int x;")
    assert "unusual" in refusal(tmp_path / "x.zip")


def test_a_table_of_contents_without_end_is_not_read(tmp_path: Path) -> None:
    """65,535 entries, as many as a zip without zip64 can have."""
    (tmp_path / "x.zip").write_bytes(corpus.many_entries(65535))
    with limited_memory(64 << 20):
        assert "more than 5000 files" in refusal(tmp_path / "x.zip")


def test_entries_that_hold_one_another_are_read_no_further_than_the_limits(tmp_path: Path) -> None:
    (tmp_path / "x.zip").write_bytes(corpus.overlapping(90, entry.LARGEST_SOURCE // 2))
    start = time.process_time()
    sentence = refusal(tmp_path / "x.zip")
    assert "broken" in sentence or "8 MB" in sentence
    assert time.process_time() - start < 5


def test_what_cannot_be_used_counts_towards_the_limits(tmp_path: Path) -> None:
    """5000 sources that are no text: each would have to be unpacked to say so."""
    files = {f"{i}.cpp": b"\0" * 1000 for i in range(entry.MOST_ENTRIES)}
    assert "more than 100 sources" in refusal(zip_of(tmp_path / "x.zip", files))


def test_an_archive_inside_a_zip_is_opened_where_no_part_is_beside_it(tmp_path: Path) -> None:
    inner = zip_of(tmp_path / "inner.zip", solution_files()).read_bytes()
    taken = submission.read(zip_of(tmp_path / "x.zip", {"a/inner.zip": inner}))
    assert {name.rpartition("/")[2] for name in taken.files} == PARTS
    within = {"inner.tgz": packed_tar(solution_files()), "notes.txt": b""}
    taken = submission.read(zip_of(tmp_path / "y.zip", within))
    assert len(taken.parts) == 4
    beside = {**solution_files(), "old.zip": inner}
    taken = submission.read(zip_of(tmp_path / "z.zip", beside))
    assert set(taken.files) == PARTS and taken.ignored == ("old.zip",)
    twice = zip_of(
        tmp_path / "twice.zip", {"x.zip": zip_of(tmp_path / "i.zip", within).read_bytes()}
    )
    assert submission.read(twice).parts == {}  # one level, and no further


def test_entries_that_share_their_bytes_are_refused(tmp_path: Path) -> None:
    """Each would be unpacked from the same bytes: a small zip that takes minutes to read."""
    path = tmp_path / "x.zip"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("part1_contacts.cpp", secrets.token_bytes(5000))
        for n in range(3):
            again = zipfile.ZipInfo(f"helper{n}.cpp")
            again.compress_type = zipfile.ZIP_DEFLATED
            first = archive.infolist()[0]
            again.compress_size, again.file_size = first.compress_size, first.file_size
            again.CRC, again.header_offset = first.CRC, first.header_offset
            archive.filelist.append(again)
    with pytest.raises(UsageError, match="its entries overlap"):
        submission.read(path)
