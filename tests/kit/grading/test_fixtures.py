"""The fixtures: the same secret gives the same bytes, and another secret gives other hidden cases."""

import json
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
