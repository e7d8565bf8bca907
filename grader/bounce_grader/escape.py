"""What a submission says, made harmless for where it goes: names of files, texts of exceptions,
messages of compilers. Each place has one function, and nothing of a submission goes there without:

    the score record      said(text), name(text)
    a terminal or a log   terminal(text)
    HTML                  html(text)              between tags, or in a quoted attribute
    XML, as in JUnit      xml(text)               likewise
    CSV                   csv_row(values)         a whole line
    a Markdown table      markdown_cell(text)
    GitHub's log          workflow(command, message, file=..., line=...)    a whole line

All begin with the same: characters that don't print become U+FFFD. These are controls, C1 controls,
bidirectional overrides, lone surrogates, and what XML 1.0 has no place for.
"""

import html as html_entities
import math
import re
from collections.abc import Iterable

REPLACEMENT = "\N{REPLACEMENT CHARACTER}"
LONGEST_TEXT = 4000
LONGEST_NAME = 255
Value = str | int | float | None


def said(text: str, most: int = LONGEST_TEXT) -> str:
    """For the record: lines of printable characters, of bounded length."""
    text = text[: 2 * most + 2].replace("\r\n", "\n").replace("\t", " ")
    clean = "".join(c if c.isprintable() or c == "\n" else REPLACEMENT for c in text)
    return clean if len(clean) <= most else clean[: most - 1] + "…"


def name(text: str) -> str:
    """For the record: a file's name, in one line."""
    return said(text, LONGEST_NAME).replace("\n", REPLACEMENT)


def terminal(text: str) -> str:
    """One line that moves no cursor. A log of CI is a terminal too: what it would take for a
    command, as "::add-mask::" at the start or "##[group]" anywhere, is broken by a space.

    Print it through rich's Text, which reads no markup.
    """
    line = _printable(text).replace("\n", REPLACEMENT)
    return re.sub(r"^(\s*:)(?=:)|(#)(?=#\w*\[)", r"\1\2 ", line)


def html(text: str) -> str:
    """Lines stay lines; a browser shows them as such inside of <pre>."""
    return html_entities.escape(_printable(text), quote=True)


def xml(text: str) -> str:
    """Line breaks as references, since an attribute has no others."""
    return html_entities.escape(_printable(text), quote=True).replace("\n", "&#10;")


def csv_row(values: Iterable[Value]) -> str:
    """A line that ends in CRLF. Numbers stay numbers, and None, NaN and infinity are empty. A text
    that a spreadsheet would calculate begins with an apostrophe instead."""
    return ",".join(_csv_field(value) for value in values) + "\r\n"


def _csv_field(value: Value) -> str:
    if value is None or (isinstance(value, float) and not math.isfinite(value)):
        return ""
    if not isinstance(value, str):
        return str(value)
    text = _printable(value)
    if not re.fullmatch(r"-?\d+(\.\d+)?", text, re.ASCII):
        # Where lists are separated by semicolons, a spreadsheet splits there, quoted or not.
        text = re.sub(r"(^|[;\n])(?= *[=+\-@＝＋－＠])", r"\1'", text)
    return '"' + text.replace('"', '""') + '"'


def markdown_cell(text: str) -> str:
    """Each line as code, where nothing else means anything, a mention or a link included."""
    return "<br>".join(filter(None, map(_code, _printable(text).split("\n"))))


def _code(line: str) -> str:
    if not line.strip(" "):
        return ""
    runs = [len(run) for run in re.findall("`+", line)]
    fence = "`" * (max(runs, default=0) + 1)
    return f"{fence} {line} {fence}".replace("|", r"\|")


def workflow(command: str, message: str, **properties: str | int) -> str:
    """One command to GitHub's runner, as workflow("error", "x", file="a.cpp", line=3)."""
    given = ",".join(f"{key}={_property(str(value))}" for key, value in properties.items())
    return f"::{command}{' ' * bool(given)}{given}::{_data(_printable(message))}"


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(_printable(text)).replace(":", "%3A").replace(",", "%2C")


def _printable(text: str) -> str:
    return said(text, len(text) + 1)
