"""The fixtures: the same secret gives the same bytes, another secret gives other hidden cases, and
each of them gets wrong what should be."""

import json
import math
import shutil
from pathlib import Path
from typing import Any

import pytest
from bounce_grader.common.manifest import parts
from bounce_grader.grading import fixtures
from bounce_grader.publish import fixtures as published

SECRETS = ["a", "correct horse", "ü" * 200, ""]
Files = dict[str, bytes]


@pytest.fixture(scope="module")
def hidden(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    folders = [tmp_path_factory.mktemp("hidden") for _ in SECRETS]
    for folder, secret in zip(folders, SECRETS):
        fixtures.write("hidden", folder, secret)
    return folders


def files(folder: Path) -> Files:
    return {file.name: file.read_bytes() for file in folder.glob("*.json")}


def checks(folder: Path, stem: str) -> dict[str, list[Any]]:
    found: dict[str, list[Any]] = json.loads((folder / f"{stem}.json").read_text())["checks"]
    return found


def test_a_secret_gives_the_same_hidden_cases_and_another_one_others(
    hidden: list[Path], tmp_path: Path
) -> None:
    fixtures.write("hidden", tmp_path, SECRETS[0])
    assert files(tmp_path) == files(hidden[0])
    for other in hidden[1:]:
        assert all(text != files(other)[name] for name, text in files(tmp_path).items())
    fixtures.write("public", tmp_path, SECRETS[1])
    assert files(tmp_path) == files(fixtures.PUBLIC)


def test_every_secret_gives_every_check_cases_that_are_not_public(hidden: list[Path]) -> None:
    for part in parts():
        public = checks(fixtures.PUBLIC, part.stem)
        asked = {json.dumps(case["input"]) for cases in public.values() for case in cases}
        for folder in hidden:
            found = checks(folder, part.stem)
            assert list(found) == [check.id for check in part.checks] and all(found.values())
            assert not any(json.dumps(c["input"]) in asked for cs in found.values() for c in cs)


def phi(case: dict[str, Any]) -> float:
    _, y, theta = case["input"]["q"]
    return float(y - case["params"]["l"] / 2 * (abs(math.sin(theta)) + abs(math.cos(theta))))


def test_what_is_often_wrong_gets_a_case_wrong(hidden: list[Path]) -> None:
    """Another threshold than delta, or one that is written down; a corner that is never lowest."""
    for folder in (fixtures.PUBLIC, *hidden):
        step, contacts = checks(folder, "part3_step"), checks(folder, "part1_contacts")
        near = [phi(c) / c["params"]["delta"] for c in step["part3.TouchesBelowDelta"]]
        for factor in (0, 0.5, 0.9, 1.1, 1.2, 1.3, 2, 3):
            assert any(min(factor, 1) < height < max(factor, 1) for height in near), factor
        numbers = step["part3.TakesEveryNumberFromTheParameters"]
        low = [c for c in numbers if c["name"] == "0 < phi < delta" and phi(c) > 0.001]
        assert low and all(c["params"]["delta"] > 0.001 for c in low)
        corners = {case["contact"] for case in contacts["part1.TurnsHoweverFar"]}
        assert corners == {f"corner {k} is the lowest" for k in (1, 2, 3, 4)}


def test_the_committed_ones_are_what_the_kit_writes_and_a_byte_of_difference_is_noticed(
    tmp_path: Path,
) -> None:
    published.write_cases(tmp_path)
    shutil.copytree(fixtures.PUBLIC / "mistakes", tmp_path / "public" / "mistakes")
    assert not published.differing(tmp_path)
    file = tmp_path / "public" / "part2_lcp.json"
    file.write_bytes(file.read_bytes().replace(b"0", b"1", 1))
    (tmp_path / "public" / "part5.json").write_text("{}")
    assert published.differing(tmp_path) == ["public/part2_lcp.json", "public/part5.json"]
