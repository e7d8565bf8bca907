"""The record is valid JSON in UTF-8, printable and of bounded length, whatever a submission does,
and tells one exception or crash once."""

import json
from pathlib import Path
from typing import Any

import golden
import pytest
from bounce_grader.common.escaping import LONGEST_NAME, LONGEST_SENTENCE, LONGEST_TEXT
from bounce_grader.common.manifest import parts
from bounce_grader.grading import judging, record
from bounce_grader.grading.judging import Judged, Verdict
from bounce_grader.grading.report import report, reports
from bounce_grader.submission.submission import Place, Submission
from hypothesis import given, settings
from hypothesis import strategies as st
from odd_texts import TEXTS

PART = parts()[0]
IDS = [check.id for check in PART.checks]
LONG = st.builds(lambda text, times: text * times, TEXTS, st.sampled_from([1, 1, 1, 5000]))


TRAP = {"what": "signal", "number": 5, "text": ""}
NO_ANSWER = {"contact": "", "expected": []}


def said(*verdicts: Verdict) -> list[dict[str, Any]]:
    part = record.part_record(PART, Judged(dict(zip(IDS, verdicts)), None, "own"))
    return list(report({"parts": [part]})["parts"][0]["checks"])


@settings(max_examples=60)  # each starts a program
@given(LONG, st.lists(LONG, max_size=3), st.sampled_from(["graded", "crashed", ""]))
def test_whatever_is_said_the_record_stays_json(text: str, names: list[str], status: str) -> None:
    """By a program, or by a compiler; and whatever files are called."""
    part = record.failed_part(PART, "does_not_compile", judging.fact("not_built", text))
    if status:
        ended = {"what": "aborted", "number": 6, "text": text}
        made: dict[str, Any] = {"passed": False, "status": status, "ended": ended, "stack": ""}
        made |= {"failure": failure(sentence=text, name=text), "answer": NO_ANSWER}
        answer = {"checks": [made | {"id": id} for id in IDS], "mistakes": [], "patterns": []}
        told = judging.read_answer(
            json.dumps(answer | {"largest_error": 0.5, "asked_given": False}).encode(), PART
        )
        part = record.part_record(PART, told)
    taken = Submission("x", {}, {}, {}, tuple(names))
    facts = record.whole(taken, [part])
    for whole in (facts, report(facts)):
        data = json.dumps(whole, ensure_ascii=False, allow_nan=False).encode("utf-8")
        assert json.loads(data.decode("utf-8")) == whole
    part = whole["parts"][0]
    assert part["message"].isprintable() and len(part["message"]) <= LONGEST_SENTENCE
    for check in part["checks"]:
        assert len(check["message"]) <= LONGEST_TEXT
        assert check["message"].replace("\n", "").isprintable()
    assert all(name.isprintable() and len(name) <= LONGEST_NAME for name in whole["ignored"])


def failure(**changes: Any) -> dict[str, Any]:
    """Facts of a check whose third of nine cases is wrong."""
    facts: dict[str, Any] = {
        "cases": 9,
        "wrong": 2,
        "ended_at": 0,
        "again": False,
        "always_zero": False,
    }
    facts |= {"name": "x", "input": [{"name": "v", "rows": [[1]], "unit": "m"}], "parameters": []}
    return facts | {"hidden": False, "sentence": "", "quantities": []} | changes


ASKED = "x\n  input    v = 1  m\n           parameters: the assignment's\n  got      "


def test_one_exception_is_told_once() -> None:
    """The other checks that fail by it refer to the first; another exception is told by itself."""
    thrown, other = (failure(sentence=f"the program threw {what}") for what in "xy")
    same = Verdict(False, "graded", failure=thrown, answer=NO_ANSWER)
    another = same._replace(failure=other)
    first, *again, last = said(*[same] * (len(IDS) - 1), another)
    whole = f"2 of 9 cases wrong; the first: {ASKED}the program threw "
    assert (first["message"], last["message"]) == (f"{whole}x", f"{whole}y")
    assert first["shown"]["sentence"] == "the program threw x" and "shown" in last
    refers = f'2 of 9 cases wrong, as in "{PART.checks[0].title}": the program threw x'
    assert all(check["message"] == refers and "shown" not in check for check in again)


def test_one_crash_is_told_once() -> None:
    """A crash in another line is told by itself."""

    def crash(case: int, line: int) -> Verdict:
        facts = failure(ended_at=case, sentence="ended")
        return Verdict(False, "crashed", TRAP, "", facts, NO_ANSWER, Place("a.cpp", line))

    first, second, *_, last = said(*(crash(n, 7) for n in range(1, len(IDS))), crash(9, 8))
    whole = f"the last: {ASKED}the program stopped itself with a trap, at a.cpp:"
    assert first["message"] == f"ended at case 1 of 9; {whole}7"
    refers = f'as in "{PART.checks[0].title}": the program stopped itself with a trap, at a.cpp:7'
    assert second["message"] == f"ended at case 2 of 9, {refers}"
    assert last["message"] == f"ended at case 9 of 9; {whole}8"


PATTERNS = [  # a part, its patterns, the first check that fails, and the heading of its hint
    (2, ["wrong", "V_row"], "part2.FormsTheBlockOfTheForces", "2.1 "),
    (2, ["wrong", "V_row"], "part2.BordersItWithTheFrictionCone", "2.2 "),
    (1, ["corner_always"], IDS[0], "1.3 "),
    (1, ["where(l)"], IDS[0], "1.5 "),
    (1, ["where(m)"], IDS[0], "1.1 "),
]


@pytest.mark.parametrize("number, ids, check, heading", PATTERNS)
def test_a_pattern_names_a_hint_for_the_numbers_that_it_is_about(
    number: int, ids: list[str], check: str, heading: str
) -> None:
    part = parts()[number - 1]
    named = (id.rstrip(")").partition("(") for id in ids)
    patterns = tuple(
        {"id": id, "words": ["", ""], "about": [about] if about else []} for id, _, about in named
    )
    wrong = Verdict(False, "graded", failure=failure(), answer=NO_ANSWER)
    verdicts = {c.id: Verdict(True, "graded") for c in part.checks} | {check: wrong}
    facts = record.part_record(part, Judged(verdicts, None, "own", (), patterns))
    told = {c["id"]: c for c in report({"parts": [facts]})["parts"][0]["checks"]}
    assert told[check]["hint"]["heading"].startswith(heading)


def test_a_crash_when_asked_again_hides_no_exception_of_before() -> None:
    """The case that is told threw; the program ended only later, in the other order."""
    facts = failure(sentence="the program threw x")
    ended = Verdict(False, "crashed", TRAP, "", facts, NO_ANSWER, Place("a.cpp", 7))
    assert said(*[ended] * len(IDS))[0]["message"].endswith("got      the program threw x")


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
        wrong = {"name": "V", "unit": "s/kg", "got": got, "right": marks}
        facts = failure(name=name, quantities=[wrong], hidden="hidden" in name)
        answer = {"contact": "", "expected": [right]}
        text += said(*[Verdict(False, "graded", None, "", facts, answer)] * len(IDS))[0]["message"]
        text += "\n"
    golden.compare_file(Path(__file__).with_name("quantities.txt"), text)


@pytest.mark.golden
def test_each_way_to_end_has_a_sentence() -> None:
    here = Path(__file__).with_name("endings.txt")
    rows = json.loads(here.with_suffix(".json").read_text())
    ended = [dict(zip(("what", "number", "text"), row)) for row in rows]
    cuts = [{"parts": [], "speed": {"cut": {"dt": 1.0, "ended": one}}} for one in ended]
    sentences = (told["speed"]["cut"].partition(": ")[2] for told in reports(cuts))
    golden.compare_file(here, "".join(f"{sentence}\n" for sentence in sentences))
