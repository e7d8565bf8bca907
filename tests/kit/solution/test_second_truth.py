"""simulate_to keeps its bounds, and the benchmark's exact motion its digits, by the word of a program
that shares nothing with them: second_truth.f90 is of another author, in another language, with
another formulation, in quadruple precision."""

import json
import math
import subprocess
from collections.abc import Iterator
from decimal import Decimal
from pathlib import Path
from random import Random

import pytest
from bounce_grader.common.paths import BUILD, FIXTURES
from bounce_study import tables

SOURCE = Path(__file__).parent / "second_truth.f90"
MOST_REFUSED = 0.01  # of all scenes
Numbers = list[float]


def scenes(count: int) -> Iterator[Numbers]:
    """l, mu, epsilon, g_x, g_y, x, y, theta, v_x, v_y, omega, until."""
    random = Random(7)
    between = random.uniform

    def from_to(least: float, most: float) -> float:
        return math.exp(between(math.log(least), math.log(most)))

    for number in range(count):
        l, mu, epsilon, tilt = between(0.1, 1), between(0, 1.2), between(0, 0.95), 0.0
        q = [0.0, between(0.8, 2) * l, between(-4, 4)]
        v = [between(-3, 3), between(-3, 1), between(-10, 10)]
        length = time = 1.0
        kind = number % 8
        if kind == 1:  # on a side, on slopes to vertical and beyond
            q, v = [0.0, l / 2, 0.0], [random.choice((0, 1)) * between(-1, 1), 0.0, 0.0]
            tilt = between(-1.6, 1.6)
        elif kind == 2:
            tilt = between(-1.5, 1.5)
        elif kind == 3:
            mu = between(1.2, 5)
        elif kind == 4:
            epsilon = between(0.9, 0.99)
        elif kind == 5:  # nearly simultaneous corners
            almost = random.choice((-1, 1)) * from_to(1e-9, 1e-2)
            q = [0.0, between(0.6, 2) * l, random.choice((0, math.pi / 2)) + almost]
            v = [between(-2, 2), between(-2, 0), 0.0]
        elif kind == 6:
            length, time = 10 ** between(-9, 9), 10 ** between(-4, 4)
        elif kind == 7:  # low, until it lies
            theta = between(-0.3, 0.3)
            low = l / 2 * (math.cos(theta) + abs(math.sin(theta))) + from_to(1e-8, 1e-2) * l
            q, v = [0.0, low, theta], [between(-1, 1), 0.0, 0.0]
        g = [9.81 * math.sin(tilt), -9.81 * math.cos(tilt)]
        until = between(0.5, 3) * math.sqrt(l / 9.81)
        speed = length / time
        yield [l * length, mu, epsilon, *(x * speed / time for x in g)] + [
            *(q[0] * length, q[1] * length, q[2]),
            *(v[0] * speed, v[1] * speed, v[2] / time, until * time),
        ]


@pytest.fixture(scope="module")
def other(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("other")
    options = ["-O2", "-std=f2008", "-Wall", "-Werror", "-J", str(folder)]
    subprocess.run(["gfortran", *options, SOURCE, "-o", folder / "second_truth"], check=True)
    return folder / "second_truth"


def answers(program: Path, asked: list[Numbers]) -> list[list[str]]:
    """All digits are asked: a quadruple number that is read from fewer isn't the double."""
    lines = "".join(" ".join(f"{x:.60e}" for x in scene) + "\n" for scene in asked)
    done = subprocess.run([program], input=lines, capture_output=True, text=True, check=True)
    return [line.split() for line in done.stdout.splitlines()]


def test_the_exact_motion_of_the_benchmark_has_twelve_digits(other: Path) -> None:
    truth = tables.read(FIXTURES / "study" / "truth.csv")
    asked: list[Numbers] = []
    for name, time in zip(truth["scene"], truth["t_s"]):
        scene = json.loads((FIXTURES / "scenes" / f"{name}.json").read_text())
        p = scene["params"]
        asked.append([p["l"], p["mu"], p["epsilon"], *p["g"][:2], *scene["q"], *scene["v"], time])
    poses = truth[["x_m", "y_m", "theta_rad"]].to_numpy().tolist()
    assert len(asked) == 11 * 20
    for pose, found in zip(poses, answers(other, asked), strict=True):
        assert pose == pytest.approx([float(x) for x in found[:3]], abs=1e-12, rel=1e-12)


@pytest.mark.parametrize("count", [400, pytest.param(10_000, marks=pytest.mark.long)])
def test_no_error_is_above_its_bound(other: Path, count: int) -> None:
    asked = list(scenes(count))
    promised, true = answers(BUILD / "ask_bounds", asked), answers(other, asked)
    assert len(promised) == len(true) == count
    refused, ratios = 0, []
    for scene, own, found in zip(asked, promised, true):
        assert found[0] != "refused", (scene, found)
        if own[0] == "refused":
            refused += 1
            continue
        off = [float(Decimal(a) - Decimal(b)) for a, b in zip(own[:3], found)]
        error = math.hypot(*off[:2], scene[0] / math.sqrt(2) * off[2])
        assert error <= float(own[3]), f"{scene}: {error} above {own[3]}"
        ratios.append(float(own[3]) / error if error else math.inf)
    assert refused <= MOST_REFUSED * count
    assert sorted(ratios)[len(ratios) // 2] < 6, "the bound is close, too"
