"""The last two lines of output that Autolab reads: feedback by stages, and scores by problem. The
assessment's problems have the names of the parts, part1_contacts to part4_simulate."""

from typing import Any

from bounce_grader.common.escaping import json_document, printable
from bounce_grader.formats import sentences
from bounce_grader.grading.record import Record


def render(record: Record) -> str:
    scores = {part["stem"]: part["score"] for part in record["parts"]}
    ratio = (record.get("speed") or {}).get("ratio")
    board = [record["score"], *([round(ratio, 2)] if ratio is not None else [])]
    result = {"scores": scores, "scoreboard": board}
    # Autolab reads lines: json_document writes a line end within a text as \\n.
    return f"{json_document(_presentation(record))}\n{json_document(result)}"


def _presentation(record: Record) -> dict[str, Any]:
    stages = [f"Part {part['part']}: {part['title']}" for part in record["parts"]]
    tests: dict[str, dict[str, Any]] = {
        stage: {check["title"]: _test(part, check) for check in part["checks"]}
        for stage, part in zip(stages, record["parts"])
    }
    for stage, part in zip(stages, record["parts"]):
        if part.get("remarks"):
            hint = printable("\n".join(part["remarks"]))
            tests[stage]["A remark without points"] = {"passed": False, "hint": hint}
    for sentence in sentences.speed_words(record):
        stages.append("Speed")
        tests["Speed"] = {"Measured": {"passed": False, "hint": printable(sentence)}}
    return {"_presentation": "semantic", "stages": stages, **tests}


def _test(part: Record, check: Record) -> dict[str, Any]:
    if check["passed"]:
        return {"passed": True}
    return {"passed": False, "hint": printable(sentences.check_words(part, check))}
