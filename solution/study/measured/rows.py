"""Reads the measured figures: CSV, plain or compressed by gzip."""

import csv
import gzip
import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from bounce_grader.common.errors import UsageError

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
Names = NDArray[np.int64]  # of trials

INTERVAL = 1 / 250  # s between rows
SQUARES = ("trial", "k", "x", "y", "theta")
STATE = tuple(f"{name}_{when}" for when in ("before", "after") for name in ("x", "y", "theta"))
VELOCITY = tuple(
    f"{name}_{when}" for when in ("before", "after") for name in ("v_x", "v_y", "omega")
)
FLAGS = tuple(f"flag_{i}" for i in range(1, 7))
ELLIPSES = ("impact", *STATE, *VELOCITY, "n_theta", "d_theta", *FLAGS)
GZIP = b"\x1f\x8b"


@dataclass(frozen=True)
class Trial:
    """One drop: rows k, and x, y (m), theta (rad) of each."""

    name: int
    k: Names
    q: Array

    @property
    def t(self) -> Array:
        return self.k * INTERVAL


def _columns(file: Path, names: tuple[str, ...]) -> dict[str, Array]:
    """Reads the named columns; raises UsageError, with file and line, where that can't be."""
    try:
        data = file.read_bytes()
        text = (gzip.decompress(data) if data.startswith(GZIP) else data).decode("utf-8-sig")
    except (OSError, EOFError, UnicodeDecodeError) as error:
        raise UsageError(f"{file} can't be read: {error}") from error
    lines = csv.reader(text.splitlines())
    header = [name.strip() for name in next(lines, [])]
    for name in names:
        if name not in header:
            raise UsageError(f"{file} has no column {name}")
    places = [header.index(name) for name in names]
    values = []
    for line, row in enumerate(lines, start=2):
        if row:
            values.append(_numbers(file, line, row, names, places))
    if not values:
        raise UsageError(f"{file} has no rows")
    return dict(zip(names, np.array(values).T))


def _numbers(
    file: Path, line: int, row: list[str], names: tuple[str, ...], places: list[int]
) -> list[float]:
    numbers = []
    for name, place in zip(names, places):
        try:
            number = float(row[place])
        except IndexError as error:
            raise UsageError(f"{file}, line {line}: {name} is missing") from error
        except ValueError as error:
            raise UsageError(f"{file}, line {line}: {name} is {row[place]!r}, no number") from error
        if not math.isfinite(number):
            raise UsageError(f"{file}, line {line}: {name} is {row[place]}")
        numbers.append(number)
    return numbers


def trials(file: Path) -> list[Trial]:
    """Reads the drops of squares, in the order of their numbers."""
    columns = _columns(file, SQUARES)
    for name in ("trial", "k"):
        if np.any(columns[name] != np.round(columns[name])):
            raise UsageError(f"{file}: {name} has to be whole numbers")
    names = columns["trial"].astype(np.int64)
    rows = columns["k"].astype(np.int64)
    poses = np.stack([columns[name] for name in ("x", "y", "theta")], axis=1)
    found = []
    for name in np.unique(names):
        own = np.flatnonzero(names == name)
        own = own[np.argsort(rows[own], kind="stable")]
        if np.any(np.diff(rows[own]) == 0):
            raise UsageError(f"{file}: trial {name} has a row twice")
        found.append(Trial(int(name), rows[own], poses[own]))
    return found


@dataclass(frozen=True)
class Ellipses:
    """Impacts of ellipses that no flag is set for: names, pose and velocity before and after, and
    the contact's place as published."""

    names: Names
    before: Array  # v_x, v_y, omega
    after: Array
    theta: Array
    n_theta: Array
    d_theta: Array
    flagged: int  # impacts left out


def ellipses(file: Path) -> Ellipses:
    columns = _columns(file, ELLIPSES)
    fine = np.all([columns[name] == 0 for name in FLAGS], axis=0)

    def stacked(when: str) -> Array:
        names = (f"v_x_{when}", f"v_y_{when}", f"omega_{when}")
        return np.stack([columns[name][fine] for name in names], axis=1)

    return Ellipses(
        columns["impact"][fine].astype(np.int64),
        stacked("before"),
        stacked("after"),
        columns["theta_before"][fine],
        columns["n_theta"][fine],
        columns["d_theta"][fine],
        int(np.sum(~fine)),
    )
