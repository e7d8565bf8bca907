"""Makes text from a submission (names of files, texts of exceptions, messages of compilers)
harmless for its destination. Each destination has one function, and all such text goes through it:

    the score record      printable_text(text), printable_name(text)
    a terminal or a log   terminal(text)
    HTML and SVG          html(text)              between tags, or in a quoted attribute;
                                                  formats/html.py calls it for each value
    JSON or XML           printable(text)         before a library writes them; then
                          json_document(value), xml_document(text)
    CSV                   csv_row(values)         a whole line
    Markdown              markdown(text)          within a line or a table's cell
                          markdown_block(text)    lines of their own
    GitHub's log          workflow(command, message, file=..., line=...)    a whole line

All begin with printable(text), which replaces unprintable characters by U+FFFD: C0 and C1 controls,
bidirectional overrides, lone surrogates, and what XML 1.0 can't hold.

Whatever is printed may end up in a CI log, which treats "::add-mask::" at the start of a line and
"##[group]" anywhere as commands. So all of these break such words up, except csv_row, whose output
only goes to files.
"""

import json
import math
import re
from collections.abc import Iterable, Sequence
from html import escape
from unicodedata import name as unicode_name

REPLACEMENT = "\N{REPLACEMENT CHARACTER}"
ZERO_WIDTH_SPACE = "\N{ZERO WIDTH SPACE}"
LONGEST_TEXT = 4000
LONGEST_NAME = 255
LONGEST_SENTENCE = 1000
Value = str | int | float | None


def printable(text: str) -> str:
    """Replaces what isn't printable; keeps the lines."""
    return printable_text(text, len(text) + 1)


def printable_text(text: str, limit: int = LONGEST_TEXT) -> str:
    """For the record: printable characters and line ends, of bounded length."""
    text = text[: 2 * limit + 2].replace("\r\n", "\n").replace("\t", " ")
    if not text.replace("\n", "").isprintable():
        text = "".join(c if c.isprintable() or c == "\n" else REPLACEMENT for c in text)
    return text if len(text) <= limit else text[: limit - 1] + "…"


def in_one_line(text: str) -> str:
    """For the record: one printable line of bounded length."""
    return printable_text(text, LONGEST_SENTENCE).replace("\n", " ")


def printable_name(text: str) -> str:
    """For the record: the name of a file, in one line."""
    return printable_text(text, LONGEST_NAME).replace("\n", REPLACEMENT)


def alphabetical(name: str) -> str:
    """To sort names by: a Latin letter counts without its marks, as L for Ł."""
    letters = ((c, re.match(r"LATIN \w+ LETTER (\w) WITH", unicode_name(c, ""))) for c in name)
    return "".join(match[1] if match else c for c, match in letters).casefold()


def first_few(items: Sequence[str], limit: int = 5, separator: str = ", ", more: int = 0) -> str:
    """Joins the first few items of a list, as "a, b and 7 more", `more` of which aren't in it."""
    rest = max(0, len(items) - limit) + more
    shown = separator.join(items[:limit])
    return f"{shown} and {rest} more" if rest > 0 else shown


def terminal(text: str) -> str:
    """One line without control characters."""
    return _no_command(printable(text).replace("\n", REPLACEMENT))


def _no_command(text: str) -> str:
    """Breaks up, by a space, what a CI log would run as a command."""
    return _no_old_command(re.sub(r"^( *:)(?=:)", r"\1 ", text, flags=re.MULTILINE))


def _no_old_command(text: str) -> str:
    return re.sub(r"#(?=#\w*\[)", "# ", text)


def html(text: str) -> str:
    """Escapes text for HTML. Line ends stay; a browser shows them within <pre>."""
    return xml_document(escape(printable(text), quote=True))


def xml_document(written: str) -> str:
    """The same document, with a character reference in what a CI log would run as a command."""
    colons = re.sub(r"^( *):(?=:)", r"\1&#58;", written, flags=re.MULTILINE)
    return re.sub("#(?=#)", "&#35;", colons)


def json_document(value: object, indent: int | None = None) -> str:
    """JSON in which a CI log finds no command: no line begins with a colon, and "##" is escaped."""
    return re.sub("#(?=#)", r"\\u0023", json.dumps(value, indent=indent, ensure_ascii=False))


FORMULA = r"[=+\-@＝＋－＠]"  # how one begins


def csv_row(values: Iterable[Value]) -> str:
    """A line that ends in CRLF. Numbers stay numbers; None, NaN and infinity become empty. Text
    that a spreadsheet would take for a formula gets an apostrophe in front."""
    return ",".join(_csv_field(value) for value in values) + "\r\n"


def _csv_field(value: Value) -> str:
    if value is None or (isinstance(value, float) and not math.isfinite(value)):
        return ""
    if not isinstance(value, str):
        return str(value)
    text = printable(value)
    if not re.fullmatch(r"-?\d+(\.\d+)?", text, re.ASCII):
        # Where a semicolon separates, a spreadsheet splits there, even within quotes.
        text = re.sub(rf"(^|\n)(?= *{FORMULA})|;(?=[ \"']*{FORMULA})", r"\g<0>'", text)
    return '"' + text.replace('"', '""') + '"'


def markdown(text: str) -> str:
    """One line without markup; on GitHub, also without a mention, a reference or a link."""
    line = escape(printable(text).replace("\n", " "), quote=False)
    marked = re.sub(r"([\\`*_{}\[\]()#+!|~$-])", r"\\\1", line)
    return _no_command(re.sub(r"(@|#|://|www\.|(?i:GH)(?=\\-))", rf"\1{ZERO_WIDTH_SPACE}", marked))


def markdown_block(text: str) -> str:
    """A code block that its content can't close."""
    fence = "`" * max(3, 1 + max(map(len, re.findall("`+", text)), default=0))
    return f"{fence}text\n{_no_command(printable(text))}\n{fence}"


def workflow(command: str, message: str, **properties: str | int) -> str:
    """One workflow command for GitHub's runner, as workflow("error", "x", file="a.cpp", line=3)."""
    values = {key: _data(str(value)) for key, value in properties.items()}
    escaped = {key: v.replace(":", "%3A").replace(",", "%2C") for key, v in values.items()}
    given = ",".join(f"{key}={value}" for key, value in escaped.items())
    return _no_old_command(f"::{command}{' ' * bool(given)}{given}::{_data(message)}")


def _data(text: str) -> str:
    return printable(text).replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")
