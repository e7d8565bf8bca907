"""Sets equations that are written as plain text, as the handout's Markdown has them, in MathML."""

import re
from collections.abc import Iterator
from html import escape
from typing import NamedTuple

GREEK = {
    "delta": "δ",
    "epsilon": "ε",
    "lambda": "λ",
    "mu": "μ",
    "omega": "ω",
    "phi": "φ",
    "theta": "θ",
}
WORDS = {"for", "of", "over", "the"}
SIGNS = {
    "<=": "≤",
    ">=": "≥",
    "-": "−",
    "*": "·",
    "...": "…",
    "perpendicular to": "⟂",
}
NAME = r"[A-Za-z]+(?:_[A-Za-z0-9]+)?'?(?:\^(?:-?\d+|T))?"
TOKEN = re.compile(
    rf"(?P<gap>\s{{2,}})|(?P<sign>perpendicular to|<=|>=|\.\.\.|[-+*/=<>,:()\[\]])"
    rf"|(?P<name>{NAME})|(?P<number>\d+(?:\.\d+)?)|(?P<power>\^(?:-?\d+|T))|\s+"
)
# In a sentence only what can't be a word: a name with a subscript, a power or a prime, or in Greek.
INLINE = re.compile(
    r"(?<![\w`/.])(?<!\w\()("
    r"[A-Za-z]+_(?:hat\b|[a-z0-9]{1,2}(?![\w(]))'?(?:\^(?:T|-1|2))?(?: [vr]'?(?![\w']))?"
    r"|[A-Za-z]\^(?:-1|2|T)(?: [A-Za-z](?:_[a-z])?(?![\w']))?"
    r"|[qv]'(?!\w)"
    rf"|(?:{'|'.join(GREEK)})(?![\w.(])"
    r")"
)


class Line(NamedTuple):
    """One displayed equation, or several beside each other; `number` is empty where it has none."""

    mathml: list[str]
    number: str


def displayed(block: str) -> list[Line]:
    """The lines of a block of equations. Lines with a matrix between bars are one."""
    found: list[Line] = []
    for lines in _grouped(block.splitlines()):
        numbers = [n for line in lines for n in re.findall(r"\((\d+)\)$", line)]
        bare = [re.sub(r"\s+\(\d+\)$", "", line).rstrip() for line in lines]
        rows = _matrix(bare) if "|" in bare[0] else map(_row, re.split(r"\s{3,}", bare[0].strip()))
        found.append(
            Line([f'<math display="block">{row}</math>' for row in rows], "".join(numbers))
        )
    return found


def inline(sentence: str) -> str:
    """HTML of a sentence without markup, in which symbols are set as in the equations."""
    parts = INLINE.split(sentence)
    return "".join(
        f"<math>{_row(part)}</math>" if i % 2 else escape(part, quote=False)
        for i, part in enumerate(parts)
    )


def _grouped(lines: list[str]) -> Iterator[list[str]]:
    group: list[str] = []
    for line in lines:
        if group and not ("|" in line and "|" in group[-1]):
            yield group
            group = []
        if line.strip():
            group.append(line)
    if group:
        yield group


def _matrix(lines: list[str]) -> list[str]:
    """V = | a  b | with its rows below each other, and what stands beside it."""
    before = " ".join(line[: line.index("|")].strip() for line in lines).strip()
    after = " ".join(line[line.rindex("|") + 1 :].strip() for line in lines).strip()
    rows = [
        re.split(r"\s{2,}", line[line.index("|") + 1 : line.rindex("|")].strip()) for line in lines
    ]
    rows = [[cell for cell in row if cell] for row in rows]
    width = max(map(len, rows))
    table = "".join(f"<mtr>{_cells(row, width)}</mtr>" for row in rows)
    fence = '<mo stretchy="true">{}</mo>'
    matrix = (
        f"<mrow>{_row(before)}<mrow>{fence.format('(')}<mtable>{table}</mtable>"
        f"{fence.format(')')}</mrow></mrow>"
    )
    return [matrix, _row(after)] if after else [matrix]


def _cells(row: list[str], width: int) -> str:
    """Of a block matrix, a row of the lower blocks may have more cells than one of the upper."""
    span = width - len(row) + 1
    spans = f' columnspan="{span}"' if span > 1 else ""
    first = f"<mtd{spans}>{_row(row[0])}</mtd>"
    return first + "".join(f"<mtd>{_row(cell)}</mtd>" for cell in row[1:])


def _row(text: str) -> str:
    return f"<mrow>{''.join(_tokens(text))}</mrow>"


def _tokens(text: str) -> Iterator[str]:
    at = 0
    starts = True  # so that a minus is a sign, and no difference
    while at < len(text):
        match = TOKEN.match(text, at)
        if not match:
            raise ValueError(f"no equation: {text[at:]}")
        at = match.end()
        kind = match.lastgroup
        if kind == "gap":
            yield '<mspace width="1em"/>'
        elif kind == "sign":
            form = ' form="prefix"' if starts and match[0] == "-" else ""
            yield f'<mo stretchy="false"{form}>{escape(SIGNS.get(match[0], match[0]))}</mo>'
        elif kind == "number":
            yield f"<mn>{match[0]}</mn>"
        elif kind == "power":
            yield f"<msup><mrow></mrow>{_power(match[0][1:])}</msup>"
        elif kind == "name":
            yield _name(match[0])
        starts = kind == "gap" or match[0] in ("(", "[", ",", "=") or (starts and not kind)


def _name(text: str) -> str:
    if text in WORDS:
        return f"<mtext>&nbsp;{text}&nbsp;</mtext>"
    bare, _, power = text.partition("^")
    prime = bare.endswith("'")
    base, _, below = bare.rstrip("'").partition("_")
    symbol = f"<mi>{GREEK.get(base, base)}</mi>"
    if below == "hat":
        symbol = f'<mover accent="true">{symbol}<mo>^</mo></mover>'
    above = ("<mo>′</mo>" if prime else "") + (_power(power) if power else "")
    above = f"<mrow>{above}</mrow>" if above else ""
    if below and below != "hat":
        index = f"<mn>{below}</mn>" if below.isdigit() else f"<mi>{below}</mi>"
        return (
            f"<msubsup>{symbol}{index}{above}</msubsup>"
            if above
            else f"<msub>{symbol}{index}</msub>"
        )
    return f"<msup>{symbol}{above}</msup>" if above else symbol


def _power(text: str) -> str:
    if text == "T":
        return "<mi>T</mi>"
    sign = "<mo>−</mo>" if text.startswith("-") else ""
    return f"<mrow>{sign}<mn>{text.lstrip('-')}</mn></mrow>"
