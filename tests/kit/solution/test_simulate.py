"""./kit study simulate: a motion within a tolerance, or one sentence."""

import json
from pathlib import Path
from typing import Any

import pytest

from bounce_grader.cli import main
from studies import SCENES


def tumble(**changes: Any) -> dict[str, Any]:
    """A scene of three fields, which is all that its motion needs; `changes` replace parameters."""
    scene = json.loads((SCENES / "tumble.json").read_text())
    return {"params": scene["params"] | changes, "q": scene["q"], "v": scene["v"]}


def simulate(tmp_path: Path, scene: str, *options: str) -> int:
    file = tmp_path / "scene.json"
    file.write_text(scene)
    return main(["study", "simulate", str(file), *options])


def test_an_answer_has_what_it_promises(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "answer.json"
    scene = json.dumps(tumble())
    assert simulate(tmp_path, scene, "--tolerance", "1e-3", "--json", str(out)) == 0
    answer = json.loads(out.read_text())
    assert set(answer) == set("times q v method step bound horizon seconds".split())
    assert len(answer["times"]) == len(answer["q"]) == len(answer["v"]) == 41
    assert answer["q"][0] == [0, 0.5, 0.3]
    assert answer["horizon"] == answer["times"][-1]
    assert 0 < answer["bound"] <= 1e-3
    assert "event-driven: within" in capsys.readouterr().out


def test_scenes_of_the_study_are_taken_as_they_are(tmp_path: Path) -> None:
    for file in sorted(SCENES.glob("*.json")):
        scene = json.loads(file.read_text())
        scene["params"]["T"] = 1 + int(scene["compare"]["until"] / scene["params"]["dt"])
        assert simulate(tmp_path, json.dumps(scene), "--tolerance", "1e-6") == 0, file.name


def test_what_can_not_be_had_is_refused_with_the_horizon(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "answer.json"
    scene = json.dumps(tumble(T=5000, epsilon=1, mu=0))
    assert simulate(tmp_path, scene, "--tolerance", "1e-9", "--json", str(out)) == 1
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert "can be had up to" in said
    assert not out.exists()


@pytest.mark.parametrize(
    ("scene", "tolerance", "message"),
    [
        (json.dumps(tumble(m=-1)), "1e-3", "params.m is -1; it must be above 0"),
        (json.dumps(tumble(mu=-0.1)), "1e-3", "params.mu is -0.1"),
        (json.dumps(tumble(epsilon=1.5)), "1e-3", "params.epsilon is 1.5; it must be from 0 to 1"),
        (json.dumps(tumble(l=float("nan"))), "1e-3", "can't be read as JSON"),
        (json.dumps({"q": [0, 1, 0]}), "1e-3", "params is missing"),
        ("hello", "1e-3", "can't be read as JSON"),
        (json.dumps(tumble()), "nan", "the tolerance is nan m; it must be above 0"),
        (json.dumps(tumble()), "-1", "the tolerance is -1 m; it must be above 0"),
        (json.dumps(tumble()), "small", "it must be a number"),
    ],
)
def test_bad_input_is_one_sentence(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], scene: str, tolerance: str, message: str
) -> None:
    assert simulate(tmp_path, scene, f"--tolerance={tolerance}") == 2
    said = capsys.readouterr().err
    assert message in said
    assert said.count("\n") == 1


def test_a_tolerance_is_needed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert simulate(tmp_path, json.dumps(tumble())) == 2
    assert main(["study", "--tolerance", "1"]) == 2
    assert "--tolerance" in capsys.readouterr().err
