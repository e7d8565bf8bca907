"""docs/instructors.md: its commands run as they are written, and the autograder for Gradescope that
one of them packs."""

import csv
import json
import os
import re
import stat
import subprocess
import zipfile
from pathlib import Path

import pytest
from bounce_grader.classroom.intake import adjustments, course, roster
from bounce_grader.develop import synthetic_class
from bounce_grader.publish import gradescope
from conftest import ROOT, solution_files, write

PAGE = (ROOT / "docs" / "instructors.md").read_text()
COMMANDS = [line.strip() for line in PAGE.splitlines() if line.startswith("    ./kit ")]
# A cluster; this course's own secret; formats, which the tests of reports print.
NOT_HERE = ("SCHEDULER", "./kit fixtures", "--format")


def test_the_commands_run_in_their_order(tmp_path: Path) -> None:
    """In the kit's folder, with ../hw3 beside it."""
    wrapper = write(tmp_path, {"kit/kit": f'#!/bin/sh\nexec "{ROOT}/kit" "$@"\n'.encode()})
    (wrapper / "kit" / "kit").chmod(0o755)
    (tmp_path / "kit" / "solution").symlink_to(ROOT / "solution")
    hw3, out = tmp_path / "hw3", tmp_path / "hw3" / "out"
    write(hw3 / "2025" / "somebody", solution_files())
    made = [synthetic_class.Made(12, "Doe, Jane", "solution", solution_files(), 100)]
    synthetic_class.canvas_zip(hw3 / "submissions.zip", made)
    export = synthetic_class.gradebook_csv(made).replace("Final Score", "HW3 part 1 (98766)")
    export = export.replace("(read only)", "30.00").replace("81.20", "")
    (hw3 / "export.csv").write_text(export)
    here = [c for c in COMMANDS if not any(word in c for word in NOT_HERE)]
    assert len(here) >= 7
    for command in here:
        done = subprocess.run(
            command, shell=True, cwd=tmp_path / "kit", capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, f"{command}\n{done.stdout}{done.stderr}"
        if "--part-column" in command:
            rows = list(csv.reader((out / "gradebook.csv").open()))
            assert rows[2][0] == "Doe, Jane" and rows[2][6:] == ["100.00", "30.00"]
    named = re.findall(r"`([\w./][\w./-]*)`", PAGE.split("| file | what |")[1].split("\n\n")[0])
    assert len(named) == 10
    for name in {*named, "results-1"} - {"feedback-new.zip"}:  # no page has changed here
        assert (out / name).exists(), name


def test_the_files_of_the_page_are_read(tmp_path: Path) -> None:
    blocks = re.findall(r"^```(?:csv|toml)\n(.*?)^```$", PAGE, re.M | re.S)
    names = ["roster.csv", "course.toml", "adjustments.csv"]
    write(tmp_path, {name: text.encode() for name, text in zip(names, blocks, strict=True)})
    assert roster.read(tmp_path) and course.read(tmp_path).percent_per_day == 10
    assert len(adjustments.read(tmp_path)) == 4


# --- the autograder for Gradescope ---


def test_the_autograder_holds_the_kit_and_its_secret(tmp_path: Path) -> None:
    """Twice the same bytes, and nothing that lies beside the kit."""
    for name in ("a.zip", "b.zip"):
        gradescope.write(tmp_path / name)
    assert (tmp_path / "a.zip").read_bytes() == (tmp_path / "b.zip").read_bytes()
    with zipfile.ZipFile(tmp_path / "a.zip") as archive:
        modes = {file.filename: file.external_attr >> 16 for file in archive.infolist()}
        for script in ("setup.sh", "run_autograder"):
            text = archive.read(script)
            assert subprocess.run(["bash", "-n"], input=text, check=False).returncode == 0
    assert all(modes[script] & 0o111 for script in ("setup.sh", "run_autograder", "kit"))
    assert modes["course-secret"] == stat.S_IFREG | 0o600
    assert not any(name.startswith(("build/", ".git/", "fixtures/hidden/")) for name in modes)
    sources = [file for room in ("grader", "solution") for file in (ROOT / room).rglob("*.[pch]*")]
    sources = [file for file in sources if file.suffix in {".py", ".cpp", ".hpp"}]
    assert {str(file.relative_to(ROOT)) for file in sources} <= modes.keys()
    write(tmp_path / "x", {f"{name}/x": b"" for name in gradescope.PACKED})
    write(tmp_path / "x", {"hw3/out/results/x.json": b"{}", "a.zip": b"", "student/build/x": b""})
    packed = {file.relative_to(tmp_path / "x") for file in gradescope._packed(tmp_path / "x")}
    assert {file.parts[0] for file in packed} == set(gradescope.PACKED)
    assert not any("build" in file.parts for file in packed)


@pytest.mark.long
def test_the_autograder_builds_and_grades_in_its_place(tmp_path: Path) -> None:
    """With this folder as /autograder, as in Gradescope's container."""
    root, results = tmp_path / "autograder", tmp_path / "autograder" / "results" / "results.json"
    gradescope.write(tmp_path / "autograder.zip")
    for folder in ("source", "submission", "results"):
        (root / folder).mkdir(parents=True)
    unzip = ["unzip", "-q", str(tmp_path / "autograder.zip"), "-d", str(root / "source")]
    subprocess.run(unzip, check=True)
    box = ["bwrap", "--dev-bind", "/", "/", "--tmpfs", "/autograder"]
    box += ["--bind", str(root), "/autograder", "--"]

    def run(*command: str) -> int:
        env = {**os.environ, "KIT_NO_INSTALL": "1"}
        return subprocess.run([*box, *command], env=env, check=False).returncode

    if run("true") != 0:
        pytest.skip("/autograder can't be mounted here")
    write(root / "submission", solution_files())
    grade = ("bash", "/autograder/source/run_autograder")
    assert run("bash", "/autograder/source/setup.sh") == 0
    assert run(*grade) == 0
    assert sum(test["score"] for test in json.loads(results.read_text())["tests"]) == 100
    results.unlink()
    for file in (root / "submission").iterdir():
        file.unlink()
    assert run(*grade) == 0
    assert json.loads(results.read_text())["score"] == 0
    results.unlink()
    (root / "source" / "build" / "kit" / "judge").unlink()
    (root / "source" / "grader" / "judge" / "main.cpp").write_text("no C++")
    assert run(*grade) == 3
    assert not results.exists()
