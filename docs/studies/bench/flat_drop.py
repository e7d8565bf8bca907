#!/usr/bin/env python3
"""./flat_drop.py ADAPTER: the restitution that an engine gives to a square that falls flat: the root
of the height of its first bounce over that of its fall."""

import json
import math
import subprocess
import sys


def given(adapter: str, epsilon: float, side: float, step: float) -> float:
    """The square falls by five sides."""
    fall, g = 5 * side, 9.81
    until = math.sqrt(2 * fall / g) * (1 + 1.3 * max(epsilon, 0.2))  # beyond the highest point
    times = [k * step for k in range(1, round(until / step) + 1)]
    asked = {"l": side, "m": 1, "mu": 0.3, "epsilon": epsilon, "g": [0, -g, 0]}
    asked |= {"q": [0, side / 2 + fall, 0], "v": [0, 0, 0], "step": step, "times": times}
    done = subprocess.run([adapter], input=json.dumps(asked), capture_output=True, text=True)
    heights = [pose[1] - side / 2 for pose in json.loads(done.stdout)["q"]]
    lowest = heights.index(min(heights))
    return math.sqrt(max(0.0, max(heights[lowest:])) / fall)


print("epsilon   side, m   step 1/60 s   1/240 s   1/1000 s   1/4000 s")
for epsilon in (0.5, 1.0):
    for side in (0.2, 2.0):
        found = [given(sys.argv[1], epsilon, side, 1 / n) for n in (60, 240, 1000, 4000)]
        print(f"{epsilon:7}   {side:7}   " + "   ".join(f"{e:8.3f}" for e in found))
