"""Numbers as the page on the engines writes them, without zeros at their end: 1 mm, 20 µs."""

import math

COUNTS = "no one two three four five six seven eight nine ten eleven twelve".split()


def short(value: float) -> str:
    if value == 0:
        return "0"
    if not math.isfinite(value):
        return "∞"
    if 1e-3 <= abs(value) < 1e4:
        return f"{float(f'{value:.2g}'):g}"
    mantissa, _, power = f"{value:.1e}".partition("e")
    return f"{float(mantissa):g}e{int(power)}"


def time(ns: float) -> str:
    ns = float(f"{ns:.2g}")
    for size, unit in ((1e9, "s"), (1e6, "ms"), (1e3, "µs")):
        if ns >= size:
            return f"{short(ns / size)} {unit}"
    return f"{short(ns)} ns"


def seconds(value: float) -> str:
    return f"{short(value)} s"


def metres(value: float) -> str:
    value = float(f"{value:.2g}")
    for size, unit in ((1.0, "m"), (1e-2, "cm"), (1e-3, "mm"), (1e-6, "µm")):
        if value >= size:
            return f"{short(value / size)} {unit}"
    return f"{short(value)} m"


def count(n: int) -> str:
    return COUNTS[n] if n < len(COUNTS) else str(n)
