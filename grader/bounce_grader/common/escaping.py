"""Makes text of a submission harmless for where it goes: names of files, texts of exceptions,
messages of compilers. Each place has one function, and no such text goes there without it:

    the score record      printable_text(text), printable_name(text)
    a terminal or a log   terminal(text)
    HTML and SVG          html(text)              between tags, or in a quoted attribute;
                                                  formats/templates.py calls it for each value
    JSON or XML           printable(text)         to a library that writes them; then
                          json_document(value), xml_document(text)
    CSV                   csv_row(values)         a whole line
    Markdown              markdown(text)          inside of a line or a table's cell
                          markdown_block(text)    lines of their own
    GitHub's log          workflow(command, message, file=..., line=...)    a whole line

All begin with printable(text): characters that don't print become U+FFFD. These are controls, C1
controls, bidirectional overrides, lone surrogates, and what XML 1.0 has no place for.

Whatever is printed may be printed to a log of CI, which takes "::add-mask::" at the start of a line
or "##[group]" anywhere for a command. So none of these leaves such words whole, except csv_row,
which is written to files alone.
"""

import json
import math
import re
from collections.abc import Iterable, Sequence

REPLACEMENT = "\N{REPLACEMENT CHARACTER}"
ZERO_WIDTH_SPACE = "\N{ZERO WIDTH SPACE}"
LONGEST_TEXT = 4000
LONGEST_NAME = 255
Value = str | int | float | None


def printable(text: str) -> str:
    """Lines of printable characters."""
    return printable_text(text, len(text) + 1)


def printable_text(text: str, most: int = LONGEST_TEXT) -> str:
    """For the record: lines of printable characters, of bounded length."""
    text = text[: 2 * most + 2].replace("\r\n", "\n").replace("\t", " ")
    clean = "\n".join(map(_printable_line, text.split("\n")))
    return clean if len(clean) <= most else clean[: most - 1] + "…"


def _printable_line(line: str) -> str:
    if line.isprintable():
        return line
    return "".join(c if c.isprintable() else REPLACEMENT for c in line)


def printable_name(text: str) -> str:
    """For the record: a file's name, in one line."""
    return printable_text(text, LONGEST_NAME).replace("\n", REPLACEMENT)


def first_few(items: Sequence[str], most: int = 5, separator: str = ", ", more: int = 0) -> str:
    """The first few of a list that may be long, as "a, b and 7 more"; `more` aren't in the list."""
    rest = max(0, len(items) - most) + more
    shown = separator.join(items[:most])
    return f"{shown} and {rest} more" if rest > 0 else shown


def terminal(text: str) -> str:
    """One line that moves no cursor. What a log would take for a command is broken by a space.

    Print it through rich's Text, which reads no markup.
    """
    return _no_command(printable(text).replace("\n", REPLACEMENT))


def _no_command(text: str) -> str:
    """In each line, breaks what a log would take for a command by a space."""
    return _no_old_command(re.sub(r"^( *:)(?=:)", r"\1 ", text, flags=re.MULTILINE))


def _no_old_command(text: str) -> str:
    return re.sub(r"#(?=#\w*\[)", "# ", text)


def html(text: str) -> str:
    """Lines stay lines; a browser shows them as such inside of <pre>."""
    from html import escape

    return xml_document(escape(printable(text), quote=True))


def xml_document(written: str) -> str:
    """The same document; what a log would take for a command has a character reference in it."""
    colons = re.sub(r"^( *):(?=:)", r"\1&#58;", written, flags=re.MULTILINE)
    return re.sub("#(?=#)", "&#35;", colons)


def json_document(value: object, indent: int | None = None) -> str:
    """None of its lines begins with a colon, and what a log would take for an older command has an
    escape in it."""
    return re.sub("#(?=#)", r"\\u0023", json.dumps(value, indent=indent, ensure_ascii=False))


def csv_row(values: Iterable[Value]) -> str:
    """A line that ends in CRLF. Numbers stay numbers, and None, NaN and infinity are empty. A text
    that a spreadsheet would calculate begins with an apostrophe instead."""
    return ",".join(_csv_field(value) for value in values) + "\r\n"


def _csv_field(value: Value) -> str:
    if value is None or (isinstance(value, float) and not math.isfinite(value)):
        return ""
    if not isinstance(value, str):
        return str(value)
    text = printable(value)
    if not re.fullmatch(r"-?\d+(\.\d+)?", text, re.ASCII):
        # Where lists are separated by semicolons, a spreadsheet splits there, quoted or not.
        text = re.sub(r"(^|[;\n])(?= *[=+\-@＝＋－＠])", r"\1'", text)
    return '"' + text.replace('"', '""') + '"'


def markdown(text: str) -> str:
    """One line, of which nothing is markup; nor, on GitHub, a mention, a reference or a link."""
    from html import escape

    line = escape(printable(text).replace("\n", " "), quote=False)
    marked = re.sub(r"([\\`*_{}\[\]()#+!|~-])", r"\\\1", line)
    return re.sub(r"(@|#|://|www\.)", rf"\1{ZERO_WIDTH_SPACE}", marked)


def markdown_block(text: str) -> str:
    """Lines of code that their content can't leave."""
    fence = "`" * max(3, 1 + max(map(len, re.findall("`+", text)), default=0))
    return f"{fence}text\n{_no_command(printable(text))}\n{fence}"


def workflow(command: str, message: str, **properties: str | int) -> str:
    """One command to GitHub's runner, as workflow("error", "x", file="a.cpp", line=3)."""
    given = ",".join(f"{key}={_property(str(value))}" for key, value in properties.items())
    return _no_old_command(f"::{command}{' ' * bool(given)}{given}::{_data(printable(message))}")


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(printable(text)).replace(":", "%3A").replace(",", "%2C")
