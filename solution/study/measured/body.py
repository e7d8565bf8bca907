"""The measured square as a body: where its corners are, how high the ground is, its inertia.

Positions alone give the geometry: at an impact the lowest corner is on the ground, to what the
ground gives way, tau times the speed of approach. The balance of angular momentum about the corner
gives the inertia, r_g^2 domega = r_x dv_y - r_y dv_x, whatever the law of impact.
"""

from dataclasses import dataclass, replace

import numpy as np

from bounce_grader.common.errors import UsageError
from measured.flights import PUBLISHED_SIDE, robust
from measured.impacts import Event, RESOLVED
from measured.rows import Array, Mask, Names

STEEP = 0.12  # rad: a side that leans more than this strikes with one corner
LEAST_IMPACTS = 30
CORNERS = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]])  # in units of half a side


@dataclass(frozen=True)
class Body:
    side: float  # m
    turn: float  # rad, to be added to theta as written
    centre_x: float  # of the square, in its own frame, from the point that was tracked, m
    centre_y: float
    ground: float  # its height at x = 0, m
    slope: float
    tau: float  # s: how far the ground gives way, over the speed of approach
    gyration_squared: float  # m^2
    rounding: float = 0.0  # m: the corners' radius


@dataclass(frozen=True)
class Impacts:
    """Impacts as arrays: motions of the centre, arms of both corners of the side that strikes."""

    trial: Names
    pose: Array  # x, y, theta
    before: Array  # v_x, v_y, omega
    after: Array
    corner: Array  # r of the corner that strikes: x, y
    other: Array  # r of the other corner of the side below
    gyration_squared: Array

    def __len__(self) -> int:
        return len(self.trial)

    def only(self, chosen: Mask) -> "Impacts":
        return Impacts(*(getattr(self, name)[chosen] for name in self.__dataclass_fields__))

    def approach(self) -> Array:
        """v_n of the corner before, m/s."""
        return self.before[:, 1] + self.corner[:, 0] * self.before[:, 2]


PUBLISHED = Body(PUBLISHED_SIDE, 0, 0, 0, 0, 0, 0, PUBLISHED_SIDE**2 / 6)


def arms(theta: Array, body: Body) -> Array:
    """The four arms from the centre: event, corner, (x, y)."""
    cosine, sine = np.cos(theta + body.turn), np.sin(theta + body.turn)
    x, y = body.side / 2 * CORNERS.T
    turned = np.stack([np.outer(cosine, x) - np.outer(sine, y)], axis=2)
    up = np.stack([np.outer(sine, x) + np.outer(cosine, y)], axis=2)
    return np.concatenate([turned, up - body.rounding], axis=2)


def centred(pose: Array, velocity: Array, body: Body) -> tuple[Array, Array]:
    """Pose and velocity of the square's centre, with theta measured from its sides."""
    theta = pose[:, 2] + body.turn
    cosine, sine = np.cos(theta), np.sin(theta)
    x = cosine * body.centre_x - sine * body.centre_y
    y = sine * body.centre_x + cosine * body.centre_y
    moved, faster = pose.copy(), velocity.copy()
    moved[:, 0] += x
    moved[:, 1] += y
    moved[:, 2] = theta
    faster[:, 0] -= velocity[:, 2] * y
    faster[:, 1] += velocity[:, 2] * x
    return moved, faster


def impacts(events: list[Event], body: Body) -> Impacts:
    pose = np.array([event.pose for event in events])
    all_arms = arms(pose[:, 2], body)
    lowest = all_arms[:, :, 1].argmin(axis=1)
    n = np.arange(len(events))
    beside = np.stack([(lowest + 1) % 4, (lowest + 3) % 4], axis=1)
    second = np.where(
        all_arms[n, beside[:, 0], 1] <= all_arms[n, beside[:, 1], 1], beside[:, 0], beside[:, 1]
    )
    moved, before = centred(pose, np.array([event.before for event in events]), body)
    after = centred(pose, np.array([event.after for event in events]), body)[1]
    return Impacts(
        np.array([event.trial for event in events]),
        moved,
        before,
        after,
        all_arms[n, lowest],
        all_arms[n, second],
        np.full(len(events), body.gyration_squared),
    )


def gap(hits: Impacts, body: Body) -> Array:
    """The corner's height over the ground, m, at the time of impact."""
    x = hits.pose[:, 0] + hits.corner[:, 0]
    return hits.pose[:, 1] + hits.corner[:, 1] - body.ground - body.slope * x


def tilt(theta: Array) -> Array:
    """The angle between the lowest side and the ground, rad, from 0 to pi/4."""
    quarter = np.pi / 2
    return np.abs((theta + quarter / 2) % quarter - quarter / 2)


def seconds_between(hits: Impacts) -> Array:
    """How long after the first corner the other one would strike, s, if the first rebounded
    without friction at half its speed. That is for sorting alone."""
    height = hits.other[:, 1] - hits.corner[:, 1]
    x, other_x = hits.corner[:, 0], hits.other[:, 0]
    pushed = np.maximum(-1.5 * hits.approach(), 0) / (1 + x**2 / hits.gyration_squared)
    speed = hits.before[:, 1] + other_x * hits.before[:, 2]
    speed = -(speed + pushed * (1 + x * other_x / hits.gyration_squared))
    return np.where(speed > 0, height / np.maximum(speed, 1e-9), np.inf)


FREE = ("side", "turn", "centre_x", "centre_y", "ground", "slope", "tau")


def fit_geometry(events: list[Event], free: tuple[str, ...] = FREE) -> Body:
    """Finds the geometry with which the corner is on the ground at each impact of one corner."""
    clear = steep(events)
    body = PUBLISHED
    for _ in range(25 if free else 0):
        misses = _misses(clear, body)
        slopes = []
        for name in free:
            shifted = replace(body, **{name: getattr(body, name) + 1e-6})
            slopes.append((_misses(clear, shifted) - misses) / 1e-6)
        step, _ = robust(np.stack(slopes, axis=1), -misses)
        body = replace(body, **{name: getattr(body, name) + d for name, d in zip(free, step)})
    return replace(body, gyration_squared=inertia(impacts(clear, body)))


def steep(events: list[Event]) -> list[Event]:
    found = [e for e in events if e.residual <= RESOLVED and tilt(e.pose[2]) > STEEP]
    if len(found) < LEAST_IMPACTS:
        raise UsageError(
            f"the squares have {len(found)} clear impacts of one corner to find their corners "
            f"from; it takes {LEAST_IMPACTS}"
        )
    return found


def _misses(events: list[Event], body: Body) -> Array:
    hits = impacts(events, body)
    return gap(hits, body) - body.tau * hits.approach()


def moments(hits: Impacts) -> tuple[Array, Array]:
    """The impulse's moment about the centre per mass, m^2/s, and the change of omega, rad/s."""
    change = hits.after - hits.before
    return hits.corner[:, 0] * change[:, 1] - hits.corner[:, 1] * change[:, 0], change[:, 2]


def inertia(hits: Impacts) -> float:
    """r_g^2 by the balance about the corner, m^2: the one with the least sum of |domega| left."""
    moment, turned = moments(hits)
    return 1 / _weighted_median(turned / moment, np.abs(moment))


def _weighted_median(values: Array, weights: Array) -> float:
    order = np.argsort(values)
    reached = np.cumsum(weights[order])
    return float(values[order][np.searchsorted(reached, reached[-1] / 2)])


def floor(hits: Impacts) -> Array:
    """The error of the best impulse at the corner: what no law of impact can get below, m/s.

    The change of velocity that is left is orthogonal, in the mass metric, to both columns of J; so
    it is the imbalance e of angular momentum, r_g |e| / sqrt(1 + r^2 / r_g^2).
    """
    moment, turned = moments(hits)
    radius = (hits.corner**2).sum(axis=1)
    left = np.abs(turned - moment / hits.gyration_squared)
    return np.sqrt(hits.gyration_squared) * left / np.sqrt(1 + radius / hits.gyration_squared)


def floor_of_side(hits: Impacts) -> Array:
    """The same for impulses at both corners: they act like one anywhere between them."""
    change = hits.after - hits.before
    lift = np.where(np.abs(change[:, 1]) > 1e-9, change[:, 1], 1e-9)
    wanted = (hits.gyration_squared * change[:, 2] + hits.corner[:, 1] * change[:, 0]) / lift
    low = np.minimum(hits.corner[:, 0], hits.other[:, 0])
    high = np.maximum(hits.corner[:, 0], hits.other[:, 0])
    middle = hits.corner.copy()
    middle[:, 0] = np.clip(wanted, low, high)
    left = floor(replace(hits, corner=middle))
    return np.where(middle[:, 0] == wanted, 0.0, left)  # and not what rounding makes of it
