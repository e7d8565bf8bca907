"""Sentences and places in a record that several formats use."""

import re
from typing import NamedTuple

from bounce_grader.grading.record import Record

STATUS_WORDS = {
    "graded": "graded",
    "not_submitted": "not submitted",
    "does_not_compile": "does not compile",
    "crashed": "crashed",
    "timed_out": "ran out of time",
    "out_of_memory": "ran out of memory",
    "no_answer": "gave no answer",
}
PLACE = re.compile(r"([\w./-]+\.(?:cpp|cc|cxx|hpp|hh|hxx|h|ipp|inl)):(\d+)(?::(\d+))?")


class Place(NamedTuple):
    """Where in the submission a fault is."""

    file: str
    line: int
    column: int | None


def place_in(message: str) -> Place | None:
    found = PLACE.search(message)
    if not found:
        return None
    file, line, column = found.groups()
    return Place(file, int(line), int(column) if column else None)


def points(x: float) -> str:
    return f"{x:g}"


def of_points(record: Record) -> str:
    return f"{points(record['score'])} / {points(record['max_score'])}"


def part_words(part: Record) -> str:
    """What there is to say of a part as a whole, in one sentence."""
    if part["status"] == "graded":
        return str(part["message"])
    return f"{STATUS_WORDS.get(part['status'], part['status'])}: {part['message']}"


def check_words(part: Record, check: Record) -> str:
    """What there is to say of a check: of a part that never ran, why it didn't. What is known of the
    part's mistakes is said with the first check that fails, for formats that have no place for it
    but there."""
    said = check["message"] or ("" if check["passed"] else part_words(part))
    first = next((c for c in part["checks"] if not c["passed"]), None)
    known = mistake_words(part) if check is first else []
    return "\n".join(filter(None, [*known, said]))


def mistake_words(part: Record) -> list[str]:
    """A line for each known mistake that the part makes; else for what its numbers say."""
    return [mistake_line(m) for m in part["mistakes"]] or list(part["patterns"])


def mistake_line(mistake: Record) -> str:
    return f"Looks like: {mistake['title']}. {mistake['sentence']} See {where_to_read(mistake)}."


def where_to_read(mistake: Record) -> str:
    """eq. (6) and hint 1.2 The moment arm r"""
    numbers = ", ".join(f"({number})" for number in mistake["equations"])
    return f"eq{'s' * (len(mistake['equations']) > 1)}. {numbers} and hint {mistake['hint']}"


def speed_words(record: Record) -> list[str]:
    """Why the submission has no time beside the solution's, where its answers are the reason."""
    from bounce_grader.grading import speed

    found = record.get("speed") or {}
    return speed.sentences(found) if "otherwise" in found else []


def numbered(record: Record) -> list[tuple[str, Record, Record]]:
    """("2.3", part, check) for each check."""
    return [
        (f"{part['part']}.{number}", part, check)
        for part in record["parts"]
        for number, check in enumerate(part["checks"], 1)
    ]


def hint(check: Record) -> str:
    from bounce_grader.assignment.hints import headings

    return headings().get(check["id"], "")
