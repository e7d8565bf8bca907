"""Writes numbers for pages, tables and charts."""

import math
from collections.abc import Callable, Iterable
from typing import Any

WORDS = "no one two three four five six seven eight nine ten eleven twelve".split()
TIMES = ((1e9, "s"), (1e6, "ms"), (1e3, "µs"), (1.0, "ns"))
LENGTHS = ((1.0, "m"), (1e-2, "cm"), (1e-3, "mm"), (1e-6, "µm"))


def short(value: float, digits: int = 2) -> str:
    """Writes a measured number with so many digits: 0.0010, 34, 1.5e-7."""
    if not value or not math.isfinite(value):
        return "∞" if value else "0"
    if 1e-4 <= abs(value) < 1e5:
        places = digits - 1 - math.floor(math.log10(abs(value)))
        return f"{round(value, places):.{max(0, places)}f}"
    return _short_exponent(f"{value:.{digits - 1}e}")


def plain(value: float) -> str:
    """Writes two digits without zeros at their end, as for a setting: 0.001, 20, 1e-5."""
    return _short_exponent(f"{float(f'{value:.2g}'):g}") if math.isfinite(value) else "∞"


def _short_exponent(text: str) -> str:
    """Writes 1e-5 for 1e-05."""
    mantissa, e, power = text.partition("e")
    return f"{mantissa}e{int(power)}" if e else text


def ratio(value: float) -> str:
    """Writes two digits: 2.4, 140, 12,000."""
    return f"{value:.2g}" if value < 10 else f"{float(f'{value:.2g}'):,.0f}"


def percent(share: float, places: int = 0) -> str:
    return f"{100 * share:.{places}f} %"


def number_word(n: int) -> str:
    """Writes a small number in letters."""
    return WORDS[n] if n < len(WORDS) else str(n)


def time(ns: float, write: Callable[[float], str] = short) -> str:
    """Writes nanoseconds in the unit that suits them."""
    size, unit = next((u for u in TIMES if float(f"{ns:.2g}") >= u[0]), TIMES[-1])
    return f"{write(ns / size)} {unit}"


def plain_time(ns: float) -> str:
    return time(ns, plain)


def metres(value: float) -> str:
    """Writes a measured length; below a tenth of a millimetre with an exponent."""
    if 1e-4 <= value < 1:
        return f"{short(100 * value)} cm" if value >= 1e-2 else f"{short(1e3 * value)} mm"
    return f"{short(value)} m"


def plain_metres(value: float) -> str:
    """Writes a length without zeros at its end, from micrometres on: 1 mm, 20 µm."""
    size, unit = next((u for u in LENGTHS if float(f"{value:.2g}") >= u[0]), LENGTHS[0])
    return f"{plain(value / size)} {unit}"


def listed(items: Iterable[Any], write: Callable[[Any], str] = str) -> str:
    """Writes "a, b and c", or "none"."""
    *others, last = [write(item) for item in items] or ["none"]
    return f"{', '.join(others)} and {last}" if others else last
