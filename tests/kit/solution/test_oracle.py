"""The oracle confirms every number of the fixtures. Were it wrong, it would not; were it lenient,
nobody would see, so what it refuses is tested."""

from __future__ import annotations

import copy
import json
import os
from pathlib import Path
from typing import Any

import pytest
from oracle import (
    answer,
    complaints,
    exact,
    get_contacts,
    mpf,
    Parameters,
    step,
    Undecidable,
    vector,
)

ROOT = Path(__file__).resolve().parents[3]
MANIFEST = json.loads((ROOT / "grader/parts.json").read_text())["parts"]
STEMS = [part["stem"] for part in MANIFEST]
DEFAULTS: dict[str, Any] = {"l": 0.2, "m": 0.3, "mu": 0.3, "epsilon": 0.5, "g": [0, -9.81, 0]}
DEFAULTS |= {"dt": 0.01, "delta": 0.001, "T": 150}
PARAMS = Parameters.read(DEFAULTS)
SLIDES = [0.4, 0.09, 0.5], [3.0, -1.0, 0.3]


# --- the fixtures ---


def folders() -> dict[str, Path]:
    """The folders of fixtures: public has to be there, hidden only where it is asked for."""
    hidden = Path(os.environ.get("BOUNCE_HIDDEN") or ROOT / "fixtures/hidden")
    public = {"public": ROOT / "fixtures/public"}
    return public | ({"hidden": hidden} if hidden.is_dir() else {})


@pytest.mark.parametrize("folder", folders())
@pytest.mark.parametrize("part", MANIFEST, ids=STEMS)
def test_the_oracle_confirms_every_number(folder: str, part: dict[str, Any]) -> None:
    stem = part["stem"]
    content = json.loads((folders()[folder] / f"{stem}.json").read_text())
    assert content["stem"] == stem
    assert set(content["checks"]) == {check["id"] for check in part["checks"]}
    for check, cases in content["checks"].items():
        assert cases, f"{check} has no case"
        assert complaints(stem, check, cases) == []


# --- what it confirms and refuses ---


def case_of(stem: str, **asked: Any) -> dict[str, Any]:
    """A case, sound unless something else is asked, with the exact numbers rounded to doubles."""
    q, v = SLIDES
    inputs: dict[str, Any] = {
        "part1_contacts": {"q": q},
        "part2_lcp": {"J": [[1, 0.3], [0.2, 1], [0.1, -0.4]], "v": v},
        "part3_step": {"q": q, "v": v},
        "part4_simulate": {"q_0": [0.0, 1.5, 0.5235987755982988], "v_0": [0.0, -0.2, 0.0]},
    }
    changed = asked.pop("params", {})
    case: dict[str, Any] = {
        "name": "a case",
        "params": DEFAULTS | changed,
        "input": inputs[stem] | asked,
    }
    case["expected"] = {"columns": [0, 1, 60, 149]} if stem == "part4_simulate" else {}
    try:
        case["expected"] = rounded(answer(stem, "a check", case))
    except Undecidable:
        pass
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


@pytest.mark.parametrize("stem, count", zip(STEMS, (7, 20, 6, 24)))
def test_it_refuses_any_number_that_is_off_by_1e_11(stem: str, count: int) -> None:
    case = case_of(stem)
    assert complaints(stem, "a check", [case]) == []
    assert len(slots(case["expected"])) == count
    for i in range(count):
        wrong = copy.deepcopy(case)
        holder, key = slots(wrong["expected"])[i]
        holder[key] += 1e-11 * max(1, abs(holder[key]))
        (found,) = complaints(stem, "a check", [wrong])
        assert found.startswith("a check, case 'a case', ")
        assert f": expected {holder[key]!r}, exact " in found and ", difference " in found
    for bad in (float("nan"), float("inf"), None, "1", True):
        wrong = copy.deepcopy(case)
        holder, key = slots(wrong["expected"])[0]
        holder[key] = bad
        assert "malformed" in complaints(stem, "a check", [wrong])[0]
    missing, extra = copy.deepcopy(case), copy.deepcopy(case)
    missing["expected"].popitem()
    extra["expected"]["z"] = 0.0
    for wrong in (missing, extra):
        assert "too much or too little" in complaints(stem, "a check", [wrong])[0]


def height(distance: float) -> float:
    """y where a corner is so far above the threshold, at a tilt of 0.5."""
    contact = get_contacts(vector([0, 1, 0.5]), PARAMS)
    return float(1 - contact.phi + PARAMS.delta + exact(distance))


UNDECIDABLE: list[tuple[str, str, dict[str, Any]]] = [
    ("second corner", "part1_contacts", {"q": [0, 1, 0.0]}),
    ("second corner", "part1_contacts", {"q": [0, 1, 1e-6]}),
    ("second corner", "part3_step", {"q": [0, 0.1, 0.0]}),
    *(("phi - delta", "part3_step", {"q": [0, height(d), 0.5]}) for d in (-9e-7, 0.0, 9e-7)),
    ("mu |b|", "part3_step", {"params": {"mu": 3.0}}),  # friction can jam the corner
    # both corners land together
    ("step from column 14:", "part4_simulate", {"q_0": [0, 0.2, 0.0], "v_0": [0, 0, 0.0]}),
]


@pytest.mark.parametrize("problem, stem, asked", UNDECIDABLE)
def test_it_refuses_what_is_undecidable(problem: str, stem: str, asked: dict[str, Any]) -> None:
    (found,) = complaints(stem, "a check", [case_of(stem, **asked)])
    assert "undecidable: " in found and problem in found


def test_it_decides_no_more_than_is_compared() -> None:
    case = case_of("part4_simulate")
    case["input"] = {"q_0": [0, 0.2, 0.0], "v_0": [0, 0, 0]}
    case["expected"] = {"columns": [0], "q": [[0, 0.2, 0]], "v": [[0, 0, 0]]}
    assert complaints("part4_simulate", "part4.StartsAtTheInitialState", [case]) == []
    assert complaints("part4_simulate", "part4.StepsFromTheColumnBefore", [case])
    case["expected"] = {}
    assert complaints("part4_simulate", "part4.StaysFiniteOnALongRun", [case]) == []
    case = case_of("part3_step", q=[0, 0.14, 0], v=[0, -1, 0])  # lands flat, in the fourth step
    assert complaints("part3_step", "a check", [case]) == []
    case["expected"]["steps"] = "decidable"
    assert complaints("part3_step", "a check", [case])
