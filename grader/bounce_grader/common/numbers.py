"""Formats numbers, in the same way in every report."""

from collections.abc import Mapping
from typing import Any

LENGTHS = (
    ("m", 1.0, 0.0999),
    ("mm", 1e-3, 0.999e-4),
    ("\N{MICRO SIGN}m", 1e-6, 0.999e-7),
    ("nm", 1e-9, 0.0),
)  # unit, its size, and the least length written in it; a tick may be rounded down
TIMES = (
    ("s", 1e9, 1e9),
    ("ms", 1e6, 1e6),
    ("\N{MICRO SIGN}s", 1e3, 1e3),
    ("ns", 1.0, 0.0),
)  # in ns


def short(x: float) -> str:
    """Points, counts and the ticks of an axis: 30, 87.5, 0.001, 1e-09."""
    return f"{x:g}"


def change(x: float) -> str:
    """A change of points, with a sign: +2.5."""
    return f"{x:+g}".replace("-", "\N{MINUS SIGN}")


def out_of(scored: Mapping[str, Any]) -> str:
    """The points of a record, a part or a check: 24 / 30."""
    return f"{short(scored['score'])} / {short(scored['max_score'])}"


def percent(share: float) -> str:
    """0.667 as "67 %"."""
    return f"{100 * share:.0f} %"


def scientific(x: float) -> str:
    """For an error, of which mostly the power of ten matters: 3.0e-13."""
    return f"{x:.1e}"


def two_digits(x: float) -> str:
    """Two significant digits; no exponent below a million."""
    return short(float(f"{x:.2g}"))


def metres(x: float) -> str:
    return _with_unit(x, LENGTHS)


def seconds(ns: float) -> str:
    """Writes a time given in nanoseconds."""
    return _with_unit(ns, TIMES)


def _with_unit(x: float, units: tuple[tuple[str, float, float], ...]) -> str:
    unit, size = next((unit, size) for unit, size, least in units if x >= least)
    return f"{two_digits(x / size)} {unit}"
