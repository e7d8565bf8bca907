"""Which fixtures the oracle confirms, and which it must refuse."""

from __future__ import annotations

import copy
from typing import Any

import pytest

import oracle
from oracle import Undecidable, answer, complaints, exact, get_contacts, mpf, step, vector
from oracle_scenes import DEFAULTS, SEED, SLIDES_RIGHT, STICKS, read


def question(stem: str) -> dict[str, Any]:
    """A sound case whose expected numbers are the exact ones, rounded to doubles."""
    q, v = SLIDES_RIGHT
    asked = {
        "part1_contacts": {"q": q},
        "part2_lcp": {"J": [[1, 0.3], [0.2, 1], [0.1, -0.4]], "v": v},
        "part3_step": {"q": q, "v": v},
        "part4_simulate": {"q_0": SEED[0], "v_0": SEED[1]},
    }
    case = {"name": "a case", "params": DEFAULTS, "input": asked[stem], "tolerance": 1e-9}
    case["expected"] = {"columns": [0, 1, 60, 149]} if stem == "part4_simulate" else {}
    case["expected"] = rounded(answer(stem, "a check", case))
    return case


def rounded(tree: Any) -> Any:
    if isinstance(tree, dict):
        return {key: rounded(branch) for key, branch in tree.items()}
    if isinstance(tree, (list, tuple)):
        return [rounded(branch) for branch in tree]
    return tree if isinstance(tree, int) else float(tree)


def slots(tree: Any) -> list[tuple[Any, int | str]]:
    """Every place of a number: its container, and the key there."""
    items = list(tree.items() if isinstance(tree, dict) else enumerate(tree))
    here = [(tree, key) for key, branch in items if isinstance(branch, float)]
    inner = [slots(branch) for _, branch in items if isinstance(branch, (dict, list))]
    return here + [slot for found in inner for slot in found]


STEMS = ["part1_contacts", "part2_lcp", "part3_step", "part4_simulate"]


@pytest.mark.parametrize("stem", STEMS)
def test_confirms_the_exact_numbers(stem: str) -> None:
    assert complaints(stem, "a check", [question(stem)]) == []


@pytest.mark.parametrize("stem", STEMS)
def test_refuses_any_number_that_is_off_by_1e_11(stem: str) -> None:
    case = question(stem)
    count = len(slots(case["expected"]))
    assert count == {"part1_contacts": 7, "part2_lcp": 20, "part3_step": 6}.get(stem, 24)
    for i in range(count):
        wrong = copy.deepcopy(case)
        holder, key = slots(wrong["expected"])[i]
        holder[key] += 1e-11 * max(1, abs(holder[key]))
        (found,) = complaints(stem, "a check", [wrong])
        assert found.startswith("a check, case 'a case', ")
        assert f": expected {holder[key]!r}, exact " in found and ", difference " in found


@pytest.mark.parametrize("stem", STEMS)
@pytest.mark.parametrize("bad", [float("nan"), float("inf"), None, "1", True])
def test_refuses_what_is_no_number(stem: str, bad: Any) -> None:
    case = question(stem)
    holder, key = slots(case["expected"])[0]
    holder[key] = bad
    (found,) = complaints(stem, "a check", [case])
    assert "malformed" in found


@pytest.mark.parametrize("stem", STEMS)
def test_refuses_a_missing_and_an_extra_quantity(stem: str) -> None:
    missing, extra = question(stem), question(stem)
    missing["expected"].popitem()
    extra["expected"]["z"] = 0.0
    for case in (missing, extra):
        (found,) = complaints(stem, "a check", [case])
        assert "too much or too little" in found


def undecidable(stem: str, changes: dict[str, Any] | None = None, **asked: Any) -> str:
    case = question(stem)
    case["params"] = DEFAULTS | (changes or {})
    case["input"] = case["input"] | asked
    (found,) = complaints(stem, "a check", [case])
    return found


def test_refuses_two_corners_equally_low() -> None:
    assert "second corner" in undecidable("part1_contacts", q=[0, 1, 0.0])
    assert "second corner" in undecidable("part1_contacts", q=[0, 1, 1e-6])
    assert "second corner" in undecidable("part3_step", q=[0, 0.1, 0.0])


def test_allows_two_corners_equally_low_in_the_air() -> None:
    assert step(vector([0, 1, 0]), vector([0, 0, 0]), read())[1][1] < 0


@pytest.mark.parametrize("distance", [-9e-7, 0.0, 9e-7])
def test_refuses_a_corner_at_the_threshold(distance: float) -> None:
    q = vector([0, 1, 0.5])
    y = float(1 - get_contacts(q, read()).phi + read().delta + exact(distance))
    assert "phi - delta" in undecidable("part3_step", q=[0, y, 0.5])


def test_names_the_undecidable_step_of_a_trajectory() -> None:
    # Flat, and without spin: both corners land together.
    found = undecidable("part4_simulate", q_0=[0, 0.2, 0.0], v_0=[0, 0, 0.0])
    assert "undecidable: step from column 1" in found


def test_looks_at_the_listed_columns_only_where_no_more_are_compared() -> None:
    case = question("part4_simulate")
    case["input"] = {"q_0": [0, 0.2, 0.0], "v_0": [0, 0, 0]}
    case["expected"] = {"columns": [0], "q": [[0, 0.2, 0]], "v": [[0, 0, 0]]}
    assert complaints("part4_simulate", "part4.StartsAtTheInitialState", [case]) == []
    assert complaints("part4_simulate", "part4.StepsFromTheColumnBefore", [case])
    case["expected"] = {}
    assert complaints("part4_simulate", "part4.StaysFiniteOnALongRun", [case]) == []


def test_refuses_friction_that_can_jam_the_corner() -> None:
    found = undecidable("part3_step", {"mu": 3.0})
    assert "mu |b|" in found


def test_refuses_steps_that_are_called_decidable_and_are_not() -> None:
    case = question("part3_step")
    case["input"] = {"q": [0, 0.14, 0], "v": [0, -1, 0]}  # it lands flat, in the fourth step
    case["expected"] = rounded(answer("part3_step", "a check", case))
    assert complaints("part3_step", "a check", [case]) == []
    case["expected"]["steps"] = "decidable"
    assert complaints("part3_step", "a check", [case])


@pytest.mark.parametrize(
    "forces, problem", [([], "no solution"), ([(1, 0), (1, mpf("0.1"))], "different velocities")]
)
def test_refuses_to_choose_among_solutions(
    monkeypatch: pytest.MonkeyPatch, forces: list[Any], problem: str
) -> None:
    monkeypatch.setattr(oracle, "contact_forces", lambda J, v, params: iter(forces))
    with pytest.raises(Undecidable, match=problem):
        step(vector(STICKS[0]), vector(STICKS[1]), read())
