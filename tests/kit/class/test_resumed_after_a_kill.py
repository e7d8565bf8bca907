"""A class that is stopped, killed or out of disk: nothing is lost, and the same command goes on."""

import os
import random
import signal
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from bounce_grader.classroom.grading.results import load
from classes import COLUMN, book, download, graded, keys, points_of, same, scores, USERS
from conftest import Patch, Printed
from stand_in import grade_class, started
from waiting import wait_for


def test_ctrl_c_says_how_to_go_on(tmp_path: Path, monkeypatch: Patch, capsys: Printed) -> None:
    """And leaves no temporary folder."""
    source, out = download(tmp_path / "x.zip", USERS), tmp_path / "out"
    own = tmp_path / "temporary"
    own.mkdir()
    monkeypatch.setenv("TMPDIR", str(own))
    with started(source, out, seconds=2) as process:
        wait_for(lambda: len(keys(out)) >= 2)
        assert grade_class(source, out) == 2
        assert "another run is under way" in capsys.readouterr().err
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=30)
        assert not list(own.glob("bounce-*"))
    assert process.returncode != 0
    assert "kit: stopped; the same command goes on from here" in said
    assert out.stat().st_mode & 0o077 == 0  # it holds points and answers
    there = keys(out)
    assert 2 <= len(there) < 10
    assert grade_class(source, out) == 0
    assert len(graded(out)) == 10 and there <= set(graded(out))


def test_gradings_end_with_the_class(tmp_path: Path) -> None:
    """If the class is killed, no grading goes on."""
    source, out = download(tmp_path / "x.zip", USERS), tmp_path / "out"
    with started(source, out, seconds=2.0):
        wait_for(lambda: len(keys(out)) >= 1)
    there = keys(out)
    time.sleep(3.0)
    assert keys(out) == there


@pytest.mark.parametrize("number, kills", [(20, 4), pytest.param(99, 20, marks=pytest.mark.long)])
def test_survives_being_killed_at_any_moment(tmp_path: Path, number: int, kills: int) -> None:
    """No result is lost, half or there twice, and the gradebook is as if undisturbed."""
    users = list(range(101, 101 + number))
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    export, chance = book(tmp_path / "export.csv", users), random.Random(number)
    known: set[str] = set()
    for _ in range(kills):
        with started(source, out, seconds=0.02):
            time.sleep(chance.uniform(0.05, 1.5))
        there = keys(out)
        assert known <= there and all(load(out / "results", key) for key in there)
        known = there
    grade_class(source, out, "--gradebook", str(export), "--column", COLUMN)
    assert len(graded(out)) == number
    grade_class(source, tmp_path / "calm", "--gradebook", str(export), "--column", COLUMN)
    assert same(out, tmp_path / "calm")
    for file in out.rglob(".*.part"):
        os.utime(file, (0, 0))
    grade_class(source, out)
    assert not list(out.rglob(".*.part"))


def test_a_killed_worker_costs_no_other(tmp_path: Path, capsys: Printed) -> None:
    bad, out = {"roe_301_3010_part2_lcp.cpp": b"// kills its grader"}, tmp_path / "out"
    assert grade_class(download(tmp_path / "x.zip", USERS, bad), out) == 3
    said = capsys.readouterr().out
    assert "roe (301): the kit failed, so" in said and "process that graded it was killed" in said
    assert scores(out) == points_of(USERS)
    assert not any("roe" in page.name for page in (out / "feedback").iterdir())


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """A file system of half a megabyte."""
    folder = tmp_path / "disk"
    folder.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=512k", "tmpfs", str(folder)]
    if subprocess.run(mount, capture_output=True, check=False).returncode != 0:
        pytest.skip("mounting needs root")
    yield folder
    subprocess.run(["umount", str(folder)], check=True)


def test_a_full_disk_loses_nothing(tmp_path: Path, small_disk: Path, capsys: Printed) -> None:
    source, out = download(tmp_path / "x.zip", USERS), small_disk / "out"
    grade_class(download(tmp_path / "y.zip", USERS[:4]), out)
    before = {f: f.read_bytes() for f in out.rglob("*.json")}
    filler = small_disk / "filler"
    with pytest.raises(OSError), filler.open("wb", buffering=0) as file:
        while True:
            file.write(bytes(1024))
    capsys.readouterr()
    assert grade_class(source, out) == 3
    assert "is full: make room, and run the same command again" in capsys.readouterr().err
    for kept, data in before.items():
        assert kept.read_bytes() == data
    for key in keys(out):
        assert load(out / "results", key)
    filler.unlink()
    assert grade_class(source, out) == 0
    assert scores(out) == points_of(USERS)
    assert len(graded(out)) == 10
