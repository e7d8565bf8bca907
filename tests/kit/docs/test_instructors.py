"""docs/instructors.md: runs its commands as they are written, and checks the files that it
names."""

import csv
import os
import re
import subprocess
import zipfile
from pathlib import Path

import pytest
from bounce_grader.develop import synthetic_class
from bounce_grader.publish import gradescope
from conftest import ROOT, solution_files, write

PAGE = (ROOT / "docs" / "instructors.md").read_text()
WORKFLOW = ROOT / "docs" / "workflows" / "autograding.yml"
COMMANDS = [line.strip() for line in PAGE.splitlines() if line.startswith("    ")]
NOT_HERE = ("SCHEDULER", "course-secret", "./kit fixtures")  # a cluster; this course's own secret


@pytest.fixture
def place(tmp_path: Path) -> Path:
    """The folders that the page's paths refer to: the kit's folder, and ../hw3 beside it."""
    here = tmp_path / "kit"
    here.mkdir()
    wrapper = here / "kit"
    wrapper.write_text(f'#!/bin/sh\nexec "{ROOT}/kit" "$@"\n')
    wrapper.chmod(0o755)
    (here / "solution").symlink_to(ROOT / "solution")
    (tmp_path / "hw3").mkdir()
    made = [synthetic_class.Made(12, "Doe, Jane", "solution", solution_files(), 100)]
    synthetic_class.canvas_zip(tmp_path / "hw3" / "submissions.zip", made)
    export = synthetic_class.gradebook_csv(made).replace("Final Score", "HW3 part 1 (98766)")
    export = export.replace("(read only)", "30.00").replace("81.20", "")
    (tmp_path / "hw3" / "export.csv").write_text(export)
    return here


@pytest.mark.slow
def test_the_commands_run_in_their_order(place: Path) -> None:
    ran = []
    for command in COMMANDS:
        if any(word in command for word in NOT_HERE):
            continue
        done = subprocess.run(
            command, shell=True, cwd=place, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, f"{command}\n{done.stdout}{done.stderr}"
        ran.append(command)
    assert len(ran) >= 8
    out = place.parent / "hw3" / "out"
    rows = list(csv.reader((out / "gradebook.csv").open()))
    assert rows[0][0] == "Student"
    named = re.findall(r"`([\w./][\w./-]*)`", PAGE.split("| file | what |")[1].split("\n\n")[0])
    assert len(named) == 7
    for name in [*named, "results-1"]:
        assert (out / name).exists(), name
    assert (place.parent / "hw3" / "cluster" / "slurm" / "1" / "submit.sh").exists()


@pytest.mark.slow
def test_the_grade_book_of_the_page_has_the_points(place: Path) -> None:
    command = next(c for c in COMMANDS if "--part-column" in c)
    subprocess.run(command, shell=True, cwd=place, check=True, capture_output=True)
    rows = list(csv.reader((place.parent / "hw3" / "out" / "gradebook.csv").open()))
    assert rows[2][0] == "Doe, Jane" and rows[2][6:] == ["100.00", "30.00"]


def test_the_secret_is_made_as_grading_says() -> None:
    grading = (ROOT / "docs" / "grading.md").read_text()
    line = next(c for c in COMMANDS if "> course-secret" in c)
    assert line in grading


def test_links_lead_somewhere() -> None:
    for target in re.findall(r"\]\(([^)#]+)\)", PAGE):
        assert (ROOT / "docs" / target).exists(), target


def test_the_workflow_is_one_that_classroom_reads() -> None:
    """The reporter's conditions: the workflow's name, one job of this name, and the step's id as
    the name of its result."""
    yaml = pytest.importorskip("yaml")
    flow = yaml.safe_load(WORKFLOW.read_text())
    assert flow["name"] == "Autograding Tests"
    assert list(flow["jobs"]) == ["run-autograding-tests"]
    steps = flow["jobs"]["run-autograding-tests"]["steps"]
    secret, graded = [step for step in steps if "run" in step]
    assert "kit/course-secret" in secret["run"] and "env" not in graded
    assert graded["run"].startswith("kit/kit grade submission --format github --min-score 70")
    reporter = steps[-1]
    runner = reporter["with"]["runners"]
    assert graded["id"] == runner
    assert list(reporter["env"]) == [f"{runner.upper()}_RESULTS"]
    assert all(not step["with"]["persist-credentials"] for step in steps[:2])


def test_the_autograder_for_gradescope_grades(tmp_path: Path) -> None:
    """Unpacks it where Gradescope does, in /autograder, builds and runs it."""
    packed = tmp_path / "autograder.zip"
    for name in ("autograder.zip", "again.zip"):
        command = [str(ROOT / "kit"), "gradescope", "--out", str(tmp_path / name)]
        subprocess.run(command, check=True)
    assert packed.read_bytes() == (tmp_path / "again.zip").read_bytes()
    with zipfile.ZipFile(packed) as archive:
        names = set(archive.namelist())
        for script in ("setup.sh", "run_autograder", "kit"):
            assert archive.getinfo(script).external_attr >> 16 & 0o111
    assert {"course-secret", "grader/parts.json", "solution/src/part1_contacts.cpp"} <= names
    assert not any(name.startswith(("build/", ".git/", "fixtures/hidden/")) for name in names)
    for script in ("setup.sh", "run_autograder"):
        with zipfile.ZipFile(packed) as archive:
            text = archive.read(script)
        assert subprocess.run(["bash", "-n"], input=text, check=False).returncode == 0


def test_the_autograder_holds_the_kit_and_nothing_that_lies_beside_it(tmp_path: Path) -> None:
    for name in gradescope.PACKED:
        if (ROOT / name).is_dir():
            write(tmp_path / name, {"x": b"", "build/x": b""})
        else:
            write(tmp_path, {name: b""})
    write(tmp_path, {"hw3/out/results/x.json": b"{}", "course-secret": b"", "a.zip": b""})
    found = {f.relative_to(tmp_path).parts[0] for f in gradescope._packed(tmp_path)}
    assert found == set(gradescope.PACKED)
    listed = ["git", "ls-files", "--exclude-standard"]
    tracked = subprocess.run(listed, cwd=ROOT, capture_output=True, text=True, check=False)
    if tracked.returncode == 0:
        tops = {line.split("/")[0] for line in tracked.stdout.splitlines()}
        assert {top for top in tops if not top.startswith(".")} == set(gradescope.PACKED)


def in_a_container(root: Path, *command: str) -> "subprocess.CompletedProcess[str]":
    """Runs a command with `root` as /autograder, as in Gradescope's container."""
    box = ["bwrap", "--dev-bind", "/", "/", "--tmpfs", "/autograder"]
    box += ["--bind", str(root), "/autograder", "--"]
    environment = {**os.environ, "KIT_NO_INSTALL": "1"}
    return subprocess.run(
        [*box, *command], env=environment, capture_output=True, text=True, check=False
    )


@pytest.mark.long
def test_the_autograder_builds_and_grades_in_its_place(tmp_path: Path) -> None:
    root = tmp_path / "autograder"
    packed = tmp_path / "autograder.zip"
    subprocess.run([str(ROOT / "kit"), "gradescope", "--out", str(packed)], check=True)
    for folder in ("source", "submission", "results"):
        (root / folder).mkdir(parents=True)
    subprocess.run(["unzip", "-q", str(packed), "-d", str(root / "source")], check=True)
    if in_a_container(root, "true").returncode != 0:
        pytest.skip("/autograder can't be mounted here")
    for name, text in solution_files().items():
        (root / "submission" / name).write_bytes(text)
    done = in_a_container(root, "bash", "/autograder/source/setup.sh")
    assert done.returncode == 0, done.stderr
    results = root / "results" / "results.json"
    done = in_a_container(root, "bash", "/autograder/source/run_autograder")
    assert done.returncode == 0, done.stderr
    import json

    assert sum(test["score"] for test in json.loads(results.read_text())["tests"]) == 100
    results.unlink()
    for file in (root / "submission").iterdir():
        file.unlink()
    assert in_a_container(root, "bash", "/autograder/source/run_autograder").returncode == 0
    assert json.loads(results.read_text())["score"] == 0
    results.unlink()
    (root / "source" / "build" / "kit" / "judge").unlink()
    (root / "source" / "grader" / "judge" / "main.cpp").write_text("no C++")
    assert in_a_container(root, "bash", "/autograder/source/run_autograder").returncode == 3
    assert not results.exists()
