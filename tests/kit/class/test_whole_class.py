"""Whole classes with real gradings: on one machine and on a cluster, and with every tenth student
attacking."""

from collections.abc import Sequence
from pathlib import Path

import pytest
from bounce_grader import cli
from bounce_grader.develop import synthetic_class
from bounce_grader.develop.synthetic_class import Made
from classes import column, COLUMN, same
from clusters import Cluster


def grade(folder: Path, out: str, *more: str) -> dict[str, str]:
    """What the column of the grade book has, by id."""
    options = ["--out", str(folder / out), "--gradebook", str(folder / "export.csv")]
    words = ["class", str(folder / "submissions.zip"), *options, "--column", COLUMN, *more]
    assert cli.main(words) == 0
    return column(folder / out / "gradebook.csv")


def written(folder: Path, made: Sequence[Made]) -> dict[str, str]:
    """Writes the download and the export, and returns the points that should come out."""
    synthetic_class.canvas_zip(folder / "submissions.zip", made)
    (folder / "export.csv").write_text(synthetic_class.gradebook_csv(made))
    return {str(student.user): f"{student.points:.2f}" for student in made}


@pytest.mark.long
def test_a_class_is_the_same_on_a_cluster(cluster: Cluster, tmp_path: Path) -> None:
    made = list(synthetic_class.students(30, ("accepted", "mistakes", "broken"), 6001))
    assert written(tmp_path, made) == grade(tmp_path, "local")
    cluster.worker()
    cluster.worker()
    grade(tmp_path, "dask", "--dask", cluster.address)
    assert same(tmp_path / "dask", tmp_path / "local")


@pytest.mark.parametrize("number", [10, 100])
@pytest.mark.long
def test_an_attacker_in_ten_costs_the_others_nothing(tmp_path: Path, number: int) -> None:
    made = list(synthetic_class.students(number, ("accepted", "mistakes"), 6001))
    hostile = list(synthetic_class.students(number // 10, ("hostile",), 6901))
    mixed = [hostile[i // 10] if i % 10 == 9 else student for i, student in enumerate(made)]
    assert written(tmp_path, mixed) == grade(tmp_path, "out")
