"""Whole classes with real gradings: on one machine and on a cluster, and with every tenth student
attacking."""

import random
import threading
from collections.abc import Sequence
from pathlib import Path

import classes
import pytest
from bounce_grader import cli
from bounce_grader.grading.known_mistakes import expected
from classes import column, COLUMN, same
from clusters import Cluster
from conftest import ROOT
from handed_in import points_without, submission_of
from waiting import wait_for


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
    """What the column of the grade book has, by id."""
    options = ["--out", str(folder / out), "--gradebook", str(folder / "export.csv")]
    words = ["class", str(folder / "submissions"), *options, "--column", COLUMN, *more]
    assert cli.main(words) == 0
    return column(folder / out / "gradebook.csv")


@pytest.mark.long
def test_a_class_is_the_same_on_a_cluster_that_loses_a_worker(
    cluster: Cluster, tmp_path: Path
) -> None:
    made = chosen(30, "accepted", "mistakes", "broken")
    assert written(tmp_path, made) == grade(tmp_path, "local")
    lost = cluster.worker()
    cluster.worker()
    results = tmp_path / "dask" / "results"

    def kill_worker() -> None:
        wait_for(lambda: list(results.glob("*.json")))
        lost.kill()

    killer = threading.Thread(target=kill_worker)
    killer.start()
    grade(tmp_path, "dask", "--dask", cluster.address)
    killer.join()
    assert same(tmp_path / "dask", tmp_path / "local")


@pytest.mark.parametrize("number", [10, 100])
@pytest.mark.long
def test_an_attacker_in_ten_costs_the_others_nothing(tmp_path: Path, number: int) -> None:
    honest, hostile = chosen(number, "accepted", "mistakes"), chosen(number // 10, "hostile")
    mixed = [hostile[i // 10] if i % 10 == 9 else one for i, one in enumerate(honest)]
    assert written(tmp_path, mixed) == grade(tmp_path, "out")
