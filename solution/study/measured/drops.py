"""Whole drops: how far the models get away from the measured pose over half a second."""

from dataclasses import dataclass

import numpy as np

from bounce_grader.common.errors import UsageError
from measured import body as bodies
from measured import laws
from measured.body import Body
from measured.impacts import Air, kinks
from measured.rows import Array, INTERVAL, Trial

SAMPLES = 125  # rows: half a second
FIRST = 8  # rows that give the start
FAR = 0.01  # m: an error beyond it ends the forecast
SEED = 21
LEAST_DROPS = 5


@dataclass(frozen=True)
class Forecast:
    model: str
    setting: Array
    median: Array  # of the error by row, m, in the mass metric
    lower: Array
    upper: Array
    horizon: float  # s until the median error passes FAR; the whole drop if it never does


@dataclass(frozen=True)
class Drops:
    count: int
    first_impact: float  # s after the start, the median
    forecasts: list[Forecast]
    spread: Array  # by row, m: how far apart two starts get that the noise can't tell apart


@dataclass(frozen=True)
class _Starts:
    trials: list[Trial]
    states: Array  # pose and velocity of the centre at the first row
    deviation: Array  # of each, one standard deviation
    first_impact: float


def forecast(
    trials: list[Trial], body: Body, air: Air, models: list[tuple[str, Array]], best: str
) -> Drops:
    """`best` is the model that the spread of two starts is worked out with."""
    starts = _starts(trials, body, air)
    seen = np.stack([_seen(trial, body) for trial in starts.trials])
    forecasts, spread = [], np.zeros(SAMPLES)
    for name, setting in models:
        poses = laws.drops(name, body, air, starts.states, setting, SAMPLES)
        forecasts.append(_forecast(name, setting, _distance(poses, seen, body)))
        if name == best:
            noise = np.random.default_rng(SEED).normal(size=starts.states.shape)
            other = starts.states + noise * starts.deviation
            again = laws.drops(name, body, air, other, setting, SAMPLES)
            spread = np.median(_distance(poses, again, body), axis=0)
    return Drops(len(starts.trials), starts.first_impact, forecasts, spread)


def _starts(trials: list[Trial], body: Body, air: Air) -> _Starts:
    used, states, impacts = [], [], []
    s = air.warped(np.arange(FIRST) * INTERVAL)
    columns = np.stack([np.ones_like(s), s], axis=1)
    for trial in trials:
        found = kinks(trial)
        whole = len(trial.k) > SAMPLES and trial.k[SAMPLES] - trial.k[0] == SAMPLES
        if not whole or not found or found[0][0] <= FIRST:
            continue
        straight = trial.q[:FIRST].copy()
        straight[:, 1] -= air.fallen(np.arange(FIRST) * INTERVAL)
        line = np.linalg.lstsq(columns, straight, rcond=None)[0]
        pose, velocity = bodies.centred(line[:1], line[1:], body)
        used.append(trial)
        states.append(np.concatenate([pose[0], velocity[0]]))
        impacts.append(found[0][0] * INTERVAL)
    if len(used) < LEAST_DROPS:
        raise UsageError(
            f"{len(used)} drops of squares begin with {FIRST} rows of flight and last "
            f"{SAMPLES} rows; it takes {LEAST_DROPS}"
        )
    share = np.sqrt(np.diag(np.linalg.inv(columns.T @ columns)))
    deviation = np.concatenate([air.noise * share[0], air.noise * share[1]])
    return _Starts(used, np.array(states), deviation, float(np.median(impacts)))


def _seen(trial: Trial, body: Body) -> Array:
    pose = trial.q[1 : SAMPLES + 1]
    return bodies.centred(pose, np.zeros_like(pose), body)[0]


def _distance(poses: Array, others: Array, body: Body) -> Array:
    """In the mass metric, m."""
    apart = poses - others
    return np.sqrt((apart[..., :2] ** 2).sum(axis=-1) + body.gyration_squared * apart[..., 2] ** 2)


def _forecast(model: str, setting: Array, errors: Array) -> Forecast:
    lower, median, upper = np.percentile(errors, (25, 50, 75), axis=0)
    beyond = np.flatnonzero(median > FAR)
    rows = beyond[0] if len(beyond) else SAMPLES
    return Forecast(model, setting, median, lower, upper, float(rows * INTERVAL))
