"""The engines beside our methods: each that is built here does what its settings say."""

import csv
import json
import math
import subprocess
from pathlib import Path
from typing import Any

import pytest
from bounce_grader.common.paths import BUILD

PROGRAM = BUILD / "bounce_peers"
G = 9.81
OURS = "assignment", "moreau_jean", "penalty", "event_driven"
Errors = dict[str, dict[str, dict[float, float]]]  # by scene, engine and step, m


def scene(name: str, **changes: Any) -> dict[str, Any]:
    params = {"l": 0.5, "m": 2, "mu": 0.4, "epsilon": 0.8, "g": [0, -G, 0]}
    params |= {"dt": 0.01, "delta": 0.001, "T": 2} | changes.pop("params", {})
    start = {"q": [0, 3, 0.3], "v": [1, 1, 2]} | changes
    about = {"title": name, "least_model": "ballistic", "why": "a test"}
    compare = {"quantity": "pose", "until": 0.5}
    return {"name": name, "params": params, "compare": compare, **about, **start}


SCENES = (
    scene("flight"),
    scene("tilted", params={"g": [2, -5, 0]}),
    scene("bounce", params={"mu": 0}, q=[0, 0.75, 0], v=[0, 0, 0]),
    scene("friction", q=[0, 0.25, 0], v=[3, 0, 0]),
    scene("heavy", params={"m": 20, "mu": 0.2}, q=[0, 0.25, 0], v=[-3, 0, 0]),
    scene("rest", q=[0, 0.25, 0], v=[0, 0, 0]),
)


@pytest.fixture(scope="module")
def errors(tmp_path_factory: pytest.TempPathFactory) -> Errors:
    if not PROGRAM.exists():
        pytest.skip("no engines are built here: run ./kit study --peers")
    folder = tmp_path_factory.mktemp("peers")
    for data in SCENES:
        (folder / f"{data['name']}.json").write_text(json.dumps(data))
    command: list[str | Path] = [PROGRAM, "--quick", folder, folder / "out.csv", "speed_accuracy"]
    subprocess.run(command, check=True, capture_output=True)
    by_scene: Errors = {}
    lines = (folder / "out.csv").read_text().splitlines()
    for row in csv.DictReader(line for line in lines if not line.startswith("#")):
        if not row["method"].startswith(OURS):
            own = by_scene.setdefault(row["scene"], {}).setdefault(row["method"], {})
            own[float(row["setting"])] = float(row["error_m"])
    assert {name: set(own) for name, own in by_scene.items()} == {
        data["name"]: set(by_scene["flight"]) for data in SCENES
    }
    return by_scene


@pytest.mark.parametrize("name, g", [("flight", G), ("tilted", math.hypot(2, 5))])
def test_free_flight_has_eulers_error(errors: Errors, name: str, g: float) -> None:
    """Either symplectic Euler is off the parabola by g t dt / 2, and by nothing else."""
    for engine, own in errors[name].items():
        for dt, error in own.items():
            if engine == "siconos":  # its midpoints are exact
                assert error < 1e-9
            else:  # Box2D computes with floats
                assert error == pytest.approx(g * 0.5 * dt / 2, rel=0.01, abs=2e-5), (engine, dt)


@pytest.mark.parametrize(
    "name, most", [("bounce", 0.01), ("friction", 0.004), ("heavy", 0.004), ("rest", 0.001)]
)
def test_settings_mean_the_same(errors: Errors, name: str, most: float) -> None:
    """A restitution that is off by 0.05, or friction by 0.02, would be 3 cm off or more. All but
    MuJoCo's soft contacts converge."""
    for engine, own in errors[name].items():
        finest, soft = own[min(own)], engine == "mujoco"
        assert finest < (0.05 if soft and name == "bounce" else most), engine
        assert soft or name == "rest" or finest < own[max(own)] / 3 or finest < 1e-9, engine
