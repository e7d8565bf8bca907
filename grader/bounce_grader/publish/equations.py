"""Sets equations that are written as plain text, as the handout's Markdown has them, in MathML."""

import re
from collections.abc import Iterator
from html import escape
from typing import NamedTuple

NAMES = "delta δ, epsilon ε, lambda λ, mu μ, omega ω, phi φ, theta θ"
GREEK = dict(name.split() for name in NAMES.split(", "))
WORDS = {"for", "of", "over", "the"}
SIGNS = {"<=": "≤", ">=": "≥", "-": "−", "*": "·", "...": "…", "perpendicular to": "⟂"}
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
    groups: list[list[str]] = [[]]
    for line in block.splitlines():
        if not (groups[-1] and "|" in line and "|" in groups[-1][-1]):
            groups.append([])
        groups[-1] += [line] if line.strip() else []
    return list(map(_line, filter(None, groups)))


def _line(lines: list[str]) -> Line:
    numbers = [n for line in lines for n in re.findall(r"\((\d+)\)$", line)]
    bare = [re.sub(r"\s+\(\d+\)$", "", line).rstrip() for line in lines]
    rows = _matrix(bare) if "|" in bare[0] else map(_row, re.split(r"\s{3,}", bare[0].strip()))
    return Line([f'<math display="block">{row}</math>' for row in rows], "".join(numbers))


def inline(sentence: str) -> str:
    """HTML of a sentence without markup, in which symbols are set as in the equations."""
    parts = INLINE.split(sentence)
    return "".join(
        f"<math>{_row(part)}</math>" if i % 2 else escape(part, quote=False)
        for i, part in enumerate(parts)
    )


def _matrix(lines: list[str]) -> list[str]:
    """V = | a  b | with its rows below each other, and what stands beside it. Of a block matrix, a
    row of the lower blocks may have more cells than one of the upper, whose first is as wide."""
    pieces = [re.split(r"\|(.*)\|", line) for line in lines]  # before, within and after the bars
    before, after = (" ".join(piece[side].strip() for piece in pieces).strip() for side in (0, 2))
    rows = [re.split(r"\s{2,}", within.strip()) for _, within, _ in pieces]
    width = max(map(len, rows))
    table = ""
    for row in rows:
        spans = f' columnspan="{width - len(row) + 1}"' if len(row) < width else ""
        others = "".join(f"<mtd>{_row(cell)}</mtd>" for cell in row[1:])
        table += f"<mtr><mtd{spans}>{_row(row[0])}</mtd>{others}</mtr>"
    left, right = (f'<mo stretchy="true">{sign}</mo>' for sign in "()")
    matrix = f"<mrow>{left}<mtable>{table}</mtable>{right}</mrow>"
    return [f"<mrow>{_row(before)}{matrix}</mrow>", *([_row(after)] if after else [])]


def _row(text: str) -> str:
    return f"<mrow>{''.join(_tokens(text))}</mrow>"


def _tokens(text: str) -> Iterator[str]:
    at = 0
    starts = True  # so that a minus is a sign, and no difference
    while at < len(text):
        match = TOKEN.match(text, at)
        if not match:
            raise ValueError(f"no equation: {text[at:]}")
        at, kind, token = match.end(), match.lastgroup, match[0]
        if kind == "gap":
            yield '<mspace width="1em"/>'
        elif kind == "sign":
            form = ' form="prefix"' if starts and token == "-" else ""
            yield f'<mo stretchy="false"{form}>{escape(SIGNS.get(token, token))}</mo>'
        elif kind == "number":
            yield f"<mn>{token}</mn>"
        elif kind == "power":
            yield f"<msup><mrow></mrow>{_power(token[1:])}</msup>"
        elif kind == "name":
            yield _name(token)
        starts = kind == "gap" or token in ("(", "[", ",", "=") or (starts and not kind)


def _name(text: str) -> str:
    if text in WORDS:
        return f"<mtext>&nbsp;{text}&nbsp;</mtext>"
    bare, _, power = text.partition("^")
    base, _, below = bare.rstrip("'").partition("_")
    symbol = f"<mi>{GREEK.get(base, base)}</mi>"
    if below == "hat":
        symbol, below = f'<mover accent="true">{symbol}<mo>^</mo></mover>', ""
    above = ("<mo>′</mo>" if bare.endswith("'") else "") + (_power(power) if power else "")
    above = f"<mrow>{above}</mrow>" if above else ""
    index = f"<mn>{below}</mn>" if below.isdigit() else f"<mi>{below}</mi>"
    if below:
        kind, shifted = ("msubsup", index + above) if above else ("msub", index)
    else:
        kind, shifted = "msup", above
    return f"<{kind}>{symbol}{shifted}</{kind}>" if shifted else symbol


def _power(text: str) -> str:
    if text == "T":
        return "<mi>T</mi>"
    sign = "<mo>−</mo>" if text.startswith("-") else ""
    return f"<mrow>{sign}<mn>{text.lstrip('-')}</mn></mrow>"
