"""The autograder that an instructor uploads to Gradescope: what it holds, and that it grades there."""

import json
import os
import stat
import subprocess
import zipfile
from argparse import Namespace
from pathlib import Path

import pytest
from bounce_grader.publish import gradescope
from conftest import Patch, solution_files, write


def test_the_autograder_holds_the_kit_and_its_secret(tmp_path: Path, monkeypatch: Patch) -> None:
    """Twice the same bytes, and nothing that lies beside the kit."""
    for name in ("a.zip", "b.zip"):
        gradescope.run(Namespace(out=tmp_path / name))
    assert (tmp_path / "a.zip").read_bytes() == (tmp_path / "b.zip").read_bytes()
    with zipfile.ZipFile(tmp_path / "a.zip") as archive:
        modes = {file.filename: file.external_attr >> 16 for file in archive.infolist()}
    assert all(modes[script] & 0o111 for script in ("setup.sh", "run_autograder", "kit"))
    assert modes["course-secret"] == stat.S_IFREG | 0o600
    assert not any(name.startswith(("build/", ".git/", "fixtures/hidden/")) for name in modes)
    kit = write(tmp_path / "hidden", {f"{name}/x": b"" for name in gradescope.PACKED})
    write(kit, {"hw3/out/results/x.json": b"{}", "a.zip": b"", "student/build/x": b""})
    monkeypatch.setattr(gradescope, "BUILT", kit / "student/build")
    packed = {file.relative_to(kit) for file in gradescope._packed(kit)}
    assert {file.parts[0] for file in packed} == set(gradescope.PACKED)
    assert not any("build" in file.parts for file in packed)


@pytest.mark.long
def test_the_autograder_builds_and_grades_in_its_place(tmp_path: Path) -> None:
    """With this folder as /autograder, as in Gradescope's container."""
    root, results = tmp_path / "autograder", tmp_path / "autograder" / "results" / "results.json"
    gradescope.run(Namespace(out=tmp_path / "autograder.zip"))
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
