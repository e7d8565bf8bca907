"""The words and colours of charts of error over time: those of the handout's own charts, read from
its files, so that a student and an instructor see the same."""

import re

from bounce_grader.common.paths import HANDOUT
from bounce_grader.common.svg import Drawing

CHARTS = HANDOUT / "given" / "study"
WORDS = dict(
    re.findall(
        r'^constexpr const char\* k(\w+) = "(.*)";$',
        (CHARTS / "words.hpp").read_text("utf-8"),
        re.M,
    )
)
STYLE = Drawing((CHARTS / "chart.css").read_text("utf-8"))
ON_PAPER = Drawing(
    STYLE.partition("@media")[0]
)  # also for pages that invert themselves in the dark
# The curve's class by what it shows; delta is in proportion to dt, as in the handout's second line.
CLASSES = {"submission": "own k1", "solution": "k2", "least": "k4"}
NAMES = {
    "submission": WORDS["Yours"],
    "solution": WORDS["Assignment"],
    "least": "no more model than each step needs",
}
