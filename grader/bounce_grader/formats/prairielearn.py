"""PrairieLearn's results.json of an external grader (docs: externalGrading)."""

from typing import Any

from bounce_grader.escape import json_document, plain
from bounce_grader.formats import words
from bounce_grader.record import Record


def render(record: Record) -> str:
    result = {
        "gradable": True,
        "score": record["score"] / record["max_score"],
        "message": "\n".join(
            [f"{words.of_points(record)} points", *map(plain, words.speed_words(record))]
        ),
        "tests": [_test(*numbered) for numbered in words.numbered(record)],
    }
    return json_document(result, indent=1)


def refused(sentence: str) -> str:
    """Not gradable: PrairieLearn takes no attempt away."""
    result = {"gradable": False, "format_errors": [plain(sentence)]}
    return json_document(result, indent=1)


def _test(number: str, part: Record, check: Record) -> dict[str, Any]:
    """Every test has its points, or PrairieLearn shows none."""
    return {
        "name": f"{number} {check['title']}",
        "description": f"Part {part['part']}: {part['title']}",
        "points": check["score"],
        "max_points": check["max_score"],
        "output": plain(words.check_words(part, check)),
        "message": f"Hint {words.hint(check)}" if not check["passed"] and words.hint(check) else "",
    }
