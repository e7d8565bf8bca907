"""A failed case as a student's page shows it: what was asked, the numbers side by side as matrices
with the wrong entries marked, and a picture."""

from typing import Any

from bounce_grader.assignment import picture
from bounce_grader.common import escaping
from bounce_grader.grading.failed_case import Shown

NOTHING = 1e-14  # what rounding leaves of a 0
Rows = list[list[Any]]


def render(shown: Shown, heading: str) -> str:
    """The heading is the message's first line, as "2 of 9 cases wrong; the first: in flight"."""
    out = f"<p>{escaping.html(heading)}</p>"
    if "contact" in shown:
        out += f"<p>{escaping.html(_sentence(shown['contact']))}</p>"
    out += f"<pre>{escaping.html(_asked(shown['input']))}</pre>"
    if shown["sentence"]:
        out += f"<p>{escaping.html(_sentence(shown['sentence']))}</p>"
    out += "".join(_quantity(quantity) for quantity in shown["quantities"])
    if any("expected" not in quantity for quantity in shown["quantities"]):
        out += '<p class="small">This case is hidden, and what is right isn\'t shown.</p>'
    return f'<div class="case">{out}{picture.of(shown)}</div>'


def _sentence(words: str) -> str:
    return f"{words[0].upper()}{words[1:]}." if words else ""


def _asked(words: str) -> str:
    lines = words.removeprefix("  input    ").split("\n")
    return "\n".join(line.removeprefix(" " * 11) for line in lines)


def _quantity(quantity: Shown) -> str:
    got, right, expected = quantity["got"], quantity["right"], quantity.get("expected")
    digits = _digits(got, right, expected)
    units = quantity["unit"].split(", ")
    by_row = units if len(units) == len(got) else None
    caption = quantity["name"] + ("" if by_row else f", in {quantity['unit']}")
    both = _matrix("yours", got, digits, by_row, right)
    if expected:
        both += _matrix("right", expected, digits, by_row)
    return f'<p class="name">{escaping.html(caption)}</p><div class="pair">{both}</div>'


def _digits(got: Rows, right: Rows, expected: Rows | None) -> int:
    """Six, or as many as it takes to see that a wrong number is another."""
    for row, ok, other in zip(got, right, expected or []):
        for x, is_right, y in zip(row, ok, other):
            if not is_right and number(x, 6) == number(y, 6):
                return 12
    return 6


def number(x: float | str, digits: int) -> str:
    if isinstance(x, str):
        return {"nan": "NaN", "inf": "\N{INFINITY}", "-inf": "\N{MINUS SIGN}\N{INFINITY}"}[x]
    shown = f"{0.0 if abs(x) < NOTHING else x:.{digits}g}"
    return shown.replace("-", "\N{MINUS SIGN}")


def _matrix(
    title: str, rows: Rows, digits: int, units: list[str] | None, right: Rows | None = None
) -> str:
    body = ""
    for i, row in enumerate(rows):
        cells = [_cell(number(x, digits), right is None or right[i][j]) for j, x in enumerate(row)]
        unit = (
            f'<td class="unit">{escaping.html(units[i])}</td>' if units and units[i] != "1" else ""
        )
        body += f"<tr>{''.join(cells)}{unit}</tr>"
    said = ", boxed where wrong" if right else ""
    return f"<table class='matrix'><caption>{title}{said}</caption>{body}</table>"


def _cell(shown: str, right: bool) -> str:
    if right:
        return f"<td>{shown}</td>"
    return f'<td class="wrong"><span class="unseen">wrong: </span>{shown}</td>'
