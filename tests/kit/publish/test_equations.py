"""The handout's page: equations in MathML, and no other file that it needs."""

import html
import re
from pathlib import Path

import golden
import pytest
from bounce_grader.publish import equations, handout_page
from conftest import ROOT

HERE = Path(__file__).parent
PAGE = handout_page.page(ROOT / "student/README.md").decode()


@pytest.mark.golden
def test_equations_are_set_as_a_person_has_read_them() -> None:
    texts = (HERE / "equations.txt").read_text("utf-8").strip().split("\n\n")
    got = "\n".join(equations.displayed(f"{text}\n") for text in texts)
    golden.compare_file(HERE / "equations.html", got.replace("><m", ">\n<m"))


def test_what_is_no_equation_is_refused_and_a_sentence_keeps_its_words() -> None:
    with pytest.raises(ValueError, match="no equation"):
        equations.displayed("x = $\n")
    sentence = "So J_t^T v is it's & the corner's velocity, phi < delta; see get_contacts."
    read = html.unescape(re.sub("<[^>]*>", "", equations.inline(sentence)))
    assert read == "So JtTv is it's & the corner's velocity, φ < δ; see get_contacts."


def test_the_page_holds_each_equation_and_needs_no_other_file() -> None:
    assert re.findall(r'<span id="eq(\d+)">', PAGE) == [str(n) for n in range(1, 16)]
    assert "prefers-color-scheme:dark" in PAGE and "@media print" in PAGE
    assert not re.search(r"(src|xlink:href)=|url\(|@import|<link|<script", PAGE)
    blocks = re.findall(r"<pre.*?</pre>", PAGE, re.S)
    assert not [block for block in blocks if re.search(r"   \(\d+\)$", block, re.M)]
    names = set(re.findall(r' id="([^"]+)"', PAGE))
    assert set(re.findall(r'href="#([^"]+)"', PAGE)) <= names
