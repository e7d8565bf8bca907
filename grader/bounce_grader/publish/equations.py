"""Sets equations that are written as plain text, as the handout's Markdown has them, in MathML."""

import re
from html import escape

NAMES = "delta δ, epsilon ε, lambda λ, mu μ, omega ω, phi φ, pi π, theta θ"
GREEK = dict(name.split() for name in NAMES.split(", "))
SIGNS = {"<=": "≤", ">=": "≥", "-": "−", "*": "·", "...": "…", "perpendicular to": "⟂"}
TOKEN = re.compile(
    r"(?P<gap>\s{2,})|(?P<blank>\s)|(?P<text>\b(?:for|of|over|the)\b)|(?P<minus>(?<!\w)-(?=\S))"
    r"|(?P<sign>perpendicular to|<=|>=|\.\.\.|[-+*/=<>,:()\[\]])|(?P<number>\d+(?:\.\d+)?)"
    r"|(?P<symbol>(?P<base>[A-Za-z]+|(?=\^))(?:_(?P<below>[A-Za-z0-9]+))?(?P<prime>'?)"
    r"(?:\^(?P<power>-?\d+|T))?)|(?P<other>.)"
)
ELEMENTS = {
    "gap": '<mspace width="1em"/>',
    "blank": "",
    "text": "<mtext>&nbsp;{}&nbsp;</mtext>",
    "minus": '<mo stretchy="false" form="prefix">{}</mo>',  # a sign, and no difference
    "sign": '<mo stretchy="false">{}</mo>',
    "number": "<mn>{}</mn>",
}
# In a sentence: formulas, from letters that can't be words there, and tuples that hold one.
SYMBOL = (
    r"(?:(?:R|phi|cos|sin|diag)\((?:[^()]|\([^()]*\))+\)"
    r"|[A-Za-z]+_(?:hat\b|[a-z0-9]{1,2}(?![A-Za-z0-9_(]))"
    rf"|(?:{'|'.join(GREEK)}|dt|[MJRTVcegklmnpqrstvxyz])(?![A-Za-z0-9_(]|\.\w))"
    r"(?:'(?!\w))?(?:\^(?:-1|2|T)|²)?"
)
NUMBER = r"\d+(?:\.\d+)?(?![\w.]\w)"
PRODUCT = rf"[-+]?{SYMBOL}(?: {SYMBOL})*"
TERM = rf"(?:{PRODUCT}|-?{NUMBER})(?:/\d)?"
OPERATOR = r"(?: (?:[<>]=|[-+*/=<>]) |/|[-+](?=\d))"
TUPLE = rf"\({TERM}(?:(?:, |{OPERATOR}){TERM})+\)(?:\^T)?"
OPERAND = rf"(?:{TUPLE}(?: {PRODUCT})?|{PRODUCT} {TUPLE}|{TERM})"
INLINE = re.compile(
    r"(?<![\w`/.'+-])(?<!\w\()(?<!\d )(?!^m$|^s\b|m/|g\+\+)(?:"
    rf"(?:{PRODUCT} {TUPLE}|{PRODUCT}|{NUMBER}(?= [<>=+] ))(?:{OPERATOR}{OPERAND})*"
    rf"|(?=.[^()]*[a-z]){TUPLE}|[<>]= {NUMBER})(?![/√²(])"
)


def inline(sentence: str) -> str:
    """HTML of a sentence without markup, in which formulas are set as the equations are."""
    page, end = "", 0
    for found in INLINE.finditer(sentence):
        page += _words(sentence[end : found.start()])
        page += f"<math>{_row(found[0].replace('²', '^2'))}</math>"
        end = found.end()
    return page + _words(sentence[end:])


def _words(text: str) -> str:
    return re.sub(r"\^(\d)", r"<sup>\1</sup>", escape(text, quote=False))


def displayed(block: str) -> str:
    """HTML of a block of equations. Lines with a matrix between bars are one."""
    return "".join(map(_equation, re.findall(r"(?:.*\|.*\n)+|.*\S.*\n", block)))


def _equation(lines: str) -> str:
    """One with its number, if it has one, or several beside each other."""
    number = "".join(re.findall(r"\((\d+)\)$", lines, re.M))
    bare = re.sub(r"\s+\(\d+\)$", "", lines, flags=re.M).rstrip()
    rows = _matrix(bare) if "|" in bare else map(_row, re.split(r"\s{3,}", bare.strip()))
    maths = "".join(f'<math display="block">{row}</math>' for row in rows)
    label = f'<span id="eq{number}">({number})</span>' if number else ""
    return f'<div class="equation"><div tabindex="0">{maths}</div>{label}</div>\n'


def _matrix(lines: str) -> list[str]:
    """V = | a  b | with its rows below each other, and what stands beside it. Of a block matrix, a
    row of the lower blocks may have more cells than one of the upper, whose first is as wide."""
    pieces = [re.split(r"\|(.*)\|", line) for line in lines.splitlines()]  # the bars' three sides
    before, after = (" ".join(piece[side].strip() for piece in pieces).strip() for side in (0, 2))
    rows = [re.split(r"\s{2,}", within.strip()) for _, within, _ in pieces]
    width = max(map(len, rows))
    table = ""
    for first, *others in rows:
        cells = "".join(f"<mtd>{_row(cell)}</mtd>" for cell in others)
        span = f' columnspan="{width - len(others)}"' if len(others) + 1 < width else ""
        table += f"<mtr><mtd{span}>{_row(first)}</mtd>{cells}</mtr>"
    left, right = (f'<mo stretchy="true">{sign}</mo>' for sign in "()")
    matrix = f"<mrow>{left}<mtable>{table}</mtable>{right}</mrow>"
    return [f"<mrow>{_row(before)}{matrix}</mrow>", *([_row(after)] if after else [])]


def _row(text: str) -> str:
    return f"<mrow>{TOKEN.sub(_element, text)}</mrow>"


def _element(found: re.Match[str]) -> str:
    token = found[0]
    if found.lastgroup == "other":
        raise ValueError(f"no equation: {found.string[found.start():]}")
    if found.lastgroup == "symbol":
        return _symbol(*found.group("base", "below", "prime", "power"))
    return ELEMENTS[str(found.lastgroup)].format(escape(SIGNS.get(token, token)))


def _symbol(base: str, below: str | None, prime: str, power: str | None) -> str:
    symbol = f"<mi>{GREEK.get(base, base)}</mi>"
    if below == "hat":
        symbol, below = f'<mover accent="true">{symbol}<mo>^</mo></mover>', None
    kind = "sub" * bool(below) + "sup" * bool(prime or power)
    scripts = _row(below) if below else ""
    if prime or power:
        scripts += f"<mrow>{'<mo>′</mo>' * bool(prime)}{_row(power or '')}</mrow>"
    return f"<m{kind}>{symbol}{scripts}</m{kind}>" if kind else symbol
