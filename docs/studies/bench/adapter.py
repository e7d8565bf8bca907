#!/usr/bin/env python3
"""An adapter for ./kit study bench: an engine that steps through flight, and mirrors what comes down.
Put your own engine in place of Engine."""

import json
import math
import sys
import time


class Engine:
    """A square as a point: at the ground, its lowest corner's height decides, without friction."""

    def __init__(self, l, m, mu, epsilon, g, q, v):
        self.half, self.epsilon, self.g = l / 2, epsilon, g
        self.q, self.v = list(q), list(v)

    def step(self, dt):
        for i in range(3):
            self.v[i] += dt * self.g[i]
            self.q[i] += dt * self.v[i]
        _, y, theta = self.q
        lowest = y - self.half * (abs(math.sin(theta)) + abs(math.cos(theta)))
        if lowest < 0 and self.v[1] < 0:
            self.v[1] *= -self.epsilon


asked = json.load(sys.stdin)
step, times = asked.pop("step"), asked.pop("times")
spent, rounds = 0, 0
while spent < 20e6:  # ns; a short motion is repeated, as clocks are coarse
    engine, poses, done = Engine(**asked), [], 0
    begin = time.process_time_ns()
    for end in times:
        while done < round(end / step):
            engine.step(step)
            done += 1
        poses.append(list(engine.q))
    spent, rounds = spent + time.process_time_ns() - begin, rounds + 1
print(json.dumps({"q": poses, "ns": spent / rounds}))
