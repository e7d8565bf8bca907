"""The feedback page for a student."""

from collections.abc import Sequence
from typing import NamedTuple

from bounce_grader.common import numbers
from bounce_grader.formats import case, figures, sentences
from bounce_grader.formats.templates import fill
from bounce_grader.grading import hints, speed
from bounce_grader.grading.record import Record

MOST_UNUSED = 20  # names of unused files on a page
TITLE = "Bouncing: "  # every page's title begins with it
PAGE = "formats/feedback.html.j2"


class InTheEnd(NamedTuple):
    """What a person gets in the end, where that isn't the score."""

    who: str  # "" if the submission is one person's
    points: float
    changes: list[tuple[float, str, str]]  # points, reason, comment


def render(
    record: Record,
    name: str = "",
    unused: tuple[str, ...] = (),
    in_the_end: Sequence[InTheEnd] = (),
) -> str:
    measured = record.get("speed") or {}
    return fill(
        PAGE,
        title=f"{TITLE}your points",
        record=record,
        name=name,
        share=f"{100 * record['score'] / record['max_score']:.1f}",
        speed=measured if measured.get("scenes") or "otherwise" in measured else None,
        speed_sentences=" ".join(speed.sentences(measured)),
        unused=_unused(record, unused),
        in_the_end=in_the_end,
        case=case,
        chart_style=figures.STYLE,
        figures=figures,
        hints=hints,
        numbers=numbers,
        sentences=sentences,
    )


def refused(sentence: str) -> str:
    """The page about a submission that can't be read."""
    return fill(PAGE, title=f"{TITLE}not graded", refusal=sentence)


def _unused(record: Record, unused: tuple[str, ...]) -> list[str]:
    files = [*unused, *(f"{file} wasn't used" for file in record["ignored"])]
    rest = max(0, len(files) - MOST_UNUSED) + record.get("ignored_more", 0)
    return [*files[:MOST_UNUSED], *([f"and {rest} more"] if rest else [])]
