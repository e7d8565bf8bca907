"""Writes numbers for pages, tables and charts."""

import math

TIMES = ((1e9, "s"), (1e6, "ms"), (1e3, "µs"), (1.0, "ns"))


def short(value: float, digits: int = 2) -> str:
    """Writes a measured number with so many digits: 0.0010, 34, 1.5e-7."""
    if not value or not math.isfinite(value):
        return "∞" if value else "0"
    if 1e-4 <= abs(value) < 1e5:
        places = digits - 1 - math.floor(math.log10(abs(value)))
        return f"{round(value, places):.{max(0, places)}f}"
    mantissa, _, power = f"{value:.{digits - 1}e}".partition("e")
    return f"{mantissa}e{int(power)}"


def ratio(value: float) -> str:
    """Writes two digits: 2.4, 140, 12,000."""
    return f"{value:.2g}" if value < 10 else f"{float(f'{value:.2g}'):,.0f}"


def time(ns: float) -> str:
    """Writes nanoseconds in the unit that suits them."""
    size, unit = next((u for u in TIMES if float(f"{ns:.2g}") >= u[0]), TIMES[-1])
    return f"{short(ns / size)} {unit}"


def metres(value: float, digits: int = 2) -> str:
    """Writes a length; below a tenth of a millimetre with an exponent."""
    if 1e-4 <= value < 1:
        size, unit = (1e2, "cm") if value >= 1e-2 else (1e3, "mm")
        return f"{short(size * value, digits)} {unit}"
    return f"{short(value, digits)} m"


def interval(value: float, low: float, high: float) -> str:
    """Writes "0.14 (0.13 to 0.16)", or a dash where there is no value."""
    return "–" if math.isnan(value) else f"{short(value)} ({short(low)} to {short(high)})"
