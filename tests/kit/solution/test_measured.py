"""./kit study measured: what was put in synthetic drops is found again, drops are fitted or judged,
and figures that can't be used are refused in a sentence."""

import csv
import gzip
import json
import math
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bounce_grader.cli import main
from bounce_grader.common.paths import BUILD, FIXTURES
from oracle import contact_velocity, Parameters, vector

MEASURED = FIXTURES / "measured"
SIDE, MU, EPSILON, GRAVITY, ROWS, DROPS = 0.06, 0.2, 0.5, 9.81, 150, 100
NOISE = np.array([2e-6, 2e-6, 5e-5])  # m, m, rad: a tenth of a camera's
ONE = "squares, one corner"
DROPPED: dict[str, Any] = {"l": SIDE, "m": 0.1, "mu": MU, "epsilon": EPSILON}
DROPPED |= {"g": [0, -GRAVITY, 0], "dt": 1 / 250, "delta": 0.001, "T": ROWS}


def drop(folder: Path, random: np.random.Generator) -> list[list[float]]:
    """The rows of a drop under Newton's law, as ./kit study simulate has it."""
    start = {"q": [0, random.uniform(0.15, 0.3), random.uniform(-3, 3)]}
    start |= {"v": [random.normal(0, 0.6), 0, random.normal(0, 6)]}
    scene = folder / "scene.json"
    scene.write_text(json.dumps({"params": DROPPED, **start}))
    command: list[str | Path] = [BUILD / "bounce_study", "simulate", scene, "1e-4"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode == 1:  # rounding decides what follows
        return drop(folder, random)
    q = np.array(json.loads(done.stdout)["q"])
    rows: list[list[float]] = (q + random.normal(size=q.shape) * NOISE).tolist()
    return rows


def drops(folder: Path) -> Path:
    random, lines = np.random.default_rng(4), ["trial,k,x,y,theta"]
    for i in range(DROPS):
        lines += [
            f"{3 * i + 1},{k},{x},{y},{theta}"
            for k, (x, y, theta) in enumerate(drop(folder, random))
        ]
    file = folder / "squares.csv"
    file.write_text("\n".join(lines))
    return file


def some_ellipses(folder: Path, count: int) -> Path:
    lines = (MEASURED / "ellipses.csv").read_text().splitlines()
    file = folder / "ellipses.csv.gz"
    file.write_bytes(gzip.compress("\n".join(lines[: count + 1]).encode()))
    return file


def table(file: Path) -> list[dict[str, str]]:
    return list(csv.DictReader(file.read_text().splitlines()))


def answer(folder: Path, squares: Path) -> Any:
    command = ["study", "measured", "--quick", "--squares", str(squares), "--out", str(folder)]
    command += ["--ellipses", str(some_ellipses(folder, 80)), "--json", str(folder / "it.json")]
    assert main(command) == 0
    return json.loads((folder / "it.json").read_text())


def test_what_was_put_in_is_found_again(tmp_path: Path) -> None:
    found = answer(tmp_path, drops(tmp_path))
    body = found["extraction"]
    assert body["side, m"] == pytest.approx(SIDE, rel=2e-3)
    assert body["r_g^2, m^2"] == pytest.approx(SIDE**2 / 6, rel=0.02)
    assert body["g, m/s^2"] == pytest.approx(GRAVITY, rel=2e-3)
    assert body["drag, 1/s"] == pytest.approx(0, abs=0.02)
    assert body["ground's slope"] == pytest.approx(0, abs=1e-3)
    one = found["shapes"][ONE]
    assert one["least_model"] == one["best"] == "newton"
    for shape in found["shapes"].values():
        assert shape["impacts_fitted"] > 0 < shape["impacts_judged"]
        best, least = (shape["laws"][shape[name]] for name in ("best", "least_model"))
        assert best["median_error"] <= least["median_error"]
        for law in shape["laws"].values():
            assert law["interval"][0] <= law["median_error"] <= law["interval"][1]
            for name, value in law["parameters"].items():
                low, high = law["parameter_intervals"][name]
                assert low <= value <= high
    newton = one["laws"]["newton"]
    assert newton["parameters"] == pytest.approx({"mu": MU, "epsilon": EPSILON}, abs=0.02)
    assert newton["median_error"] < one["laws"]["frictionless"]["median_error"] / 3
    hits = table(tmp_path / "measured_impacts.csv")  # those that are judged
    assert len(hits) == one["impacts_judged"]
    assert len({hit["trial"] for hit in hits}) == one["trials_judged"], "by whole drops"
    assert abs(one["trials_judged"] - one["trials_fitted"]) <= 1
    ladder = table(tmp_path / "measured_ladder.csv")
    (law,) = (row for row in ladder if row["group"] == ONE and row["law"] == "newton")
    again = np.median([error(hit, law, body["r_g^2, m^2"]) for hit in hits])
    assert again == pytest.approx(float(law["median_m_s"]), rel=0.02, abs=2e-5)


def error(hit: dict[str, str], law: dict[str, str], r_g_squared: float) -> float:
    """How far an impact is from the oracle's, m/s."""
    _, x, y, *v = map(float, hit.values())
    numbers = dict(DROPPED, l=math.sqrt(6 * r_g_squared), g=[0, 0, 0])
    numbers |= {name: float(law[name]) for name in ("mu", "epsilon")}
    J = vector([1, 0, -y]), vector([0, 1, x])
    expected = contact_velocity(J, vector(v[:3]), Parameters.read(numbers))
    a, b, c = (float(own - there) for own, there in zip(expected, v[3:]))
    return math.hypot(a, b, math.sqrt(r_g_squared) * c)


@pytest.mark.long
def test_the_same_figures_give_the_same_answer(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    squares = drops(tmp_path)
    assert answer(tmp_path, squares) == answer(tmp_path, squares)
    few = some_ellipses(tmp_path, 4)
    assert main(["study", "measured", "--quick", "--ellipses", str(few)]) == 2
    assert "ellipses have no flag" in capsys.readouterr().err


TABLES = json.loads((Path(__file__).parent / "study.json").read_text())
BYTES: dict[str, bytes | None] = {name: text.encode() for name, text in TABLES["squares"].items()}
BYTES |= {
    "squares.csv can't be read": None,
    "squares.csv can't be read: ": (MEASURED / "squares.csv.gz").read_bytes()[:5000],
    "clear impacts of one corner": b"\n".join(
        gzip.decompress((MEASURED / "squares.csv.gz").read_bytes()).splitlines()[: 12 * 200]
    ),
}


@pytest.mark.parametrize("sentence", BYTES)
def test_figures_that_can_not_be_used_are_refused_in_a_sentence(
    sentence: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file, data = tmp_path / "squares.csv", BYTES[sentence]
    if data is not None:
        file.write_bytes(data)
    assert main(["study", "measured", "--squares", str(file)]) == 2
    message = capsys.readouterr().err
    assert sentence in message and message.count("\n") == 1
