"""Judges the cases that are handed in beside the parts, as ./check --examples does, by the same
functions. They give points only if parts.json has some for them."""

import json
import re
from collections.abc import Iterator, Sequence

from bounce_grader.common.errors import KitError
from bounce_grader.common.manifest import Check, example_points, Part, parts
from bounce_grader.common.paths import EXAMPLES, FIXTURES, HANDOUT, ROOT, RUNNER
from bounce_grader.grading.judging import fact, Facts
from bounce_grader.grading.record import failed_part, Record
from bounce_grader.sandbox.box import Box
from bounce_grader.sandbox.budget import Overrun
from bounce_grader.sandbox.processes import Limits
from bounce_grader.submission.submission import CASES

NAME = "wrong_programs.txt"
SOURCE = ROOT / "solution" / "fixtures" / NAME
TABLE = FIXTURES / "public" / NAME
LIMITS = Limits(cpu_seconds=5, wall_seconds=60, memory=1 << 30, file_size=1 << 20, output=1 << 24)


def folders() -> dict[str, str]:
    """The gallery's folder of each buggy program: {"1A": "part1_quadrant_truncated"}."""
    return dict(re.findall(r"(?m)^\[wrong (\S+) (\S+)\]$", SOURCE.read_text("utf-8")))


def judged(cases: bytes, box: Box) -> tuple[Record | None, list[Record]]:
    """What the record says of them, None if there are none; and, where they give points, the part
    of the record. If the grading is out of time, they catch nothing."""
    is_own = cases.split() not in ([], (HANDOUT / CASES).read_bytes().split())
    if not is_own and not example_points():
        return None, []
    try:
        found = _judged(cases if is_own else b"", box)
    except Overrun as overrun:
        return None, _part_records(0.0, fact("no_time", str(overrun)))
    caught, missed = len(found["caught"]), found["missed"]
    every = caught + len(missed)
    why = fact("cases_caught", str(caught), str(every))
    return found, _part_records(caught / every, why, missed)


def wrong_in(text: str) -> Iterator[str]:
    """What is wrong with the cases in a text of the kit's own: a sentence each, with its line."""
    lines = (line if re.match(r"part \d: .*->", line) else "" for line in text.splitlines())
    for case in _judged("\n".join(lines).encode(), Box("none"))["cases"]:
        if not case["right"]:
            yield f"{case['place']}: {case['message']}"


def _judged(cases: bytes, box: Box) -> Record:
    command = [*box.to_build(RUNNER, [EXAMPLES, TABLE], ()), str(EXAMPLES), str(TABLE)]
    result = box.run(command, LIMITS, stdin=cases)
    if not result.ok:
        raise KitError(f"the cases in {CASES} could not be judged: {result.err.strip()}")
    return dict(json.loads(result.out))


def _part_records(share: float, why: Facts, missed: Sequence[str] = ()) -> list[Record]:
    """The part of the record in which each buggy program that is caught gives its share; none if they
    give no points."""
    most, number = example_points(), len(parts()) + 1
    if not most:
        return []
    check = Check(f"part{number}.CasesCatchWrongPrograms", "cases catch all buggy programs", most)
    part = Part(number, f"part{number}_examples", "Cases", "", most, (check,), ())
    made = failed_part(part, "graded", why)
    made["notes"] = [fact("cases_missed", ", ".join(missed))] if missed else []
    made["score"] = made["checks"][0]["score"] = round(most * share, 2)
    made["checks"][0]["passed"] = share == 1
    return [made]
