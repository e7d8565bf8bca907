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
SIDE, MU, EPSILON, GRAVITY, ROWS, DROPS = 0.06, 0.2, 0.5, 9.81, 150, 60
NOISE = np.array([2e-6, 2e-6, 5e-5])  # m, m, rad: a tenth of a camera's
DROPPED: dict[str, Any] = {"l": SIDE, "m": 0.1, "mu": MU, "epsilon": EPSILON}
DROPPED |= {"g": [0, -GRAVITY, 0], "dt": 1 / 250, "delta": 0.001, "T": ROWS}


def drop(folder: Path, random: np.random.Generator) -> list[list[float]]:
    """The rows of a drop under Newton's law, as ./kit study simulate has it."""
    start = {"q": [0, random.uniform(0.15, 0.3), random.uniform(-3, 3)]}
    start |= {"v": [random.normal(0, 0.6), 0, random.normal(0, 6)]}
    scene = folder / "scene.json"
    scene.write_text(json.dumps({"params": DROPPED, **start}))
    command: list[str | Path] = [BUILD / "bounce_study", "simulate", scene, "0.01"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode == 1:  # rounding decides what follows
        return drop(folder, random)
    q = np.array(json.loads(done.stdout)["q"])
    rows: list[list[float]] = (q + random.normal(size=q.shape) * NOISE).tolist()
    return rows


of_squares = pytest.mark.xdist_group("squares")  # which take longer to make than to study


@pytest.fixture(scope="module")
def squares(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("squares")
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


def answer(folder: Path, squares: Path) -> dict[str, list[dict[str, str]]]:
    """The tables, by name."""
    command = ["study", "measured", "--quick", "--squares", str(squares), "--out", str(folder)]
    assert main([*command, "--ellipses", str(some_ellipses(folder, 80))]) == 0
    files = folder.glob("measured_*.csv")
    return {file.stem: list(csv.DictReader(file.read_text().splitlines())) for file in files}


@of_squares
def test_what_was_put_in_is_found_again(tmp_path: Path, squares: Path) -> None:
    found = answer(tmp_path, squares)
    body = {row["quantity"]: float(row["value"]) for row in found["measured_body"]}
    assert body["side"] == pytest.approx(SIDE, rel=2e-3)
    assert body["gyration_squared"] == pytest.approx(SIDE**2 / 6, rel=0.02)
    assert body["g, m/s^2"] == pytest.approx(GRAVITY, rel=2e-3)
    assert body["drag, 1/s"] == pytest.approx(0, abs=0.02)
    assert body["slope"] == pytest.approx(0, abs=1e-3)
    for law in found["measured_laws"]:
        assert float(law["median_low"]) <= float(law["median_m_s"]) <= float(law["median_high"])
    laws = {row["law"]: row for row in found["measured_laws"] if row["shape"] == "squares"}
    newton = laws["newton"]
    assert newton["best"] == newton["least"] == "1"
    assert float(newton["mu"]) == pytest.approx(MU, abs=0.02)
    assert float(newton["epsilon"]) == pytest.approx(EPSILON, abs=0.02)
    assert float(newton["median_m_s"]) < float(laws["frictionless"]["median_m_s"]) / 3
    hits = found["measured_impacts"]  # those that are judged, of every other drop
    assert len(hits) == int(newton["tested"]) > 0
    assert {int(hit["trial"]) for hit in hits} <= {3 * i + 1 for i in range(1, DROPS, 2)}
    again = np.median([error(hit, newton, body["gyration_squared"]) for hit in hits])
    assert again == pytest.approx(float(newton["median_m_s"]), rel=0.02, abs=2e-5)


@of_squares
def test_what_is_judged_trains_nothing(tmp_path: Path, squares: Path) -> None:
    """Other test drops change no fitted number."""
    header, *lines = squares.read_text().splitlines()
    others = [line.split(",") for line in lines]
    for row in others:
        if int(row[0]) % 2 == 0:  # of trials 1, 4, 7, ... the odd ones train
            row[4] = str(float(row[4]) + 0.01)
    changed = tmp_path / "changed.csv"
    changed.write_text("\n".join([header, *map(",".join, others)]))
    one, two = (answer(tmp_path, file) for file in (squares, changed))
    assert one["measured_impacts"] != two["measured_impacts"]
    fitted = ("mu", "epsilon", "kappa", "mu_low", "epsilon_high", "trained")
    for law, again in zip(one["measured_laws"], two["measured_laws"]):
        assert [law[name] for name in fitted] == [again[name] for name in fitted]
    for body, same in zip(one["measured_body"], two["measured_body"]):
        assert body == same or body["quantity"].startswith(("left out", "impacts", "approach"))


def error(hit: dict[str, str], law: dict[str, str], r_g_squared: float) -> float:
    """How far an impact is from the oracle's, m/s."""
    _, x, y, *v = map(float, hit.values())
    numbers = dict(DROPPED, l=math.sqrt(6 * r_g_squared), g=[0, 0, 0])
    numbers |= {name: float(law[name]) for name in ("mu", "epsilon")}
    J = vector([1, 0, -y]), vector([0, 1, x])
    expected = contact_velocity(J, vector(v[:3]), Parameters.read(numbers))
    a, b, c = (float(own - there) for own, there in zip(expected, v[3:]))
    return math.hypot(a, b, math.sqrt(r_g_squared) * c)


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
