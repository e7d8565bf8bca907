"""The measured ellipses as impacts.

With d as published (J_t = (1, 0, d)) the angular momentum about the contact isn't kept, with -d it
is: x and v_x are written with the opposite sign, while y, theta and n agree. So v_x is turned round
here, and the contact lies at r = (n, -d).
"""

from dataclasses import dataclass

import numpy as np

from bounce_grader.common.errors import UsageError
from measured import body as bodies
from measured.body import Impacts
from measured.rows import Ellipses

GYRATION = 0.0192**2  # m^2, as published
SEMI_AXES = (0.035, 0.025)  # m, as published
LEAST_IMPACTS = 20


@dataclass(frozen=True)
class Signs:
    """The balance of angular momentum with both signs: |domega| left, rad/s, medians."""

    as_published: float
    turned: float


def impacts(read: Ellipses, gyration_squared: float, sign: float = -1.0) -> Impacts:
    """`sign` is that of v_x."""
    if len(read.names) < LEAST_IMPACTS:
        raise UsageError(
            f"{len(read.names)} ellipses have no flag; it takes {LEAST_IMPACTS} to fit a law"
        )
    corner = np.stack([read.n_theta, -read.d_theta], axis=1)
    mirror = np.array([sign, 1, 1])
    pose = np.stack([0 * read.theta, 0 * read.theta, read.theta], axis=1)
    nowhere = np.full_like(corner, np.nan)
    gyrations = np.full(len(corner), gyration_squared)
    return Impacts(
        read.names, pose, read.before * mirror, read.after * mirror, corner, nowhere, gyrations
    )


def signs(read: Ellipses) -> Signs:
    return Signs(*(_left(impacts(read, GYRATION, sign)) for sign in (1.0, -1.0)))


def _left(hits: Impacts) -> float:
    moment, turned = bodies.moments(hits)
    return float(np.median(np.abs(turned - moment / hits.gyration_squared)))


def uniform_gyration() -> float:
    """r_g^2 of a uniform ellipse with the published semi-axes, m^2."""
    a, b = SEMI_AXES
    return (a * a + b * b) / 4
