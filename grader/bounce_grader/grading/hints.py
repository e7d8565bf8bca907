"""The hints that students receive: which heading helps with a failed check or a known pattern."""

import re
from functools import cache
from typing import NamedTuple

from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import HANDOUT

HINTS = HANDOUT / "hints"


class Hint(NamedTuple):
    """One section of a part's hints."""

    part: int
    heading: str  # "1.2 The moment arm r"
    checks: list[str]  # ids
    diagnoses: list[str]  # words of patterns
    nudge: str  # its first stage, a paragraph of plain text


@cache
def hints() -> tuple[Hint, ...]:
    return tuple(
        Hint(
            part.number,
            section.partition("\n")[0],
            _listed("Checks: ", ", ", section),
            _listed("Diagnoses: ", "; ", section),
            "".join(re.findall(r"^### A nudge\n\n(.+)$", section, re.M)).replace("`", ""),
        )
        for part in parts()
        for section in (HINTS / f"{part.stem}.md").read_text("utf-8").split("\n## ")[1:]
    )


def _listed(label: str, separator: str, section: str) -> list[str]:
    lines = re.findall(f"(?m)^{label}(.*)$", section)
    return [item for line in lines for item in line.split(separator)]


def of_check(check: str) -> str:
    """The heading for a check's id; empty if there is none."""
    return next((hint.heading for hint in hints() if check in hint.checks), "")


def of_patterns(part: int, patterns: list[str], check: str) -> str:
    """The heading for what the patterns of a part's wrong numbers say: that of the words which come
    first; empty if there is none. Words with "your" are about numbers of the hint's own checks."""
    said = " ".join(patterns)
    found = [
        (said.find(words), hint.heading)
        for hint in hints()
        for words in hint.diagnoses
        if hint.part == part and (check in hint.checks or "your" not in words.lower())
    ]
    return min((place for place in found if place[0] >= 0), default=(0, ""))[1]


def nudge(heading: str) -> str:
    """The first stage of the hint with this heading; empty if there is none."""
    return next((hint.nudge for hint in hints() if hint.heading == heading), "")
