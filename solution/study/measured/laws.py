"""The laws of impact, smallest first, and the program that works them out (laws.cpp)."""

import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from bounce_grader.common.errors import KitError
from bounce_grader.common.paths import BUILD
from bounce_grader.sandbox import processes
from measured.body import Body, Impacts
from measured.impacts import Air
from measured.rows import Array, INTERVAL

PROGRAM = BUILD / "bounce_measured"


@dataclass(frozen=True)
class Law:
    name: str
    parameters: tuple[str, ...]  # of mu, epsilon, kappa
    corners: int = 1


ONE_CORNER = (
    Law("frictionless", ("epsilon",)),
    Law("sticking", ("epsilon",)),
    Law("newton", ("mu", "epsilon")),
    Law("poisson_normal", ("mu", "epsilon")),
    Law("stronge_normal", ("mu", "epsilon")),
    Law("routh_poisson", ("mu", "epsilon")),
    Law("routh_stronge", ("mu", "epsilon")),
    Law("compliant", ("mu", "epsilon", "kappa")),
)
TWO_CORNERS = (
    Law("two_frictionless", ("epsilon",), 2),
    Law("two_newton", ("mu", "epsilon"), 2),
    Law("two_poisson", ("mu", "epsilon"), 2),
    Law("sequence_newton", ("mu", "epsilon"), 2),
    Law("sequence_routh", ("mu", "epsilon"), 2),
)
# By the number of parameters, and among equals from the shorter rule to the longer.
LADDER = tuple(sorted(ONE_CORNER + TWO_CORNERS, key=lambda law: len(law.parameters)))
GRID = {
    "mu": np.linspace(0, 1.2, 61),
    "epsilon": np.linspace(0, 1, 51),
    "kappa": np.array([0.5, 1.0, 2.0, 4.0, 8.0]),
}
COARSE = {"mu": np.linspace(0, 1.2, 25), "epsilon": np.linspace(0, 1, 21)}  # with kappa
UNUSED = {"mu": 0.0, "epsilon": 0.0, "kappa": 0.0}


def grid(law: Law) -> Array:
    """The settings that are tried first: rows of mu, epsilon, kappa."""
    axes = {**GRID, **COARSE} if "kappa" in law.parameters else GRID
    return product([axes[n] if n in law.parameters else np.array([v]) for n, v in UNUSED.items()])


def around(law: Law, setting: Array) -> Array:
    """Settings in finer steps around one of the grid."""
    axes, width = [], 0.03 if "kappa" in law.parameters else 0.02
    for name, value in zip(UNUSED, setting):
        near = value + np.linspace(-width, width, 11)
        if name not in law.parameters or name == "kappa":
            near = np.array([value])
        axes.append(near[(near >= 0) & ((near <= 1) | (name != "epsilon"))])
    return product(axes)


def product(axes: list[Array]) -> Array:
    return np.stack([axis.ravel() for axis in np.meshgrid(*axes, indexing="ij")], axis=1)


def errors(law: Law, hits: Impacts, settings: Array) -> NDArray[np.float32]:
    """The error of the velocity after each impact (rows) with each setting (columns), m/s."""
    out = _call("errors", law.name, [rows(hits), settings])
    return np.frombuffer(out, dtype=np.float32).reshape(len(hits), len(settings))


def after(law: Law, hits: Impacts, setting: Array) -> Array:
    """v_x, v_y, omega after each impact."""
    out = _call("after", law.name, [rows(hits), setting])
    return np.frombuffer(out).reshape(len(hits), 3).copy()


def drops(law: str, body: Body, air: Air, starts: Array, setting: Array, samples: int) -> Array:
    """Poses after 1 to `samples` intervals: drop, sample, (x, y, theta)."""
    world = np.array(
        [body.side, body.gyration_squared, body.ground, body.slope, air.g, air.drag, INTERVAL]
    )
    out = _call("drops", law, [world, starts, setting], str(samples))
    return np.frombuffer(out).reshape(len(starts), samples, 3)


def rows(hits: Impacts) -> Array:
    """The impacts as struct Impact of laws.hpp has them."""
    columns = [hits.gyration_squared[:, None], hits.corner, hits.other, hits.before, hits.after]
    return np.concatenate(columns, axis=1)


def _call(question: str, law: str, inputs: list[Array], *more: str) -> bytes:
    if not PROGRAM.exists():
        raise KitError("bounce_measured is not built: run ./kit study")
    with tempfile.TemporaryDirectory(prefix="bounce-measured-") as name:
        files = [Path(name) / f"{i}" for i in range(len(inputs) + 1)]
        for file, values in zip(files, inputs):
            file.write_bytes(np.ascontiguousarray(values, dtype=np.float64).tobytes())
        paths = [str(file) for file in files[:-1]]
        done = processes.run([str(PROGRAM), question, law, *paths, *more, str(files[-1])])
        if not done.ok:
            raise KitError(f"bounce_measured failed: {done.err.strip() or done.code}")
        return files[-1].read_bytes()
