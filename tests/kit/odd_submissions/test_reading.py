"""Whatever is handed in is read within the limits or refused in one sentence: expected/ says for
each submission which."""

import re
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from textwrap import indent

import golden
import odd_submissions
import pytest
from bounce_grader.common.errors import UsageError
from bounce_grader.common.files import digest
from bounce_grader.common.manifest import parts
from bounce_grader.submission import intake, submission
from bounce_grader.submission.submission import Submission
from bounce_grader.submission.intake import UNPACKED
from conftest import write
from handed_in import limited_memory, packed_tar, zipped
from odd_submissions import bash, COMMANDS, FILES, PARTS, PATHS, UNTOUCHED
from odd_tars import tars
from odd_zips import Archive, zips

pytestmark = pytest.mark.golden
EXPECTED = Path(__file__).parent / "expected"
LIBRARYS = re.compile(r"(broken|unpacked) \((?!its entries|it takes).*?\):")
MOST = 12  # names of one kind that are written


def read(path: Path) -> str:
    """What is taken of a submission, or the sentence that refuses it. Reading may take no more
    than a few seconds, and a small multiple of what an archive may hold."""
    start = time.process_time()
    with limited_memory(3 * UNPACKED):
        words = taken_or_refused(path, lambda: submission.read(path))
    assert time.process_time() - start < 5, path
    return words


def taken_or_refused(path: Path, reads: Callable[[], Submission]) -> str:
    try:
        return "\n".join(taken(reads()))
    except UsageError as refused:
        assert str(refused).isprintable()
        sentence = str(refused).replace(str(path), "SUBMISSION")
        # What a library says of a broken archive is its own.
        return "refused: " + re.sub(LIBRARYS, r"\1 (...):", sentence)


def taken(read: Submission) -> Iterator[str]:
    for number, name in read.parts.items():
        yield f"part {number}: {name} {text(read.files[name])}"
    for number, reason in read.refused.items():
        yield f"part {number} refused: {reason}"
    for part in parts():
        if part.number not in read.parts and (instead := read.instead_of(part)):
            yield f"part {part.number} isn't there{instead}"
    others = sorted(read.files.keys() - {*read.parts.values()})
    yield from (f"beside them: {printable(name)} {text(read.files[name])}" for name in others)
    yield from (f"not used: {printable(name)}" for name in read.ignored[:MOST])
    if len(read.ignored) > MOST:
        yield f"not used: and {len(read.ignored) - MOST} more"


def text(data: bytes) -> str:
    """A file's text, or how it begins and how long it is."""
    if data in UNTOUCHED.values():
        return "(the stub)"
    if len(data) <= 40:
        return repr(data.decode())
    return f"{data[:8].decode()!r}... ({len(data)} bytes)"


def printable(name: str) -> str:
    shown = name if name.isprintable() else ascii(name)
    return shown if len(shown) < 100 else f"{shown[:30]}... ({len(shown)} characters)"


def compare(name: str, rows: Iterator[tuple[str, str]]) -> None:
    text = "\n".join(f"{what}\n{indent(words, '    ')}\n" for what, words in rows)
    golden.compare_file(EXPECTED / f"{name}.txt", text)


def test_files_are_the_same_in_a_folder_a_zip_and_a_tar(tmp_path: Path) -> None:
    def rows() -> Iterator[tuple[str, str]]:
        for number, (what, files) in enumerate(FILES.items()):
            folder = write(tmp_path / f"{number}", files)
            words = read(folder)
            assert read(zipped(tmp_path / "x.zip", files)) == words, what
            (tmp_path / "x.tar.gz").write_bytes(packed_tar(files))
            assert read(tmp_path / "x.tar.gz") == words, what
            yield what, words

    compare("files", rows())


def test_folders_and_paths(tmp_path: Path) -> None:
    def rows() -> Iterator[tuple[str, str]]:
        write(tmp_path / "parts", PARTS)
        for number, (what, (command, path)) in enumerate(PATHS.items()):
            yield what, read(bash(command, tmp_path / f"{number}") / path)
        yield "3000 folders deep", read(odd_submissions.deep(tmp_path / "deep"))
        bash("rm -rf *", tmp_path)  # pytest can't remove what is deep
        misleading = dict.fromkeys(odd_submissions.MISLEADING, b"int x;")
        yield "misleading names", read(zipped(tmp_path / "x.zip", PARTS | misleading))

    compare("folders", rows())


@pytest.mark.parametrize("make", [zips, tars])
def test_archives(tmp_path: Path, make: Callable[[], Iterator[Archive]]) -> None:
    def rows() -> Iterator[tuple[str, str]]:
        for what, name, data in make():
            (tmp_path / name).write_bytes(data)
            yield what, read(tmp_path / name)

    compare(make.__name__, rows())


# --- changes while it is read ---


def test_a_folder_that_changes_while_it_is_read_leads_nowhere_else(tmp_path: Path) -> None:
    def rows() -> Iterator[tuple[str, str]]:
        for what, command in COMMANDS["changes"].items():
            folder = tmp_path / what / "x"
            write(folder, {"src/part1_contacts.cpp": b"int x;", "README": b""})
            with intake.opened(folder) as entries:
                bash(command, folder / "src")
                words = taken_or_refused(folder, lambda: submission.take(folder, entries))
            yield what, words

    compare("changes", rows())


def test_a_zip_that_is_replaced_while_it_is_read_stays_the_first_one(tmp_path: Path) -> None:
    path = zipped(tmp_path / "x.zip", {"part1_contacts.cpp": b"int first;"})
    second = zipped(tmp_path / "y.zip", {"part1_contacts.cpp": b"int second;"})
    with intake.opened(path) as entries:
        second.replace(path)
        assert submission.take(path, entries).files["part1_contacts.cpp"] == b"int first;"


def test_the_name_of_a_submission_is_its_content(tmp_path: Path) -> None:
    first = submission.read(write(tmp_path / "a", PARTS))
    again = submission.read(write(tmp_path / "b", PARTS))
    other = submission.read(write(tmp_path / "c", PARTS | {"part2_lcp.cpp": b"\n"}))
    odd = first._replace(files={**first.files, "L\udcf6sung.hpp": b""})
    assert first.sha256 == again.sha256
    assert len({first.sha256, other.sha256, odd.sha256, odd._replace(files={}).sha256}) == 4
    # Its cases could spell a helper of somebody else's.
    spelled = Submission("a", {"x.hpp": b"1"}, {}, {}, cases=b"b.hpp\0001\0002")
    helper = Submission("a", {"x.hpp": b"1", "b.hpp": b"2"}, {}, {})
    assert spelled.sha256 != helper.sha256
    assert digest("a", "b") != digest("ab") != digest("a'", "'b")
