"""Measures the checks: every mutation of the solution, and of right programs in other styles, must
lose points, and only in its own part.

`python -m mutation` prints each change and what it costs.
"""

from collections.abc import Callable

import pytest
from bounce_grader.common.manifest import parts, Part
from conftest import SOLUTION, Grade, lost
from mutation.changes import Change
from mutation.table import faults, is_alike, reasons, summary
from mutation.trial import (
    all_changes,
    changes_of,
    differing,
    files_of_styles,
    outcomes,
    part_of,
)

FILES = [*(part.file for part in parts()), *files_of_styles()]
EVERY = 10  # the usual run tries one in this many changes
QUESTIONS = {1: 20000, 2: 20000, 3: 20000, 4: 2000}
TOLD_APART = {
    "return {J, q(1) [-+-]{+-+} r.y()};",
    "const Vector3 f_e = [-M * -]params.g;",
    "if ([-phi < params.delta-]{+false+}) {",
    "if ([-t > 0-]{+false+}) state = step(state.q, state.v, params);",
}
Tell = Callable[[str, object], None]


def test_what_is_excused_is_a_change_and_has_a_reason() -> None:
    known = {(c.file, c.name) for file in FILES for c in changes_of(file)}
    for file, excused in reasons().items():
        for name, reason in excused.items():
            assert (file, name) in known
            assert len(reason.split()) >= 4


def itself(file: str) -> Change:
    return Change(file, 1, "none", "itself", (SOLUTION / file).read_text())


def of_part(part: Part) -> list[Change]:
    return [change for change in all_changes() if change.file == part.file]


def test_a_sample_of_small_changes_loses_points(record_property: Tell) -> None:
    found = [outcome for part in parts() for outcome in outcomes(of_part(part)[::EVERY])]
    assert faults(found) == []
    record_property("shown", summary(f"one in {EVERY} changes of the solution", found))


@pytest.mark.long
@pytest.mark.parametrize("file", FILES)
def test_every_small_change_loses_points_or_is_excused(file: str, record_property: Tell) -> None:
    found = outcomes(changes_of(file))
    record_property("shown", summary(file, found))
    assert faults(found) == []


@pytest.mark.parametrize("part", parts(), ids=lambda part: part.stem)
def test_random_questions_tell_the_solution_from_a_change(part: Part) -> None:
    wrong = next(c for c in of_part(part) if c.name in TOLD_APART)
    found = differing([itself(part.file), wrong], QUESTIONS[part.number])
    assert found["itself"] == 0
    assert found[wrong.name] > QUESTIONS[part.number] / 100


@pytest.mark.long
@pytest.mark.parametrize("file", FILES)
def test_random_questions_tell_no_excused_change_from_the_solution(file: str) -> None:
    excused = list(filter(is_alike, changes_of(file)))
    questions = QUESTIONS[part_of(excused[0]).number]
    assert not any(differing(excused, questions).values())


@pytest.mark.long
@pytest.mark.parametrize("part", parts(), ids=lambda part: part.stem)
def test_random_questions_tell_what_loses_points_from_the_solution(part: Part) -> None:
    losing = [o.change for o in outcomes(of_part(part)) if o.lost]
    told = differing(losing, QUESTIONS[part.number] // 10)
    assert [name for name, number in told.items() if number == 0] == []


# One in three hundred, from all parts; one in thirty in the long run.
WHOLE = [
    pytest.param(c, marks=[pytest.mark.long] if i % 10 else [], id=str(i))
    for i, c in enumerate(all_changes()[::30])
]


@pytest.mark.parametrize("change", WHOLE)
@pytest.mark.usual(2)
def test_a_whole_grading_takes_the_same_points_in_that_part_alone(
    change: Change, grade: Grade
) -> None:
    record = grade({change.file: change.text.encode()})
    outcome = outcomes([itself(change.file), change])[1]
    whole = [check.id for part in parts() if part.file == change.file for check in part.checks]
    assert lost(record) == sorted(outcome.lost if outcome.compiles else whole)
