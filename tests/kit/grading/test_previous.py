"""What has changed since a record of before, ours or Gradescope's."""

import json
from pathlib import Path
from typing import Any

import pytest
import stand_in
from bounce_grader import formats
from bounce_grader.common.errors import UsageError
from bounce_grader.common.manifest import parts
from bounce_grader.formats import sentences
from bounce_grader.grading import previous
from bounce_grader.submission import submission
from conftest import write

NOWHERE = Path("/nowhere")
FIRST, SECOND = parts()[0].checks[:2]


def graded(tmp_path: Path, passed: set[str]) -> dict[str, Any]:
    """A record in which just these checks are passed."""
    folder = write(tmp_path / "x", {"part2_lcp.cpp": b"1"})
    record = stand_in.record_of(submission.read(folder))
    for part in record["parts"]:
        for check in part["checks"]:
            check["passed"] = check["id"] in passed
            check["score"] = check["max_score"] * check["passed"]
        part["score"] = sum(check["score"] for check in part["checks"])
    record["score"] = sum(part["score"] for part in record["parts"])
    return {**record, "speed": None}


def gradescope(*records: dict[str, Any]) -> dict[str, Any]:
    """submission_metadata.json, as its documentation has it; the newest is not the last."""
    submissions = [
        {
            "submission_time": f"2026-11-{20 - number}T10:00:00.000000-08:00",
            "autograder_error": False,
            "results": json.loads(formats.render("gradescope", record, NOWHERE)),
        }
        for number, record in enumerate(records)
    ]
    failed = {"submission_time": "2026-11-30", "autograder_error": True, "results": {}}
    return {"id": 1, "previous_submissions": [*submissions, failed]}


@pytest.mark.parametrize("form", ["record", "gradescope"])
def test_what_was_gained_and_lost_is_said(tmp_path: Path, form: str) -> None:
    then, now = graded(tmp_path, {FIRST.id}), graded(tmp_path, {SECOND.id, parts()[3].checks[0].id})
    file = tmp_path / "before.json"
    older = graded(tmp_path, set())
    file.write_text(json.dumps(then if form == "record" else gradescope(then, older)))
    compared = previous.compared(now, previous.read(file))
    gained = [SECOND.id, parts()[3].checks[0].id]
    assert compared["before"] == {"score": then["score"], "gained": gained, "lost": [FIRST.id]}
    words = sentences.since_last_time(compared)
    assert words[0].startswith(f"Since last time: {FIRST.points:g} -> ")
    assert f"Gained: {SECOND.title}" in words and f"Lost: {FIRST.title}" in words
    for name in ("gradescope", "markdown", "html"):
        assert "Since last time" in formats.render(name, compared, NOWHERE)


def test_a_first_submission_has_nothing_before(tmp_path: Path) -> None:
    file = tmp_path / "before.json"
    file.write_text(json.dumps(gradescope()))
    record = graded(tmp_path, set())
    assert previous.compared(record, previous.read(file)) == record


@pytest.mark.parametrize("score", [None, "a lot", "missing"])
def test_results_of_another_autograder_are_passed_over(tmp_path: Path, score: object) -> None:
    then = graded(tmp_path, {FIRST.id})
    there = gradescope(then)
    other = json.loads(json.dumps(there["previous_submissions"][0]))
    other["submission_time"] = "2026-11-29"
    for test in other["results"]["tests"]:
        test["score"] = score
        if score == "missing":
            del test["score"]
    there["previous_submissions"].append(other)
    file = tmp_path / "before.json"
    file.write_text(json.dumps(there))
    read = previous.read(file)
    assert read is not None and read.score == then["score"]


@pytest.mark.parametrize(
    "text", ["", "[]", "{}", "null", '{"previous_submissions": 3}', '{"score": 1, "parts": [{}]}']
)
def test_another_file_is_refused_in_a_sentence(tmp_path: Path, text: str) -> None:
    file = tmp_path / "before.json"
    file.write_text(text)
    with pytest.raises(UsageError, match="is neither a score record nor Gradescope's"):
        previous.read(file)
