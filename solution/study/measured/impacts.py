"""Finds the impacts of the measured squares, and the velocities before and after each.

An impact shows as an upward kink of y near the ground. Around it x, y and theta are free flight
with drag on both sides, a line each in the warped time s = (1 - exp(-c t)) / c; the fit has the
time of impact, the pose there, and six velocities, and is least squares with the flight's noise as
weights.
"""

from dataclasses import dataclass

import numpy as np

from measured.flights import Air, lowest
from measured.rows import Array, INTERVAL, Trial

KINK = 40.0  # m/s^2: a larger upward acceleration over three rows is an impact
NEAR = 0.01  # m: the lowest corner has to be this close to the ground
MOST, LEAST = 8, 4  # rows on each side of an impact
TRIES = 17  # times of impact tried in each of REFINED rounds
REFINED = 4


@dataclass(frozen=True)
class Event:
    """One impact: pose at its time and velocities, in the rows' frame."""

    trial: int
    pose: Array
    before: Array
    after: Array
    residual: float  # chi^2 over its degrees of freedom


def find(trials: list[Trial], air: Air) -> tuple[list[Event], int]:
    """The events; and how many more have fewer than LEAST rows to the next or to the end."""
    events, crowded = [], 0
    for trial in trials:
        found = kinks(trial)
        for i, (first, last) in enumerate(found):
            start = max(found[i - 1][1] + 1 if i else 0, first - MOST)
            end = min(found[i + 1][0] if i + 1 < len(found) else len(trial.k), last + 1 + MOST)
            whole = trial.k[end - 1] - trial.k[start] == end - 1 - start
            if first - start < LEAST or end - 1 - last < LEAST or not whole:
                crowded += 1
            else:
                events.append(_event(trial, first, last, slice(start, end), air))
    return events, crowded


def kinks(trial: Trial) -> list[tuple[int, int]]:
    """The first and last row of each impact."""
    y, near = trial.q[:, 1], lowest(trial.q) < NEAR
    found: list[tuple[int, int]] = []
    for i in range(1, len(y) - 1):
        bent = y[i - 1] - 2 * y[i] + y[i + 1] > KINK * INTERVAL**2
        if bent and near[max(0, i - 2) : i + 3].any():
            if found and i - found[-1][1] <= 2:
                found[-1] = (found[-1][0], i)
            else:
                found.append((i, i))
    return found


def _event(trial: Trial, first: int, last: int, rows: slice, air: Air) -> Event:
    t, q = trial.t[rows] - trial.t[first], trial.q[rows]
    low, high = -INTERVAL, (last - first + 1) * INTERVAL
    for _ in range(REFINED):
        tries = np.linspace(low, high, TRIES)
        best = float(tries[np.argmin(_hinges(t, q, tries, air)[1])])
        width = (high - low) / (TRIES - 1)
        low, high = best - width, best + width
    solutions, chi = _hinges(t, q, np.array([best]), air)
    pose, before, after = solutions[0]
    return Event(trial.name, pose, before, after, float(chi[0]) / (3 * len(t) - 10))


def _hinges(t: Array, q: Array, tries: Array, air: Air) -> tuple[Array, Array]:
    """For impacts at these times: pose, velocity before and velocity after; and chi^2."""
    since = t - tries[:, None]
    s = air.warped(since)
    columns = np.stack([np.ones_like(s), np.where(s < 0, s, 0), np.where(s >= 0, s, 0)], axis=-1)
    straight = np.repeat(q[None], len(tries), axis=0)
    straight[:, :, 1] -= air.fallen(since)
    across = columns.transpose(0, 2, 1)
    solution = np.linalg.solve(across @ columns, across @ straight)
    left = (straight - columns @ solution) / air.noise
    return solution, (left**2).sum(axis=(1, 2))
