"""Judges the cases that are handed in beside the parts, as ./check --examples does, by the same
functions. They give points only if parts.json has some for them."""

import json
import re

from bounce_grader.common.errors import KitError
from bounce_grader.common.manifest import Check, example_points, Part, parts
from bounce_grader.common.paths import EXAMPLES, FIXTURES, HANDOUT, ROOT, RUNNER
from bounce_grader.grading.record import failed_part, Record
from bounce_grader.sandbox.box import Box
from bounce_grader.sandbox.processes import Limits
from bounce_grader.submission.submission import CASES

NAME = "wrong_programs.txt"
SOURCE = ROOT / "solution" / "fixtures" / NAME
TABLE = FIXTURES / "public" / NAME
LIMITS = Limits(cpu_seconds=5, wall_seconds=60, memory=1 << 30, file_size=1 << 20, output=1 << 24)


def folders() -> dict[str, str]:
    """The gallery's folder of each wrong program: {"1A": "part1_quadrant_truncated"}."""
    return dict(re.findall(r"(?m)^\[wrong (\S+) (\S+)\]$", SOURCE.read_text("utf-8")))


def judged(cases: bytes, box: Box) -> Record | None:
    """What the record says of them; None if there are none, and no points for them either."""
    is_own = cases.split() not in ([], (HANDOUT / CASES).read_bytes().split())
    if not is_own and not example_points():
        return None
    command = [*box.to_build(RUNNER, [EXAMPLES, TABLE], ()), str(EXAMPLES), str(TABLE)]
    result = box.run(command, LIMITS, stdin=cases if is_own else b"")
    if not result.ok:
        raise KitError(f"the cases in {CASES} could not be judged: {result.err.strip()}")
    return dict(json.loads(result.out))


def part_records(found: Record) -> list[Record]:
    """Where cases give points, a part of the record: each wrong program caught gives its share."""
    most, missed = example_points(), found["missed"]
    if not most:
        return []
    number, caught = len(parts()) + 1, len(found["caught"])
    check = Check(f"part{number}.CasesCatchWrongPrograms", "cases catch all wrong programs", most)
    part = Part(number, f"part{number}_examples", "Cases", "", most, (check,), ())
    made = failed_part(part, "graded", f"{caught} of {caught + len(missed)} are caught")
    made["score"] = made["checks"][0]["score"] = round(most * caught / (caught + len(missed)), 2)
    made["checks"][0]["passed"] = not missed
    made["checks"][0]["message"] = f"not caught: {', '.join(missed)}" if missed else ""
    return [made]
