"""The measured square as a body: where its corners are, how high the ground is, its inertia; and
impacts as rows of a table.

Positions alone give the geometry: at an impact the lowest corner is on the ground, to what the
ground gives way, tau times the speed of approach. The balance of angular momentum about the corner
gives the inertia, r_g^2 domega = r_x dv_y - r_y dv_x, whatever the law of impact.

A table of impacts has the columns COLUMNS: r from the centre of mass to the corner that strikes, m,
and velocities of that centre, m/s and rad/s.
"""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pandas as pd

from bounce_grader.common.errors import UsageError
from measured.flights import PUBLISHED_SIDE, robust
from measured.impacts import Event
from measured.rows import Array

COLUMNS = "trial r_x_m r_y_m v_x_m_s v_y_m_s omega_rad_s v_x_after_m_s v_y_after_m_s".split()
COLUMNS.append("omega_after_rad_s")
STEEP = 0.12  # rad: a side that leans more than this strikes with one corner
RESOLVED = 6.0  # chi^2 over its degrees of freedom: below it one impact describes the rows
LEAST_IMPACTS = 30
CORNERS = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]])  # in units of half a side


@dataclass(frozen=True)
class Body:
    side: float = PUBLISHED_SIDE  # m
    turn: float = 0.0  # rad, to be added to theta as written
    centre_x: float = 0.0  # of the square, in its own frame, from the point that was tracked, m
    centre_y: float = 0.0
    ground: float = 0.0  # its height at x = 0, m
    slope: float = 0.0
    tau: float = 0.0  # s: how far the ground gives way, over the speed of approach
    gyration_squared: float = PUBLISHED_SIDE**2 / 6  # m^2


FITTED = ("side", "turn", "centre_x", "centre_y", "ground", "slope", "tau")


def impacts(events: list[Event], body: Body) -> Any:
    """The table; with `gap`, the corner's height over the ground at the time of impact, m, and
    `wait`, how long after it the other corner of its side would strike, s, if the first rebounded
    without friction at half its speed."""
    pose, before, after = (
        np.array([getattr(e, name) for e in events]) for name in ("pose", "before", "after")
    )
    theta = pose[:, 2] + body.turn
    arms = _turned(theta, body.side / 2 * CORNERS)
    centre = _turned(theta, np.array([[body.centre_x, body.centre_y]]))[:, 0]
    for velocity in (before, after):
        velocity[:, :2] += velocity[:, 2:] * np.stack([-centre[:, 1], centre[:, 0]], axis=1)
    order, rows = np.argsort(arms[:, :, 1], axis=1), np.arange(len(events))
    corner, other = (arms[rows, order[:, i]] for i in (0, 1))
    place = pose[:, :2] + centre + corner
    table = pd.DataFrame(np.hstack([corner, before, after]), columns=COLUMNS[1:])
    table.insert(0, "trial", [event.trial for event in events])
    table["gap"] = place[:, 1] - body.ground - body.slope * place[:, 0]
    table["wait"] = _wait(table, other, body.gyration_squared)
    return table


def _turned(theta: Array, points: Array) -> Array:
    """Event, point, (x, y)."""
    cosine, sine = np.cos(theta)[:, None], np.sin(theta)[:, None]
    x, y = points.T
    return np.stack([cosine * x - sine * y, sine * x + cosine * y], axis=2)


def _wait(table: Any, other: Array, gyration_squared: float) -> Array:
    x, other_x = table["r_x_m"].to_numpy(), other[:, 0]
    pushed = np.maximum(-1.5 * approach(table), 0) / (1 + x**2 / gyration_squared)
    speed = table["v_y_m_s"] + other_x * table["omega_rad_s"]
    speed = -(speed + pushed * (1 + x * other_x / gyration_squared))
    height = other[:, 1] - table["r_y_m"]
    return np.where(speed > 0, height / np.maximum(speed, 1e-9), np.inf)


def approach(table: Any) -> Any:
    """v_n of the corner before, m/s."""
    return table["v_y_m_s"] + table["r_x_m"] * table["omega_rad_s"]


def fit(events: list[Event]) -> Body:
    """Finds the geometry with which the corner is on the ground at each impact of one corner."""
    quarter = np.pi / 2
    clear = [
        e
        for e in events
        if e.residual <= RESOLVED and abs((e.pose[2] + quarter / 2) % quarter - quarter / 2) > STEEP
    ]
    if len(clear) < LEAST_IMPACTS:
        raise UsageError(
            f"the squares have {len(clear)} clear impacts of one corner to find their corners "
            f"from; it takes {LEAST_IMPACTS}"
        )

    def body_of(values: Array) -> Body:
        return Body(**dict(zip(FITTED, values)))

    def misses(values: Array) -> Array:
        table = impacts(clear, body_of(values))
        off: Array = (table["gap"] - values[-1] * approach(table)).to_numpy()
        return off

    body = body_of(robust(misses, np.array([getattr(Body(), name) for name in FITTED])))
    return replace(body, gyration_squared=inertia(impacts(clear, body)))


def moments(table: Any) -> tuple[Array, Array]:
    """The impulse's moment about the centre per mass, m^2/s, and the change of omega, rad/s."""
    r, before, after = (table[COLUMNS[i:j]].to_numpy() for i, j in ((1, 3), (3, 6), (6, 9)))
    change = after - before
    return r[:, 0] * change[:, 1] - r[:, 1] * change[:, 0], change[:, 2]


def inertia(table: Any) -> float:
    """r_g^2 by the balance about the corner, m^2: the one with the least sum of |domega| left."""
    moment, turned = moments(table)
    order = np.argsort(turned / moment)
    reached = np.cumsum(np.abs(moment)[order])
    return 1 / float((turned / moment)[order][np.searchsorted(reached, reached[-1] / 2)])


def floor(table: Any, gyration_squared: float) -> Array:
    """The error of the best impulse at the corner: what no law of impact can get below, m/s.

    The change of velocity that is left is orthogonal, in the mass metric, to both columns of J; so
    it is the imbalance e of angular momentum, r_g |e| / sqrt(1 + r^2 / r_g^2).
    """
    moment, turned = moments(table)
    radius = (table[["r_x_m", "r_y_m"]].to_numpy() ** 2).sum(axis=1)
    left = np.abs(turned - moment / gyration_squared)
    return np.sqrt(gyration_squared) * left / np.sqrt(1 + radius / gyration_squared)
