"""The fixtures: the same secret gives the same bytes, another secret gives other hidden cases."""

import json
from pathlib import Path

import oracle
import pytest
from bounce_grader.common.manifest import parts
from bounce_grader.grading import fixtures
from bounce_grader.publish import fixtures as published

Cases = dict[str, list[dict[str, object]]]


def written(kind: str, folder: Path) -> dict[str, bytes]:
    fixtures.write(kind, folder, fixtures.secret())
    return {file.name: file.read_bytes() for file in folder.iterdir()}


def with_secret(monkeypatch: pytest.MonkeyPatch, secret: str) -> None:
    monkeypatch.setattr(fixtures, "secret", lambda: secret)


def test_the_committed_ones_are_what_the_solution_writes() -> None:
    assert published.differing() == []


def test_a_byte_of_difference_is_noticed(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    fixtures.write("public", tmp_path)
    file = tmp_path / "part2_lcp.json"
    file.write_bytes(file.read_bytes().replace(b"0", b"1", 1))
    (tmp_path / "part5.json").write_text("{}")
    monkeypatch.setattr(published, "PUBLIC", tmp_path)
    assert published.differing() == ["public/part2_lcp.json", "public/part5.json"]


def test_the_same_secret_gives_the_same_bytes(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    with_secret(monkeypatch, "ours")
    assert written("hidden", tmp_path / "a") == written("hidden", tmp_path / "b")


def test_another_secret_gives_other_hidden_cases_and_the_same_public_ones(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    with_secret(monkeypatch, "ours")
    hidden, public = written("hidden", tmp_path / "a"), written("public", tmp_path / "b")
    with_secret(monkeypatch, "theirs")
    other = written("hidden", tmp_path / "c")
    assert written("public", tmp_path / "d") == public
    assert all(hidden[name] != other[name] for name in hidden)


@pytest.mark.parametrize("secret", ["a", "b", "correct horse", "ü" * 200, ""])
def test_every_secret_gives_every_check_its_cases(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, secret: str
) -> None:
    fixtures.write("hidden", tmp_path, secret)
    for part in parts():
        checks: Cases = json.loads((tmp_path / f"{part.stem}.json").read_text())["checks"]
        assert list(checks) == [check.id for check in part.checks]
        assert all(cases for cases in checks.values())


def test_no_hidden_input_is_a_public_one(tmp_path: Path) -> None:
    def inputs(folder: Path) -> set[str]:
        return {
            json.dumps(case["input"])
            for part in parts()
            for cases in json.loads((folder / f"{part.stem}.json").read_text())["checks"].values()
            for case in cases
        }

    fixtures.write("hidden", tmp_path)
    assert not inputs(tmp_path) & inputs(fixtures.PUBLIC)


def heights_in_deltas(folder: Path) -> list[float]:
    """phi / delta of the cases about the threshold."""
    file = json.loads((folder / "part3_step.json").read_text())
    found = []
    for case in file["checks"]["part3.TouchesBelowDelta"]:
        params = oracle.Parameters.read(case["params"])
        contact = oracle.get_contacts(oracle.vector(case["input"]["q"]), params)
        found.append(float(contact.phi / params.delta))
    return found


@pytest.mark.parametrize("factor", [0, 0.5, 0.9, 1.1, 1.2, 1.3, 2, 3])
def test_another_threshold_than_delta_gets_a_case_wrong(tmp_path: Path, factor: float) -> None:
    fixtures.write("hidden", tmp_path)
    for folder in (tmp_path, fixtures.PUBLIC):
        wrong = [h for h in heights_in_deltas(folder) if min(factor, 1) < h < max(factor, 1)]
        assert wrong, folder


def test_a_threshold_that_is_written_down_gets_a_case_wrong(tmp_path: Path) -> None:
    """A corner above 0.001 m is in contact if delta is larger."""
    fixtures.write("hidden", tmp_path)
    for folder in (tmp_path, fixtures.PUBLIC):
        file = json.loads((folder / "part3_step.json").read_text())
        cases = file["checks"]["part3.TakesEveryNumberFromTheParameters"]
        low = [c for c in cases if c["name"] == "0 < phi < delta" and c["params"]["delta"] > 0.001]
        heights = [
            oracle.get_contacts(
                oracle.vector(case["input"]["q"]), oracle.Parameters.read(case["params"])
            ).phi
            for case in low
        ]
        assert low and all(phi > 0.001 for phi in heights)


def test_each_corner_is_the_lowest_after_many_turns(tmp_path: Path) -> None:
    fixtures.write("hidden", tmp_path)
    for folder in (tmp_path, fixtures.PUBLIC):
        file = json.loads((folder / "part1_contacts.json").read_text())
        corners = {case["contact"] for case in file["checks"]["part1.TurnsHoweverFar"]}
        assert corners == {f"corner {k} is the lowest" for k in (1, 2, 3, 4)}
