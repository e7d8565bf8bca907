"""A class that is stopped, killed or out of disk: nothing is lost, and the same command goes on."""

import os
import random
import signal
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from bounce_grader.classroom.grading import results
from bounce_grader.classroom.intake import students
from classes import COLUMN, book, download, graded, points_of, same, scores
from conftest import write
from stand_in import grade_class, started
from waiting import wait_for


def test_ctrl_c_stops_and_says_how_to_go_on(
    tmp_path: Path,
    users: list[int],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """And leaves no temporary folder."""
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    own = tmp_path / "temporary"
    own.mkdir()
    monkeypatch.setenv("TMPDIR", str(own))
    with started(source, out, seconds=2) as process:
        wait_for(lambda: len(results.keys(out / "results")) >= 2)
        assert grade_class(source, out) == 2
        assert "another run is under way" in capsys.readouterr().err
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=30)
        assert not list(own.glob("bounce-*"))
    assert process.returncode != 0
    assert "what is graded is kept. Run the same command again to go on." in said
    assert out.stat().st_mode & 0o077 == 0  # it holds points and answers
    there = results.keys(out / "results")
    assert 2 <= len(there) < 10
    assert grade_class(source, out) == 0
    assert len(graded(out)) == 10 and there <= set(graded(out))


def test_gradings_end_with_the_class(tmp_path: Path, users: list[int]) -> None:
    """If the class is killed, no grading goes on."""
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    with started(source, out, seconds=2.0):
        wait_for(lambda: len(results.keys(out / "results")) >= 1)
    there = results.keys(out / "results")
    time.sleep(3.0)
    assert results.keys(out / "results") == there


@pytest.mark.parametrize("number, kills", [(20, 4), pytest.param(99, 20, marks=pytest.mark.long)])
def test_survives_being_killed_at_any_moment(tmp_path: Path, number: int, kills: int) -> None:
    """No result is lost, half or there twice, and the grade book is as if undisturbed."""
    users = list(range(101, 101 + number))
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    export, chance = book(tmp_path / "export.csv", users), random.Random(number)
    known: set[str] = set()
    for _ in range(kills):
        with started(source, out, seconds=0.02):
            time.sleep(chance.uniform(0.05, 1.5))
        there = results.keys(out / "results")
        assert known <= there and all(results.load(out / "results", key) for key in there)
        known = there
    grade_class(source, out, "--gradebook", str(export), "--column", COLUMN)
    assert len(graded(out)) == number
    grade_class(source, tmp_path / "calm", "--gradebook", str(export), "--column", COLUMN)
    assert same(out, tmp_path / "calm")
    for file in out.rglob(".*.part"):
        os.utime(file, (0, 0))
    grade_class(source, out)
    assert not list(out.rglob(".*.part"))


def test_a_grading_that_kills_its_worker_costs_nobody_else(
    tmp_path: Path, users: list[int], capsys: pytest.CaptureFixture[str]
) -> None:
    bad, out = {"roe_301_3010_part2_lcp.cpp": b"// kills its grader"}, tmp_path / "out"
    assert grade_class(download(tmp_path / "x.zip", users, bad), out) == 3
    said = capsys.readouterr().out
    assert "roe (301): the kit failed, so" in said and "process that graded it was killed" in said
    assert scores(out) == points_of(users)
    assert not any("roe" in page.name for page in (out / "feedback").iterdir())


def test_a_broken_result_is_graded_again(tmp_path: Path, users: list[int]) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    grade_class(source, out)
    torn, empty, *_ = sorted(f for f in (out / "results").iterdir() if f.name != "set.json")
    torn.write_bytes(torn.read_bytes()[:100])
    empty.write_bytes(b"")
    grade_class(source, out)
    assert scores(out) == points_of(users)


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


def test_a_full_disk_loses_nothing(
    tmp_path: Path, users: list[int], small_disk: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    source, out = download(tmp_path / "x.zip", users), small_disk / "out"
    grade_class(download(tmp_path / "y.zip", users[:4]), out)
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
    for key in results.keys(out / "results"):
        assert results.load(out / "results", key)
    filler.unlink()
    assert grade_class(source, out) == 0
    assert scores(out) == points_of(users)
    assert len(graded(out)) == 10


# --- which results are kept ---


def test_a_result_is_named_by_all_that_it_follows_from(tmp_path: Path) -> None:
    stamp = results.Stamp("kit", "fixtures")
    others: list[dict[str, Any]] = [
        {"kit": "2"},
        {"fixtures": "2"},
        {"trust": True},
        {"sanitize": True},
    ]
    stamps = [stamp, *(stamp._replace(**other) for other in others)]
    keys = set()
    for text in (b"// x", b"// y", b"// x"):
        write(tmp_path, {"all/anna/part2_lcp.cpp": text})
        (student,) = students.read(tmp_path / "all").students
        keys |= {results.task_of(student, one, tmp_path, False).key for one in stamps}
    assert len(keys) == 10


PACKAGE = "grader/bounce_grader"
MAKES_RESULTS = [f"{PACKAGE}/grading/judging.py", f"{PACKAGE}/classroom/grading/unit.py"]
MAKES_RESULTS += ["grader/runner/prelude.hpp", "grader/parts.json", "tests/parts/cases.cpp"]
SHOWS_RESULTS = [f"{PACKAGE}/formats/html.py", "tests/kit/judge/judge_test.cpp"]


def test_another_kit_is_known_wherever_it_lies(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Even in a folder with the name of one of the kit's own."""
    root = tmp_path / "classroom" / "formats"
    monkeypatch.setattr(results, "ROOT", root)
    write(root, dict.fromkeys([*MAKES_RESULTS, *SHOWS_RESULTS], b"0"))
    before = results._kit_digest()
    write(root, dict.fromkeys(SHOWS_RESULTS, b"changed"))
    assert results._kit_digest() == before
    for name in MAKES_RESULTS:
        write(root, {name: b"2"})
        assert results._kit_digest() != before, name
        write(root, {name: b"0"})
