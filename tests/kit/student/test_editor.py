"""What an editor finds in the handout: settings that name what is there, and headers."""

import json
import re
import shutil
import signal
import subprocess
from pathlib import Path

import pytest
from conftest import ROOT
from handed_out import unzipped
from test_check import MISTAKES, SYSTEM, check, put

STUDENT = ROOT / "student"
SETTINGS = [STUDENT / "CMakePresets.json", *STUDENT.glob(".vscode/*"), *STUDENT.glob(".dev*/*")]


def of_vscode(name: str) -> dict[str, object]:
    return dict(json.loads((STUDENT / f".vscode/{name}.json").read_text()))


def test_settings_are_read_and_name_what_is_there() -> None:
    assert len(SETTINGS) == 6 and all(json.loads(file.read_text()) for file in SETTINGS)
    tasks = of_vscode("tasks")["tasks"]
    labels = {task["label"] for task in tasks}  # type: ignore[attr-defined]
    assert {"check", "check this part"} <= labels
    named = re.findall(
        r'"(?:preLaunchTask|dependsOn)": "([^"]+)"',
        "".join((STUDENT / f".vscode/{name}.json").read_text() for name in ("tasks", "launch")),
    )
    assert named and set(named) <= labels
    presets = json.loads((STUDENT / "CMakePresets.json").read_text())
    assert [p["name"] for p in presets["buildPresets"]] == ["debug"]


def test_clangd_finds_no_fault_in_the_stubs(tmp_path: Path) -> None:
    if not shutil.which("clangd"):
        pytest.skip("clangd isn't installed")
    home = unzipped(tmp_path)
    subprocess.run(["cmake", "-S", ".", "-B", "build"], cwd=home, check=True, capture_output=True)
    for part in sorted(home.glob("src/part*.cpp")):
        done = subprocess.run(
            ["clangd", f"--check={part}"], cwd=home, capture_output=True, text=True, check=False
        )
        assert "All checks completed, 0 errors" in done.stderr, done.stderr
        assert not re.search(r"^[EW]\[", done.stderr, re.M), done.stderr


@pytest.mark.xdist_group("student")
def test_the_worked_example_prints_the_handouts_numbers(home: Path) -> None:
    put(home)
    build = ["cmake", "--build", "build", "--target", "bounce"]
    subprocess.run(build, cwd=home, check=True, capture_output=True)
    printed = subprocess.run(
        ["build/bounce", "--worked"], cwd=home, capture_output=True, text=True, check=True
    ).stdout
    readme = (STUDENT / "README.md").read_text()
    [v] = re.findall(r"^v' = (\(.*\)) m/s", readme, re.M)
    [q] = re.findall(r"^q' = (\(.*\)) m, m, rad  ", readme, re.M)
    assert f"v' = {v} m/s" in printed and f"q' = {q} m" in printed, printed
    assert "0.0551012" in printed and "phi = 0.00041433 m" in printed


@pytest.mark.xdist_group("student")
def test_a_debugger_stops_before_the_first_wrong_case_is_asked_again(home: Path) -> None:
    put(home, MISTAKES / "part2_force_is_g")
    check(home, "part2_lcp")
    program = ["build/part2_lcp_test", "--debug"]
    run = subprocess.run(program, cwd=home, env=SYSTEM, capture_output=True, text=True, check=False)
    assert run.returncode == -signal.SIGTRAP and "yours, >wrong<" in run.stdout, run.stdout
