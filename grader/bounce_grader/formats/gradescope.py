"""Gradescope's results.json (gradescope-autograders.readthedocs.io/en/latest/specs/)."""

from typing import Any

from bounce_grader.common.escaping import json_document, printable
from bounce_grader.formats import sentences
from bounce_grader.grading.record import Record


def render(record: Record) -> str:
    """No score at the top: it would override the sum of the tests."""
    result: dict[str, Any] = {
        "execution_time": record["seconds"]["total"],
        "output": _summary(record),
        "output_format": "text",
        "test_output_format": "text",
        "test_name_format": "text",
        "visibility": "visible",
        "stdout_visibility": "hidden",
        "tests": [_test(*numbered) for numbered in sentences.numbered(record)],
        "leaderboard": _leaderboard(record),
        "extra_data": {
            name: record[name] for name in ("kit", "box", "fixtures_sha256", "submission_sha256")
        },
    }
    return json_document(result, indent=1)


def refused(sentence: str) -> str:
    """A submission that can't be read: nothing was graded, and the student can hand in again.
    Gradescope takes a result without a score for a failure of the autograder."""
    result: dict[str, Any] = {"score": 0, "output": printable(sentence), "output_format": "text"}
    result["tests"] = []
    return json_document({**result, "stdout_visibility": "hidden"}, indent=1)


def _summary(record: Record) -> str:
    lines = [
        f"Part {part['part']}, {part['title']}: {sentences.points(part['score'])} / "
        f"{sentences.points(part['max_score'])}. {printable(sentences.part_words(part))}"
        for part in record["parts"]
    ]
    return "\n".join([*lines, *map(printable, sentences.speed_words(record))])


def _test(number: str, part: Record, check: Record) -> dict[str, Any]:
    said = printable(sentences.check_words(part, check))
    hint = sentences.hint(check)
    if hint and not check["passed"]:
        said += f"\nhint {hint}"
    return {
        "number": number,
        "name": check["title"],
        "score": check["score"],
        "max_score": check["max_score"],
        "status": "passed" if check["passed"] else "failed",
        "output": said,
        "tags": [part["stem"]],
        "visibility": "visible",
    }


def _leaderboard(record: Record) -> list[dict[str, Any]]:
    """Speed and error are those of right answers: returning zeros is quicker than any."""
    rows: list[dict[str, Any]] = [{"name": "Points", "value": record["score"]}]
    right = record["score"] == record["max_score"]
    speed = (record.get("speed") or {}) if right else {}
    if speed.get("ratio") is not None:
        ratio = round(speed["ratio"], 2)
        rows.append({"name": "Time over the solution's", "value": ratio, "order": "asc"})
    if speed.get("largest_error") is not None:
        error = float(f"{speed['largest_error']:.1e}")
        rows.append({"name": "Largest error", "value": error, "order": "asc"})
    return rows
