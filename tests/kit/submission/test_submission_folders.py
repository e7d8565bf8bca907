"""Folders that aren't what they seem: links, pipes, deep folders, and changes while they are
read."""

import os
import shutil
import subprocess
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest
from bounce_grader.common.errors import UsageError
from bounce_grader.submission import entry, intake, submission
from conftest import solution_files, write
from handed_in import PARTS, refusal, zip_of


def test_an_empty_folder_is_said(tmp_path: Path) -> None:
    assert "is empty" in refusal(tmp_path)


def test_links_are_never_followed(tmp_path: Path) -> None:
    secret = tmp_path / "secret.cpp"
    secret.write_text("a secret")
    folder = write(tmp_path / "submission", solution_files())
    (folder / "helper.cpp").symlink_to(secret)
    os.mkfifo(folder / "pipe.cpp")
    archive = zipfile.ZipInfo("part1_contacts.cpp")
    archive.external_attr = 0o120777 << 16
    with zipfile.ZipFile(tmp_path / "x.zip", "w") as out:
        out.writestr(archive, str(secret))
        out.writestr("part2_lcp.cpp", "int x;")
    assert {"helper.cpp", "pipe.cpp"} <= set(submission.read(folder).ignored)
    assert set(submission.read(tmp_path / "x.zip").parts) == {2}


@pytest.mark.parametrize("path", ["/dev/zero", "/dev/null", "pipe"])
def test_a_device_or_a_pipe_is_not_opened(tmp_path: Path, path: str) -> None:
    os.mkfifo(tmp_path / "pipe")
    assert "neither a folder nor a zip" in refusal(tmp_path / path)


def test_a_folder_of_folders_without_end_is_refused(tmp_path: Path) -> None:
    for i in range(entry.MOST_ENTRIES + 1):
        (tmp_path / f"{i}").mkdir()
    assert "more than" in refusal(tmp_path)


def test_a_very_deep_folder_is_read_to_a_depth(tmp_path: Path) -> None:
    write(tmp_path, solution_files())
    here = os.open(tmp_path, os.O_RDONLY)
    for _ in range(3000):  # deeper than a path can be long
        os.mkdir("d", dir_fd=here)
        below = os.open("d", os.O_RDONLY, dir_fd=here)
        os.close(here)
        here = below
    os.close(here)
    assert set(submission.read(tmp_path).files) == PARTS
    subprocess.run(["rm", "-rf", tmp_path / "d"], check=True)


# --- changes while it is read ---


def nothing_instead(path: Path) -> None:
    path.unlink()


def link_instead(path: Path) -> None:
    path.unlink()
    path.symlink_to("/etc/passwd")


def pipe_instead(path: Path) -> None:
    path.unlink()
    os.mkfifo(path)


def folder_link_instead(path: Path) -> None:
    elsewhere = path.parent.parent / "elsewhere"
    shutil.move(path.parent, elsewhere)
    path.parent.symlink_to(elsewhere)


def larger_instead(path: Path) -> None:
    path.write_bytes(b" " * 2 * entry.LARGEST_SOURCE)


CHANGES: list[Callable[[Path], None]] = [
    nothing_instead,
    link_instead,
    pipe_instead,
    folder_link_instead,
]


@pytest.mark.parametrize("change", CHANGES)
def test_a_folder_that_changes_while_it_is_read_leads_nowhere_else(
    tmp_path: Path, change: Callable[[Path], None]
) -> None:
    write(tmp_path / "x", {"src/part1_contacts.cpp": b"int x;", "README": b""})
    with intake.opened(tmp_path / "x") as entries:
        change(tmp_path / "x" / "src" / "part1_contacts.cpp")
        with pytest.raises(UsageError, match="src/part1_contacts.cpp can't be read: "):
            submission.take(tmp_path, entries)


def test_a_file_that_grows_while_it_is_read_is_no_source(tmp_path: Path) -> None:
    write(tmp_path, {"part1_contacts.cpp": b"int x;"})
    with intake.opened(tmp_path) as entries:
        larger_instead(tmp_path / "part1_contacts.cpp")
        assert "larger than it says" in submission.take(tmp_path, entries).refused[1]


def test_a_zip_that_is_replaced_while_it_is_read_stays_the_first_one(tmp_path: Path) -> None:
    path = zip_of(tmp_path / "x.zip", {"part1_contacts.cpp": b"int first;"})
    second = zip_of(tmp_path / "y.zip", {"part1_contacts.cpp": b"int second;"})
    with intake.opened(path) as entries:
        second.replace(path)
        assert submission.take(path, entries).files["part1_contacts.cpp"] == b"int first;"
