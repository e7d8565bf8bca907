"""A fifth part, fifth_part.patch, is added to a copy of the kit as CONTRIBUTING.md says, and graded."""

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT

PATCH = Path(__file__).with_name("fifth_part.patch")
CHECK = "part5.AddsKineticAndPotentialEnergy"


def copy_with_a_fifth_part(to: Path) -> Path:
    tracked = subprocess.run(
        ["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True
    ).stdout.split("\0")
    for name in filter(None, tracked):
        target = to / name
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(ROOT / name, target)
    subprocess.run(["git", "apply", str(PATCH)], cwd=to, check=True)
    manifest = json.loads((to / "grader/parts.json").read_text())
    part = {"part": 5, "stem": "part5_energy", "title": "Energy", "function": "energy"}
    checks = [{"id": CHECK, "title": "the energy is kinetic and potential", "points": 10}]
    manifest["parts"].append(part | {"points": 10, "checks": checks})
    (to / "grader/parts.json").write_text(json.dumps(manifest))
    return to


def kit(copy: Path, *arguments: str) -> str:
    command = [str(copy / "kit"), *arguments]
    environment = {**os.environ, "KIT_NO_INSTALL": "1"}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def points(copy: Path, submission: Path) -> list[Any]:
    record = json.loads(kit(copy, "grade", str(submission), "--no-sanitize", "--json", "-"))
    return [part["score"] for part in record["parts"]]


@pytest.mark.long
def test_a_fifth_part_is_graded_beside_the_four(tmp_path: Path) -> None:
    copy = copy_with_a_fifth_part(tmp_path / "kit")
    kit(copy, "fixtures")
    assert points(copy, copy / "solution" / "src") == [30, 30, 30, 10, 10]
    wrong = shutil.copytree(copy / "solution" / "src", tmp_path / "wrong")
    part = wrong / "part5_energy.cpp"
    part.write_text(part.read_text().replace("0.5 * ", ""))
    assert points(copy, wrong) == [30, 30, 30, 10, 0]
    part.unlink()
    assert points(copy, wrong) == [30, 30, 30, 10, 0]
    own_build = ["ninja", "-C", str(copy / "build" / "kit"), "solution_test"]
    assert subprocess.run(own_build, capture_output=True, check=False).returncode == 0
    moved = copy.rename(tmp_path / "moved")
    assert points(moved, moved / "solution" / "src") == [30, 30, 30, 10, 10]
