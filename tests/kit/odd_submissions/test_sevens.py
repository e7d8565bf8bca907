"""7-Zip's archives, which its own program unpacks in a box."""

import os
import subprocess
import time
from pathlib import Path

import pytest
from bounce_grader.sandbox import box, processes
from bounce_grader.sandbox.box import Box
from bounce_grader.sandbox.processes import Limits, Result
from bounce_grader.submission import sevens, submission, unpack_limits
from bounce_grader.submission.entry import MOST_ENTRIES
from conftest import solution_files, write
from handed_in import refusal, zipped

HERE = [program for program in sevens.PROGRAMS if os.path.isfile(program)]
needs_7zip = pytest.mark.skipif(not HERE, reason="needs 7-Zip: apt-get install 7zip")


def seven_of(path: Path, files: dict[str, bytes], *options: str) -> Path:
    folder = write(path.parent / "files", files)
    subprocess.run([HERE[0], "a", "-bso0", *options, path, "."], cwd=folder, check=True)
    return path


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
def test_a_7z_that_cannot_be_unpacked_is_refused(tmp_path: Path) -> None:
    bomb = {"part1_contacts.cpp": bytes(unpack_limits.LARGEST + 1)}
    assert "more than 64 MB unpacked" in refusal(seven_of(tmp_path / "bomb.7z", bomb))
    for hidden in ("-mhe=off", "-mhe=on"):
        locked = seven_of(tmp_path / f"{hidden}.7z", solution_files(), "-psecret", hidden)
        assert "password" in refusal(locked)
    path = seven_of(tmp_path / "x.7z", solution_files())
    path.write_bytes(path.read_bytes()[:-20])
    assert "broken" in refusal(path)


@needs_7zip
def test_files_of_a_7z_are_taken_apart_without_copies_of_the_rest(tmp_path: Path) -> None:
    """The rest was copied for each file: minutes for five thousand before a large one."""
    sources = {f"{i}.txt": b"x" for i in range(MOST_ENTRIES - 2)}
    sources["part1_contacts.cpp"] = b"int x;\n"
    sources["large.txt"] = bytes(unpack_limits.LARGEST - 10_000)
    path = seven_of(tmp_path / "x.7z", sources)
    start = time.process_time()
    assert submission.read(path).files == {"part1_contacts.cpp": b"int x;\n"}
    assert time.process_time() - start < 10
    assert "more than 5000 files" in refusal(seven_of(tmp_path / "y.7z", {"a": b"", "b": b""}))


def test_the_7z_archives_of_a_submission_share_their_time(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Ten uploads may hold forty, each of which could take ten seconds."""
    asked = []

    def run(command: list[str], limits: Limits, **_: object) -> Result:
        asked.append(limits.cpu_seconds)
        listed = b"Path = a.txt\nSize = 1\nAttributes = A -rw-r--r--\nCRC = 8CDC1683\n\n"
        return Result(0, 3.0, listed if "l" in command else b"x", "", False, False)

    monkeypatch.setattr(sevens, "_program", lambda path: "7zz")
    monkeypatch.setattr(box, "choose", lambda: Box("none"))
    monkeypatch.setattr(processes, "run", run)
    whole = zipped(tmp_path / "x.zip", {f"{i}.7z": b"7z\xbc\xaf\x27\x1c" for i in range(3)})
    assert "too much time" in refusal(whole)
    assert asked == [10, 7, 4, 1]
