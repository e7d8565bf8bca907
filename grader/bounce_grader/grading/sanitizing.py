"""Builds and runs a part that crashed again, with AddressSanitizer and UBSan, which report the
first wrong memory access, not the last. This explains the crash and never changes the score."""

import re
from pathlib import Path

from bounce_grader.build import linking
from bounce_grader.common.errors import KitError
from bounce_grader.common.manifest import Part
from bounce_grader.grading import judging
from bounce_grader.grading.judging import Judged, Verdict
from bounce_grader.sandbox.box import Box
from bounce_grader.sandbox.budget import Budget, Overrun
from bounce_grader.submission.submission import Submission

CPU_SECONDS, WALL_SECONDS = 20.0, 40.0  # for the explanation of one part
MARGIN = 5.0  # s, to stop it


def with_cause(
    part: Part, judged: Judged, taken: Submission, work: Path, hidden: Path, box: Box
) -> Judged:
    """The same verdicts; those about crashes also say what the sanitizers found, if anything."""
    if box.kind != "full" or not any(map(_is_unclear, judged.verdicts.values())):
        return judged
    cpu, wall = box.budget.left()
    cpu, wall = min(cpu - MARGIN, CPU_SECONDS), min(wall - MARGIN, WALL_SECONDS)
    box = box._replace(budget=Budget(cpu, wall, part_of=box.budget))
    try:
        built = linking.link_sanitized(part, taken, work, box)
        if not built.path:
            return judged
        given = bool(part.calls)
        again = judging.judge(part, built.path, given, hidden, box, sanitized=True)
    except (KitError, Overrun):  # the score is valid without the explanation
        return judged
    verdicts = {id: _with_finding(v, again.verdicts[id]) for id, v in judged.verdicts.items()}
    return judged._replace(verdicts=verdicts)


def _is_unclear(verdict: Verdict) -> bool:
    """Whether it is a crash that no assertion explains."""
    return verdict.status == "crashed" and "assertion" not in verdict.message


def _with_finding(verdict: Verdict, again: Verdict) -> Verdict:
    finding = re.search(r"^  got      (.*)$", again.message, re.MULTILINE)
    if not _is_unclear(verdict) or again.status != "crashed" or not finding:
        return verdict
    if finding.group(1).startswith("the program"):  # the sanitizers found nothing
        return verdict
    return verdict._replace(message=f"{verdict.message}\n  checked  {finding.group(1)}")
