"""Formats numbers, in the same way in every report."""

from collections.abc import Mapping
from typing import Any

PREFIXES = (("", 1.0), ("m", 1e-3), ("\N{MICRO SIGN}", 1e-6), ("n", 1e-9))


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


def metres(x: float) -> str:
    return _with_prefix(x, "m")


def seconds(ns: float) -> str:
    """Writes a time given in nanoseconds."""
    return _with_prefix(1e-9 * ns, "s")


def _with_prefix(x: float, unit: str) -> str:
    """With two significant digits."""
    prefix, size = next((one for one in PREFIXES if x >= 0.999 * one[1]), PREFIXES[-1])
    return f"{short(float(f'{x / size:.2g}'))} {prefix}{unit}"
