"""Mistakes of the same weight cost about the same. `python -m costs` prints all costs."""

from collections.abc import Callable

import pytest
from costs import Cost, costs, table

WRITTEN_AS_NUMBERS = ("hard_coded", "default_parameters", "kept_from_the_first_call")


def among(*words: str) -> list[Cost]:
    return [cost for cost in costs() if any(word in cost.mistake for word in words)]


def test_every_mistake_costs_something_and_none_more_than_its_part() -> None:
    assert all(0 < cost.share <= 1 for cost in costs())


def test_a_parameter_written_as_a_number_costs_a_tenth_of_its_part_or_a_little_more() -> None:
    found = among(*WRITTEN_AS_NUMBERS)
    assert len({cost.part for cost in found}) == 4
    assert all(0.1 <= cost.share <= 0.27 for cost in found), found


def test_a_trajectory_that_does_not_step_on_costs_most_of_its_part() -> None:
    found = [cost for cost in costs() if "StepsFromTheColumnBefore" in cost.lost]
    assert all(cost.share >= 0.6 for cost in found), found


@pytest.mark.long
def test_the_table_names_every_mistake(record_property: Callable[[str, object], None]) -> None:
    assert all(cost.mistake in table() for cost in costs())
    record_property("shown", table())
