"""What kind an archive is, by its bytes; and 7-Zip's, which its own program unpacks."""

import os
import subprocess
from pathlib import Path

import pytest
from bounce_grader.common.errors import UsageError
from bounce_grader.sandbox import box
from bounce_grader.sandbox.box import Box
from bounce_grader.submission import sevens, submission
from conftest import solution_files, write
from handed_in import refusal, zip_of

HERE = [program for program in sevens.PROGRAMS if os.path.isfile(program)]
needs_7zip = pytest.mark.skipif(not HERE, reason="needs 7-Zip: apt-get install 7zip")


def seven_of(path: Path, files: dict[str, bytes], *options: str) -> Path:
    folder = write(path.parent / "files", files)
    subprocess.run([HERE[0], "a", "-bso0", *options, path, "."], cwd=folder, check=True)
    return path


@pytest.mark.parametrize("name", ["x.zip", "x.rar", "x.7z"])
def test_a_rar_is_named_whatever_its_ending(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_bytes(b"Rar!\x1a\x07\x01\x00" + bytes(100))
    assert "is a RAR archive" in refusal(tmp_path / name)
    assert "as files, or as one zip" in refusal(tmp_path / name)


@pytest.mark.parametrize("name", ["x.tar.gz", "x.7z"])
def test_a_zip_is_read_whatever_its_ending(tmp_path: Path, name: str) -> None:
    assert len(submission.read(zip_of(tmp_path / name, solution_files())).parts) == 4


def test_says_what_is_missing_to_open_a_7z(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sevens, "PROGRAMS", ())
    (tmp_path / "x.7z").write_bytes(b"7z\xbc\xaf\x27\x1c" + bytes(100))
    assert "submit a zip" in refusal(tmp_path / "x.7z")
    assert "apt-get install 7zip" in refusal(tmp_path / "x.7z")


@needs_7zip
@pytest.mark.parametrize("kind", ["full", "reduced"])
def test_a_7z_is_read_in_a_box(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, kind: str) -> None:
    if problem := box.problem_of(Box(kind)):
        pytest.skip(problem)
    monkeypatch.setattr(box, "choose", lambda: Box(kind))
    files = {f"src/{name}": text for name, text in solution_files().items()}
    path = seven_of(tmp_path / "x.7z", {**files, "größe.hpp": b"// x", "empty.hpp": b""})
    taken = submission.read(path)
    assert len(taken.parts) == 4 and taken.files["größe.hpp"] == b"// x"
    assert submission.read(path.rename(tmp_path / "x.zip")).files == taken.files


@needs_7zip
def test_a_7z_that_cannot_be_unpacked_is_said(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    path = seven_of(tmp_path / "a" / "x.7z", solution_files())
    path.write_bytes(path.read_bytes()[:-20])
    assert "broken" in refusal(path)
    for number, hidden in enumerate(("-mhe=off", "-mhe=on")):
        (tmp_path / str(number)).mkdir()
        locked = tmp_path / str(number) / "x.7z"
        assert "password" in refusal(seven_of(locked, solution_files(), "-psecret", hidden))


@needs_7zip
def test_a_7z_that_is_a_bomb_is_refused(tmp_path: Path) -> None:
    bomb = {"part1_contacts.cpp": bytes(sevens.LARGEST + 1)}
    with pytest.raises(UsageError, match="unpacks to more than 64 MB"):
        submission.read(seven_of(tmp_path / "x.7z", bomb))
