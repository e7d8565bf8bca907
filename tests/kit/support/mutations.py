"""Every small change of a C++ function, each of one place, by a table of patterns.

The patterns read what clang-format has formatted. What they get wrong doesn't compile, and a change
that doesn't compile loses points as well.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass

# A value: a number, or a name with members, calls and indices; or what is in brackets.
INSIDE = r"\((?:[^()]|\([^()]*\))*\)"
VALUE = rf"(?:\b\d[\d.]*\b|\b[A-Za-z_]\w*(?:::\w+)*(?:<[\w, ]+>)?(?:{INSIDE}|\.\w+)*|{INSIDE})"
# A number with a name: what rounding, an absolute value or a threshold would change.
SCALAR = r"(?:params\.(?!M|g\b|T\b)\w+|\b[qvpr]\([0-3]\)|\b[qrp]\w*\.[xy]\(\)|\bphi\b(?! =|;|,|\]))"
# A statement that declares and returns nothing; and the place before a declaration.
STATEMENT = r"(?<=[;{}\n/]) *(?!return|const |using|[}\]]|\w[\w:<>, ]* \w+[ ;({])\S[^;{}]*;"
DECLARATION = r"(?:(?<=\n  )|(?<=\n    ))(?=(?:const )?(?!return|const)[A-Z][\w:]*(?:<.*?>)? \w+)"
DOUBLES = ("params.l", "params.m", "params.mu", "params.epsilon", "params.dt", "params.delta")

# What changes, where, and into what; \0 is what stood there.
TABLE: list[tuple[str, str, tuple[str, ...]]] = [
    ("sign", rf"(?:(?<=<< )|(?<=, )|(?<= = )|(?<=return )|(?<=\{{))(?!0\b)(?={VALUE})", ("-",)),
    ("sign", r"(?<=[ (\[{])-(?=[\w(])", ("",)),
    ("operator", r"(?<= )\+(?= )", ("-", "*")),
    ("operator", r"(?<= )-(?= )", ("+",)),
    ("operator", r"(?<= )\*(?= )", ("/", "+")),
    ("operator", r"(?<= )/(?= )", ("*",)),
    ("operator", r"(?<= )[-+*]=(?= )", ("=", "-=", "+=")),
    ("operator", r"\+\+", ("--",)),
    ("comparison", r"(?<= )<=?(?= )", ("<", "<=", ">", ">=", "!=")),
    ("dropped", rf" [-+*/] {VALUE}", ("", r"\0\0")),
    ("dropped", rf"{VALUE} [-+*] ", ("", r"\0\0")),
    ("dropped", rf"{VALUE}(?= / )", ("1.0",)),
    ("dropped", r"\.(?:transpose|inverse|partialPivLu|imag|real)\(\)", ("",)),
    ("name", r"\bparams\.(?:l|m|mu|epsilon|dt|delta)\b", DOUBLES),
    ("name", r"\bq(?=[.(,])", ("v",)),
    ("name", r"\bv(?=[.( ),;])", ("q", "v_free", "v_next")),
    ("name", r"\bv_(?:free|next)\b", ("v",)),
    ("name", r"\bJ_[nt]\b", ("J_n", "J_t")),
    ("name", r"\b(?:f|f_e|f_c)\b(?! =)", ("f", "f_e", "f_c")),
    ("name", r"\bM(?:_inv)?\b(?!\()", ("M", "M_inv")),
    ("name", r"\bparams\b(?=[.,)])", ("Parameters()",)),
    ("index", r"(?<=[(, ])\d(?=[),;.])", ("0", "1", "2")),
    ("index", r"(?<=\.)[xy](?=\()", ("x", "y")),
    ("index", r"\b(?:row|col)\b(?=\()", ("row", "col")),
    ("index", r"\b(?:min|max)(?=Coeff|_element)", ("min", "max")),
    ("index", r"\b(?:top|bottom)(?=L|R)", ("top", "bottom")),
    ("index", r"\b(?:imag|real)\b", ("imag", "real")),
    ("index", r"\b(?:Zero|Ones|Identity)\b|set(?:Ones|Zero|Identity)", ("Zero", "Ones", "setZero")),
    ("swap", rf"(?P<a>-?{VALUE}), (?P<b>-?{VALUE})(?=[,;)}}])", (r"\g<b>, \g<a>",)),
    ("condition", r"(?<=if \()(?:[^()]|\([^()]*\))+(?=\))", ("true", "false", r"!(\0)")),
    ("statement", STATEMENT, (";",)),
    ("kept", DECLARATION, ("static ",)),
    ("precision", SCALAR, (r"float(\0)",)),
    ("absolute", rf"(?!params){SCALAR}", (r"std::abs(\0)",)),
    ("threshold", rf"(?!params){SCALAR}", (r"(std::abs(\0) < 1e-3 ? 0.0 : \0)",)),
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
