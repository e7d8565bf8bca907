"""Temporary folders: those of killed gradings go. And files are written where they should be."""

import os
import sys
import tempfile
from pathlib import Path

import pytest
from bounce_grader.common import files
from bounce_grader.common.paths import WORK_FOLDER
from conftest import Patch, write


def test_what_a_killed_grading_left_goes_after_an_hour(tmp_path: Path, monkeypatch: Patch) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    write(tmp_path / "mine", {"x": b""})
    (tmp_path / f"{WORK_FOLDER}link").symlink_to(tmp_path / "mine")
    with files.temporary_folder() as running:
        left = write(tmp_path / f"{WORK_FOLDER}left", {"sources/x.cpp": b""})
        for path in (left, tmp_path / "mine"):
            os.utime(path, (0, 0))
        files.remove_abandoned()
        assert Path(running).is_dir() and not left.exists() and (tmp_path / "mine" / "x").exists()


def test_no_link_that_somebody_left_is_followed_when_a_file_is_written(tmp_path: Path) -> None:
    victim = tmp_path / "victim"
    victim.write_text("whole")
    for name in ("record.json", f".record.json.{os.getpid()}.part"):
        (tmp_path / name).symlink_to(victim)
    files.write_whole(tmp_path / "record.json", "new")
    assert victim.read_text() == "whole"
    assert not (tmp_path / "record.json").is_symlink()
    assert (tmp_path / "record.json").read_text() == "new"


def test_a_write_that_is_stopped_leaves_nothing(tmp_path: Path, monkeypatch: Patch) -> None:
    monkeypatch.setattr(Path, "replace", lambda *_: sys.exit(143))  # as SIGTERM does
    with pytest.raises(SystemExit):
        files.write_whole(tmp_path / "record.json", "new")
    assert not list(tmp_path.iterdir())
