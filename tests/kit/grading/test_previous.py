"""What has changed since a record of before, ours or Gradescope's."""

import json
from pathlib import Path
from typing import Any

import pytest
import stand_in
from bounce_grader import formats
from bounce_grader.common.manifest import parts
from bounce_grader.grading import previous
from bounce_grader.submission.submission import Submission

FIRST, SECOND = (check.id for check in parts()[0].checks[:2])


def graded(*passed: str) -> dict[str, Any]:
    """A record in which just these checks are passed."""
    record = stand_in.record_of(Submission("x", {}, {}, {}, ()))
    for part in record["parts"]:
        for check in part["checks"]:
            check["passed"] = check["id"] in passed
            check["score"] = check["max_score"] * check["passed"]
        part["score"] = sum(check["score"] for check in part["checks"])
    return {**record, "score": sum(part["score"] for part in record["parts"])}


def of_gradescope(*records: dict[str, Any]) -> dict[str, Any]:
    """submission_metadata.json, as its documentation has it: the newest isn't the last; one has
    failed, and others are another autograder's."""
    results = [json.loads(formats.render("gradescope", r)) for r in records]
    others: list[dict[str, Any]] = [{"score": None}, {"score": "a lot"}, {}]
    for other in others:
        results.insert(0, {"tests": [{"number": "1.1", "status": "passed", **other}]})
    submissions = [
        {"submission_time": f"2026-11-{20 - n}T10:00:00-08:00", "results": result}
        for n, result in enumerate(results)
    ]
    failed = {"submission_time": "2026-11-30", "autograder_error": True, "results": {}}
    return {"id": 1, "previous_submissions": [*submissions, failed]}


@pytest.mark.parametrize("form", [lambda *records: records[0], of_gradescope])
def test_what_was_gained_and_lost_since_the_newest_is_known(tmp_path: Path, form: Any) -> None:
    then, now = graded(FIRST), graded(SECOND)
    (tmp_path / "before.json").write_text(json.dumps(form(then, graded())))
    compared = previous.compared(now, previous.read(tmp_path / "before.json"))
    assert compared["before"] == {"score": then["score"], "gained": [SECOND], "lost": [FIRST]}


def test_a_first_submission_has_nothing_before(tmp_path: Path) -> None:
    (tmp_path / "before.json").write_text(json.dumps(of_gradescope()))
    assert previous.compared(graded(), previous.read(tmp_path / "before.json")) == graded()
