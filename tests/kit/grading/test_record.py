"""The record is valid JSON in UTF-8, printable and of bounded length, whatever a submission does,
and tells one exception or crash once."""

import json
from pathlib import Path
from typing import Any

import golden
import pytest
from bounce_grader.common.escaping import LONGEST_NAME, LONGEST_TEXT
from bounce_grader.common.manifest import parts
from bounce_grader.grading import hints, judging, record, words
from bounce_grader.grading.judging import Judged
from bounce_grader.grading.words import Verdict
from bounce_grader.submission.submission import Place, Submission
from hypothesis import given
from hypothesis import strategies as st
from odd_texts import TEXTS

PART = parts()[0]
IDS = [check.id for check in PART.checks]
LONG = st.builds(lambda text, times: text * times, TEXTS, st.sampled_from([1, 1, 1, 5000]))


TRAP = {"what": "signal", "number": 5, "text": ""}


def judged(*verdicts: Verdict) -> list[dict[str, Any]]:
    part = record.part_record(PART, Judged(dict(zip(IDS, verdicts)), None, "own"))
    return list(part["checks"])


@given(LONG, st.lists(LONG, max_size=3), st.sampled_from(["graded", "crashed", ""]))
def test_whatever_is_said_the_record_stays_json(text: str, names: list[str], status: str) -> None:
    """By a program, or by a compiler; and whatever files are called."""
    part: dict[str, Any] = record.failed_part(PART, "does_not_compile", text)
    if status:
        ended = {"what": "aborted", "number": 6, "text": text}
        made: dict[str, Any] = {"passed": False, "status": status, "ended": ended, "stack": ""}
        made["failure"] = failure(sentence=text, name=text)
        answer = {"checks": [made | {"id": id} for id in IDS], "mistakes": [], "patterns": [text]}
        told = judging.read_answer(
            json.dumps(answer | {"largest_error": 0.5, "asked_given": False}).encode(), PART
        )
        part = record.part_record(PART, told)
    taken = Submission("x", {}, {}, {}, tuple(names))
    whole = record.whole(taken, [part])
    data = json.dumps(whole, ensure_ascii=False, allow_nan=False).encode("utf-8")
    assert json.loads(data.decode("utf-8")) == whole
    assert part["message"].isprintable() and len(part["message"]) <= record.LONGEST_SENTENCE
    for check in part["checks"]:
        assert len(check["message"]) <= LONGEST_TEXT
        assert check["message"].replace("\n", "").isprintable()
    assert all(name.isprintable() and len(name) <= LONGEST_NAME for name in whole["ignored"])


def failure(**changes: Any) -> dict[str, Any]:
    """Facts of a check whose third of nine cases is wrong."""
    facts: dict[str, Any] = {"cases": 9, "wrong": 2, "ended_at": 0, "again": False}
    facts |= {"name": "x", "input": "in", "hidden": False}
    return facts | {"contact": "", "sentence": "", "quantities": []} | changes


def test_one_exception_is_told_once() -> None:
    """The other checks that fail by it refer to the first; another exception is told by itself."""
    thrown, other = (failure(sentence=f"the program threw {what}") for what in "xy")
    same = Verdict(False, "graded", failure=thrown)
    another = same._replace(failure=other)
    first, *again, last = judged(*[same] * (len(IDS) - 1), another)
    whole = "2 of 9 cases wrong; the first: x\n  input    in\n  got      the program threw "
    assert (first["message"], last["message"]) == (f"{whole}x", f"{whole}y")
    assert first["shown"]["sentence"] == "the program threw x" and "shown" in last
    refers = f'2 of 9 cases wrong, as in "{PART.checks[0].title}": the program threw x'
    assert all(check["message"] == refers and "shown" not in check for check in again)


def test_one_crash_is_told_once() -> None:
    """A crash in another line is told by itself."""

    def crash(case: int, line: int) -> Verdict:
        facts = failure(ended_at=case, sentence="ended")
        return Verdict(False, "crashed", TRAP, "", facts, Place("a.cpp", line))

    first, second, *_, last = judged(*(crash(n, 7) for n in range(1, len(IDS))), crash(9, 8))
    whole = (
        "the last: x\n  input    in\n  got      the program stopped itself with a trap, at a.cpp:"
    )
    assert first["message"] == f"ended at case 1 of 9; {whole}7"
    refers = f'as in "{PART.checks[0].title}": the program stopped itself with a trap, at a.cpp:7'
    assert second["message"] == f"ended at case 2 of 9, {refers}"
    assert last["message"] == f"ended at case 9 of 9; {whole}8"


def test_what_is_said_of_other_numbers_names_no_hint_for_a_check() -> None:
    border = ["Wrong: V.", "The last row of your V is (2 mu, -1, -1, 0) in every question."]
    assert hints.of_patterns(2, border, "part2.FormsTheBlockOfTheForces") == ""
    assert (
        hints.of_patterns(2, border, "part2.BordersItWithTheFrictionCone") == "2.2 The border of V"
    )
    corner = ["Your answer is always that of corner 2."]
    assert hints.of_patterns(1, corner, IDS[0]) == "1.3 Any of the four corners"


def test_a_crash_when_asked_again_hides_no_exception_of_before() -> None:
    """The case that is told threw; the program ended only later, in the other order."""
    facts = failure(sentence="the program threw x")
    first, *_ = judged(*[Verdict(False, "crashed", TRAP, "", facts, Place("a.cpp", 7))] * len(IDS))
    assert first["message"].endswith("got      the program threw x")


@pytest.mark.golden
def test_a_wrong_quantity_is_laid_out_with_its_wrong_entries_marked() -> None:
    rows = {
        "a matrix": ([[1, 2], [3, 4]], [[1, 2], ["nan", 4]], [[True, True], [False, True]]),
        "a vector": ([[1], [2], [0]], [[1], [-0.0], [-6.9e-17]], [[True], [False], [True]]),
        "a vector, hidden": ([[1], [2], [3]], [[1], [-2], [3]], [[True], [False], [True]]),
        "a row": ([[1, 2]], [["nan", 4]], [[False, False]]),
        "a scalar": ([[5]], [[1e-7 / 3]], [[False]]),
    }
    text = ""
    for name, (right, got, marks) in rows.items():
        wrong = {"name": "V", "unit": "s/kg", "expected": right, "got": got, "right": marks}
        facts = failure(name=name, quantities=[wrong], hidden="hidden" in name)
        text += words.say([Verdict(False, "graded", failure=facts)])[0].lines + "\n"
    golden.compare_file(Path(__file__).with_name("quantities.txt"), text)


@pytest.mark.golden
def test_each_way_to_end_has_a_sentence() -> None:
    here = Path(__file__).with_name("endings.txt")
    rows = json.loads(here.with_suffix(".json").read_text())
    facts = (dict(zip(("what", "number", "text"), row)) for row in rows)
    said = words.say([Verdict(False, "crashed", ended) for ended in facts])
    golden.compare_file(here, "".join(f"{each.end}\n" for each in said))
