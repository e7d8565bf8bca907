"""Every small change of a source file, each of one place.

The changes are made on tokens, not on a syntax tree: the four files hold one function each, in
plain C++, so a tokenizer of a page is enough, and what it gets wrong doesn't compile.
"""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from mutation.expressions import (
    COMPARISONS,
    declares,
    is_declared,
    lists,
    pieces,
    statements,
    values,
)
from mutation.names import Names, members
from mutation.tokens import Source, Token

TWINS = {
    "x": ["y"],
    "y": ["x"],
    "row": ["col"],
    "col": ["row"],
    "minCoeff": ["maxCoeff"],
    "topLeftCorner": ["topRightCorner", "bottomLeftCorner"],
    "topRightCorner": ["topLeftCorner", "bottomRightCorner"],
    "Zero": ["Ones"],
}
SQUARE = ("Matrix2d", "Matrix3d")
Edit = tuple[int, int, str]  # of the text: from, to, and what stands there then


@dataclass(frozen=True)
class Change:
    file: str
    line: int
    operator: str
    name: str  # the line, with [-what goes-]{+and comes+}
    text: str  # the whole file

    def __str__(self) -> str:
        return f"{self.file}:{self.line}: {self.operator}: {self.name}"


def changes(file: str, text: str) -> list[Change]:
    """In the order of OPERATORS and of the text; the same text is made once."""
    source = Source(text)
    made = {text}
    found = []
    for operator, edits in OPERATORS.items():
        for start, end, new in edits(source):
            changed = text[:start] + new + text[end:]
            if changed not in made:
                made.add(changed)
                line = text.count("\n", 0, start) + 1
                found.append(Change(file, line, operator, _name(text, start, end, new), changed))
    return found


def _name(text: str, start: int, end: int, new: str) -> str:
    before = text[text.rfind("\n", 0, start) + 1 : start]
    after = text[end : text.find("\n", end)]
    marks = (f"[-{text[start:end]}-]" if end > start else "") + (f"{{+{new}+}}" if new else "")
    without_comments = re.sub(r"\s+//[^\n]*", "", before + marks + after)
    return " ".join(without_comments.split())


def _body(source: Source) -> Iterator[tuple[int, Token]]:
    first, last = source.body()
    return ((i, source.tokens[i]) for i in range(first, last))


def _values(source: Source) -> Iterator[tuple[int, int]]:
    for first, last in lists(source, *source.body()):
        yield from values(source, first, last)


def _replaced(token: Token, *new: str) -> Iterator[Edit]:
    return ((token.start, token.end, text) for text in new if text != token.text)


def _constants(source: Source) -> Iterator[Edit]:
    """A literal is one more, one less, 0 or 1."""
    for i, token in _body(source):
        if token.kind == "number" and not source.in_template(i):
            more = [f"{float(token.text) + d:g}" for d in (1, -1)]
            yield from _replaced(token, *more, "0", "1")


def _signs(source: Source) -> Iterator[Edit]:
    names = Names(source)
    for first, last in _values(source):
        token = source.tokens[first]
        if token.text == "-":
            yield token.start, token.end, ""
        elif token.text != "0" and names.type_of(source.of(first, last)) not in members():
            yield token.start, token.start, "-"


def _arithmetic(source: Source) -> Iterator[Edit]:
    other = {"+": "-", "-": "+", "*": "/", "/": "*", "+=": "-=", "++": "--"}
    for i, token in _body(source):
        if token.text in other and (token.text in ("+=", "++") or source.is_binary(i)):
            yield from _replaced(token, other[token.text], *("=" if token.text == "+=" else ""))


def _comparisons(source: Source) -> Iterator[Edit]:
    for i, token in _body(source):
        after_blank = source.tokens[i - 1].end < token.start
        if token.text in COMPARISONS and after_blank:
            yield from _replaced(token, "<", "<=", ">", ">=", "!=")


def _terms(source: Source) -> Iterator[Edit]:
    for first, last in _values(source):
        yield from _dropped_and_doubled(source, first, last, ("+", "-"))


def _factors(source: Source) -> Iterator[Edit]:
    for first, last in _values(source):
        for term in pieces(source, first, last, ("+", "-")):
            yield from _dropped_and_doubled(source, term.first, term.last, ("*", "/"))


def _plain_factors(source: Source) -> Iterator[tuple[int, int]]:
    """Each without its sign; not those that are written as a number."""
    for first, last in _values(source):
        for term in pieces(source, first, last, ("+", "-")):
            start = term.first + (source.tokens[term.first].text == "-")
            for factor in pieces(source, start, term.last, ("*", "/")):
                if source.tokens[factor.first].kind != "number":
                    yield factor.first, factor.last


def _dropped_and_doubled(
    source: Source, first: int, last: int, operators: tuple[str, str]
) -> Iterator[Edit]:
    found = pieces(source, first, last, operators)
    if len(found) < 2:
        return
    for k, piece in enumerate(found):
        operator = operators[0] if piece.operator is None else source.tokens[piece.operator].text
        start, end = source.tokens[piece.first].start, source.tokens[piece.last - 1].end
        yield end, end, f" {operator} {source.of(piece.first, piece.last)}"
        if piece.operator is not None:
            yield source.tokens[found[k - 1].last - 1].end, end, ""
        elif source.tokens[found[1].operator or 0].text == "/":
            yield start, end, "1.0"
        elif source.tokens[found[1].operator or 0].text == "-":
            yield start, source.tokens[found[1].operator or 0].start, ""
        else:
            yield start, source.tokens[found[1].first].start, ""


def _exchanged_names(source: Source) -> Iterator[Edit]:
    """A variable, or a member such as params.mu, for another of its type."""
    names = Names(source)
    for i, token in _body(source):
        before, after = source.tokens[i - 1].text, source.tokens[i + 1].text
        elsewhere = before in (".", "::") or after == "::" or is_declared(source, i)
        if token.kind != "name" or elsewhere:
            continue
        end = token.end
        member = f"{token.text}.{source.tokens[i + 2].text}"
        if after == "." and names.type_of(member):
            end = source.tokens[i + 2].end
        for other in names.others(source.text[token.start : end], token.start):
            yield token.start, end, other


def _twins(source: Source) -> Iterator[Edit]:
    """x for y, a row for a column, another corner of a matrix."""
    for i, token in _body(source):
        if source.tokens[i - 1].text in (".", "::"):
            yield from _replaced(token, *TWINS.get(token.text, []))


def _transposed(source: Source) -> Iterator[Edit]:
    """A transpose or an inverse that is dropped, or added to a matrix."""
    names = Names(source)
    for i, token in _body(source):
        if token.text in ("transpose", "inverse"):
            yield source.tokens[i - 1].start, source.tokens[i + 2].end, ""
        of = names.type_of(token.text) if source.tokens[i - 1].text != "." else None
        assigned = source.tokens[i + 1].text in (";", "=", "<<")
        if of in (*SQUARE, "Jacobian") and not assigned:
            yield token.end, token.end, ".transpose()"
        if of in SQUARE and not assigned:
            yield token.end, token.end, ".inverse()"


def _swapped(source: Source) -> Iterator[Edit]:
    """Two neighbours in a list of arguments, or of a matrix's entries."""
    for first, last in lists(source, *source.body()):
        for a, b in _neighbours(source, first, last):
            start, end = source.tokens[a[0]].start, source.tokens[b[1] - 1].end
            between = source.text[source.tokens[a[1] - 1].end : source.tokens[b[0]].start]
            yield start, end, source.of(*b) + between + source.of(*a)


def _neighbours(
    source: Source, first: int, last: int
) -> Iterator[tuple[tuple[int, int], tuple[int, int]]]:
    entries = pieces(source, first, last, (",", "<<"))
    for a, b in zip(entries, entries[1:]):
        if source.tokens[b.operator or 0].text == ",":
            yield (a.first, a.last), (b.first, b.last)


def _conditions(source: Source) -> Iterator[Edit]:
    """A condition negated, so that the branches change places; or always true or false."""
    for i, token in _body(source):
        if token.text == "if":
            start, end = source.tokens[i + 2].start, source.tokens[source.partner[i + 1] - 1].end
            yield from (
                (start, end, new) for new in ("true", "false", f"!({source.text[start:end]})")
            )


def _statements(source: Source) -> Iterator[Edit]:
    """A statement that is dropped, or done twice. What is declared is needed once."""
    for first, last in statements(source, *source.body()):
        start, end = source.tokens[first].start, source.tokens[last - 1].end
        if not declares(source, first, last):
            yield start, end, ";"
            if source.tokens[first].text != "return":
                yield end, end, " " + source.text[start:end]


def _kept(source: Source) -> Iterator[Edit]:
    """A variable that keeps its value from one call to the next."""
    for first, last in statements(source, *source.body()):
        start = source.tokens[first].start
        if declares(source, first, last):
            yield start, start, "static "


def _defaults(source: Source) -> Iterator[Edit]:
    """The assignment's numbers in place of those that are asked."""
    for _, token in _body(source):
        if token.text == "params":
            yield token.start, token.end, "Parameters()"


def _single_precision(source: Source) -> Iterator[Edit]:
    return _wrapped(source, {"double": ["float({})"], None: ["float({})"]})


def _absolute(source: Source) -> Iterator[Edit]:
    """The absolute value of a number, or of a vector's entries. Skips params, which are
    positive."""
    number, vector = "std::abs({})", "Vector3({}.cwiseAbs())"
    return _wrapped(source, {"Vector3": [vector], None: [number, vector]})


def _thresholds(source: Source) -> Iterator[Edit]:
    """What is small counts as nothing. Skips params, which are as small as they are asked."""
    small = "(std::abs({0}) < 1e-3 ? 0.0 : {0})"
    rows = "Vector3(({0}.array().abs() < 1e-3).select(0.0, {0}))"
    changed = _wrapped(source, {"Vector3": [rows], None: [small, rows]})
    return ((start, end, new) for start, end, new in changed if "params." not in new)


def _wrapped(source: Source, functions: dict[str | None, list[str]]) -> Iterator[Edit]:
    """Functions of each factor, by its type where that is known."""
    names = Names(source)
    for first, last in _plain_factors(source):
        text = source.of(first, last)
        for function in functions.get(names.type_of(text), []):
            yield source.tokens[first].start, source.tokens[last - 1].end, function.format(text)


OPERATORS: dict[str, Callable[[Source], Iterator[Edit]]] = {
    "constant": _constants,
    "sign": _signs,
    "operator": _arithmetic,
    "comparison": _comparisons,
    "term": _terms,
    "factor": _factors,
    "name": _exchanged_names,
    "index": _twins,
    "transpose": _transposed,
    "swap": _swapped,
    "condition": _conditions,
    "statement": _statements,
    "kept": _kept,
    "default": _defaults,
    "precision": _single_precision,
    "absolute": _absolute,
    "threshold": _thresholds,
}
