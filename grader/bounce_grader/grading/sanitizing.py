"""Builds and runs a part again with AddressSanitizer and UBSan: one that crashed, as they report the
first wrong memory access, not the last; or one with all points, whose right numbers may be luck.
This never changes the score."""

from contextlib import suppress
from pathlib import Path

from bounce_grader.build import linking
from bounce_grader.common.errors import KitError
from bounce_grader.common.manifest import Part
from bounce_grader.grading import judging, words
from bounce_grader.grading.judging import Judged
from bounce_grader.grading.words import Verdict
from bounce_grader.sandbox.box import Box
from bounce_grader.sandbox.budget import Overrun
from bounce_grader.submission.submission import Place, Submission

CPU_SECONDS, WALL_SECONDS = 20.0, 80.0  # for one part
MARGIN = 5.0  # s, to stop it
FOUND = "found"  # the kind of an end by a fault that the sanitizers name, and we know


def with_cause(
    part: Part, judged: Judged, taken: Submission, work: Path, hidden: Path, box: Box
) -> Judged:
    """The same verdicts; those about crashes that no assertion explains also say what the
    sanitizers found, if anything."""
    unclear = {
        id: verdict
        for id, verdict in judged.verdicts.items()
        if verdict.status == "crashed" and verdict.kind_of_end != "assertion"
    }
    again = _again(part, taken, work, hidden, box) if unclear else {}
    found = {
        id: verdict._replace(found=again[id].end)
        for id, verdict in unclear.items()
        if again and again[id].kind_of_end == FOUND
    }
    return judged._replace(verdicts=judged.verdicts | found)


def remark(part: Part, taken: Submission, work: Path, box: Box) -> tuple[str, Place | None] | None:
    """What the sanitizers find in a part with all points, in the public cases, and where; None if
    nothing."""
    again = _again(part, taken, work, None, box)
    for verdict in again.values():
        if verdict.kind_of_end == FOUND and verdict.ended:
            return f"{verdict.place or part.file}: {words.ending(verdict.ended)}", verdict.place
    for check, verdict in zip(part.checks, again.values()):
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
) -> dict[str, Verdict]:
    """The verdicts with sanitizers and given parts, on the public cases alone where no folder of
    hidden ones is given. Empty where that can't be done: the score is valid without them."""
    cpu, wall = (left - MARGIN for left in box.budget.left())
    limited = box.budget.part(min(cpu, CPU_SECONDS), min(wall, WALL_SECONDS))
    box = box._replace(budget=limited)
    with suppress(KitError, Overrun):
        built = linking.link_sanitized(part, taken, work, box) if box.kind == "full" else None
        if built and built.path:
            return judging.judge(
                part, built.path, taken.files, box, hidden, sanitized=True
            ).verdicts
    return {}
