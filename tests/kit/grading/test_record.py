"""The record is valid JSON in UTF-8, printable and of bounded length, whatever a submission
does."""

import json
from typing import Any

from bounce_grader.common.escaping import LONGEST_NAME, LONGEST_TEXT
from bounce_grader.common.manifest import parts
from bounce_grader.grading import record
from bounce_grader.grading.judging import Judged, Verdict
from bounce_grader.grading.record import LONGEST_SENTENCE
from bounce_grader.submission.submission import Submission
from hypothesis import given
from hypothesis import strategies as st
from odd_texts import TEXTS

PART = parts()[0]
LONG = st.builds(lambda text, times: text * times, TEXTS, st.sampled_from([1, 1, 1, 5000]))


def judged(message: str, status: str) -> Judged:
    return Judged({check.id: Verdict(False, status, message) for check in PART.checks}, 0.5, "own")


def written(part: dict[str, Any], names: tuple[str, ...]) -> dict[str, Any]:
    """Writes a record as ./kit grade --json does, and reads it with a strict reader."""
    submission = Submission("x", {}, {}, {}, names)
    whole = record.whole(submission, [part], "full", {"run": 1.0}, "", None)
    data = json.dumps(whole, ensure_ascii=False, allow_nan=False).encode("utf-8")
    read: dict[str, Any] = json.loads(data.decode("utf-8"))
    assert read == whole
    return read


def check_texts(whole: dict[str, Any]) -> None:
    part = whole["parts"][0]
    assert part["message"].isprintable() and len(part["message"]) <= LONGEST_SENTENCE
    for check in part["checks"]:
        assert len(check["message"]) <= LONGEST_TEXT
        assert check["message"].replace("\n", "").isprintable()
    assert all(name.isprintable() and len(name) <= LONGEST_NAME for name in whole["ignored"])


@given(LONG, st.lists(LONG, max_size=3), st.sampled_from(["graded", "crashed"]))
def test_whatever_a_program_says_the_record_stays_json(
    message: str, names: list[str], status: str
) -> None:
    check_texts(written(record.part_record(PART, judged(message, status)), tuple(names)))


@given(LONG)
def test_whatever_a_compiler_says_the_record_stays_json(message: str) -> None:
    check_texts(written(record.failed_part(PART, "does_not_compile", message), ()))


def test_how_a_program_ended_is_the_parts_message() -> None:
    message = "1 of 1 cases wrong; the first: x\n  got      the program crashed"
    assert record.part_record(PART, judged(message, "crashed"))["message"] == "the program crashed"


def test_one_exception_is_told_once() -> None:
    """The other checks that fail by it refer to the first; another exception is told by itself."""
    thrown: dict[str, Any] = {
        "name": "x",
        "input": "in",
        "sentence": "the program threw x",
        "quantities": [],
    }
    text = "2 of 9 cases wrong; the first: x\nin\n  got the program threw x"
    verdicts = {c.id: Verdict(False, "graded", text, thrown) for c in PART.checks}
    last = PART.checks[-1]
    other = {**thrown, "sentence": "the program threw y"}
    verdicts[last.id] = Verdict(False, "graded", text, other)
    checks = record.part_record(PART, Judged(verdicts, None, "own"))["checks"]
    assert checks[0]["message"] == text and checks[0]["shown"] == thrown
    again = f'2 of 9 cases wrong, as in "{PART.checks[0].title}": the program threw x'
    assert all(c["message"] == again and "shown" not in c for c in checks[1:-1])
    assert checks[-1]["message"] == text and checks[-1]["shown"] == other


def test_one_crash_is_told_once() -> None:
    """With what was answered before it; a crash in another line is told by itself."""

    def crash(case: int, line: int) -> Verdict:
        ended = f"ended at case {case} of 9; the last: x\nin"
        return Verdict(False, "crashed", f"{ended}\n  got      out of range, at a.cpp:{line}")

    verdicts = {check.id: crash(n, 7) for n, check in enumerate(PART.checks, 1)}
    verdicts[PART.checks[-1].id] = crash(9, 8)
    checks = record.part_record(PART, Judged(verdicts, None, "own"))["checks"]
    first = f'as in "{PART.checks[0].title}": out of range, at a.cpp:7'
    assert checks[0]["message"].endswith("the last: x\nin\n  got      out of range, at a.cpp:7")
    assert checks[1]["message"] == f"ended at case 2 of 9, {first}"
    assert checks[-1]["message"].endswith("at a.cpp:8") and "as in" not in checks[-1]["message"]
