"""The record is valid JSON in UTF-8, printable and of bounded length, whatever a submission does,
and tells one exception or crash once."""

import json
from typing import Any

from bounce_grader.common.escaping import LONGEST_NAME, LONGEST_TEXT
from bounce_grader.common.manifest import parts
from bounce_grader.grading import record
from bounce_grader.grading.judging import Judged, Verdict
from bounce_grader.submission.submission import Submission
from hypothesis import given
from hypothesis import strategies as st
from odd_texts import TEXTS

PART = parts()[0]
IDS = [check.id for check in PART.checks]
LONG = st.builds(lambda text, times: text * times, TEXTS, st.sampled_from([1, 1, 1, 5000]))


def judged(*verdicts: Verdict) -> list[dict[str, Any]]:
    part = record.part_record(PART, Judged(dict(zip(IDS, verdicts)), None, "own"))
    return list(part["checks"])


@given(LONG, st.lists(LONG, max_size=3), st.sampled_from(["graded", "crashed", ""]))
def test_whatever_is_said_the_record_stays_json(text: str, names: list[str], status: str) -> None:
    """By a program, or by a compiler; and whatever files are called."""
    verdicts = {id: Verdict(False, status, text) for id in IDS}
    part = record.failed_part(PART, "does_not_compile", text)
    if status:
        part = record.part_record(PART, Judged(verdicts, 0.5, "own"))
    taken = Submission("x", {}, {}, {}, tuple(names))
    whole = record.whole(taken, [part], "full", {"run": 1.0}, "", None)
    data = json.dumps(whole, ensure_ascii=False, allow_nan=False).encode("utf-8")
    assert json.loads(data.decode("utf-8")) == whole
    assert part["message"].isprintable() and len(part["message"]) <= record.LONGEST_SENTENCE
    for check in part["checks"]:
        assert len(check["message"]) <= LONGEST_TEXT
        assert check["message"].replace("\n", "").isprintable()
    assert all(name.isprintable() and len(name) <= LONGEST_NAME for name in whole["ignored"])


def test_one_exception_is_told_once() -> None:
    """The other checks that fail by it refer to the first; another exception is told by itself."""
    text = "2 of 9 cases wrong; the first: x\nin\n  got the program threw x"
    thrown: dict[str, Any] = {"name": "x", "input": "in", "quantities": []}
    thrown["sentence"] = "the program threw x"
    other = {**thrown, "sentence": "the program threw y"}
    same = Verdict(False, "graded", text, thrown)
    first, *again, last = judged(*[same] * (len(IDS) - 1), Verdict(False, "graded", text, other))
    assert (first["message"], first["shown"]) == (text, thrown)
    refers = f'2 of 9 cases wrong, as in "{PART.checks[0].title}": the program threw x'
    assert all(check["message"] == refers and "shown" not in check for check in again)
    assert (last["message"], last["shown"]) == (text, other)


def test_one_crash_is_told_once() -> None:
    """A crash in another line is told by itself."""

    def crash(case: int, line: int) -> Verdict:
        ended = f"ended at case {case} of 9; the last: x\nin"
        return Verdict(False, "crashed", f"{ended}\n  got      out of range, at a.cpp:{line}")

    first, second, *_, last = judged(*(crash(n, 7) for n in range(1, len(IDS))), crash(9, 8))
    assert first["message"].endswith("the last: x\nin\n  got      out of range, at a.cpp:7")
    refers = f'as in "{PART.checks[0].title}": out of range, at a.cpp:7'
    assert second["message"] == f"ended at case 2 of 9, {refers}"
    assert last["message"].endswith("at a.cpp:8") and "as in" not in last["message"]
