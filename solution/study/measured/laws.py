"""Fits each law of impact on the training impacts and judges it on the test impacts.

A fit minimises the mean error of the velocity after the impact, over a grid of settings, so that
drawing the trials again (the bootstrap) costs a product of matrices. What is judged is the median
error. The least law is the first whose median can't be told from the best's: the 95 % interval of
the difference, both fitted and judged anew on the same drawn trials, holds zero or less.
"""

import tempfile
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.paths import BUILD
from bounce_grader.sandbox import processes
from measured import body
from measured.rows import Array

PROGRAM = BUILD / "bounce_measured"
# From the smallest on, with the parameters of each.
LAWS = {
    "frictionless": ("epsilon",),
    "sticking": ("epsilon",),
    "newton": ("mu", "epsilon"),
    "poisson": ("mu", "epsilon"),
    "compliant": ("mu", "epsilon", "kappa"),
}
FINE = {"mu": np.linspace(0, 0.6, 61), "epsilon": np.linspace(0, 1, 101)}
COARSE = {"mu": np.linspace(0, 0.6, 31), "epsilon": np.linspace(0, 1, 51)}  # with kappa
KAPPA = np.array([0.5, 1.0, 2.0, 4.0, 8.0])
SEED = 20
LEVEL = (2.5, 97.5)  # percentiles of an interval
LEAST_IMPACTS = 10
Reals = NDArray[np.floating[Any]]


def judge(shape: str, train: Any, test: Any, gyration_squared: float, replicates: int) -> Any:
    """A row for each law: its parameters and its error, with intervals, beside the best impulse."""
    if min(len(train), len(test)) < LEAST_IMPACTS:
        raise UsageError(
            f"{shape}: {len(train)} impacts to fit and {len(test)} to judge are too few; it takes "
            f"{LEAST_IMPACTS} of each"
        )
    random = np.random.default_rng(SEED)
    draws = [_draw(random, table["trial"], replicates) for table in (train, test)]
    rows, medians = [], {}
    for law in LAWS:
        row, medians[law] = _judged(law, train, test, gyration_squared, draws)
        rows.append({"shape": shape, **row})
    table = pd.DataFrame(rows)
    best = table["law"][table["median_m_s"].idxmin()]
    behind = np.array([_interval(medians[law] - medians[best]) for law in LAWS])
    table["behind_low"], table["behind_high"] = behind.T
    table["best"] = (table["law"] == best).astype(int)
    table["least"] = (table.index == np.argmax(behind[:, 0] <= 0)).astype(int)
    floor = body.floor(test, gyration_squared)
    low, high = _interval(_medians(floor[:, None], draws[1]))
    return table.assign(floor_m_s=np.median(floor), floor_low=low, floor_high=high)


def _judged(
    law: str, train: Any, test: Any, gyration_squared: float, draws: list[Array]
) -> tuple[dict[str, Any], Array]:
    """The row, and the median error of each replicate."""
    settings = _grid(law)
    tried = errors(law, train, gyration_squared, settings)
    chosen = np.argmin(tried.mean(axis=0))
    drawn = np.argmin(draws[0] @ tried, axis=1)
    once, place = np.unique(np.append(drawn, chosen), return_inverse=True)
    judged = errors(law, test, gyration_squared, settings[once])
    own = judged[:, place[-1]]
    medians = _medians(judged[:, place[:-1]], draws[1])
    row: dict[str, Any] = {"law": law}
    for i, name in enumerate(("mu", "epsilon", "kappa")):
        values = (settings[chosen, i], *_interval(settings[drawn, i]))
        used = values if name in LAWS[law] else (np.nan, np.nan, np.nan)
        row |= dict(zip((name, f"{name}_low", f"{name}_high"), used))
    row |= {"trained": len(train), "tested": len(test), "median_m_s": np.median(own)}
    row["median_low"], row["median_high"] = _interval(medians)
    row["lower_quartile"], row["upper_quartile"] = np.percentile(own, (25, 75))
    return row, medians


def _grid(law: str) -> Array:
    """The settings: rows of mu, epsilon, kappa."""
    axes = {**(COARSE if "kappa" in LAWS[law] else FINE), "kappa": KAPPA}
    used = [axes[n] if n in LAWS[law] else np.zeros(1) for n in ("mu", "epsilon", "kappa")]
    return np.stack([axis.ravel() for axis in np.meshgrid(*used, indexing="ij")], axis=1)


def _draw(random: np.random.Generator, trial: Any, replicates: int) -> Array:
    """How often each impact is drawn, for each replicate: whole trials are."""
    place, names = pd.factorize(trial)
    counts = random.multinomial(len(names), np.full(len(names), 1 / len(names)), size=replicates)
    return counts[:, place].astype(float)


def _medians(errors: Reals, draws: Array) -> Array:
    """The median of each replicate's column (or of the one column), its rows counted as drawn."""
    errors = np.broadcast_to(errors, draws.T.shape)
    order = np.argsort(errors, axis=0, kind="stable")
    reached = np.cumsum(np.take_along_axis(draws.T, order, axis=0), axis=0)
    middle = np.argmax(reached >= reached[-1] / 2, axis=0)
    return np.take_along_axis(errors, order, axis=0)[middle, np.arange(errors.shape[1])]


def _interval(values: Array) -> Array:
    return np.percentile(values, LEVEL)


def errors(law: str, table: Any, gyration_squared: float, settings: Array) -> NDArray[np.float32]:
    """The error of the velocity after each impact (rows) with each setting (columns), m/s."""
    if not PROGRAM.exists():
        raise KitError("bounce_measured is not built: run ./kit study")
    hits = table[body.COLUMNS].to_numpy(dtype=float, copy=True)
    hits[:, 0] = gyration_squared
    with tempfile.TemporaryDirectory(prefix="bounce-measured-") as name:
        files = [str(Path(name) / file) for file in ("impacts", "settings", "errors")]
        for file, values in zip(files, (hits, settings)):
            Path(file).write_bytes(np.ascontiguousarray(values).tobytes())
        done = processes.run([str(PROGRAM), law, *files])
        if not done.ok:
            raise KitError(f"bounce_measured failed: {done.err.strip() or done.code}")
        out = np.frombuffer(Path(files[-1]).read_bytes(), dtype=np.float32)
    return out.reshape(len(hits), len(settings))
