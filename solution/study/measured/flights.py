"""Free flight of the measured squares: gravity, drag and the noise of the positions.

A window of rows without an impact gives the acceleration and the velocity in its middle, by a
parabola; over many windows a_y = -g - drag v_y.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares

from bounce_grader.common.errors import UsageError
from measured.rows import Array, INTERVAL, Trial

HALF = 5  # rows on each side of a window's middle
CLEAR = 4e-3  # m: how far from the ground a window has to stay
PUBLISHED_SIDE = 0.06  # m
LEAST_WINDOWS = 30


@dataclass(frozen=True)
class Air:
    g: float  # m/s^2
    drag: float  # 1/s of every velocity
    noise: Array  # of x, y (m) and theta (rad): one standard deviation

    def warped(self, t: Array) -> Array:
        return -np.expm1(-self.drag * t) / self.drag if self.drag > 1e-6 else t

    def fallen(self, t: Array) -> Array:
        """y without velocity at t = 0."""
        if self.drag > 1e-6:
            return -self.g / self.drag * (t - self.warped(t))
        return -self.g / 2 * t**2


def lowest(q: Array, side: float = PUBLISHED_SIDE) -> Array:
    """The lowest corner's height, m."""
    return q[:, 1] - side / 2 * (np.abs(np.cos(q[:, 2])) + np.abs(np.sin(q[:, 2])))


def measure(trials: list[Trial]) -> Air:
    s = np.arange(-HALF, HALF + 1) * INTERVAL
    parabola = np.linalg.pinv(np.vander(s, 3, increasing=True))
    cubic = np.vander(s, 4, increasing=True)
    rest = np.eye(len(s)) - cubic @ np.linalg.pinv(cubic)
    fits, squares = [], []
    for trial in trials:
        clear = lowest(trial.q) > CLEAR
        for i in range(HALF, len(trial.k) - HALF, HALF):
            rows = slice(i - HALF, i + HALF + 1)
            if clear[rows].all() and trial.k[rows][-1] - trial.k[rows][0] == 2 * HALF:
                fits.append((parabola @ trial.q[rows])[:, 1])
                squares.append(((rest @ trial.q[rows]) ** 2).sum(axis=0) / (len(s) - 4))
    if len(fits) < LEAST_WINDOWS:
        raise UsageError(
            f"the squares have {len(fits)} stretches of free flight of {len(s)} rows; "
            f"it takes {LEAST_WINDOWS} to find gravity"
        )
    _, v, half_a = np.array(fits).T
    g, drag = robust(lambda p: 2 * half_a + p[0] + p[1] * v, np.array([9.8, 0.0]))
    return Air(float(g), max(float(drag), 0.0), np.sqrt(np.median(squares, axis=0)))


def robust(left: Callable[[Array], Array], start: Array) -> Array:
    """Least squares that outliers don't move much: Huber's loss, at 1.5 deviations."""
    solution = start
    for _ in range(5):
        scale = max(1.5 * 1.4826 * float(np.median(np.abs(left(solution)))), 1e-12)
        solution = least_squares(left, solution, loss="huber", f_scale=scale, x_scale="jac").x
    return solution
