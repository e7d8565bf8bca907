"""Finds a check's heading in the student's hints, and the first stage below it."""

import re
from functools import cache

from bounce_grader.common.manifest import parts, Part
from bounce_grader.common.paths import ROOT


@cache
def headings() -> dict[str, str]:
    """Check id -> "1.2 The moment arm r"."""
    heading_of: dict[str, str] = {}
    for part in parts():
        heading = ""
        for line in _text(part).splitlines():
            if line.startswith("## "):
                heading = line[3:]
            if line.startswith("Checks: "):
                heading_of |= {check: heading for check in re.findall(r"part\d\.\w+", line)}
    return heading_of


def diagnosed(part: int, diagnosis: str) -> str:
    """The heading of the hint for what the patterns of a part's wrong numbers say: that of the words
    which come first; empty if there is none."""
    found = {diagnosis.find(words): to for words, to in _words() if to.startswith(f"{part}.")}
    return found[min(found.keys() - {-1})] if found.keys() - {-1} else ""


@cache
def _words() -> list[tuple[str, str]]:
    """What a diagnosis says, and the heading of its hint."""
    words: list[tuple[str, str]] = []
    for part in parts():
        heading = ""
        for line in _text(part).splitlines():
            if line.startswith("## "):
                heading = line[3:]
            if line.startswith("Diagnoses: "):
                words += [(said, heading) for said in line.partition(": ")[2].split("; ")]
    return words


@cache
def nudges() -> dict[str, str]:
    """Heading -> the hint's first stage, a paragraph of plain text."""
    stage = re.compile(r"^## (.+)\n(?:(?!## ).*\n)*?### A nudge\n\n(.+)\n", re.MULTILINE)
    found = (match for part in parts() for match in stage.findall(_text(part)))
    return {heading: text.replace("`", "") for heading, text in found}


def _text(part: Part) -> str:
    return (ROOT / "student" / "hints" / f"{part.stem}.md").read_text()
