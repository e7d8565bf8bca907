"""Fits each law on one half of the trials, judges it on the other, and finds the least model.

A fit minimises the mean error of the velocity after the impact. It looks through a grid of settings
and then through a finer one around the best, for a compliant law around the best with each ratio of
stiffness, so that drawing the trials again (the bootstrap) costs a product of matrices. What is
judged is the median error. The best law has the lowest; the least model is the first of the ladder
whose median can't be told from the best's: the 95 % interval of the difference, both judged and
fitted on the same drawn trials, holds zero or less.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from bounce_grader.common.errors import UsageError
from measured import laws
from measured.body import Impacts
from measured.laws import Law
from measured.rows import Array, Mask, Names

Reals = NDArray[np.floating[Any]]

SEED = 20
LEVEL = (2.5, 97.5)  # percentiles of an interval
LEAST_IMPACTS = 10  # in each half


@dataclass(frozen=True)
class Half:
    fit: Mask  # True where an impact belongs to the half that is fitted
    judge: Mask


@dataclass(frozen=True)
class Group:
    """Impacts that share a parameter set; the mean over its shapes is taken with equal weights."""

    name: str
    shapes: tuple[Impacts, ...]
    floors: tuple[Array, ...]  # the error of the best impulse for each impact
    ladder: tuple[Law, ...]


@dataclass(frozen=True)
class Rung:
    law: Law
    setting: Array  # mu, epsilon, kappa
    low: Array  # of the settings' interval
    high: Array
    median: float  # m/s, judged
    interval: tuple[float, float]
    quartiles: tuple[float, float]
    behind: tuple[float, float]  # the interval of the median less the best law's


@dataclass(frozen=True)
class Verdict:
    group: str
    fitted: int
    judged: int
    fitted_trials: int
    judged_trials: int
    floor: float
    floor_interval: tuple[float, float]
    rungs: list[Rung]
    best: str
    least: str


class Grids:
    """The errors over each law's grid: groups share their shapes, and each is worked out once."""

    def __init__(self) -> None:
        self._known: dict[tuple[str, int], tuple[Impacts, NDArray[np.float32]]] = {}

    def errors(self, law: Law, shape: Impacts) -> NDArray[np.float32]:
        """Of the half that is fitted; the shape is kept, so that its id stays its own."""
        key = (law.name, id(shape))
        if key not in self._known:
            fitted = shape.only(halves(shape.trial).fit)
            self._known[key] = shape, laws.errors(law, fitted, laws.grid(law))
        return self._known[key][1]


@dataclass(frozen=True)
class _Draws:
    """How often each impact of a half is drawn, for each replicate."""

    fit: list[NDArray[np.float32]]  # by shape: replicate, impact
    judge: list[NDArray[np.float32]]


def halves(trial: Names) -> Half:
    """Every other trial, in the order of their numbers, is fitted."""
    place = np.searchsorted(np.unique(trial), trial)
    return Half(place % 2 == 0, place % 2 == 1)


def judge(group: Group, replicates: int, grids: Grids) -> Verdict:
    split = [halves(shape.trial) for shape in group.shapes]
    parts = [
        (shape.only(half.fit), shape.only(half.judge)) for shape, half in zip(group.shapes, split)
    ]
    for fitted, judged in parts:
        if min(len(fitted), len(judged)) < LEAST_IMPACTS:
            raise UsageError(
                f"{group.name}: {len(fitted)} impacts to fit and {len(judged)} to judge are too "
                f"few; it takes {LEAST_IMPACTS} of each"
            )
    draws = _draw(parts, replicates)
    tried = [
        _try(law, [grids.errors(law, shape) for shape in group.shapes], parts, draws)
        for law in group.ladder
    ]
    floors = [floor[half.judge] for floor, half in zip(group.floors, split)]
    floor_medians = _medians([np.repeat(f[:, None], replicates, 1) for f in floors], draws.judge)
    best = min(tried, key=lambda one: one[0].median)
    rungs = [_behind(rung, medians, best[1]) for rung, medians in tried]
    return Verdict(
        group.name,
        sum(len(fitted) for fitted, _ in parts),
        sum(len(judged) for _, judged in parts),
        sum(len(np.unique(fitted.trial)) for fitted, _ in parts),
        sum(len(np.unique(judged.trial)) for _, judged in parts),
        float(np.mean([np.median(floor) for floor in floors])),
        _interval(floor_medians),
        rungs,
        best[0].law.name,
        next(rung.law.name for rung in rungs if rung.behind[0] <= 0),
    )


def _draw(parts: list[tuple[Impacts, Impacts]], replicates: int) -> _Draws:
    random = np.random.default_rng(SEED)

    def drawn(hits: Impacts) -> NDArray[np.float32]:
        names, place = np.unique(hits.trial, return_inverse=True)
        shares = np.full(len(names), 1 / len(names))
        counts = random.multinomial(len(names), shares, size=replicates)
        return counts[:, place].astype(np.float32)

    return _Draws([drawn(fitted) for fitted, _ in parts], [drawn(judged) for _, judged in parts])


def _try(
    law: Law,
    coarse: list[NDArray[np.float32]],
    parts: list[tuple[Impacts, Impacts]],
    draws: _Draws,
) -> tuple[Rung, Array]:
    """Fits and judges a law, whose errors over its grid are known; gives its medians by replicate,
    too."""
    settings = laws.grid(law)
    means = sum(e.mean(axis=0) for e in coarse)
    centers = [
        settings[np.argmin(np.where(settings[:, 2] == kappa, means, np.inf))]
        for kappa in np.unique(settings[:, 2])
    ]
    finer = np.concatenate([laws.around(law, center) for center in centers])
    fine = [laws.errors(law, fitted, finer) for fitted, _ in parts]
    chosen = finer[np.argmin(sum(e.mean(axis=0) for e in fine))]
    settings = np.concatenate([settings, finer])
    means = sum(
        draw @ np.concatenate([a, b], axis=1) / draw.sum(axis=1, keepdims=True)
        for draw, a, b in zip(draws.fit, coarse, fine)
    )
    by_replicate = settings[np.argmin(means, axis=1)]
    once, place = np.unique(np.vstack([chosen, by_replicate]), axis=0, return_inverse=True)
    place = place.ravel()
    judged = [laws.errors(law, part, once) for _, part in parts]
    own = [e[:, place[0]] for e in judged]
    medians = _medians([e[:, place[1:]] for e in judged], draws.judge)
    low, high = np.percentile(by_replicate, LEVEL, axis=0)
    quartiles = np.mean([np.percentile(e, (25, 75)) for e in own], axis=0)
    rung = Rung(
        law,
        chosen,
        np.minimum(low, chosen),
        np.maximum(high, chosen),
        float(np.mean([np.median(e) for e in own])),
        _interval(medians),
        (float(quartiles[0]), float(quartiles[1])),
        (0.0, 0.0),
    )
    return rung, medians


def _medians(errors: Sequence[Reals], draws: list[NDArray[np.float32]]) -> Array:
    """The median by replicate: the mean over the shapes."""
    return np.mean([_weighted(e, d.T) for e, d in zip(errors, draws)], axis=0)


def _weighted(errors: Reals, weights: Reals) -> Array:
    """The median of each column, its rows counted as often as the weights say."""
    order = np.argsort(errors, axis=0, kind="stable")
    reached = np.cumsum(np.take_along_axis(weights, order, axis=0), axis=0)
    middle = np.argmax(reached >= reached[-1] / 2, axis=0)
    return np.take_along_axis(errors, order, axis=0)[middle, np.arange(errors.shape[1])]


def _behind(rung: Rung, medians: Array, best: Array) -> Rung:
    return replace(rung, behind=_interval(medians - best))


def _interval(values: Array) -> tuple[float, float]:
    low, high = np.percentile(values, LEVEL)
    return float(low), float(high)
