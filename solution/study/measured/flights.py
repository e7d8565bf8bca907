"""Free flight of the measured squares: gravity, drag and the noise of the positions.

A window of rows without an impact gives the acceleration and the velocity in its middle, by a
parabola. Over many windows the acceleration depends on the velocity; three laws of drag and none
are fitted to that.
"""

from dataclasses import dataclass

import numpy as np

from bounce_grader.common.errors import UsageError
from measured.rows import Array, INTERVAL, Trial

HALF = 5  # rows on each side of a window's middle
CLEAR = 4e-3  # m: how far from the ground a window has to stay
PUBLISHED_SIDE = 0.06  # m
LEAST_WINDOWS = 30


@dataclass(frozen=True)
class Flight:
    velocity: Array  # in the middle of each window: v_x, v_y, omega
    acceleration: Array
    noise: Array  # of x, y (m) and theta (rad): one standard deviation


@dataclass(frozen=True)
class Drag:
    """a_y = -g - drag times a function of v_y; and how well that fits."""

    name: str
    g: float  # m/s^2
    drag: float  # 1/s for the linear law
    left: float  # of the acceleration, m/s^2, root mean square without outliers


def lowest(q: Array, side: float = PUBLISHED_SIDE) -> Array:
    """The lowest corner's height, m."""
    return q[:, 1] - side / 2 * (np.abs(np.cos(q[:, 2])) + np.abs(np.sin(q[:, 2])))


def measure(trials: list[Trial]) -> Flight:
    s = np.arange(-HALF, HALF + 1) * INTERVAL
    parabola = np.linalg.pinv(np.stack([np.ones_like(s), s, s**2], axis=1))
    cubic = np.stack([np.ones_like(s), s, s**2, s**3], axis=1)
    rest = np.eye(len(s)) - cubic @ np.linalg.pinv(cubic)
    velocity, acceleration, squares = [], [], []
    for trial in trials:
        clear = lowest(trial.q) > CLEAR
        for i in range(HALF, len(trial.k) - HALF, HALF):
            window = slice(i - HALF, i + HALF + 1)
            if not clear[window].all() or trial.k[window][-1] - trial.k[window][0] != 2 * HALF:
                continue
            fit = parabola @ trial.q[window]
            velocity.append(fit[1])
            acceleration.append(2 * fit[2])
            squares.append(((rest @ trial.q[window]) ** 2).sum(axis=0) / (len(s) - 4))
    if len(velocity) < LEAST_WINDOWS:
        raise UsageError(
            f"the squares have {len(velocity)} stretches of free flight of {len(s)} rows; "
            f"it takes {LEAST_WINDOWS} to find gravity"
        )
    noise = np.sqrt(np.median(squares, axis=0))
    return Flight(np.array(velocity), np.array(acceleration), noise)


def drags(flight: Flight) -> list[Drag]:
    """Fits the laws of drag to the vertical motion."""
    v, a = flight.velocity[:, 1], flight.acceleration[:, 1]
    laws = {"none": 0 * v, "linear": v, "quadratic": v * np.abs(v), "dry": np.sign(v)}
    return [_fit(name, x, a) for name, x in laws.items()]


def linear_drag(flight: Flight, i: int) -> float:
    """The drag in proportion to the velocity that coordinate i asks for by itself, 1/s."""
    return _fit("linear", flight.velocity[:, i], flight.acceleration[:, i]).drag


def _fit(name: str, x: Array, a: Array) -> Drag:
    columns = np.stack([np.ones_like(x), x], axis=1) if np.any(x) else np.ones((len(x), 1))
    solution, left = robust(columns, a)
    drag = -float(solution[1]) if len(solution) > 1 else 0.0
    return Drag(name, -float(solution[0]), drag, float(np.median(np.abs(left)) * 1.4826))


def robust(columns: Array, target: Array) -> tuple[Array, Array]:
    """Least squares that outliers don't move much: Huber's weights, at 1.5 deviations."""
    weights = np.ones(len(target))
    solution = np.zeros(columns.shape[1])
    for _ in range(30):
        root = np.sqrt(weights)
        solution = np.linalg.lstsq(columns * root[:, None], target * root, rcond=None)[0]
        left = target - columns @ solution
        scale = max(float(np.median(np.abs(left))) * 1.4826, 1e-300)
        weights = 1 / np.maximum(1.0, np.abs(left) / (1.5 * scale))
    return solution, target - columns @ solution
