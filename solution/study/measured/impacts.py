"""Finds the impacts of the measured squares, and the velocities before and after each.

An impact shows as an upward kink of y near the ground. Around it x, y and theta are free flight
with drag on both sides, a line each in the warped time s = (1 - exp(-c t)) / c; the fit has the
time of impact, the pose there, and six velocities, and is least squares with the flight's noise as
weights. Where both corners of a side strike within a row or two, the pose is not continuous to the
rows' accuracy: then each side of the event has lines of its own, and the rows between are left out.
"""

from dataclasses import dataclass

import numpy as np

from measured.flights import lowest
from measured.rows import Array, INTERVAL, Trial

KINK = 40.0  # m/s^2: a larger upward acceleration over three rows is an impact
NEAR = 0.01  # m: the lowest corner has to be this close to the ground
MOST, LEAST = 8, 4  # rows on each side of an impact
TRIES = 17  # times of impact tried in each of REFINED rounds
REFINED = 4
RESOLVED = 6.0  # chi^2 over its degrees of freedom: below it one hinge describes the rows


@dataclass(frozen=True)
class Air:
    """What the flight has shown: gravity, drag, noise."""

    g: float
    drag: float
    noise: Array

    def warped(self, t: Array) -> Array:
        return -np.expm1(-self.drag * t) / self.drag if self.drag > 1e-6 else t

    def fallen(self, t: Array) -> Array:
        """y without velocity at t = 0."""
        if self.drag > 1e-6:
            return -self.g / self.drag * (t - self.warped(t))
        return -self.g / 2 * t**2


@dataclass(frozen=True)
class Event:
    """One impact, or two that can't be told apart: pose and velocities in the rows' frame."""

    trial: int
    pose: Array  # at the time of impact, by the lines before
    before: Array
    after: Array
    residual: float  # of one hinge: chi^2 over its degrees of freedom
    apart: float  # of separate lines on both sides
    deviation: Array  # one standard deviation of after - before, by the noise


@dataclass(frozen=True)
class Found:
    events: list[Event]
    crowded: int  # left out: fewer than LEAST rows to the next impact or to the end


def find(trials: list[Trial], air: Air) -> Found:
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
                events.append(_event(trial, first, last, start, end, air))
    return Found(events, crowded)


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


def _event(trial: Trial, first: int, last: int, start: int, end: int, air: Air) -> Event:
    t, q = trial.t[start:end] - trial.t[first], trial.q[start:end]
    low, high = -INTERVAL, (last - first + 1) * INTERVAL
    best = 0.0
    for _ in range(REFINED):
        tries = np.linspace(low, high, TRIES)
        best = float(tries[np.argmin(_hinges(t, q, tries, air)[1])])
        width = (high - low) / (TRIES - 1)
        low, high = best - width, best + width
    solutions, chi = _hinges(t, q, np.array([best]), air)
    residual = float(chi[0]) / (3 * len(t) - 10)
    before, after, apart, deviation = _two_lines(t, q, first - start, last - start, air)
    if residual <= RESOLVED:
        return _hinged(trial.name, best, t, solutions[0], residual, apart, air)
    at = _meeting(before, after, air, -INTERVAL, (last - first + 1) * INTERVAL)
    pose, velocity = _moved(before, at, air)
    return Event(
        trial.name,
        pose,
        velocity,
        _moved(after, at, air)[1],
        residual,
        apart,
        deviation,
    )


def _hinged(
    trial: int,
    at: float,
    t: Array,
    solution: Array,
    residual: float,
    apart: float,
    air: Air,
) -> Event:
    columns = _columns(t - at, air)
    spread = np.linalg.inv(columns.T @ columns)
    share = spread[1, 1] + spread[2, 2] - 2 * spread[1, 2]
    return Event(
        trial,
        solution[0],
        solution[1],
        solution[2],
        residual,
        apart,
        air.noise * np.sqrt(share),
    )


def _columns(t: Array, air: Air) -> Array:
    s = air.warped(t)
    return np.stack([np.ones_like(s), np.where(s < 0, s, 0), np.where(s >= 0, s, 0)], axis=-1)


def _hinges(t: Array, q: Array, tries: Array, air: Air) -> tuple[Array, Array]:
    """For impacts at these times: pose, velocity before and velocity after; and chi^2."""
    since = t - tries[:, None]
    columns = _columns(since, air)
    straight = np.repeat(q[None], len(tries), axis=0)
    straight[:, :, 1] -= air.fallen(since)
    across = columns.transpose(0, 2, 1)
    solution = np.linalg.solve(across @ columns, across @ straight)
    left = (straight - columns @ solution) / air.noise
    return solution, (left**2).sum(axis=(1, 2))


def _two_lines(
    t: Array, q: Array, first: int, last: int, air: Air
) -> tuple[Array, Array, float, Array]:
    """Pose and velocity at t = 0 of the rows before and of those after; chi^2 over its degrees of
    freedom; and the deviation of the difference of velocities."""
    lines, chi, variance, rows = [], 0.0, 0.0, 0
    for part in (slice(0, first), slice(last + 1, len(t))):
        s = air.warped(t[part])
        columns = np.stack([np.ones_like(s), s], axis=1)
        straight = q[part].copy()
        straight[:, 1] -= air.fallen(t[part])
        line = np.linalg.lstsq(columns, straight, rcond=None)[0]
        chi += float((((straight - columns @ line) / air.noise) ** 2).sum())
        variance += float(np.linalg.inv(columns.T @ columns)[1, 1])
        rows += len(s)
        lines.append(line)
    return lines[0], lines[1], chi / (3 * rows - 12), air.noise * np.sqrt(variance)


def _moved(line: Array, t: float, air: Air) -> tuple[Array, Array]:
    """Pose and velocity at t."""
    at = np.array(t)
    pose = line[0] + line[1] * air.warped(at)
    pose[1] += float(air.fallen(at))
    velocity = line[1] * np.exp(-air.drag * t)
    velocity[1] -= air.g * float(air.warped(at))
    return pose, velocity


def _meeting(before: Array, after: Array, air: Air, low: float, high: float) -> float:
    """When both heights are the same; in the middle where they never are."""
    closing = before[1, 1] - after[1, 1]
    s = (after[0, 1] - before[0, 1]) / closing if closing < 0 else np.inf
    return float(s) if low <= s <= high else (low + high) / 2
