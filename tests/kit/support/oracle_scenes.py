"""Parameters and states that the oracle is tried on."""

from typing import Any

from oracle import Parameters

DEFAULTS: dict[str, Any] = {
    "l": 0.2,
    "m": 0.3,
    "mu": 0.3,
    "epsilon": 0.5,
    "g": [0, -9.81, 0],
    "dt": 0.01,
    "delta": 0.001,
    "T": 150,
}
OTHERS = DEFAULTS | {"l": 0.7, "m": 2.1, "mu": 0.6, "epsilon": 0.2, "g": [3.1, -7.4, 0]}

# Contact states under either set of parameters, one for each thing that a corner can do.
STICKS = [0.4, 0.09, 0.5], [0.05, -2.0, -1.0]
SLIDES_RIGHT = [0.4, 0.09, 0.5], [3.0, -1.0, 0.3]
SLIDES_LEFT = [-2.0, 0.1, 8.2], [-3.0, -1.0, 0.3]
LEAVES = [1.0, 0.09, -0.6], [0.4, 3.0, 0.3]
CONTACTS = [STICKS, SLIDES_RIGHT, SLIDES_LEFT, LEAVES]
SEED = [0.0, 1.5, 0.5235987755982988], [0.0, -0.2, 0.0]


def read(**changes: Any) -> Parameters:
    return Parameters.read(DEFAULTS | changes)
