"""Once after each build, a known wrong program must lose its points; else nothing is graded."""

from pathlib import Path
from typing import Any

import pytest
from bounce_grader.common.errors import KitError
from bounce_grader.grading import judging, self_check
from bounce_grader.sandbox.box import FULL_OR_REDUCED


@pytest.fixture(autouse=True)
def built_anew(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "built").touch()
    monkeypatch.setattr(self_check, "BUILT", tmp_path / "built")
    monkeypatch.setattr(self_check, "CHECKED", tmp_path / "checked")


def test_a_sound_judge_is_asked_once(monkeypatch: pytest.MonkeyPatch) -> None:
    self_check.require_sound_judge(FULL_OR_REDUCED)
    monkeypatch.setattr(self_check, "grade", None)  # would be a TypeError
    self_check.require_sound_judge(FULL_OR_REDUCED)


def test_a_judge_that_finds_nothing_grades_nobody(monkeypatch: pytest.MonkeyPatch) -> None:
    judge = judging.judge

    def kind(*given: Any) -> judging.Judged:
        judged = judge(*given)
        verdicts = {id: v._replace(passed=True) for id, v in judged.verdicts.items()}
        return judged._replace(verdicts=verdicts)

    monkeypatch.setattr(judging, "judge", kind)
    with pytest.raises(KitError, match="got 30 of 30 points, .* lost nothing: trust no score"):
        self_check.require_sound_judge(FULL_OR_REDUCED)


def test_a_judge_that_fails_grades_nobody(monkeypatch: pytest.MonkeyPatch) -> None:
    """As with GoogleTest 1.14, whose messages the judge read."""

    def failing(*_: Any) -> judging.Judged:
        raise KitError("the judge failed on part 3")

    monkeypatch.setattr(judging, "judge", failing)
    with pytest.raises(KitError, match="can't be graded: the judge failed on part 3"):
        self_check.require_sound_judge(FULL_OR_REDUCED)
