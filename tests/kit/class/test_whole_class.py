"""Whole classes: on one machine, on a cluster that loses a part, and with every tenth student
attacking."""

import random
from collections.abc import Sequence
from pathlib import Path

import classes
import pytest
import stand_in
from bounce_grader import cli
from bounce_grader.grading.known_mistakes import expected
from classes import column, COLUMN, same
from clusters import Cluster, killed_once
from conftest import Printed, ROOT
from handed_in import points_without, submission_of

pytestmark = pytest.mark.long


def chosen(number: int, *kinds: str) -> list[Path]:
    """Submissions of the gallery, in a shuffled order."""
    folders = (ROOT / "tests" / "submissions" / kind for kind in kinds)
    every = [one for folder in folders for one in sorted(folder.iterdir()) if one.is_dir()]
    return random.Random(1).sample(every, number)


def written(folder: Path, submissions: Sequence[Path]) -> dict[str, str]:
    """Writes a folder for each student and the export, and returns the points that should come
    out."""
    users = dict(enumerate(submissions, 6001))
    (folder / "submissions").mkdir()
    for user, submission in users.items():
        submission_of(submission, folder / "submissions" / str(user))
    classes.book(folder / "export.csv", list(users))
    points = {user: points_without(expected(s)["lost"]) for user, s in users.items()}
    return {str(user): f"{sum(of):.2f}" for user, of in points.items()}


def grade(folder: Path, out: str, *more: str) -> dict[str, str]:
    """What the column of the gradebook has, by id."""
    options = ["--out", str(folder / out), "--gradebook", str(folder / "export.csv")]
    words = ["class", str(folder / "submissions"), *options, "--column", COLUMN, *more]
    assert cli.main(words) == 0
    return column(folder / out / "gradebook.csv")


def test_a_cluster_that_loses_a_worker_grades_alike(cluster: Cluster, tmp_path: Path) -> None:
    made = chosen(30, "accepted", "mistakes", "broken")
    assert written(tmp_path, made) == grade(tmp_path, "local")
    lost = cluster.worker()
    cluster.worker()
    with killed_once(lambda: classes.keys(tmp_path / "dask"), lost):
        grade(tmp_path, "dask", "--dask", cluster.address)
    assert same(tmp_path / "dask", tmp_path / "local")


@pytest.mark.parametrize("number", [10, 100])
def test_an_attacker_in_ten_costs_the_others_nothing(tmp_path: Path, number: int) -> None:
    honest, hostile = chosen(number, "accepted", "mistakes"), chosen(number // 10, "hostile")
    mixed = [hostile[i // 10] if i % 10 == 9 else one for i, one in enumerate(honest)]
    assert written(tmp_path, mixed) == grade(tmp_path, "out")


def test_a_failing_dask_is_said(cluster: Cluster, tmp_path: Path, capsys: Printed) -> None:
    source, out = classes.download(tmp_path / "x.zip", [101]), tmp_path / "out"
    assert stand_in.grade_class(source, out, "--dask", "tcp://127.0.0.1:9") == 2
    assert "no Dask scheduler answers at tcp://127.0.0.1:9" in capsys.readouterr().err
    cluster.worker(path="")
    assert stand_in.grade_class(source, out, "--dask", cluster.address) == 2
    assert "start them with PYTHONPATH=KIT/grader" in capsys.readouterr().err


def test_a_dead_scheduler_costs_nothing(cluster: Cluster, tmp_path: Path, capsys: Printed) -> None:
    source, out = classes.download(tmp_path / "x.zip", list(range(101, 121))), tmp_path / "out"
    cluster.worker()
    with killed_once(lambda: len(classes.keys(out)) >= 3, cluster.processes[0]):
        assert stand_in.grade_class(source, out, "--dask", cluster.address, seconds=0.3) == 3
    assert "the Dask scheduler was lost: start it, and run the same" in capsys.readouterr().err
    assert len(classes.keys(out)) >= 3
    assert stand_in.grade_class(source, out) == 0
    assert stand_in.grade_class(source, tmp_path / "calm") == 0
    assert same(out, tmp_path / "calm")
