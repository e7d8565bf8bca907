#!/usr/bin/env python3
"""./flat_drop.py ADAPTER: the restitution and the friction that an engine gives to a square that
falls by five sides. Flat: the root of the height of its first bounce over that of its fall, which
should be epsilon. On a corner, sliding: the speed that the impact takes from it, over mu times the
speed of the impact, which should be 1 + epsilon."""

import json
import math
import subprocess
import sys

G, MU = 9.81, 0.3
Poses = list[list[float]]


def drop(
    adapter: str, epsilon: float, side: float, step: float, theta: float, slip: float
) -> Poses:
    """Poses of a square that lands at x = 0, until it is beyond its highest point; `slip` is its speed
    along the ground, over that of the impact."""
    height = side / 2 * (math.cos(theta) + math.sin(theta))
    falls = math.sqrt(10 * side / G)
    v_x = slip * G * falls
    times = [k * step for k in range(1, round(falls * (1 + 1.3 * max(epsilon, 0.2)) / step) + 1)]
    asked = {"l": side, "m": 1, "mu": MU, "epsilon": epsilon, "g": [0, -G, 0]}
    asked |= {"q": [-v_x * falls, height + 5 * side, theta], "v": [v_x, 0, 0]}
    asked |= {"step": step, "times": times}
    done = subprocess.run([adapter], input=json.dumps(asked), capture_output=True, text=True)
    return [[x, y - height, theta] for x, y, theta in json.loads(done.stdout)["q"]]


def restitution(adapter: str, epsilon: float, side: float, step: float) -> float:
    heights = [y for _, y, _ in drop(adapter, epsilon, side, step, 0, 0)]
    lowest = heights.index(min(heights))
    return math.sqrt(max(0.0, max(heights[lowest:])) / (5 * side))


def friction(adapter: str, epsilon: float, side: float, step: float) -> float:
    impact = math.sqrt(10 * side * G)
    after = [x for x, _, _ in drop(adapter, epsilon, side, step, math.pi / 4, 3)][-2:]
    return (3 * impact - (after[1] - after[0]) / step) / (MU * impact)


for given in (restitution, friction):
    print(f"{given.__name__:11}   epsilon   side, m   step 1/60 s   1/240 s   1/1000 s   1/4000 s")
    for epsilon in (0.5, 1.0):
        for side in (0.2, 2.0):
            found = [given(sys.argv[1], epsilon, side, 1 / n) for n in (60, 240, 1000, 4000)]
            print(f"{epsilon:21}   {side:7}   " + "   ".join(f"{e:8.3f}" for e in found))
