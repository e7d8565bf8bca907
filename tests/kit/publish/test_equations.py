"""The handout's page: equations in MathML, and no other file that it needs."""

import re
from xml.etree import ElementTree

import pytest
from bounce_grader.publish import equations, handout_page
from conftest import ROOT

PAGE = handout_page.page(ROOT / "student/README.md").decode()


def words(mathml: str) -> str:
    """What is read, without markup."""
    tree = ElementTree.fromstring(f"<div>{mathml.replace('&nbsp;', ' ')}</div>")
    return " ".join("".join(tree.itertext()).split())


def test_symbols_have_their_indices_powers_and_accents() -> None:
    [line] = equations.displayed("J_hat^T M^-1 v' <= mu f_n          (9)\n")
    assert line.number == "9" and len(line.mathml) == 1
    assert words(line.mathml[0]) == "J^TM−1v′≤μfn"
    assert '<mover accent="true"><mi>J</mi><mo>^</mo></mover>' in line.mathml[0]
    assert "<msub><mi>f</mi><mi>n</mi></msub>" in line.mathml[0]


def test_a_matrix_is_one_line_with_its_rows_below_each_other() -> None:
    block = "V = | A B   e |         e = (0, 1)^T       (9)\n    | mu  -1  0 |\n"
    [line] = equations.displayed(block)
    assert line.number == "9" and len(line.mathml) == 2
    rows = ElementTree.fromstring(line.mathml[0]).findall(".//mtr")
    assert ["".join(cell.itertext()) for row in rows for cell in row] == ["AB", "e", "μ", "−1", "0"]
    assert rows[0][0].get("columnspan") == "2"
    assert words(line.mathml[1]) == "e=(0,1)T"


def test_columns_beside_each_other_stay_apart() -> None:
    [line] = equations.displayed("J_hat = [J_n  -J_t  J_t]   (7)\n")
    assert line.mathml[0].count('<mspace width="1em"/>') == 2
    assert '<mo stretchy="false" form="prefix">−</mo>' in line.mathml[0]
    [difference] = equations.displayed("c - (x, -y)\n")
    assert difference.mathml[0].count('form="prefix"') == 1


def test_what_is_no_equation_is_refused() -> None:
    with pytest.raises(ValueError, match="no equation"):
        equations.displayed("x = $\n")


def test_a_sentence_keeps_its_words() -> None:
    text = "So J_t^T v is it's & the corner's velocity, phi < delta; see get_contacts."
    html = equations.inline(text)
    assert words(html) == "So JtTv is it's & the corner's velocity, φ < δ; see get_contacts."


def test_the_page_holds_each_equation_and_needs_no_other_file() -> None:
    assert re.findall(r'<span id="eq(\d+)">', PAGE) == [str(n) for n in range(1, 16)]
    assert "prefers-color-scheme: dark" in PAGE and "@media print" in PAGE
    assert not re.search(r"(src|xlink:href)=|url\(|@import|<link|<script", PAGE)
    left = [
        block
        for block in re.findall(r"<pre.*?</pre>", PAGE, re.S)
        if re.search(r"   \(\d+\)$", block, re.M)
    ]
    assert not left


def test_links_within_the_page_arrive() -> None:
    names = set(re.findall(r' id="([^"]+)"', PAGE))
    assert set(re.findall(r'href="#([^"]+)"', PAGE)) <= names


def test_the_same_markdown_gives_the_same_page() -> None:
    assert handout_page.page(ROOT / "student/README.md").decode() == PAGE
