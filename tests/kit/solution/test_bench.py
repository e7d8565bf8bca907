"""./kit study bench measures somebody's engine, says what it can't use, and has adapters to begin
with."""

import json
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
from bounce_grader.cli import main
from bounce_grader.common.paths import ROOT
from bounce_study import bench, tables

Said = pytest.CaptureFixture[str]
ADAPTERS = ROOT / "docs" / "studies" / "bench"
SCHEMA = json.loads((ADAPTERS / "adapter.schema.json").read_text())


def adapter(folder: Path, prints: str, name: str = "engine") -> Path:
    """A program that prints this expression of what it was asked."""
    file = folder / name
    lines = ["#!/usr/bin/python3", "import json, sys", "asked = json.load(sys.stdin)"]
    file.write_text("\n".join([*lines, f"print({prints})", ""]))
    file.chmod(0o755)
    return file


def validate(data: Any, kind: str) -> None:
    pytest.importorskip("jsonschema").validate(data, {**SCHEMA, "$ref": f"#/$defs/{kind}"})


def test_an_engine_that_does_not_move_is_right_at_rest_alone(tmp_path: Path, capsys: Said) -> None:
    keeps = f"[open({str(tmp_path / 'asked')!r}, 'a').write(json.dumps(asked) + '\\n')]"
    stays = 'json.dumps({"q": [asked["q"] for t in asked["times"]], "ns": 1e6})'
    own = adapter(tmp_path, f"{keeps} and {stays}", "box2d")  # as an engine of the study is called
    assert main(["study", "bench", str(own), "--out", str(tmp_path)]) == 0
    errors = pd.read_csv(tmp_path / "bench.csv").groupby("scene")["error_m"].min()
    assert errors["rest"] == 0 and sorted(errors)[1] > 0.01
    table = capsys.readouterr().out.splitlines()
    assert (
        len(table) == 1 + len(errors) + 1
        and sum("no run within" in row for row in table) == len(errors) - 1
    )
    assert "box2d" in (tmp_path / "bench.svg").read_text()
    questions = (tmp_path / "asked").read_text().splitlines()
    page = (ADAPTERS / "README.md").read_text()
    assert f"{len(questions)} times in all" in page and f"are {len(errors)} scenes" in page
    for line in questions:
        asked = json.loads(line)
        validate(asked, "asked")
        assert asked["times"] == sorted(asked["times"])


def test_the_exact_motion_would_be_an_answer() -> None:
    truth = tables.read(bench.STUDY / "truth.csv")
    for _, own in truth.groupby("scene"):
        poses = own[["x_m", "y_m", "theta_rad"]].to_numpy().tolist()
        validate({"q": poses, "ns": 1}, "answer")


def test_a_pose_that_is_not_finite_has_an_endless_error(tmp_path: Path, capsys: Said) -> None:
    """As of an engine that explodes at a large step: JSON has null, and Python's has NaN, too."""
    explodes = 'json.dumps({"q": [[0, None, float("nan")]] * 20, "ns": 1})'
    own = adapter(tmp_path, explodes)
    assert main(["study", "bench", str(own), "--out", str(tmp_path)]) == 0
    assert np.isinf(pd.read_csv(tmp_path / "bench.csv")["error_m"]).all()
    assert "∞ m" in capsys.readouterr().out


@pytest.mark.parametrize(
    "prints, sentence",
    {
        '"hello"': "engine in flat_drop with a step of 0.025 s printed no {",
        'json.dumps({"q": [asked["q"]], "ns": 1})': "printed no {",
        'json.dumps({"q": 7, "ns": 1})': "printed no {",
        'json.dumps({"q": [asked["q"]] * 20})': "printed no {",
        'json.dumps({"q": [asked["q"]] * 20, "ns": 0})': "printed no {",
        'json.dumps({"q": [asked["q"]] * 20, "ns": "1"})': "printed no {",
        'json.dumps({"q": [["0", 0, 0]] * 20, "ns": 1})': "printed no {",
        'json.dumps({"q": [[0, 0]] * 20, "ns": 1})': "printed no {",
        "asked['mass']": "failed: ",
    }.items(),
)
def test_an_answer_that_is_none_is_named(
    tmp_path: Path, capfd: Said, prints: str, sentence: str
) -> None:
    own = adapter(tmp_path, prints)
    assert main(["study", "bench", str(own), "--out", str(tmp_path)]) == 2
    assert sentence in capfd.readouterr().err and not (tmp_path / "bench.csv").exists()
    printed = subprocess.run(own, input='{"q": [0, 1, 0]}', capture_output=True, text=True).stdout
    with pytest.raises((json.JSONDecodeError, pytest.importorskip("jsonschema").ValidationError)):
        validate(json.loads(printed), "answer")


def test_the_adapters_to_begin_with_agree(tmp_path: Path) -> None:
    engine = tmp_path / "engine"
    source = ADAPTERS / "adapter.cpp"
    subprocess.run(["g++", "-std=c++20", "-Wall", "-Werror", source, "-o", engine], check=True)
    asked: Any = {"l": 0.2, "m": 0.3, "mu": 0.3, "epsilon": 0.5, "g": [0, -9.81, 0]}
    asked |= {"q": [0, 0.3, 0.3], "v": [2, -1, 3], "step": 0.01, "times": [0.1, 0.2, 0.4]}
    programs = ([str(engine)], ["/usr/bin/python3", str(ADAPTERS / "adapter.py")])
    told = [
        json.loads(subprocess.run(p, input=json.dumps(asked), stdout=-1, text=True).stdout)
        for p in programs
    ]
    for one, other in zip(told[0]["q"], told[1]["q"], strict=True):
        assert one == pytest.approx(other, abs=1e-12)
    assert len(told[0]["q"]) == 3 and all(one["ns"] > 0 for one in told)


def test_a_drop_tells_the_restitution_and_the_friction_that_an_engine_gives() -> None:
    command = [str(ADAPTERS / name) for name in ("flat_drop.py", "adapter.py")]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    lines = [line.split() for line in done.stdout.splitlines() if "epsilon" not in line]
    rows = [[float(x) for x in line] for line in lines]
    assert len(rows) == 8
    for epsilon, _, *found in rows[:4]:
        assert found[-1] == pytest.approx(epsilon, abs=2e-3) and found == sorted(found)
    assert not any(x for _, _, *found in rows[4:] for x in found), "the example has no friction"
