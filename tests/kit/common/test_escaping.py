"""Text from a submission never acts as markup or as a command: what is written for a destination is
read by an independent reader of its format, as the text that it was."""

import csv
import html
import io
import re
import unicodedata
from collections.abc import Callable
from typing import NamedTuple
from xml.etree import ElementTree

import odd_texts
import pytest
from bounce_grader.common import escaping
from hypothesis import example, given
from hypothesis import strategies as st
from markdown_it import MarkdownIt
from odd_texts import TEXTS

# --- independent readers ---


def printable(text: str) -> str:
    """The printable text, computed with the Unicode database instead of str.isprintable."""
    kept = text.replace("\r\n", "\n").replace("\t", " ")
    return "".join(escaping.REPLACEMENT if _moves(c) else c for c in kept)


def _moves(c: str) -> bool:
    kind = unicodedata.category(c)
    return c != "\n" and c != " " and (kind[0] == "C" or kind in ("Zl", "Zp", "Zs"))


def html_reads(document: str) -> str:
    """As the text of an element or of an attribute: no sign of markup is left in it."""
    assert not set("<>\"'") & set(document)
    return html.unescape(document)


def xml_of(text: str) -> str:
    written = ElementTree.Element("failure", {"message": escaping.printable(text)})
    written.text = escaping.printable(text)
    return escaping.xml_document(ElementTree.tostring(written, encoding="unicode"))


def xml_reads(document: str) -> str:
    element = ElementTree.fromstring(document)
    assert element.get("message") == (element.text or "")
    return element.text or ""


MARKDOWN = MarkdownIt("commonmark").enable("table")


def cell_reads(document: str) -> str:
    assert not re.search(r"[@#]\w|://\w|www\.\w", document.replace("\\", ""))
    cells = [token for token in MARKDOWN.parse(document) if token.type == "inline"]
    assert [cell.content for cell in (*cells[:2], *cells[3:])] == ["a", "b", "end"]
    inside = cells[2].children or []
    assert {token.type for token in inside} <= {"text", "text_special"}
    return "".join(token.content for token in inside).replace(escaping.ZERO_WIDTH_SPACE, "")


def block_reads(document: str) -> str:
    [read] = MARKDOWN.parse(document)
    assert (read.type, read.info) == ("fence", "text")
    return read.content.removesuffix("\n")


def runner_reads(line: str) -> str:
    [(command, where, message)] = odd_texts.runner_commands(line)
    assert (command, where) == ("error", {"file": message, "line": "3"}) and "\r" not in line
    return message


# --- the destinations ---


class Destination(NamedTuple):
    write: Callable[[str], str]
    read: Callable[[str], str]
    new_line: str = "\n"  # what stands for one
    keeps_spaces: bool = True  # none is added to break up a command


DESTINATIONS = {
    "a terminal": Destination(escaping.terminal, str, escaping.REPLACEMENT, False),
    "HTML": Destination(escaping.html, html_reads),
    "XML": Destination(xml_of, xml_reads),
    "a cell of Markdown": Destination(
        lambda text: f"| a | b |\n|--|--|\n| {escaping.markdown(text)} | end |\n",
        cell_reads,
        " ",
        False,
    ),
    "a block of Markdown": Destination(escaping.markdown_block, block_reads, "\n", False),
    "GitHub's log": Destination(
        lambda text: escaping.workflow("error", text, file=text, line=3), runner_reads, "\n", False
    ),
}


@pytest.mark.parametrize("name", DESTINATIONS)
@given(TEXTS)
@example("::add-mask::x")
@example(" \t::stop-commands::x")
@example("\t ::x\na\n::error::b")
@example("a##[group]b")
@example("##vso[task.complete]")
@example("###[x]")
@example("a|b\\|c\\")
@example("`` ` ``` **a** [b](c) <i> &amp; #1 @all")
@example("https://a.b www.a.b ssh://a")
@example("```\nout")
@example("````\n~~~\n    x")
@example("50% done\nnow,a:b")
@example("$x^2$, GH-1 and gh-2")
def test_a_text_is_read_as_what_it_was(name: str, text: str) -> None:
    to = DESTINATIONS[name]
    document = to.write(text)
    document.encode("utf-8")
    read, shown = to.read(document), printable(text).replace("\n", to.new_line)
    if not to.keeps_spaces:
        read, shown = read.replace(" ", ""), shown.replace(" ", "")
    assert read == shown
    assert odd_texts.commands_in(document) == [document] * (name == "GitHub's log")


def test_markdown_holds_no_mathematics_and_no_reference_to_an_issue() -> None:
    written = escaping.markdown("$x$ GH-1 gh-2")
    assert "\\$x\\$" in written and "GH\\-" not in written and "gh\\-" not in written


# --- the record ---


@given(TEXTS, st.integers(1, 60))
def test_a_text_of_the_record_is_printable_bounded_and_utf8(text: str, most: int) -> None:
    kept, whole = escaping.printable_text(text, most), printable(text)
    kept.encode("utf-8")
    assert len(kept) <= most
    assert kept == whole if len(whole) <= most else whole.startswith(kept[:-1]) and kept[-1] == "…"
    name = escaping.printable_name(text * most)
    assert "\n" not in name and len(name) <= escaping.LONGEST_NAME


def test_a_text_of_many_megabytes_is_cut_before_it_is_looked_at() -> None:
    assert escaping.printable_text("\r\n" * 10_000_000) == "\n" * (escaping.LONGEST_TEXT - 1) + "…"


# --- CSV ---

FORMULAS = ("=", "+", "-", "@", "＝", "＋", "－", "＠")
VALUES = st.none() | st.integers() | st.floats() | TEXTS


def unguarded(cell: str) -> str:
    signs = r"[=+\-@＝＋－＠]"
    return re.sub(rf"((?:^|\n)(?=' *{signs})|;(?='[ \"']*{signs}))'", r"\1", cell)


@given(st.lists(VALUES, min_size=2))
@example([None, "\r\n="])
@example([1, 87.5, -0.25, "-3", float("nan"), 'O\'Neil, "Jo"'])
def test_csv_is_read_as_the_row_that_it_was(values: list[escaping.Value]) -> None:
    line = escaping.csv_row(values)
    line.encode("utf-8")
    [row] = csv.reader(io.StringIO(line, newline=""), strict=True)
    assert len(row) == len(values)
    for value, cell in zip(values, row):
        if isinstance(value, str):
            assert unguarded(cell) == unguarded(printable(value))
        elif value is None or value != value or value in (float("inf"), -float("inf")):
            assert cell == ""
        else:
            assert type(value)(cell) == value


@given(TEXTS)
@example('x;"=1+1;.txt')
@example(" =1+1")
@example("\t=1+1")
@example("-1+cmd|' /C calc'!A0")
@example("@SUM(1)")
def test_no_text_is_calculated_by_a_spreadsheet(text: str) -> None:
    [cell, _] = next(csv.reader(io.StringIO(escaping.csv_row([text, 0]), newline="")))
    if not re.fullmatch(r"-?[0-9]+(\.[0-9]+)?", cell):
        assert not any(part.strip().startswith(FORMULAS) for part in re.split(r"[;\n]", cell))
    # As where semicolons separate: the first comma is then within a field, and quotes mean nothing.
    [_, *fields] = next(csv.reader([escaping.csv_row([0, text.replace("\n", " ")])], delimiter=";"))
    assert not any(f.strip(" \"'").startswith(FORMULAS) and "'" not in f for f in fields)
