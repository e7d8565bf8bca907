"""Numbers and names as the pages write them."""

import math
from collections.abc import Iterable, Sequence

from bounce_study import look

UNITS = ((1e9, "s"), (1e6, "ms"), (1e3, "µs"), (1.0, "ns"))


def short(value: float, digits: int = 2) -> str:
    """0.0012, 34, 1.5e-7: so many digits."""
    if value == 0:
        return "0"
    if not math.isfinite(value):
        return "∞"
    if 1e-4 <= abs(value) < 1e5:
        places = max(0, digits - 1 - math.floor(math.log10(abs(value))))
        return f"{round(value, digits - 1 - math.floor(math.log10(abs(value)))):.{places}f}"
    mantissa, _, power = f"{value:.{digits - 1}e}".partition("e")
    return f"{mantissa}e{int(power)}"


def plain(value: float) -> str:
    """A setting: 0.001, 1e-5, 0.013."""
    text = f"{value:.2g}"
    mantissa, e, power = text.partition("e")
    return f"{mantissa}e{int(power)}" if e else text


def time(ns: float) -> str:
    for size, unit in UNITS:
        if ns >= size:
            return f"{short(ns / size)} {unit}"
    return f"{short(ns)} ns"


def times(ratio: float) -> str:
    """2.4, 140, 12,000: two digits."""
    if ratio < 10:
        return f"{ratio:.2g}"
    digits = 1 - math.floor(math.log10(ratio))
    return f"{round(ratio, digits):,.0f}"


def metres(value: float) -> str:
    if value >= 1 or value == 0:
        return f"{short(value)} m"
    if value >= 1e-2:
        return f"{short(100 * value)} cm"
    if value >= 1e-4:
        return f"{short(1e3 * value)} mm"
    return f"{short(value)} m"


def method(name: str) -> str:
    return look.METHODS[name].label if name in look.METHODS else peer(name)


def peer(name: str) -> str:
    return look.PEERS[name].label if name in look.PEERS else name


def scene(name: str) -> str:
    return name.replace("_", " ")


def listed(names: Iterable[str]) -> str:
    """a, b and c; none."""
    words = list(names)
    if len(words) < 2:
        return words[0] if words else "none"
    return f"{', '.join(words[:-1])} and {words[-1]}"


def table(header: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join(f"| {' | '.join(_cell(cell) for cell in line)} |" for line in lines)


def _cell(text: str) -> str:
    return text.replace("|", "\\|")


def median(values: Iterable[float]) -> float:
    ordered = sorted(values)
    return ordered[len(ordered) // 2]
