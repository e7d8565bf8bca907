"""Tars as programs write them, and as nobody should: what is read, and what is refused."""

import bz2
import gzip
import io
import lzma
import tarfile
import time
from collections.abc import Iterable
from pathlib import Path

import pytest
from bounce_grader.common.errors import UsageError
from bounce_grader.submission import submission, tars
from bounce_grader.submission.unpack_limits import HEADERS, LARGEST, UnpackLimits
from conftest import solution_files
from handed_in import limited_memory, packed_tar, PARTS, refusal

SOURCE = {"part1_contacts.cpp": b"int x;\n"}


@pytest.mark.parametrize("kind, ending", [("gz", "tar.gz"), ("bz2", "TAR.BZ2"), ("xz", "tar.xz")])
def test_a_tar_is_read_as_a_zip_is(tmp_path: Path, kind: str, ending: str) -> None:
    path = tmp_path / f"hw.{ending}"
    path.write_bytes(packed_tar({f"hw/{n}": text for n, text in solution_files().items()}, kind))
    assert set(submission.read(path).files) == PARTS


def test_a_hostile_tar_is_refused_in_a_sentence(tmp_path: Path) -> None:
    path = tmp_path / "hw.tar.gz"
    for name in ("../part1_contacts.cpp", "/etc/part1_contacts.cpp"):
        path.write_bytes(packed_tar({name: b""}))
        assert "points outside of it" in refusal(path)
    path.write_bytes(gzip.compress(bytes(65 << 20)))
    assert "more than 64 MB unpacked" in refusal(path)
    path.write_bytes(packed_tar(solution_files())[:-200])
    assert "is broken" in refusal(path)
    data = io.BytesIO()
    with tarfile.open(fileobj=data, mode="w:gz") as archive:
        for kind in (tarfile.SYMTYPE, tarfile.LNKTYPE, tarfile.FIFOTYPE, tarfile.CHRTYPE):
            info = tarfile.TarInfo(f"part{kind.decode()}.cpp")
            info.type, info.linkname = kind, "/etc/passwd"
            archive.addfile(info)
    path.write_bytes(data.getvalue())
    assert submission.read(path).files == {}


def member(name: str, data: bytes = b"", kind: bytes = tarfile.REGTYPE) -> bytes:
    info = tarfile.TarInfo(name)
    info.size, info.type = len(data), kind
    return bytes(info.tobuf(tarfile.USTAR_FORMAT)) + data + bytes(-len(data) % 512)


def record(key: bytes, value: bytes) -> bytes:
    rest = b" " + key + b"=" + value + b"\n"
    length = len(rest) + 1
    while len(str(length)) + len(rest) != length:
        length += 1
    return str(length).encode() + rest


def tar_of(*members: bytes) -> bytes:
    return b"".join([*members, *(member(n, data) for n, data in SOURCE.items()), bytes(1024)])


@pytest.mark.parametrize(
    "written_as", [tarfile.USTAR_FORMAT, tarfile.GNU_FORMAT, tarfile.PAX_FORMAT]
)
def test_each_format_is_read_as_tarfile_reads_it(tmp_path: Path, written_as: int) -> None:
    data = io.BytesIO()
    names = ["a.cpp", "./" + "d" * 90 + "/" + "n" * 80 + ".cpp", "\u00fc.hpp", "empty"]
    names += [] if written_as == tarfile.USTAR_FORMAT else ["f" * 150 + "/" + "g" * 150 + ".cpp"]
    comment = {"comment": "0123abcd"} if written_as == tarfile.PAX_FORMAT else None
    with tarfile.open(fileobj=data, mode="w", format=written_as, pax_headers=comment) as archive:
        folder = tarfile.TarInfo("folder")
        folder.type = tarfile.DIRTYPE
        archive.addfile(folder)
        for number, name in enumerate(names):
            info = tarfile.TarInfo(name)
            info.size = 300 * number if name != "empty" else 0
            archive.addfile(info, io.BytesIO(bytes([number]) * info.size))
    with tars.opened(Path("x.tar"), data.getvalue(), UnpackLimits()) as listed:
        found = {entry.name: entry.read(10_000) for entry in listed}
    data.seek(0)
    with tarfile.open(fileobj=data) as archive:
        expected = {
            info.name.removeprefix("./"): stream.read()
            for info in archive
            if (stream := archive.extractfile(info))
        }
    assert found == expected and len(found) == len(names)


def test_a_size_in_a_pax_header_counts() -> None:
    text = b"int y;\n"
    header = member("pax", record(b"size", b"%d" % len(text)) + record(b"path", b"y.cpp"), b"x")
    data = tar_of(header, member("short")[:512] + text + bytes(512 - len(text)))
    with tars.opened(Path("x.tar"), data, UnpackLimits()) as listed:
        assert {e.name: e.read(99) for e in listed} == {"y.cpp": text, **SOURCE}


def test_a_sparse_file_is_no_regular_one(tmp_path: Path) -> None:
    """Its map may have any length."""
    keys = {b"major": b"1", b"minor": b"0", b"name": b"x.cpp", b"realsize": b"10"}
    header = b"".join(record(b"GNU.sparse." + key, value) for key, value in keys.items())
    path = tmp_path / "x.tar"
    path.write_bytes(tar_of(member("pax", header, b"x"), member("x.cpp", b"9\n" + b"0\n" * 18)))
    assert set(submission.read(path).files) == set(SOURCE)
    path.write_bytes(tar_of(member("x.cpp", b"", tarfile.GNUTYPE_SPARSE)))
    assert "headers of a kind" in refusal(path)


def hostile() -> Iterable[tuple[str, bytes, str]]:
    every = b"".join(record(b"%x" % i, b"") for i in range(500_000))
    many = [member(f"f{i}") for i in range(600)]
    yield "global", tar_of(member("pax", every, b"g"), *many), "headers of a kind"
    fewer = b"".join(record(b"%x" % i, b"") for i in range(100_000))
    yield "fewer", tar_of(member("pax", fewer, b"g"), *many), ""
    chain = member("pax", record(b"comment", b""), b"x") * 60_000
    yield "chain", tar_of(chain), "headers of a kind"
    smallest = record(b"a", b"") * (HEADERS // tars.RECORDS_WEIGH // 5 - 1000)
    yield "records", tar_of(member("pax", smallest, b"x")), ""
    yield "long", tar_of(member("pax", b"n" * (9 << 20), b"L")), "headers of a kind"
    number = record(b"size", b"1" * (1 << 20))
    yield "number", tar_of(member("pax", number, b"x")), "cut short"
    yield "negative", tar_of(member("pax", record(b"size", b"-512"), b"x")), "cut short"
    yield "digits", tar_of(member("pax", b"1" * (1 << 20), b"x")), "invalid header"


@pytest.mark.parametrize("data, sentence", [pytest.param(d, s, id=n) for n, d, s in hostile()])
def test_headers_cost_neither_memory_nor_time(tmp_path: Path, data: bytes, sentence: str) -> None:
    path = tmp_path / "x.tar.gz"
    path.write_bytes(gzip.compress(data, 1))
    bounded(path, sentence)


def test_pieces_without_end_are_not_unpacked(tmp_path: Path) -> None:
    for empty, ending in ((gzip.compress(b""), "gz"), (bz2.compress(b""), "bz2")):
        path = tmp_path / f"x.tar.{ending}"
        path.write_bytes(empty * 100_000)
        bounded(path, "in several pieces")
    for packed, ending in ((bz2.compress(b"x"), "bz2"), (lzma.compress(b"x"), "xz")):
        path = tmp_path / f"x.tar.{ending}"
        path.write_bytes(packed + bytes(tars.LARGEST_SLOW))
        bounded(path, "is larger than 8 MB")
    path = tmp_path / "padded.tar.gz"
    path.write_bytes(gzip.compress(tar_of()) + bytes(1000))  # as a tape pads it
    assert set(submission.read(path).files) == set(SOURCE)


def bounded(path: Path, sentence: str) -> None:
    """Reads a submission in a second or so, and in a small multiple of what a tar may hold."""
    start = time.process_time()
    said = ""
    with limited_memory(3 * LARGEST):
        try:
            assert set(submission.read(path).files) == set(SOURCE)
        except UsageError as error:
            said = str(error)
    assert time.process_time() - start < 5
    assert sentence in said and bool(sentence) == bool(said)
