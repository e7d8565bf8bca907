"""What the published numbers don't explain, gravity and inertia: hypotheses, each with a number.

Each is worked out on both halves of the trials; their difference says how well it is known.
"""

from dataclasses import dataclass, replace

import numpy as np

from measured import body as bodies
from measured import ellipses, flights
from measured.body import Body
from measured.flights import Flight, PUBLISHED_SIDE
from measured.impacts import Air, Event, find, RESOLVED
from measured.ladder import halves
from measured.rows import Ellipses, INTERVAL, Trial

GRAVITY = 9.81  # m/s^2
RESTING = 10  # rows
STILL = (2e-4, 3e-3)  # of y (m) and theta (rad): a square that moves less over them lies still


@dataclass(frozen=True)
class Finding:
    about: str  # gravity, drag, inertia, ellipses, metric or approach
    hypothesis: str
    quantity: str
    values: tuple[float, ...]  # of the two halves


def findings(
    trials: list[Trial], events: list[Event], body: Body, air: Air, read: Ellipses
) -> list[Finding]:
    parts = [flights.measure(trials[i::2]) for i in (0, 1)]
    return [
        *_gravity(parts),
        *_drag_alone(parts),
        *_inertia(events),
        *_at_rest(trials, body),
        *_without_drag(trials, air),
        *_ellipses(read),
    ]


def _gravity(parts: list[Flight]) -> list[Finding]:
    found = []
    for laws in zip(*(flights.drags(part) for part in parts)):
        name = laws[0].name
        found.append(Finding("gravity", name, "g, m/s^2", tuple(law.g for law in laws)))
        found.append(Finding("gravity", name, "drag", tuple(law.drag for law in laws)))
        found.append(Finding("gravity", name, "left, m/s^2", tuple(law.left for law in laws)))
    none = [flights.drags(part)[0].g for part in parts]
    clock = tuple(float(np.sqrt(GRAVITY / g) / INTERVAL) for g in none)
    found.append(Finding("gravity", "other frame rate", "rows per second", clock))
    scale = tuple(GRAVITY / g for g in none)
    found.append(Finding("gravity", "other length scale", "true over written length", scale))
    falling = [part.acceleration[part.velocity[:, 1] < -2, 1] for part in parts]
    if min(map(len, falling)) > 0:
        fast = tuple(-float(np.median(a)) for a in falling)
        found.append(Finding("gravity", "falling at over 2 m/s", "g, m/s^2", fast))
    return found


def _drag_alone(parts: list[Flight]) -> list[Finding]:
    """The drag that the other two coordinates ask for, each by itself."""
    return [
        Finding("drag", name, "drag, 1/s", tuple(flights.linear_drag(part, i) for part in parts))
        for i, name in ((0, "v_x"), (2, "omega"))
    ]


def _inertia(events: list[Event]) -> list[Finding]:
    """Adds to the published body one thing after the other."""
    half = halves(np.array([event.trial for event in events]))
    found = []
    steps = {
        "as published": (),
        "theta turned": ("turn", "ground", "slope"),
        "centre moved": ("turn", "ground", "slope", "centre_x", "centre_y"),
        "ground gives way": tuple(name for name in bodies.FREE if name != "side"),
        "side fitted": bodies.FREE,
    }
    parts = [[e for e, mine in zip(events, own) if mine] for own in (half.fit, half.judge)]
    for name, free in steps.items():
        fits = [bodies.fit_geometry(part, free) for part in parts]
        found += _body_findings(name, parts, fits)
    rounded = [_rounded(fit) for fit in fits]
    found += _body_findings("corners rounded", parts, rounded)
    found.append(
        Finding("inertia", "ground gives way", "contact lasts, s", tuple(2 * f.tau for f in fits))
    )
    both = bodies.impacts(events, fits[0])
    clear = np.array([event.residual <= RESOLVED for event in events])
    clear &= bodies.tilt(both.pose[:, 2]) > bodies.STEEP
    speed = -both.approach()
    slow = clear & (speed < np.median(speed[clear]))
    by_speed = (bodies.inertia(both.only(slow)), bodies.inertia(both.only(clear & ~slow)))
    found.append(Finding("inertia", "slow and fast impacts", "r_g^2, m^2", by_speed))
    return found


def _rounded(body: Body) -> Body:
    """The published side with corners so round that they touch where the body's corners do."""
    radius = (PUBLISHED_SIDE - body.side) / 2
    return replace(body, rounding=radius, ground=body.ground - radius)


def _body_findings(name: str, parts: list[list[Event]], fits: list[Body]) -> list[Finding]:
    hits = [bodies.impacts(bodies.steep(part), fit) for part, fit in zip(parts, fits)]
    inertias = [bodies.inertia(own) for own in hits]
    own = [replace(h, gyration_squared=np.full(len(h), r)) for h, r in zip(hits, inertias)]
    misses = [h.approach() * f.tau for h, f in zip(hits, fits)]
    gaps = [bodies.gap(h, f) - m for h, f, m in zip(hits, fits, misses)]

    def finding(quantity: str, values: list[float]) -> Finding:
        return Finding("inertia", name, quantity, tuple(values))

    return [
        finding("side, m", [fit.side for fit in fits]),
        finding("turn, rad", [fit.turn for fit in fits]),
        finding("corner off the ground, m", [float(np.median(np.abs(g))) for g in gaps]),
        finding("r_g^2, m^2", inertias),
        finding("r_g^2 over side^2 / 6", [6 * r / f.side**2 for r, f in zip(inertias, fits)]),
        finding("side of a uniform square, m", [6 * r / f.side for r, f in zip(inertias, fits)]),
        finding("floor, m/s", [float(np.median(bodies.floor(h))) for h in own]),
    ]


def _at_rest(trials: list[Trial], body: Body) -> list[Finding]:
    """By how much theta as written is off a multiple of a right angle where a square lies still."""
    turns, quarter = [], np.pi / 2
    for part in (trials[0::2], trials[1::2]):
        last = [trial.q[-RESTING:] for trial in part]
        still = [q for q in last if np.all(np.ptp(q, axis=0)[1:] < STILL)]
        off = [(q[:, 2].mean() + quarter / 2) % quarter - quarter / 2 for q in still]
        turns.append(float(np.arctan(body.slope) - np.median(off)) if off else float("nan"))
    if not np.all(np.isfinite(turns)):
        return []
    return [Finding("inertia", "squares at rest", "turn, rad", tuple(turns))]


def _without_drag(trials: list[Trial], air: Air) -> list[Finding]:
    inertias = []
    for i in (0, 1):
        events = find(trials[i::2], Air(GRAVITY, 0.0, air.noise)).events
        inertias.append(bodies.fit_geometry(events).gyration_squared)
    return [Finding("inertia", "flight without drag", "r_g^2, m^2", tuple(inertias))]


def _ellipses(read: Ellipses) -> list[Finding]:
    whole = ellipses.impacts(read, ellipses.GYRATION)
    half = halves(whole.trial)
    fitted = tuple(bodies.inertia(whole.only(own)) for own in (half.fit, half.judge))
    published, uniform = ellipses.GYRATION, ellipses.uniform_gyration()
    return [
        Finding("ellipses", "ellipse, fitted", "r_g^2, m^2", fitted),
        Finding("ellipses", "ellipse, as published", "r_g^2, m^2", (published, published)),
        Finding("ellipses", "ellipse, uniform", "r_g^2, m^2", (uniform, uniform)),
    ]
