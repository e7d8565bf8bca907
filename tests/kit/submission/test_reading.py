"""Whatever is handed in is read within the limits or refused in one sentence: expected/ says for
each submission which."""

import os
import re
import shutil
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from textwrap import indent

import golden
import odd_submissions
import pytest
from bounce_grader.common.errors import UsageError
from bounce_grader.submission import entry, intake, submission
from bounce_grader.submission.submission import Submission
from bounce_grader.submission.unpack_limits import LARGEST
from conftest import ROOT, write
from handed_in import limited_memory, packed_tar, zip_of
from odd_submissions import FILES, FOLDERS
from odd_tars import tars
from odd_zips import Archive, zips

pytestmark = pytest.mark.golden
EXPECTED = Path(__file__).parent / "expected"
LIBRARYS = re.compile(r"broken \((?!its entries|it is cut short|invalid header).*?\):")
MOST = 12  # names of one kind that are written


def read(path: Path) -> str:
    """What is taken of a submission, or the sentence that refuses it. Reading may take no more
    than a few seconds, and a small multiple of what an archive may hold."""
    start = time.process_time()
    with limited_memory(3 * LARGEST):
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
        return "refused: " + re.sub(LIBRARYS, "broken (...):", sentence)


def taken(read: Submission) -> Iterator[str]:
    for number, name in read.parts.items():
        yield f"part {number}: {name} {text(read.files[name])}"
    for number, reason in read.refused.items():
        yield f"part {number} refused: {reason}"
    others = sorted(read.files.keys() - {*read.parts.values()})
    yield from (f"beside them: {printable(name)} {text(read.files[name])}" for name in others)
    yield from (f"not used: {printable(name)}" for name in read.ignored[:MOST])
    if len(read.ignored) > MOST:
        yield f"not used: and {len(read.ignored) - MOST} more"


def text(data: bytes) -> str:
    """A file's text, or how it begins and how long it is."""
    if len(data) <= 40:
        return repr(data.decode())
    return f"{data[:8].decode()!r}... ({len(data)} bytes)"


def printable(name: str) -> str:
    shown = name if name.isprintable() else ascii(name)
    return shown if len(shown) < 100 else f"{shown[:30]}... ({len(shown)} characters)"


def story(rows: Iterator[tuple[str, str]]) -> dict[str, str]:
    return {"read.txt": "\n".join(f"{what}\n{indent(words, '    ')}\n" for what, words in rows)}


def test_files_are_the_same_in_a_folder_a_zip_and_a_tar(tmp_path: Path) -> None:
    def rows() -> Iterator[tuple[str, str]]:
        for number, (what, files) in enumerate(FILES.items()):
            folder = write(tmp_path / f"{number}", files)
            words = read(folder)
            assert read(zip_of(tmp_path / "x.zip", files)) == words, what
            (tmp_path / "x.tar.gz").write_bytes(packed_tar(files))
            assert read(tmp_path / "x.tar.gz") == words, what
            yield what, words

    golden.compare(EXPECTED / "files", story(rows()))


def test_folders_and_paths(tmp_path: Path) -> None:
    def rows() -> Iterator[tuple[str, str]]:
        for number, (what, make) in enumerate(FOLDERS.items()):
            folder = tmp_path / f"{number}"
            folder.mkdir()
            yield what, read(make(folder))
            odd_submissions.remove(folder)

    golden.compare(EXPECTED / "folders", story(rows()))


@pytest.mark.parametrize("make", [zips, tars])
def test_archives(tmp_path: Path, make: Callable[[], Iterator[Archive]]) -> None:
    def rows() -> Iterator[tuple[str, str]]:
        for what, name, data in make():
            (tmp_path / name).write_bytes(data)
            yield what, read(tmp_path / name)

    golden.compare(EXPECTED / make.__name__, story(rows()))


# --- changes while it is read ---


def removed(path: Path) -> None:
    path.unlink()


def a_link(path: Path) -> None:
    path.unlink()
    path.symlink_to("/etc/passwd")


def a_pipe(path: Path) -> None:
    path.unlink()
    os.mkfifo(path)


def in_a_link_to_a_folder(path: Path) -> None:
    elsewhere = path.parent.parent / "elsewhere"
    shutil.move(path.parent, elsewhere)
    path.parent.symlink_to(elsewhere)


def larger(path: Path) -> None:
    path.write_bytes(b" " * 2 * entry.LARGEST_SOURCE)


def test_a_folder_that_changes_while_it_is_read_leads_nowhere_else(tmp_path: Path) -> None:
    def rows() -> Iterator[tuple[str, str]]:
        for change in (removed, a_link, a_pipe, in_a_link_to_a_folder, larger):
            folder = tmp_path / change.__name__
            write(folder, {"src/part1_contacts.cpp": b"int x;", "README": b""})
            with intake.opened(folder) as entries:
                change(folder / "src" / "part1_contacts.cpp")
                words = taken_or_refused(folder, lambda: submission.take(folder, entries))
            yield change.__name__.replace("_", " "), words

    golden.compare(EXPECTED / "changes", story(rows()))


def test_a_zip_that_is_replaced_while_it_is_read_stays_the_first_one(tmp_path: Path) -> None:
    path = zip_of(tmp_path / "x.zip", {"part1_contacts.cpp": b"int first;"})
    second = zip_of(tmp_path / "y.zip", {"part1_contacts.cpp": b"int second;"})
    with intake.opened(path) as entries:
        second.replace(path)
        assert submission.take(path, entries).files["part1_contacts.cpp"] == b"int first;"


def test_the_name_of_a_submission_is_its_content(tmp_path: Path) -> None:
    files = odd_submissions.PARTS
    first = submission.read(write(tmp_path / "a", files))
    again = submission.read(write(tmp_path / "b", files))
    other = submission.read(write(tmp_path / "c", files | {"part2_lcp.cpp": b"\n"}))
    odd = first._replace(files={**first.files, "L\udcf6sung.hpp": b""})
    assert first.sha256 == again.sha256
    assert len({first.sha256, other.sha256, odd.sha256, odd._replace(files={}).sha256}) == 4


def test_a_hostile_path_moves_no_cursor_and_writes_no_line(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "bounce_grader", "grade", f"{tmp_path}/\x1b[2J\n::error::x\udcff"],
        env={**os.environ, "PYTHONPATH": str(ROOT / "grader")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2 and done.stdout == ""
    assert done.stderr.startswith("kit: there is no file or folder")
    assert "\x1b" not in done.stderr and "\n::" not in done.stderr
