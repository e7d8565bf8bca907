"""Every small change of a C++ function, each of one place, by the patterns of mutations.toml.

The patterns read what clang-format has formatted. What they get wrong doesn't compile, and a change
that doesn't compile loses points as well.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import golden

# A value: a number, or a name with members, calls and indices; or what is in brackets.
INSIDE = r"\((?:[^()]|\([^()]*\))*\)"
VALUE = rf"(?:\b\d[\d.]*\b|\b[A-Za-z_]\w*(?:::\w+)*(?:<[\w, ]+>)?(?:{INSIDE}|\.\w+)*|{INSIDE})"
# A number with a name: what rounding, an absolute value or a threshold would change.
SCALAR = r"(?:params\.(?!M|g\b|T\b)\w+|\b[qvpr]\([0-3]\)|\b[qrp]\w*\.[xy]\(\)|\bphi\b(?! =|;|,|\]))"
TABLE: list[tuple[str, str, list[str]]] = [
    (kind, pattern.replace("{VALUE}", VALUE).replace("{SCALAR}", SCALAR), replacements)
    for kind, pattern, replacements in golden.table(Path(__file__).with_suffix(".toml"))["changes"]
]
KINDS = tuple(dict.fromkeys(kind for kind, _, _ in TABLE))


@dataclass(frozen=True)
class Change:
    kind: str
    name: str  # the line, with [-what goes-]{+and comes+}
    text: str  # the whole file


def changes(text: str) -> list[Change]:
    """In the order of the table; the same text is made once."""
    made: dict[str, Change] = {}
    for kind, start, end, new in _edits(text):
        changed = text[:start] + new + text[end:]
        if changed != text and changed not in made:
            made[changed] = Change(kind, _name(text, start, end, new), changed)
    return list(made.values())


def _edits(text: str) -> Iterator[tuple[str, int, int, str]]:
    begin, end = text.index(") {\n"), text.rindex("}  // namespace")
    hidden = [found.span() for found in re.finditer(r"//[^\n]*|#[^\n]*", text)]
    words = set(re.findall(r"\w+", text))
    for kind, pattern, replacements in TABLE:
        for found in re.finditer(pattern, text):
            inside = begin < found.start() and found.end() < end
            if not inside or any(a <= found.start() < b for a, b in hidden):
                continue
            for new in replacements:
                if kind != "name" or words.issuperset(re.findall(r"^\w+", new)):
                    yield kind, *found.span(), found.expand(new.replace(r"\0", r"\g<0>"))


def _name(text: str, start: int, end: int, new: str) -> str:
    before = text[text.rfind("\n", 0, start) + 1 : start]
    after = text[end : text.find("\n", end)]
    marks = (f"[-{text[start:end]}-]" if end > start else "") + (f"{{+{new}+}}" if new else "")
    return " ".join(re.sub(r"\s+//[^\n]*", "", before + marks + after).split())
