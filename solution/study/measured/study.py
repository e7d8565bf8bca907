"""The whole of the measured part: from two files to its tables.

Training and test data are apart from the first line on: every other trial trains, and gravity,
drag, noise, geometry, inertia and the laws' parameters come from these alone.
"""

from collections import Counter
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd

from bounce_grader.common.errors import UsageError
from measured import body as bodies
from measured import flights, impacts, laws, rows
from measured.body import Body
from measured.impacts import Event

SQUARES, ELLIPSES = "squares", "ellipses"
TOGETHER = 0.008  # s: two rows; corners that strike within it are one impact of two corners
SLOWEST = 0.1  # m/s of approach: below it the noise is a tenth of the velocity
CROWDED = "left out: fewer than four rows to the next impact or the end"
LEAST_ELLIPSES = 20
GYRATION = 0.0192**2  # m^2, of the ellipses as published


def tables(squares: Path, oval: Path, quick: bool) -> dict[str, Any]:
    trials, read = rows.trials(squares), rows.ellipses(oval)
    if len(trials) < 4:
        raise UsageError(f"{squares} has {len(trials)} trials; it takes four to fit and to judge")
    hits, train, test = _ellipses(read), trials[::2], trials[1::2]
    air = flights.measure(train)
    found = [impacts.find(part, air) for part in (train, test)]
    body = bodies.fit(found[0][0])
    (trained, counts), (tested, others) = (_one_corner(*part, body) for part in found)
    replicates = 100 if quick else 400
    r_squared = body.gyration_squared
    judged = [
        laws.judge(SQUARES, trained, tested, r_squared, replicates),
        laws.judge(ELLIPSES, hits[::2], hits[1::2], GYRATION, replicates),
    ]
    figures = {
        "trials": len(trials),
        "g, m/s^2": air.g,
        "drag, 1/s": air.drag,
        **{f"noise of {n}": noise for n, noise in zip(("x, m", "y, m", "theta, rad"), air.noise)},
        **asdict(body),
        **(counts + others),
        "approach of squares, m/s": float(-bodies.approach(tested).median()),
        "approach of ellipses, m/s": float(-bodies.approach(hits[1::2]).median()),
    }
    return {
        "measured_laws": pd.concat(judged),
        "measured_impacts": tested[bodies.COLUMNS],
        "measured_body": pd.DataFrame(figures.items(), columns=["quantity", "value"]),
    }


def _one_corner(events: list[Event], crowded: int, body: Body) -> tuple[Any, Counter[str]]:
    """The impacts of one corner, and how many events are what."""
    table = bodies.impacts(events, body)
    kinds = np.select(
        [
            bodies.approach(table) > -SLOWEST,
            table["wait"] < TOGETHER,
            [event.residual > bodies.RESOLVED for event in events],
        ],
        [
            "left out: slower than 0.1 m/s",
            "left out: the other corner strikes within two rows",
            "left out: more than one impact in the rows",
        ],
        "impacts of one corner",
    )
    return table[kinds == "impacts of one corner"], Counter(kinds) + Counter({CROWDED: crowded})


def _ellipses(read: Any) -> Any:
    """With d as published (J_t = (1, 0, d)) the angular momentum about the contact isn't kept, with
    -d it is: x and v_x are written with the opposite sign, while y, theta and n agree. So v_x is
    turned round here, and the contact lies at r = (n, -d)."""
    if len(read) < LEAST_ELLIPSES:
        raise UsageError(
            f"{len(read)} ellipses have no flag; it takes {LEAST_ELLIPSES} to fit a law"
        )
    mirror = np.array([-1, 1, 1])
    places = [read["impact"], read["n_theta"], -read["d_theta"]]
    velocities = [read[names].to_numpy() * mirror for names in (rows.BEFORE, rows.AFTER)]
    table = pd.DataFrame(np.hstack([np.stack(places, axis=1), *velocities]), columns=bodies.COLUMNS)
    return table.sort_values("trial", ignore_index=True)
