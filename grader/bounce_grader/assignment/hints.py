"""Finds the heading in the student's hints that belongs to a check."""

import re
from functools import cache

from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import ROOT


@cache
def headings() -> dict[str, str]:
    """Check id -> "1.2 The moment arm r"."""
    heading_of: dict[str, str] = {}
    for part in parts():
        heading = ""
        for line in (ROOT / "student" / "hints" / f"{part.stem}.md").read_text().splitlines():
            if line.startswith("## "):
                heading = line[3:]
            if line.startswith("Checks: "):
                heading_of |= {check: heading for check in re.findall(r"part\d\.\w+", line)}
    return heading_of
