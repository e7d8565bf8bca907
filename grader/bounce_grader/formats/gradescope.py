"""Gradescope's results.json (gradescope-autograders.readthedocs.io/en/latest/specs/)."""

from typing import Any

from bounce_grader.common.escaping import json_document, printable
from bounce_grader.common.numbers import out_of, scientific
from bounce_grader.formats import sentences
from bounce_grader.grading.report import Report

EXTRA = ("kit", "box", "fixtures_sha256", "submission_sha256")  # of the record
TEXT = {"output_format": "text", "stdout_visibility": "hidden"}


def render(record: Report) -> str:
    """The report. It has no score at the top level, which would override the sum of the tests."""
    lines = []
    for part in record["parts"]:
        words = printable(sentences.part_words(part))
        lines.append(f"Part {part['part']}, {part['title']}: {out_of(part)}. {words}")
    result: dict[str, Any] = {
        "execution_time": record["seconds"]["total"],
        "output": "\n".join([*lines, *map(printable, sentences.speed_words(record))]),
        **TEXT,
        "test_output_format": "text",
        "test_name_format": "text",
        "visibility": "visible",
        "tests": [_test(*numbered) for numbered in sentences.numbered(record)],
        "leaderboard": _leaderboard(record),
        "extra_data": {name: record[name] for name in EXTRA},
    }
    return json_document(result, indent=1)


def refused(sentence: str) -> str:
    """The report on a submission that can't be read. Its score is 0, because Gradescope takes a
    result without a score for a failure of the autograder; the student can submit again."""
    return json_document({"score": 0, "output": printable(sentence), **TEXT, "tests": []}, indent=1)


def _test(number: str, part: sentences.Part, check: sentences.Part) -> dict[str, Any]:
    words, hint = printable(sentences.check_words(part, check)), check["hint"]["heading"]
    return {
        "number": number,
        "name": check["title"],
        "score": check["score"],
        "max_score": check["max_score"],
        "status": "passed" if check["passed"] else "failed",
        "output": f"{words}\nhint {hint}" if hint else words,
        "tags": [part["stem"]],
        "visibility": "visible",
    }


def _leaderboard(record: Report) -> list[dict[str, Any]]:
    """Speed and error count only with full points: a program that returns zeros is fastest."""
    rows: list[dict[str, Any]] = [{"name": "Points", "value": record["score"]}]
    right = record["score"] == record["max_score"]
    speed = (record.get("speed") or {}) if right else {}
    if (ratio := speed.get("ratio")) is not None:
        rows.append({"name": "Time over the solution's", "value": round(ratio, 2), "order": "asc"})
    if (error := speed.get("largest_error")) is not None:
        value = float(scientific(error))
        rows.append({"name": "Largest error", "value": value, "order": "asc"})
    return rows
