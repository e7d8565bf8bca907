"""The feedback page for a student, and templates of pages."""

from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

from markupsafe import Markup

from bounce_grader.common import escaping, numbers
from bounce_grader.formats import sentences, speed_chart
from bounce_grader.grading import speed
from bounce_grader.grading.report import Report

MOST_UNUSED = 20  # names of unused files on a page
TITLE = "Bouncing: "  # every page's title begins with it
PAGE = "formats/feedback.html.j2"
PACKAGE = Path(__file__).resolve().parents[1]


def render(
    record: Report,
    name: str = "",
    unused: Sequence[str] = (),
    final: Any = None,
    comments: Sequence[Any] = (),
    note: str = "",
) -> str:
    """The page of a person or a group. `final` has the points that count, where that isn't the score,
    and what was applied; `comments` are an instructor's, with lines of the code."""
    measured = record.get("speed") or {}
    return fill(
        PAGE,
        title=f"{TITLE}your points",
        record=record,
        name=name,
        speed=measured if measured.get("scenes") or "otherwise" in measured else None,
        speed_sentences=" ".join(speed.sentences(measured)),
        unused=_unused(record, unused),
        final=final,
        counts=round(final.points, 2) if final else record["score"],
        comments=comments,
        note=note,
    )


def refused(sentence: str) -> str:
    """The page about a submission that can't be read."""
    return fill(PAGE, title=f"{TITLE}not graded", refusal=sentence)


def _unused(record: Report, unused: Sequence[str]) -> list[str]:
    files = [*unused, *(f"{file} wasn't used" for file in record["ignored"])]
    rest = max(0, len(files) - MOST_UNUSED) + record.get("ignored_more", 0)
    return [*files[:MOST_UNUSED], *([f"and {rest} more"] if rest else [])]


def fill(template: str, **values: Any) -> str:
    """Fills the template at a path in this package. Raises UndefinedError for a missing value."""
    return str(_environment().get_template(template).render(values))


@cache
def _environment() -> Any:
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    made = Environment(
        loader=FileSystemLoader(PACKAGE),
        autoescape=True,
        finalize=_escaped,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    made.globals.update(numbers=numbers, sentences=sentences, speed_chart=speed_chart)
    return made


def _escaped(value: Any) -> Any:
    """Escapes each printed value; Jinja's own escaping would leave control characters and commands
    to CI in it. Drawings and markup of macros have __html__, and stay as they are."""
    return value if hasattr(value, "__html__") else Markup(escaping.html(str(value)))
