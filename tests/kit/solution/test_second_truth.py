"""simulate_to keeps its bounds by the word of a program that shares nothing with it: second_truth.f90
is of another author, in another language, with another formulation, in quadruple precision."""

import json
import math
import subprocess
from collections import Counter
from collections.abc import Iterator
from decimal import Decimal
from pathlib import Path
from random import Random

import pytest
from bounce_grader.common.paths import BUILD, FIXTURES

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


def answers(program: Path, asked: list[Numbers]) -> list[list[str]]:
    """All digits are asked: a quadruple number that is read from fewer isn't the double."""
    lines = "".join(" ".join(f"{x:.60e}" for x in scene) + "\n" for scene in asked)
    done = subprocess.run([program], input=lines, capture_output=True, text=True, check=True)
    return [line.split() for line in done.stdout.splitlines()]


def second_truth(folder: Path, asked: list[Numbers]) -> list[list[str]]:
    """x, y, theta, v_x, v_y and omega of each scene, or "refused" and why."""
    options = ["-O2", "-std=f2008", "-Wall", "-Werror", "-J", str(folder)]
    subprocess.run(["gfortran", *options, SOURCE, "-o", folder / "second_truth"], check=True)
    return answers(folder / "second_truth", asked)


def off(one: list[str], two: list[str], l: float) -> float:
    """The distance of two poses, m."""
    x, y, theta = (float(Decimal(a) - Decimal(b)) for a, b in zip(one[:3], two))
    return math.hypot(x, y, l / math.sqrt(2) * theta)


# Truths are printed with 17 digits; where errors grow, those of long double show.
GROWS = {"pointed_drop": 1e-12, "ten_seconds": 1e-11}


def test_it_confirms_the_truth_of_each_scene(tmp_path: Path) -> None:
    lines = (FIXTURES / "study/truth.csv").read_text().splitlines()
    truth = [line.split(",") for line in lines if not line.startswith(("#", "scene"))]
    scenes = {file.stem: json.loads(file.read_text()) for file in FIXTURES.glob("scenes/*.json")}
    assert {name: 20 for name in scenes} == Counter(row[0] for row in truth)
    asked = []
    for name, t, *_ in truth:
        scene, p = scenes[name], scenes[name]["params"]
        given = [p["l"], p["mu"], p["epsilon"], *p["g"][:2], *scene["q"], *scene["v"]]
        asked.append([*given, float(t)])
    for (name, _, *pose), own, found in zip(truth, asked, second_truth(tmp_path, asked)):
        assert off(pose, found, own[0]) < GROWS.get(name, 1e-14), (name, pose, found)


@pytest.mark.parametrize("count", [400, pytest.param(10_000, marks=pytest.mark.long)])
def test_no_error_is_above_its_bound(tmp_path: Path, count: int) -> None:
    asked = list(scenes(count))
    promised = answers(BUILD / "ask_bounds", asked)
    true = second_truth(tmp_path, asked)
    assert len(promised) == len(true) == count
    refused, ratios = 0, []
    for scene, own, found in zip(asked, promised, true):
        assert found[0] != "refused", (scene, found)
        if own[0] == "refused":
            refused += 1
            continue
        error = off(own, found, scene[0])
        assert error <= float(own[3]), f"{scene}: {error} above {own[3]}"
        ratios.append(float(own[3]) / error if error else math.inf)
    assert refused <= MOST_REFUSED * count
    assert sorted(ratios)[len(ratios) // 2] < 6, "the bound is close, too"
