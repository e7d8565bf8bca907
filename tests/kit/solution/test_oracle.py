"""The oracle confirms every number of the fixtures, and that right programs can't differ on any."""

from __future__ import annotations

import copy
import json
import os
from pathlib import Path
from typing import Any

import pytest
from oracle import complaints

ROOT = Path(__file__).resolve().parents[3]
MANIFEST = json.loads((ROOT / "grader/parts.json").read_text())["parts"]
STEMS = [part["stem"] for part in MANIFEST]
FIRST_NUMBER = {"part1_contacts": "phi", "part2_lcp": "V", "part3_step": "q", "part4_simulate": "q"}
LANDS_FLAT = [0, 0.1, 0.0]  # both corners are the lowest


def folders() -> dict[str, Path]:
    """The folders of fixtures: public has to be there, hidden only where it is asked for."""
    hidden = Path(os.environ.get("BOUNCE_HIDDEN") or ROOT / "fixtures/hidden")
    public = {"public": ROOT / "fixtures/public"}
    return public | ({"hidden": hidden} if hidden.is_dir() else {})


def content(folder: Path, stem: str) -> dict[str, Any]:
    return dict(json.loads((folder / f"{stem}.json").read_text()))


@pytest.mark.parametrize("folder", folders())
@pytest.mark.parametrize("part", MANIFEST, ids=STEMS)
def test_the_oracle_confirms_every_number(folder: str, part: dict[str, Any]) -> None:
    stem = part["stem"]
    fixtures = content(folders()[folder], stem)
    assert fixtures["stem"] == stem
    assert set(fixtures["checks"]) == {check["id"] for check in part["checks"]}
    for check, cases in fixtures["checks"].items():
        assert cases, f"{check} has no case"
        assert complaints(stem, check, cases) == []


@pytest.mark.parametrize("stem", STEMS)
def test_it_refuses_a_number_that_is_off_by_1e_11_and_what_is_undecidable(stem: str) -> None:
    key: Any = FIRST_NUMBER[stem]
    checks = content(folders()["public"], stem)["checks"]
    check = next(name for name, cases in checks.items() if cases[0]["expected"].get(key))
    wrong = copy.deepcopy(checks[check][0])
    holder = wrong["expected"]
    while isinstance(holder[key], list):
        holder, key = holder[key], 0
    holder[key] += 1e-11 * max(1, abs(holder[key]))
    (found,) = complaints(stem, check, [wrong])
    assert ", difference " in found
    if stem in ("part1_contacts", "part3_step"):
        wrong["input"]["q"] = LANDS_FLAT
        assert "undecidable: the second corner" in complaints(stem, check, [wrong])[0]
