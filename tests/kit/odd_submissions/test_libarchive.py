"""What libarchive's bsdtar unpacks in a box: that it does so for each kind of archive, and reaches
nothing else, and that all archives of a submission have one limit."""

import os
import subprocess
from pathlib import Path

import pytest
from bounce_grader.common.errors import KitError
from bounce_grader.sandbox import box, processes
from bounce_grader.sandbox.box import Box
from bounce_grader.sandbox.processes import Limits, Result
from bounce_grader.submission import submission
from conftest import Patch, solution_files, write
from corpus import Member, zip_of
from handed_in import packed_tar, refusal, zipped


def packed(path: Path, files: dict[str, bytes], *options: str) -> Path:
    folder = write(path.parent / "files", files)
    command = ["bsdtar", "-cf", str(path), *options, "-C", str(folder), "."]
    subprocess.run(command, env={"LC_ALL": "C.UTF-8", "PATH": os.defpath}, check=True)
    return path


@pytest.fixture(params=["full", "reduced"])
def kind(request: pytest.FixtureRequest, monkeypatch: Patch) -> str:
    """The kind of box that archives are unpacked in."""
    if problem := box.problem_of(Box(request.param)):
        pytest.skip(problem)
    monkeypatch.setattr(box, "choose", lambda: Box(request.param))
    return str(request.param)


@pytest.mark.parametrize("ending", ["7z", "tar.zst", "tar.xz"])
def test_archives_are_read_in_a_box(tmp_path: Path, kind: str, ending: str) -> None:
    files = {f"src/{name}": text for name, text in solution_files().items()}
    path = packed(tmp_path / f"x.{ending}", {**files, "größe.hpp": b"// x", "e.hpp": b""}, "-a")
    taken = submission.read(path)
    assert len(taken.parts) == 4
    assert (taken.files["größe.hpp"], taken.files["e.hpp"]) == (b"// x", b"")
    assert submission.read(path.rename(tmp_path / "x.zip")).files == taken.files


def test_an_archive_that_asks_for_a_file_gets_none(tmp_path: Path, kind: str) -> None:
    """An mtree may say where the content of an entry lies."""
    for target in ("/etc/passwd", "/proc/1/environ", "/proc/self/environ", __file__):
        asking = f"#mtree\npart1_contacts.cpp type=file mode=644 size=20 contents={target}\n"
        (tmp_path / "x.tar").write_text(asking)
        assert "Can't open" in refusal(tmp_path / "x.tar")


def test_all_archives_of_a_submission_share_their_time(tmp_path: Path, monkeypatch: Patch) -> None:
    asked = []

    def run(command: list[str], limits: Limits, **_: object) -> Result:
        asked.append(limits.cpu_seconds)
        return Result(0, 4.0, zip_of([Member(b"a.txt")]), "", False, False)

    monkeypatch.setattr(box, "choose", lambda: Box("none"))
    monkeypatch.setattr(processes, "run", run)
    whole = zipped(tmp_path / "x.zip", {f"{i}.7z": b"7z\xbc\xaf\x27\x1c" for i in range(3)})
    assert "too much time" in refusal(whole)
    assert asked == [10, 6, 2]


def test_nothing_is_unpacked_without_a_box(tmp_path: Path, monkeypatch: Patch) -> None:
    def choose() -> Box:
        raise KitError("no box can be had here")

    monkeypatch.setattr(box, "choose", choose)
    (tmp_path / "x.tar").write_bytes(packed_tar(solution_files(), ""))
    assert "a zip would be: no box can be had here" in refusal(tmp_path / "x.tar")
