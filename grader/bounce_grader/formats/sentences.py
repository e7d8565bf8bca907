"""Sentences about a record, for several formats."""

from typing import Any

from bounce_grader.grading import speed
from bounce_grader.grading.report import Report

Part = dict[str, Any]  # of a report, or one of its checks
STATUS_WORDS = {
    "not_submitted": "not submitted",
    "does_not_compile": "does not build",
    "crashed": "crashed",
    "timed_out": "ran out of time",
    "out_of_memory": "ran out of memory",
    "no_answer": "gave no answer",
}


def has_run(part: Part) -> bool:
    return any(check["passed"] or check["message"] for check in part["checks"])


def had_help(part: Part) -> bool:
    """Whether it lost points with given earlier parts, so that mistakes in these cost nothing."""
    return part["graded_with"] == "given" and part["score"] < part["max_score"]


def part_words(part: Part) -> str:
    """One sentence about a part as a whole, and the remarks about it."""
    if part["status"] == "graded":
        remarks = [f"a remark without points: {remark}" for remark in part.get("remarks", [])]
        return "; ".join([part["message"], *remarks])
    return f"{STATUS_WORDS.get(part['status'], part['status'])}: {part['message']}"


def check_words(part: Part, check: Part) -> str:
    """A check's message, or why its part never ran. The first failed check begins with the part's
    known mistakes, for formats that have no other place for them; the first of a part with all
    points has the remarks."""
    message = check["message"] or ("" if check["passed"] else part_words(part))
    first_failed = next((one for one in part["checks"] if not one["passed"]), None)
    if not first_failed and check is part["checks"][0]:
        return "\n".join(part.get("remarks", []))
    mistakes = mistake_words(part) if check is first_failed else []
    return "\n".join(filter(None, [*mistakes, message]))


def mistake_words(part: Part) -> list[str]:
    """A line for each known mistake that the part makes; if there is none, its patterns."""
    lines = [
        f"Looks like: {mistake['title']}. {mistake['sentence']} See {mistake['where']}."
        for mistake in part["mistakes"]
    ]
    return lines or list(part["patterns"])


def speed_words(record: Report) -> list[str]:
    """Why the submission wasn't timed, if different answers are the reason."""
    measured = record.get("speed") or {}
    return speed.sentences(measured) if "otherwise" in measured else []


def about_cases(record: Report) -> list[str]:
    """What the cases are worth that were handed in, a line each; empty if none were."""
    found = record.get("examples")
    if not found:
        return []
    cases, caught, missed = found["cases"], found["caught"], found["missed"]
    not_yet = f"; not caught yet: {', '.join(missed)}" if missed else ""
    return [
        f"Cases: {sum(case['right'] for case in cases)} of {len(cases)} are right; they catch "
        f"{len(caught)} of {len(caught) + len(missed)} buggy programs{not_yet}",
        *(f"{case['place']}: {case['message']}" for case in cases if not case["right"]),
    ]


def numbered(record: Report) -> list[tuple[str, Part, Part]]:
    """Each check with its number and part, as ("2.3", part, check)."""
    return [
        (f"{part['part']}.{number}", part, check)
        for part in record["parts"]
        for number, check in enumerate(part["checks"], 1)
    ]


def first_to_do(record: Report) -> str:
    """What to look at first: the earliest part that lost points, and its first failed check."""
    for number, part, check in numbered(record):
        if not check["passed"]:
            if not has_run(part):
                return f"First: part {part['part']}, {part_words(part)}"
            advice = check["hint"]["heading"]
            return f"First: {number} {check['title']}" + (f"; hint {advice}" if advice else "")
    return ""
