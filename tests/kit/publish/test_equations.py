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
    assert read == "So JtTv is it's & the corner's velocity, φ<δ; see get_contacts."


@pytest.mark.parametrize(
    "sentence",
    [
        "a force [>= 0] for each, along [-t], with [dt = 0]",
        "[f_t1 + f_t2 = mu f_n], and [dt = 0.01] s, 9.81 m, 3 J, m/s, in C++ and g++",
        "In flight it loses [m g² dt² / 2], where [R(theta)] turns [(-l/2, -l/2)] by [pi/2].",
        "the factor [1 + epsilon], (eq. (7)), don't, e.g. [t+1] and [T - 1] of [q = (x, y, theta)]",
        "I take a part, 3B or [M^-1 f_e] or [diag(1/m, 6/(m l^2))]; a 3x3 block, [s >= 0]",
    ],
)
def test_a_formula_in_a_sentence_is_set_whole(sentence: str) -> None:
    bare = re.sub(r"[\[\]]", "", sentence)
    marked = equations.INLINE.sub(lambda found: f"[{found[0]}]", bare)
    assert marked == sentence
    assert equations.inline(bare).count("<math>") == marked.count("[")


def test_the_page_holds_each_equation_and_needs_no_other_file() -> None:
    assert re.findall(r'<span id="eq(\d+)">', PAGE) == [str(n) for n in range(1, 16)]
    assert "prefers-color-scheme:dark" in PAGE and "@media print" in PAGE
    assert not re.search(r"(src|xlink:href)=|url\(|@import|<link|<script", PAGE)
    blocks = re.findall(r"<pre.*?</pre>", PAGE, re.S)
    assert not [block for block in blocks if re.search(r"   \(\d+\)$", block, re.M)]
    names = set(re.findall(r' id="([^"]+)"', PAGE))
    assert set(re.findall(r'href="#([^"]+)"', PAGE)) <= names


def test_pages_have_contents_and_lead_from_one_to_the_next() -> None:
    pages = {file: handout_page.page(file).decode() for file in handout_page.sources()}
    order = [file.stem for file in pages]
    assert order == ["README", *sorted(order[1:-1]), "explore"] and len(order) == 6
    for file, page in pages.items():
        assert set(re.findall(r'href="#([^"]+)"', page)) <= set(re.findall(r' id="([^"]+)"', page))
        sections = re.findall(r'<h2 id="([^"]+)"', page)
        assert len(sections) > 3 and all(f'<a href="#{name}">' in page for name in sections)
        links = dict(re.findall(r'<a rel="(\w+)" href="([^"]+)"', page))
        near = {name: (file.parent / link).resolve().stem for name, link in links.items()}
        n = order.index(file.stem)
        expected = {"prev": order[n - 1 : n], "next": order[n + 1 : n + 2]}
        assert near == {name: stem[0] for name, stem in expected.items() if stem}
