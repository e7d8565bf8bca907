"""Which names have which type, so that a name can be exchanged for another of the same type."""

import re
from functools import cache

from bounce_grader.common.paths import CONTRACT

from mutation.tokens import Source

TYPE = r"((?:\w+::)*\w+(?:<[^<>]*>)?)"
DECLARED = re.compile(rf"\b{TYPE}&?\s+(\w+)\s*(?=[,)=;({{])")
NO_TYPES = {"return", "namespace", "const"}


@cache
def members() -> dict[str, dict[str, str]]:
    """The members of the contract's types, with their types."""
    text = (CONTRACT / "bounce" / "types.hpp").read_text()
    structs = re.findall(r"struct (\w+) \{\n(.*?)\n\};", text, re.DOTALL)
    return {
        name: {m: _short(t) for t, m in re.findall(r"^  (\S+) (\w+)(?: = |;|\{)", body, re.M)}
        for name, body in structs
    }


def _short(type_name: str) -> str:
    return type_name.removeprefix("Eigen::")


class Names:
    """The variables of the file's one function; each is known from the end of its statement on."""

    def __init__(self, source: Source) -> None:
        first, last = source.body()
        signature = source.text.rindex("\n", 0, source.tokens[first - 1].start)
        opening = source.text.index("(", signature)
        self._known: list[tuple[int, str, str]] = []
        for found in DECLARED.finditer(source.text, opening, source.tokens[last].start):
            if found.group(1) not in NO_TYPES:
                inside = found.start() > source.tokens[first].start
                known = source.text.index(";", found.end()) if inside else found.end()
                self._known.append((known, found.group(2), _short(found.group(1))))

    def type_of(self, expression: str) -> str | None:
        """The type of a variable, or of a variable's member."""
        name, _, member = expression.partition(".")
        for _, known, type_name in self._known:
            if known == name:
                return members().get(type_name, {}).get(member) if member else type_name
        return None

    def others(self, expression: str, place: int) -> list[str]:
        """The other names of the same type that are known at a place in the text."""
        wanted = self.type_of(expression)
        seen = [(name, t) for known, name, t in self._known if known < place]
        parts = [(f"{n}.{m}", of) for n, t in seen for m, of in members().get(t, {}).items()]
        return sorted({n for n, t in seen + parts if t == wanted and n != expression})
