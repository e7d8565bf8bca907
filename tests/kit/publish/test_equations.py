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


MATRIX = "V = | A B   e |         e = (0, 1)^T       (9)\n    | mu  -1  0 |"
HAT = '<mover accent="true"><mi>J</mi><mo>^</mo></mover>'
NEGATIVE = '<mo stretchy="false" form="prefix">−</mo>'


@pytest.mark.parametrize(
    "text, number, read, markup",
    [
        ("J_hat^T M^-1 v' <= mu f_n          (9)", "9", ["J^TM−1v′≤μfn"], {HAT: 1}),
        ("f_n", "", ["fn"], {"<msub><mi>f</mi><mrow><mi>n</mi></mrow></msub>": 1}),
        (MATRIX, "9", ["V=(ABeμ−10)", "e=(0,1)T"], {"<mtr>": 2, "<mtd": 5, 'columnspan="2"': 1}),
        ("J_hat = [J_n  -J_t  J_t]   (7)", "7", None, {'<mspace width="1em"/>': 2, NEGATIVE: 1}),
        ("c - (x, -y)", "", ["c−(x,−y)"], {'form="prefix"': 1}),
    ],
)
def test_an_equation_is_read_as_it_is_written(
    text: str, number: str, read: list[str] | None, markup: dict[str, int]
) -> None:
    html = equations.displayed(f"{text}\n")
    assert re.findall(r'id="eq(\d+)"', html) == ([number] if number else [])
    maths = re.findall("<math.*?</math>", html)
    if read:
        assert [words(one).replace(" ", "") for one in maths] == read
    assert {piece: maths[0].count(piece) for piece in markup} == markup


def test_what_is_no_equation_is_refused_and_a_sentence_keeps_its_words() -> None:
    with pytest.raises(ValueError, match="no equation"):
        equations.displayed("x = $\n")
    html = equations.inline(
        "So J_t^T v is it's & the corner's velocity, phi < delta; see get_contacts."
    )
    assert words(html) == "So JtTv is it's & the corner's velocity, φ < δ; see get_contacts."


def test_the_page_holds_each_equation_and_needs_no_other_file() -> None:
    assert re.findall(r'<span id="eq(\d+)">', PAGE) == [str(n) for n in range(1, 16)]
    assert "prefers-color-scheme:dark" in PAGE and "@media print" in PAGE
    assert not re.search(r"(src|xlink:href)=|url\(|@import|<link|<script", PAGE)
    blocks = re.findall(r"<pre.*?</pre>", PAGE, re.S)
    assert not [block for block in blocks if re.search(r"   \(\d+\)$", block, re.M)]
    names = set(re.findall(r' id="([^"]+)"', PAGE))
    assert set(re.findall(r'href="#([^"]+)"', PAGE)) <= names
