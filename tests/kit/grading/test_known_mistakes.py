"""What students are told of known mistakes. That each is named is shown by the gallery."""

import re

import pytest
from bounce_grader.grading.known_mistakes import gallery, Mistake
from bounce_grader.grading.record import KNOWN
from conftest import ROOT

# The numbers don't tell how the code is written: a cause is said as one, after "Often:". And in a
# pair, what is right of the one may be wrong by the other.
ABOUT_CODE = re.compile(
    r"\b(loops?|static|global|variables?|typed|written down|hard-coded|appears? nowhere|<<)\b"
)
README = (ROOT / "student" / "README.md").read_text("utf-8")
EQUATIONS = {int(number) for number in re.findall(r"\((\d+)\)$", README, re.M)}
SAYS_RIGHT = re.compile(r"\b(is|are) right\b(?! one)")


@pytest.mark.parametrize("m", gallery(), ids=lambda m: m.name)
def test_a_mistakes_words_are_true_and_no_instructors(m: Mistake) -> None:
    assert not ABOUT_CODE.search(f"{m.title}. {m.sentence}".partition("Often:")[0])
    assert not SAYS_RIGHT.search(m.sentence)
    hints = (ROOT / "student" / "hints" / f"{m.part.stem}.md").read_text("utf-8")
    assert m.hint.startswith(m.name[4])  # its part's
    assert f"\n## {m.hint}\n" in hints and set(m.equations) <= EQUATIONS
    assert m.instructor not in (KNOWN / f"{m.part.stem}.json").read_text()
