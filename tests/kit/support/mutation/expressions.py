"""Statements, the values in them, and the terms and factors of a value, as ranges of tokens."""

from collections.abc import Iterator
from dataclasses import dataclass

from mutation.tokens import Source

ASSIGNMENTS = ("=", "+=", "-=", "*=", "/=")
COMPARISONS = ("<", ">", "<=", ">=", "==", "!=")
SEPARATORS = (",", ";", "<<", "return", *ASSIGNMENTS, *COMPARISONS)

Range = tuple[int, int]


@dataclass(frozen=True)
class Piece:
    """What stands between operators: a term, a factor, or an element of a list."""

    operator: int | None  # the token before it; None for the first
    first: int
    last: int


def pieces(source: Source, first: int, last: int, operators: tuple[str, ...]) -> list[Piece]:
    """[first, last), cut at these operators outside of brackets."""
    found, operator, start = [], None, first
    for i in source.top_level(first, last):
        text = source.tokens[i].text
        binary = text not in "+-*/" or (i > first and source.is_binary(i))
        if text in operators and i not in source.partner and binary:
            if i > start or operator is not None:
                found.append(Piece(operator, start, i))
            operator, start = i, i + 1
    return [p for p in [*found, Piece(operator, start, last)] if p.first < p.last]


def statements(source: Source, first: int, last: int) -> Iterator[Range]:
    """The statements of a block, and those nested in them."""
    i = first
    while i < last:
        end = _end_of_statement(source, i, last)
        yield i, end
        if source.tokens[i].text in ("if", "for", "while"):
            inner = source.partner[i + 1] + 1
            block = source.tokens[inner].text == "{"
            yield from statements(source, inner + block, end - block)
        i = end


def _end_of_statement(source: Source, first: int, last: int) -> int:
    if source.tokens[first].text in ("if", "for", "while"):
        inner = source.partner[first + 1] + 1
        if source.tokens[inner].text == "{":
            return source.partner[inner] + 1
        return _end_of_statement(source, inner, last)
    return next(i for i in source.top_level(first, last) if source.tokens[i].text == ";") + 1


def lists(source: Source, first: int, last: int) -> Iterator[Range]:
    """Where values may stand: the simple statements, and what is in round and curly brackets."""
    for start, end in statements(source, first, last):
        if source.tokens[start].text not in ("if", "for", "while"):
            yield start, end - 1
    for opening, closing in source.partner.items():
        body = opening > first - 1 and closing <= last
        block = source.tokens[opening].text == "{" and source.tokens[opening - 1].text == ")"
        if body and not block and source.tokens[opening].text in ("(", "{"):
            yield opening + 1, closing


def values(source: Source, first: int, last: int) -> Iterator[Range]:
    """The values in a list: not what is assigned to, declared, or called for its effect."""
    bracketed = first - 1 in source.partner
    found = pieces(source, first, last, SEPARATORS)
    for i, piece in enumerate(found):
        after = source.tokens[found[i + 1].operator or 0].text if i + 1 < len(found) else ""
        first_of_all = piece.operator is None and not bracketed
        if after in ASSIGNMENTS or (first_of_all and source.tokens[first].text != "return"):
            continue
        plain = source.tokens[piece.first].text not in ("&", "++", "--", "{")
        if plain and not declares(source, piece.first, piece.last):
            yield piece.first, piece.last


def declares(source: Source, first: int, last: int) -> bool:
    """Whether a statement, or the begin of one, declares a variable."""
    return any(is_declared(source, i) for i in source.top_level(first, last))


def is_declared(source: Source, i: int) -> bool:
    """Whether this token is the name of a variable that is declared here, behind its type."""
    before = source.tokens[i - 1]
    behind_a_type = before.kind == "name" and before.text not in ("return", "const")
    behind_a_template = before.text == ">" and i - 1 in source.partner.values()
    bound = source.tokens[i].text == "[" and before.text == "auto"
    return bound or (source.tokens[i].kind == "name" and (behind_a_type or behind_a_template))
