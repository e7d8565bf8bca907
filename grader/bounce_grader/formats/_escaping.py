"""Text from a submission, or a name, made harmless for where it goes."""

import csv
import html
import io
import re

# What XML 1.0 can't hold, and what turns the direction of a line.
NOT_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
TURNING = re.compile("[\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069]")
FORMULA = ("=", "+", "-", "@", "\t", "\r")


def plain(text: str) -> str:
    """Without control characters, but with its lines."""
    shown = NOT_XML.sub("\N{REPLACEMENT CHARACTER}", TURNING.sub("\N{REPLACEMENT CHARACTER}", text))
    return "".join(
        c if c in "\n\t" or c.isprintable() else "\N{REPLACEMENT CHARACTER}" for c in shown
    )


def to_html(text: str) -> str:
    return html.escape(plain(text))


def csv_cell(value: object) -> str:
    """A text that a spreadsheet would take for a formula gets an apostrophe."""
    text = str(value)
    if isinstance(value, str) and text.lstrip().startswith(FORMULA):
        return "'" + plain(text)
    return plain(text)


def csv_line(values: list[str]) -> str:
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerow([csv_cell(value) for value in values])
    return out.getvalue()


def markdown(text: str) -> str:
    """One line, of which nothing is markup, a mention or a link."""
    line = html.escape(plain(text).replace("\n", " "), quote=False)
    marked = re.sub(r"([\\`*_{}\[\]()#+!|~-])", r"\\\1", line)
    return marked.replace("@", "@\N{ZERO WIDTH SPACE}")


def markdown_code(text: str) -> str:
    """A block that its content can't leave."""
    longest = max((len(run) for run in re.findall(r"`+", text)), default=0)
    fence = "`" * max(3, longest + 1)
    return f"{fence}text\n{plain(text)}\n{fence}"


def workflow_data(text: str) -> str:
    """The message of a workflow command of GitHub's."""
    return plain(text).replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def workflow_property(text: str) -> str:
    return workflow_data(text).replace(":", "%3A").replace(",", "%2C")
