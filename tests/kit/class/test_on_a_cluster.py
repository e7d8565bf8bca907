"""A Dask cluster that can't grade, or is lost."""

import threading
from pathlib import Path

import classes
import pytest
import stand_in
from clusters import Cluster
from waiting import wait_for

pytestmark = pytest.mark.long


def test_a_dask_that_cannot_grade_is_said(
    cluster: Cluster, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    source, out = classes.download(tmp_path / "x.zip", [101]), tmp_path / "out"
    assert stand_in.grade_class(source, out, "--dask", "tcp://127.0.0.1:9") == 2
    assert "no Dask scheduler answers at tcp://127.0.0.1:9" in capsys.readouterr().err
    cluster.worker(path="")
    assert stand_in.grade_class(source, out, "--dask", cluster.address) == 2
    assert "start them with PYTHONPATH=KIT/grader" in capsys.readouterr().err


def test_a_scheduler_that_dies_is_said_and_costs_nothing(
    cluster: Cluster, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    source, out = classes.download(tmp_path / "x.zip", list(range(101, 121))), tmp_path / "out"
    cluster.worker()

    def kill_scheduler() -> None:
        wait_for(lambda: len(classes.keys(out)) >= 3)
        cluster.processes[0].kill()

    killer = threading.Thread(target=kill_scheduler)
    killer.start()
    assert stand_in.grade_class(source, out, "--dask", cluster.address, seconds=0.3) == 3
    assert "the Dask scheduler was lost: start it, and run the same" in capsys.readouterr().err
    killer.join()
    assert len(classes.keys(out)) >= 3
    assert stand_in.grade_class(source, out) == 0
    assert stand_in.grade_class(source, tmp_path / "calm") == 0
    assert classes.same(out, tmp_path / "calm")
