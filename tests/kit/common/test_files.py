"""Temporary folders: those of killed processes go, those of running ones stay. And files are
written where they should be."""

import os
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest
from bounce_grader.common import files
from bounce_grader.common.paths import WORK_FOLDER
from conftest import ROOT

HOLDER = f"""
import sys, time
sys.path.insert(0, {str(ROOT / "grader")!r})
from bounce_grader.common.files import temporary_folder
with temporary_folder({WORK_FOLDER!r}) as folder:
    print(folder, flush=True)
    time.sleep(600)
"""


def test_what_a_killed_grading_left_goes_with_the_next_one_and_nothing_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    (tmp_path / "mine").mkdir()
    (tmp_path / f"{WORK_FOLDER}file").touch()
    (tmp_path / f"{WORK_FOLDER}link").symlink_to(tmp_path / "mine")
    ours = set(tmp_path.iterdir())
    command = [sys.executable, "-c", HOLDER]
    environment = {"TMPDIR": str(tmp_path)}
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment) as holder:
        assert holder.stdout
        folder = Path(holder.stdout.readline().strip())
        (folder / "sources").mkdir()
        files.remove_unlocked()
        assert (folder / "sources").is_dir()
        holder.send_signal(signal.SIGKILL)
    assert folder.is_dir()
    files.remove_unlocked()
    assert set(tmp_path.iterdir()) == ours


def test_no_link_that_somebody_left_is_followed_when_a_file_is_written(tmp_path: Path) -> None:
    victim = tmp_path / "victim"
    victim.write_text("whole")
    for name in ("record.json", f".record.json.{os.getpid()}.part"):
        (tmp_path / name).symlink_to(victim)
    files.write_whole(tmp_path / "record.json", "new")
    assert victim.read_text() == "whole"
    assert not (tmp_path / "record.json").is_symlink()
    assert (tmp_path / "record.json").read_text() == "new"


def test_a_write_that_is_stopped_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Path, "replace", lambda *_: sys.exit(143))  # as SIGTERM does
    with pytest.raises(SystemExit):
        files.write_whole(tmp_path / "record.json", "new")
    assert not list(tmp_path.iterdir())
