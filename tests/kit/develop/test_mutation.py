"""Measures the checks: every mutation of the solution must lose points, and only in its own part.

`PYTHONPATH=grader:tests /usr/bin/python3 -m mutation` prints each change and what it costs.
"""

from collections.abc import Callable

import pytest
from bounce_grader.common.manifest import parts, Part
from conftest import SOLUTION, Grade, lost
from mutation.changes import OPERATORS, Change, changes
from mutation.table import by_operator, counts, faults, is_alike, reasons, survivors, table
from mutation.trial import (
    all_changes,
    changes_of_style,
    differing,
    files_of_styles,
    outcomes,
    part_of,
)

EVERY = 5  # the usual run tries one in this many changes
QUESTIONS = {1: 20000, 2: 20000, 3: 20000, 4: 2000}
TOLD_APART = {
    "return {J, q(1) [-+-]{+-+} r.y()};",
    "const Vector3 f_e = [-M * -]params.g;",
    "if ([-phi < params.delta-]{+false+}) {",
    "if ([-t > 0-]{+false+}) state = step(state.q, state.v, params);",
}
Tell = Callable[[str, object], None]

FILE = """namespace bounce {

State step(const Vector3& q, const Vector3& v, const Parameters& params) {
  const Eigen::Matrix<double, 3, 3> M = params.M();
  if (q(1) < params.delta) return {q - v, v};
  return {q + params.dt * v, v};
}

}  // namespace bounce
"""


def made(operator: str) -> list[str]:
    return [c.name for c in changes("step.cpp", FILE) if c.operator == operator]


def test_a_sign_is_changed_where_a_value_begins() -> None:
    assert "return {{+-+}q + params.dt * v, v};" in made("sign")
    assert "if (q(1) < {+-+}params.delta) return {q - v, v};" in made("sign")


def test_the_bracket_of_a_template_is_no_comparison() -> None:
    places = [name.index("[") for name in made("comparison")]
    assert places == [len("if (q(1) ")] * 4


def test_a_term_is_dropped_and_doubled() -> None:
    assert "return {q{+ + q+} + params.dt * v, v};" in made("term")
    assert "return {q[- + params.dt * v-], v};" in made("term")
    assert "if (q(1) < params.delta) return {[-q -]- v, v};" in made("term")


def test_a_factor_is_dropped() -> None:
    assert "return {q + [-params.dt * -]v, v};" in made("factor")


def test_a_name_is_exchanged_for_each_other_one_of_its_type() -> None:
    others = [name for name in made("name") if "[-params.dt-]" in name]
    assert len(others) == len(["l", "m", "mu", "epsilon", "delta"])
    assert "return {q + params.dt * v, [-v-]{+params.g+}};" in made("name")


def test_two_arguments_change_places() -> None:
    assert "return {[-q + params.dt * v, v-]{+v, q + params.dt * v+}};" in made("swap")


def test_a_condition_is_turned_round() -> None:
    assert any("{+!(q(1) < params.delta)+}" in name for name in made("condition"))


def test_a_statement_is_dropped_unless_it_declares() -> None:
    dropped = [name for name in made("statement") if name.endswith("{+;+}")]
    assert len(dropped) == len(["if", "the return in it", "return"])


def test_no_change_is_made_twice() -> None:
    assert len({(c.file, c.text) for c in all_changes()}) == len(all_changes())
    assert len({(c.file, c.name) for c in all_changes()}) == len(all_changes())


def test_every_kind_of_change_is_made() -> None:
    assert {c.operator for c in all_changes()} == set(OPERATORS)


def test_what_is_excused_is_a_change_and_has_a_reason() -> None:
    known = {(c.file, c.name) for c in all_changes()}
    for file, excused in reasons().items():
        for name, reason in excused.items():
            assert (file, name) in known
            assert len(reason.split()) >= 4


def itself(file: str) -> Change:
    return Change(file, 1, "none", "itself", (SOLUTION / file).read_text())


def of_part(part: Part) -> list[Change]:
    return [change for change in all_changes() if change.file == part.file]


@pytest.mark.slow
def test_a_sample_of_small_changes_loses_points(record_property: Tell) -> None:
    found = [outcome for part in parts() for outcome in outcomes(of_part(part)[::EVERY])]
    assert faults(found) == []
    number, compiled, noticed, alike, left, left_in_public = counts(found)
    record_property(
        "shown",
        f"one in {EVERY} small changes of the solution: {number} made, {compiled} compiled, "
        f"{noticed} lost points, {alike} can't be told from it, {left} left "
        f"({left_in_public} by the public cases alone)",
    )


@pytest.mark.long
@pytest.mark.parametrize("part", parts(), ids=lambda part: part.stem)
def test_every_small_change_of_a_part_loses_points(part: Part, record_property: Tell) -> None:
    found = outcomes(of_part(part))
    record_property("shown", table(found))
    assert faults(found) == []


@pytest.mark.slow
@pytest.mark.parametrize("part", parts(), ids=lambda part: part.stem)
def test_random_questions_tell_the_solution_from_a_change(part: Part) -> None:
    wrong = next(c for c in of_part(part) if c.name in TOLD_APART)
    found = differing([itself(part.file), wrong], QUESTIONS[part.number])
    assert found["itself"] == 0
    assert found[wrong.name] > QUESTIONS[part.number] / 100


@pytest.mark.long
@pytest.mark.parametrize("part", parts(), ids=lambda part: part.stem)
def test_a_change_loses_points_exactly_where_random_questions_tell_it(part: Part) -> None:
    alike = differing(filter(is_alike, of_part(part)), QUESTIONS[part.number])
    assert alike and set(alike.values()) == {0}
    lost = [o.change for o in outcomes(of_part(part)) if o.lost]
    told = differing(lost, QUESTIONS[part.number] // 10)
    assert [name for name, number in told.items() if number == 0] == []


# One in three hundred, from all parts; one in thirty in the long run.
WHOLE = [
    pytest.param(c, marks=[pytest.mark.slow if i % 10 == 0 else pytest.mark.long], id=str(i))
    for i, c in enumerate(all_changes()[::30])
]


@pytest.mark.parametrize("change", WHOLE)
def test_a_whole_grading_takes_the_same_points_in_that_part_alone(
    change: Change, grade: Grade
) -> None:
    record = grade({change.file: change.text.encode()})
    outcome = outcomes([itself(change.file), change])[1]
    whole = [check.id for part in parts() if part.file == change.file for check in part.checks]
    assert lost(record) == sorted(outcome.lost if outcome.compiles else whole)


# The same changes of right programs in other styles: of so many, one in this many is tried. One that
# costs nothing has to answer random questions as the solution does.
EVERY_OF_A_STYLE = 10


@pytest.mark.long
def test_small_changes_of_other_styles_lose_points_or_change_nothing(
    record_property: Tell,
) -> None:
    found, told_apart = [], set()
    for file in files_of_styles():
        tried = outcomes(changes_of_style(file)[::EVERY_OF_A_STYLE])
        left = survivors(tried)
        number = part_of(left[0]).number if left else 1
        asked = differing(left, QUESTIONS[number]) if left else {}
        told_apart |= {str(change) for change in left if asked[change.name]}
        found += tried
    record_property("shown", by_operator(found, told_apart))
    assert not told_apart
