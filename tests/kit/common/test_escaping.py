"""Text from a submission never acts as markup or as a command: each escape is checked with an
independent reader of its format."""

import csv
import io
import json
import re
import unicodedata
from html.parser import HTMLParser
from xml.etree import ElementTree

import odd_texts
import pytest
from bounce_grader.common import escaping
from hypothesis import example, given
from hypothesis import strategies as st
from markdown_it import MarkdownIt
from odd_texts import TEXTS


def printable(text: str) -> str:
    """The printable text, computed with the Unicode database instead of str.isprintable."""
    kept = text.replace("\r\n", "\n").replace("\t", " ")
    return "".join(escaping.REPLACEMENT if _moves(c) else c for c in kept)


def _moves(c: str) -> bool:
    kind = unicodedata.category(c)
    return c != "\n" and c != " " and (kind[0] == "C" or kind in ("Zl", "Zp", "Zs"))


@given(TEXTS, st.integers(1, 60))
def test_a_text_of_the_record_is_printable_bounded_and_utf8(text: str, most: int) -> None:
    kept, whole = escaping.printable_text(text, most), printable(text)
    kept.encode("utf-8")
    assert len(kept) <= most
    assert kept == whole if len(whole) <= most else whole.startswith(kept[:-1]) and kept[-1] == "…"


@given(TEXTS)
def test_a_name_of_the_record_is_one_line(text: str) -> None:
    name = escaping.printable_name(text)
    assert "\n" not in name and len(name) <= escaping.LONGEST_NAME


def test_a_text_of_many_megabytes_is_cut_before_it_is_looked_at() -> None:
    assert escaping.printable_text("\r\n" * 10_000_000) == "\n" * (escaping.LONGEST_TEXT - 1) + "…"


@given(TEXTS)
def test_no_control_reaches_a_terminal(text: str) -> None:
    assert not any(_moves(c) or c == "\n" for c in escaping.terminal(text))


@given(TEXTS)
@example("::add-mask::x")
@example(" \t::stop-commands::x")
@example("a##[group]b")
@example("##vso[task.complete]")
@example("###[x]")
@example("a\n::error::b")
@example("\t ::x")
def test_no_line_is_a_command_of_ci(text: str) -> None:
    assert odd_texts.commands_in(escaping.terminal(text)) == []


def test_words_that_are_no_command_stay_as_they_are() -> None:
    compiler = "part1.cpp:3:9: no member in std::vector"
    for line in (compiler, "a # b [c]", "[bold]x[/]", "q = (1, 2)"):
        assert escaping.terminal(line) == line


class Heard(HTMLParser):
    """Collects the text between <pre title="..."> and </pre>, the attribute, and any other
    markup."""

    def __init__(self, document: str) -> None:
        super().__init__(convert_charrefs=True)
        self.text = ""
        self.tags: list[object] = []
        self.others: list[str] = []
        self.feed(document)
        self.close()

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, attributes))

    def handle_data(self, data: str) -> None:
        self.text += data

    def handle_decl(self, decl: str) -> None:
        self.others.append(decl)

    def handle_comment(self, data: str) -> None:
        self.others.append(data)

    handle_pi = unknown_decl = handle_comment


@given(TEXTS)
def test_html_is_read_as_the_text_that_it_was(text: str) -> None:
    heard = Heard(f'<pre title="{escaping.html(text)}">{escaping.html(text)}</pre>')
    assert odd_texts.commands_in(escaping.html(text)) == []
    assert (heard.text, heard.others) == (printable(text), [])
    assert heard.tags == [("pre", [("title", printable(text))])]


@given(TEXTS)
def test_a_plain_text_can_stand_in_xml(text: str) -> None:
    written = ElementTree.Element("failure", {"message": escaping.printable(text)})
    written.text = escaping.printable(text)
    document = escaping.xml_document(ElementTree.tostring(written, encoding="unicode"))
    element = ElementTree.fromstring(document)
    assert (element.text or "") == element.get("message") == printable(text)
    assert odd_texts.commands_in(document) == []


@given(TEXTS, st.sampled_from([None, 1]))
def test_json_is_read_as_what_it_was(text: str, indent: int | None) -> None:
    document = escaping.json_document({"said": escaping.printable(text)}, indent)
    assert json.loads(document) == {"said": printable(text)}
    assert odd_texts.commands_in(document) == []


def unguarded(cell: str) -> str:
    signs = r"[=+\-@＝＋－＠]"
    return re.sub(rf"((?:^|\n)(?=' *{signs})|;(?='[ \"']*{signs}))'", r"\1", cell)


VALUES = st.none() | st.integers() | st.floats() | TEXTS


@given(st.lists(VALUES, min_size=2))
@example([None, "\r\n="])
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


FORMULAS = ("=", "+", "-", "@", "＝", "＋", "－", "＠")


@given(TEXTS)
@example('x;"=1+1;.txt')
@example("=HYPERLINK(1)")
@example(" =1+1")
@example("\t=1+1")
@example("a;=1+1")
@example("-1+cmd|' /C calc'!A0")
@example("@SUM(1)")
def test_no_text_is_calculated_by_a_spreadsheet(text: str) -> None:
    [cell, _] = next(csv.reader(io.StringIO(escaping.csv_row([text, 0]), newline="")))
    if not re.fullmatch(r"-?[0-9]+(\.[0-9]+)?", cell):
        for field in re.split(r"[;\n]", cell):
            assert not field.strip().startswith(FORMULAS)
    # As where semicolons separate: the first comma is then within a field, and quotes mean nothing.
    [_, *fields] = next(csv.reader([escaping.csv_row([0, text.replace("\n", " ")])], delimiter=";"))
    assert not any(
        field.strip(" \"'").startswith(FORMULAS) and "'" not in field for field in fields
    )


def test_numbers_in_csv_stay_numbers() -> None:
    row = escaping.csv_row([1, 87.5, -0.25, "-3", None, float("nan"), 'O\'Neil, "Jo"'])
    assert row == '1,87.5,-0.25,"-3",,,"O\'Neil, ""Jo"""\r\n'


MARKDOWN = MarkdownIt("commonmark").enable("table")


@given(TEXTS)
@example("a|b\\|c\\")
@example("`` ` ``` **a** [b](c) <i> &amp; #1 @all")
@example("https://a.b www.a.b ssh://a")
def test_markdown_is_read_as_the_line_that_it_was(text: str) -> None:
    line = escaping.markdown(text)
    tokens = MARKDOWN.parse(f"| a | b |\n|--|--|\n| {line} | end |\n")
    cells = [token for token in tokens if token.type == "inline"]
    assert [cell.content for cell in cells[:2]] == ["a", "b"]
    assert len(cells) == 4 and cells[3].content == "end"
    inside = cells[2].children or []
    assert {token.type for token in inside} <= {"text", "text_special"}
    read = "".join(token.content for token in inside).replace(escaping.ZERO_WIDTH_SPACE, "")
    assert read == printable(text).replace("\n", " ").strip(" ")
    assert not re.search(r"[@#]\w|://\w|www\.\w", line.replace("\\", ""))


@given(TEXTS)
@example("```\nout")
@example("````\n~~~\n    x")
def test_a_block_of_markdown_is_code_and_nothing_else(text: str) -> None:
    block = escaping.markdown_block(text)
    [read] = MARKDOWN.parse(block)
    assert (read.type, read.info) == ("fence", "text")
    assert unbroken(read.content) == unbroken(f"{printable(text)}\n")
    assert odd_texts.commands_in(block) == []


def unbroken(text: str) -> str:
    """The text without spaces, including those that break up commands."""
    return text.replace(" ", "")


def runner_reads(line: str) -> tuple[str, dict[str, str], str]:
    """Decodes as GitHub's runner does: https://github.com/actions/toolkit documents these
    escapes."""
    assert "\n" not in line and "\r" not in line
    match = re.fullmatch(r"::(\w+)(?: (.*?))?::(.*)", line)
    assert match
    command, properties, data = match.groups(default="")
    pairs = (pair.split("=", 1) for pair in properties.split(",") if pair)
    return command, {key: unescape(value) for key, value in pairs}, unescape(data)


def unescape(text: str) -> str:
    for escaped, plain in (("%3A", ":"), ("%2C", ","), ("%0D", "\r"), ("%0A", "\n"), ("%25", "%")):
        text = text.replace(escaped, plain)
    return text


@given(TEXTS, TEXTS.filter(bool))
def test_a_workflow_command_is_one_command_with_its_own_properties(text: str, file: str) -> None:
    line = escaping.workflow("error", text, file=file, line=3)
    command, properties, data = runner_reads(line)
    assert (command, list(properties), properties["line"]) == ("error", ["file", "line"], "3")
    assert unbroken(properties["file"]) == unbroken(printable(file))
    assert unbroken(data) == unbroken(printable(text))
    assert odd_texts.commands_in(line) == [line]


def test_a_workflow_command_needs_no_properties() -> None:
    assert escaping.workflow("notice", "50% done\nnow") == "::notice::50%25 done%0Anow"


@pytest.mark.parametrize("text", ["", "a", "ä\n界"])
def test_a_harmless_text_stays_as_it_is(text: str) -> None:
    assert escaping.printable_text(text) == escaping.html(text) == text
