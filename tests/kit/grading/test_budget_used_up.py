"""A grading whose time is used up before any of its steps ends in a record, and never in a fault of
the kit."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from bounce_grader.grading import examples
from bounce_grader.grading.grade import grade, Options
from bounce_grader.sandbox import box
from bounce_grader.sandbox.budget import Budget, Overrun, UNLIMITED
from conftest import ROOT, solution_files, write

WRONG = ROOT / "tests/submissions/mistakes/part3_friction_sign/part3_step.cpp"
EXAMPLE = b"part 1: y = 0.1, theta = 45 deg -> phi = -0.0414\n"


def counted(patch: pytest.MonkeyPatch, late_from: int) -> Callable[[], int]:
    """The time is up from this call on; gives how many calls there were."""
    calls = [0]

    def require_time(asked: Budget) -> None:
        if asked is UNLIMITED:  # as of what the kit does on its own account
            return
        calls[0] += 1
        if calls[0] >= late_from:
            raise Overrun("the grading as a whole had used its 60 s of CPU time")

    patch.setattr(Budget, "require_time", require_time)
    return lambda: calls[0]


def test_a_grading_that_is_out_of_time_before_any_step_ends_in_a_record(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    files = {**solution_files(), "part3_step.cpp": WRONG.read_bytes(), "examples.txt": EXAMPLE}
    submission = write(tmp_path / "submission", files)
    monkeypatch.setattr(examples, "example_points", lambda: 10.0)
    box.choose(box.FULL_OR_REDUCED)  # once a process, without a budget

    def record(late_from: int) -> tuple[dict[str, Any], int]:
        with monkeypatch.context() as patch:
            calls = counted(patch, late_from)
            return grade(submission, Options(sanitize=False)), calls()

    whole, steps = record(10**9)
    assert whole["score"] > 80 and steps >= 8
    scores = []
    for late_from in range(1, steps + 1):
        late, _ = record(late_from)
        assert [part["part"] for part in late["parts"]] == [1, 2, 3, 4, 5]
        scores.append(late["score"])
    assert scores[0] == 0 and scores == sorted(scores)
