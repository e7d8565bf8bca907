"""C++ as tokens, and how its brackets nest.

It reads what clang-format has formatted: a comparison has a blank before it, and the bracket of a
template has none. There are no strings and no preprocessor's lines in a function's body.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass

PATTERN = re.compile(
    r"(?P<blank>\s+|//[^\n]*|\#[^\n]*)"
    r"|(?P<number>\d+\.?\d*(?:[eE][-+]?\d+)?)"
    r"|(?P<name>[A-Za-z_]\w*)"
    r"|(?P<symbol>::|<<|\+\+|--|[-+*/<>=!]=|&&|\|\||.)"
)
CLOSING = {"(": ")", "[": "]", "{": "}", "<": ">"}


@dataclass(frozen=True)
class Token:
    text: str
    kind: str  # number, name or symbol
    start: int  # where it stands in the text
    end: int

    @property
    def ends_a_value(self) -> bool:
        return self.kind != "symbol" or self.text in (")", "]", "}", ">")


class Source:
    """The text of a file, its tokens, and for each opening bracket the closing one."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.tokens = [
            Token(found.group(), found.lastgroup, found.start(), found.end())
            for found in PATTERN.finditer(text)
            if found.lastgroup and found.lastgroup != "blank"
        ]
        self.partner: dict[int, int] = {}
        opened: list[int] = []
        for i, token in enumerate(self.tokens):
            if self._opens(i):
                opened.append(i)
            elif opened and token.text == CLOSING[self.tokens[opened[-1]].text]:
                self.partner[opened.pop()] = i

    def _opens(self, i: int) -> bool:
        token = self.tokens[i]
        touches = i > 0 and self.tokens[i - 1].end == token.start
        return token.text in ("(", "[", "{") or (token.text == "<" and touches)

    def top_level(self, first: int, last: int) -> Iterator[int]:
        """The tokens of [first, last) outside of any bracket in it; of a bracket, its opening."""
        i = first
        while i < last:
            yield i
            i = self.partner.get(i, i) + 1

    def in_template(self, i: int) -> bool:
        """Whether a token stands between the brackets of a template, as a part of a type."""
        opened = (a for a, b in self.partner.items() if a < i < b)
        return any(self.tokens[a].text == "<" for a in opened)

    def of(self, first: int, last: int) -> str:
        """The text of tokens [first, last)."""
        return self.text[self.tokens[first].start : self.tokens[last - 1].end]

    def is_binary(self, i: int) -> bool:
        return self.tokens[i - 1].ends_a_value and self.tokens[i - 1].text != "return"

    def body(self) -> tuple[int, int]:
        """The tokens between the braces of the file's one function."""
        for i in sorted(self.partner):
            if self.tokens[i].text == "{" and self.tokens[i - 1].text == ")":
                return i + 1, self.partner[i]
        raise ValueError("there is no function")
