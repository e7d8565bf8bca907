"""PrairieLearn's results.json of an external grader (docs: externalGrading)."""

from typing import Any

from bounce_grader.common.escaping import json_document, printable
from bounce_grader.common.numbers import out_of
from bounce_grader.formats import sentences
from bounce_grader.grading.record import Record


def render(record: Record) -> str:
    lines = [f"{out_of(record)} points", *map(printable, sentences.speed_words(record))]
    result = {
        "gradable": True,
        "score": record["score"] / record["max_score"],
        "message": "\n".join(lines),
        "tests": [_test(*numbered) for numbered in sentences.numbered(record)],
    }
    return json_document(result, indent=1)


def refused(sentence: str) -> str:
    """The report on a submission that can't be read: not gradable, so that it costs no attempt."""
    result = {"gradable": False, "format_errors": [printable(sentence)]}
    return json_document(result, indent=1)


def _test(number: str, part: Record, check: Record) -> dict[str, Any]:
    """A test with its points; PrairieLearn shows points only if every test has them."""
    hint = sentences.hint(part, check)
    return {
        "name": f"{number} {check['title']}",
        "description": f"Part {part['part']}: {part['title']}",
        "points": check["score"],
        "max_points": check["max_score"],
        "output": printable(sentences.check_words(part, check)),
        "message": f"Hint {hint}" if hint else "",
    }
