"""Judges the cases that are handed in beside the parts, as ./check --examples does, with the same
program. They give no points."""

import json
import re

from bounce_grader.common.errors import KitError
from bounce_grader.common.paths import EXAMPLES, FIXTURES, HANDOUT, ROOT, RUNNER
from bounce_grader.grading.record import Record
from bounce_grader.sandbox.box import Box
from bounce_grader.sandbox.processes import Limits
from bounce_grader.submission.submission import CASES

NAME = "wrong_programs.txt"
SOURCE = ROOT / "solution" / "fixtures" / NAME
TABLE = FIXTURES / "public" / NAME
LIMITS = Limits(cpu_seconds=5, wall_seconds=60, memory=1 << 30, file_size=1 << 20, output=1 << 24)


def folders() -> dict[str, str]:
    """The gallery's folder of each wrong program: {"1A": "part1_quadrant_truncated"}."""
    return dict(re.findall(r"(?m)^wrong (\S+) (\S+)$", SOURCE.read_text("utf-8")))


def judged(cases: bytes, box: Box) -> Record | None:
    """What the record says of them; None if there are none, or those as handed out."""
    if cases.split() in ([], (HANDOUT / CASES).read_bytes().split()):
        return None
    command = [*box.to_build(RUNNER, [EXAMPLES, TABLE], ()), str(EXAMPLES), "-", str(TABLE)]
    result = box.run(command, LIMITS, stdin=cases)
    if not result.ok:
        raise KitError(f"the cases in {CASES} could not be judged: {result.err.strip()}")
    found: Record = json.loads(result.out)
    return found
