"""Builds and runs a part again with AddressSanitizer and UBSan: one that crashed, as they report the
first wrong memory access, not the last; or one with all points, whose right numbers may be luck.
This never changes the score."""

from pathlib import Path

from bounce_grader.build import linking
from bounce_grader.common.errors import KitError
from bounce_grader.common.manifest import Part
from bounce_grader.grading import judging, words
from bounce_grader.grading.judging import Judged
from bounce_grader.grading.words import Verdict
from bounce_grader.sandbox.box import Box
from bounce_grader.sandbox.budget import Budget, Overrun
from bounce_grader.submission.submission import Place, Submission

CPU_SECONDS, WALL_SECONDS = 20.0, 80.0  # for one part
MARGIN = 5.0  # s, to stop it


def with_cause(
    part: Part, judged: Judged, taken: Submission, work: Path, hidden: Path, box: Box
) -> Judged:
    """The same verdicts; those about crashes also say what the sanitizers found, if anything."""
    if not any(map(_is_unclear, judged.verdicts.values())):
        return judged
    again = _again(part, taken, work, hidden, box)
    if not again:
        return judged
    verdicts = {id: _with_finding(v, again.verdicts[id]) for id, v in judged.verdicts.items()}
    return judged._replace(verdicts=verdicts)


def remark(part: Part, taken: Submission, work: Path, box: Box) -> tuple[str, Place | None] | None:
    """What the sanitizers find in a part with all points, in the public cases, and where; None if
    nothing."""
    again = _again(part, taken, work, None, box)
    verdicts = again.verdicts if again else {}
    for verdict in verdicts.values():
        if verdict.is_of_sanitizer and verdict.ended:
            return f"{verdict.place or part.file}: {words.ending(verdict.ended)}", verdict.place
    for check in part.checks if again else []:
        verdict = verdicts[check.id]
        answered = verdict.status == "graded" and (verdict.failure or {}).get("quantities")
        if not verdict.passed and answered:
            sentence = (
                f'{part.file}: built with g++ and its sanitizers, it fails "{check.title}": does '
                "it use a value that was never set, or that is gone?"
            )
            return sentence, None
    return None


def _again(
    part: Part, taken: Submission, work: Path, hidden: Path | None, box: Box
) -> Judged | None:
    """Judged with sanitizers and given parts, on the public cases alone where no folder of hidden
    ones is given. None where that can't be done: the score is valid without it."""
    if box.kind != "full":
        return None
    cpu, wall = box.budget.left()
    cpu, wall = min(cpu - MARGIN, CPU_SECONDS), min(wall - MARGIN, WALL_SECONDS)
    box = box._replace(budget=Budget(cpu, wall, part_of=box.budget))
    files = frozenset(taken.files)
    try:
        built = linking.link_sanitized(part, taken, work, box)
        if not built.path:
            return None
        given = bool(part.calls)
        return judging.judge(part, built.path, given, hidden, box, sanitized=True, files=files)
    except (KitError, Overrun):
        return None


def _is_unclear(verdict: Verdict) -> bool:
    """Whether it is a crash that no assertion explains."""
    return verdict.status == "crashed" and not verdict.is_of_assertion


def _with_finding(verdict: Verdict, again: Verdict) -> Verdict:
    if not _is_unclear(verdict) or not again.is_of_sanitizer:
        return verdict
    return verdict._replace(found=again.end)
