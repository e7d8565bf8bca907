"""Prepares the text and numbers of a failed case for case.html.j2."""

from collections.abc import Iterator
from typing import Any

from bounce_grader.common.numbers import significant
from bounce_grader.grading.words import Facts

NOT_FINITE = {"nan": "NaN", "inf": "\N{INFINITY}", "-inf": "\N{MINUS SIGN}\N{INFINITY}"}
Entry = tuple[str, bool]  # a number, and whether it is right
Matrix = tuple[str, list[tuple[list[Entry], str]]]  # a title, and the rows, each with its unit


def sentence(words: str) -> str:
    return f"{words[0].upper()}{words[1:]}." if words else ""


def is_hidden(shown: Facts) -> bool:
    return any("expected" not in quantity for quantity in shown["quantities"])


def caption(quantity: Facts) -> str:
    return quantity["name"] + ("" if _units(quantity) else f", in {quantity['unit']}")


def matrices(quantity: Facts) -> Iterator[Matrix]:
    """The submission's matrix, and the right one if it may be shown."""
    got, right, expected = quantity["got"], quantity["right"], quantity.get("expected")
    digits = _digits(quantity)
    units = _units(quantity) or [""] * len(got)
    entries = [[(number(x, digits), ok) for x, ok in zip(*rows)] for rows in zip(got, right)]
    yield "yours" + (", boxed where wrong" if right else ""), list(zip(entries, units))
    if expected:
        yield "right", [
            ([(number(x, digits), True) for x in r], u) for r, u in zip(expected, units)
        ]


def _units(quantity: Facts) -> list[str]:
    """The unit of each row, "" for dimensionless ones. Empty if one unit holds for all rows."""
    units = quantity["unit"].split(", ")
    return ["" if u == "1" else u for u in units] if len(units) == len(quantity["got"]) else []


def _digits(quantity: Facts) -> int:
    """Six digits; twelve if a wrong number and the right one look the same with six."""
    for rows in zip(quantity["got"], quantity["right"], quantity.get("expected") or []):
        for x, right, y in zip(*rows):
            if not right and number(x, 6) == number(y, 6):
                return 12
    return 6


def number(x: Any, digits: int) -> str:
    return NOT_FINITE[x] if isinstance(x, str) else significant(x, digits)
