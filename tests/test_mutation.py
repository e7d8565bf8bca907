"""The checks, measured: every small change of the solution loses points, in its own part alone.

`PYTHONPATH=grader:tests /usr/bin/python3 -m mutation` prints each change and what it costs.
"""

from collections.abc import Callable

import pytest
from bounce_grader.manifest import Part, parts
from conftest import Grade, lost
from mutation.changes import OPERATORS, changes
from mutation.table import counts, faults, is_alike, reasons, table
from mutation.trial import all_changes, differing, outcome, outcomes, part_of

EVERY = 20  # of the changes, one in so many is tried in the ordinary run
QUESTIONS = {1: 20000, 2: 20000, 3: 20000, 4: 2000}
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


@pytest.mark.slow
def test_a_sample_of_small_changes_loses_points(record_property: Tell) -> None:
    found = list(outcomes(all_changes()[::EVERY]))
    assert faults(found) == []
    number, compiled, noticed, alike, left, _ = counts(found)
    record_property(
        "shown",
        f"one in {EVERY} small changes of the solution: {number} made, {compiled} compiled, "
        f"{noticed} lost points, {alike} can't be told from it, {left} left",
    )


@pytest.mark.long
@pytest.mark.parametrize("part", parts(), ids=lambda part: part.stem)
def test_every_small_change_of_a_part_loses_points(part: Part, record_property: Tell) -> None:
    found = list(outcomes(change for change in all_changes() if part_of(change) == part))
    record_property("shown", table(found))
    assert faults(found) == []


@pytest.mark.slow
@pytest.mark.parametrize("part", parts(), ids=lambda part: part.stem)
def test_the_solution_answers_as_itself(part: Part) -> None:
    assert differing(None, part, QUESTIONS[part.number]) == 0


@pytest.mark.long
@pytest.mark.parametrize("change", filter(is_alike, all_changes()), ids=str)
def test_what_loses_nothing_answers_as_the_solution_does(change) -> None:
    part = part_of(change)
    assert differing(change, part, QUESTIONS[part.number]) == 0


@pytest.mark.slow
def test_a_change_costs_what_a_whole_grading_takes(grade: Grade) -> None:
    """What is judged here part by part is what a submission with this file gets."""
    change = next(c for c in all_changes() if c.name == "Vector3 f = {+-+}f_e;")
    record = grade({change.file: change.text.encode()})
    assert lost(record) == list(outcome(change).lost)
