"""The same class through Dask: the same results as with the built-in workers."""

import random
import signal
import threading
import time
from pathlib import Path

import classes
import pytest
import stand_in
from bounce_grader.classroom.grading import results
from clusters import Cluster
from waiting import wait_for

pytestmark = pytest.mark.long


def download(path: Path, number: int) -> Path:
    return classes.download(path, list(range(101, 101 + number)))


def same(out: Path, source: Path, tmp_path: Path) -> bool:
    """Whether the results are those of the built-in engine."""
    assert stand_in.grade_class(source, tmp_path / "calm") == 0
    return classes.same(out, tmp_path / "calm")


def test_dask_survives_workers_that_are_killed(cluster: Cluster, tmp_path: Path) -> None:
    source, out = download(tmp_path / "x.zip", 40), tmp_path / "out"
    first, second = cluster.worker(), cluster.worker()
    with stand_in.started(source, out, 0.2, "--dask", cluster.address) as the_class:
        chance = random.Random(1)
        for worker in (first, second):
            there = len(results.keys(out / "results")) if out.exists() else 0
            wait_for(lambda: out.exists() and len(results.keys(out / "results")) >= there + 4)
            time.sleep(chance.uniform(0, 0.2))
            worker.send_signal(signal.SIGKILL)
            cluster.worker()
        _, said = the_class.communicate()
    assert the_class.returncode == 0, said
    assert same(out, source, tmp_path)
    assert len(classes.graded(out)) == 40


def test_a_dask_that_cannot_grade_is_said(
    cluster: Cluster, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    source, out = download(tmp_path / "x.zip", 1), tmp_path / "out"
    assert stand_in.grade_class(source, out, "--dask", "tcp://127.0.0.1:9") == 2
    assert "no Dask scheduler answers at tcp://127.0.0.1:9" in capsys.readouterr().err
    cluster.worker(path="")
    cluster.wait_for_worker()
    assert stand_in.grade_class(source, out, "--dask", cluster.address) == 2
    assert "start them with PYTHONPATH=KIT/grader" in capsys.readouterr().err


def test_a_scheduler_that_dies_is_said_and_costs_nothing(
    cluster: Cluster, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    source, out = download(tmp_path / "x.zip", 20), tmp_path / "out"
    cluster.worker()

    def kill_scheduler() -> None:
        wait_for(lambda: len(results.keys(out / "results")) >= 3)
        cluster.processes[0].kill()

    killer = threading.Thread(target=kill_scheduler)
    killer.start()
    assert stand_in.grade_class(source, out, "--dask", cluster.address, seconds=0.3) == 3
    assert "the Dask scheduler was lost: start it, and run the same" in capsys.readouterr().err
    killer.join()
    assert len(results.keys(out / "results")) >= 3
    assert stand_in.grade_class(source, out) == 0
    assert same(out, source, tmp_path)
