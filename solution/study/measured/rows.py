"""Reads the measured figures: CSV, plain or compressed by gzip."""

import gzip
import io
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from bounce_grader.common.errors import UsageError

Array = NDArray[np.float64]

INTERVAL = 1 / 250  # s between rows
SQUARES = ("trial", "k", "x", "y", "theta")
BEFORE, AFTER = (
    [f"{name}_{when}" for name in ("v_x", "v_y", "omega")] for when in ("before", "after")
)
FLAGS = [f"flag_{i}" for i in range(1, 7)]
ELLIPSES = ("impact", *BEFORE, *AFTER, "n_theta", "d_theta", *FLAGS)
GZIP = b"\x1f\x8b"


@dataclass(frozen=True)
class Trial:
    """One drop: rows k, and x, y (m), theta (rad) of each."""

    name: int
    k: NDArray[np.int64]
    q: Array

    @property
    def t(self) -> Array:
        return self.k * INTERVAL


def trials(file: Path) -> list[Trial]:
    """Reads the drops of squares, in the order of their numbers."""
    table = _numbers(file, SQUARES)
    for name in ("trial", "k"):
        if (table[name] % 1 != 0).any():
            raise UsageError(f"{file}: {name} has to be whole numbers")
    found = []
    for name, rows in table.sort_values(["trial", "k"]).groupby("trial"):
        if rows["k"].duplicated().any():
            raise UsageError(f"{file}: trial {int(name)} has a row twice")
        k = rows["k"].to_numpy(dtype=np.int64)
        found.append(Trial(int(name), k, rows[["x", "y", "theta"]].to_numpy()))
    return found


def ellipses(file: Path) -> Any:
    """The impacts of ellipses that no flag is set for, as a table with the columns ELLIPSES."""
    table = _numbers(file, ELLIPSES)
    return table[(table[FLAGS] == 0).all(axis=1)]


def _numbers(file: Path, names: tuple[str, ...]) -> Any:
    """Reads the named columns; raises UsageError, with file and line, where that can't be."""
    try:
        data = file.read_bytes()
        text = (gzip.decompress(data) if data.startswith(GZIP) else data).decode("utf-8-sig")
        options = {"skip_blank_lines": False, "skipinitialspace": True, "index_col": False}
        table = pd.read_csv(io.StringIO(text), dtype=str, keep_default_na=False, **options)
    except pd.errors.EmptyDataError:
        table = pd.DataFrame()
    except (OSError, EOFError, ValueError) as error:
        raise UsageError(f"{file} can't be read: {error}".replace("\n", " ").strip()) from error
    for name in names:
        if name not in table:
            raise UsageError(f"{file} has no column {name}")
    table = table[list(names)].fillna("")
    table = table[(table != "").any(axis=1)]
    if table.empty:
        raise UsageError(f"{file} has no rows")
    numbers = table.apply(pd.to_numeric, errors="coerce")
    for row, column in np.argwhere(~np.isfinite(numbers.to_numpy(dtype=float))):
        where = f"{file}, line {table.index[row] + 2}: {names[column]} is"
        raise UsageError(f"{where} {_wrong(table.iat[row, column])}")
    return numbers.astype(float)


def _wrong(cell: str) -> str:
    try:
        float(cell)
    except ValueError:
        return f"{cell!r}, no number" if cell else "missing"
    return cell
