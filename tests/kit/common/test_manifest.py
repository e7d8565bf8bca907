"""The manifest of parts and checks: what an instructor may change in it, and what is refused."""

import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from bounce_grader import cli
from bounce_grader.common import manifest
from bounce_grader.common.errors import UsageError
from conftest import ROOT

Manifest = dict[str, Any]


@pytest.fixture
def changed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[[Any], Any]]:
    """Reads a changed manifest beside the kit's own tests."""
    folder = tmp_path / "grader"
    folder.mkdir()
    (tmp_path / "tests").symlink_to(ROOT / "tests")
    monkeypatch.setattr(manifest, "ROOT", tmp_path)

    def read(change: Callable[[Manifest], object] | str) -> Any:
        text = (ROOT / "grader" / "parts.json").read_text()
        if isinstance(change, str):
            text = change
        else:
            words = json.loads(text)
            change(words)
            text = json.dumps(words)
        (folder / "parts.json").write_text(text)
        manifest.parts.cache_clear()
        return manifest.parts()

    yield read
    manifest.parts.cache_clear()


def check(words: Manifest, part: int = 0, number: int = 0) -> Manifest:
    found: Manifest = words["parts"][part]["checks"][number]
    return found


@pytest.mark.parametrize(
    "change, sentence",
    [
        (lambda w: check(w).update(points=7), "part 1 gives 30 points, and its checks 31 together"),
        (lambda w: check(w).update(points=-6), "have to be a number that isn't negative"),
        (lambda w: check(w).update(points="6"), "have to be a number that isn't negative"),
        (lambda w: check(w).update(points=True), "have to be a number that isn't negative"),
        (lambda w: check(w).update(points=float("nan")), "have to be a number"),
        (lambda w: check(w).update(id="part1.NoSuchCheck"), "has no check part1.NoSuchCheck"),
        (lambda w: check(w).update(id=check(w, 0, 1)["id"]), "is there twice"),
        (lambda w: check(w).pop("title"), "has to have an id, a title and points"),
        (lambda w: w["parts"][1].pop("title"), "part 2 lacks its 'title'"),
        (lambda w: w["parts"][1].update(part=3), "entry 2 isn't part 2"),
        (lambda w: w["parts"].clear(), "it lists no parts"),
        (lambda w: w.pop("parts"), "can't be read as JSON with a list of parts"),
        ('{"parts": [', "can't be read as JSON"),
    ],
)
def test_a_manifest_that_does_not_add_up_is_refused_in_a_sentence(
    changed: Callable[[Any], Any], change: Any, sentence: str
) -> None:
    with pytest.raises(UsageError) as refused:
        changed(change)
    assert sentence in str(refused.value) and "\n" not in str(refused.value)


def test_a_wrong_manifest_ends_a_command_before_it_builds_anything(
    changed: Callable[[Any], Any], capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(UsageError):
        changed(lambda w: check(w).update(points=7))
    assert cli.check_manifest() == 2
    assert capsys.readouterr().err.startswith("kit: grader/parts.json: part 1 gives 30 points")


def leave_out_the_first(words: Manifest) -> None:
    part = words["parts"][0]
    part["points"] -= part["checks"].pop(0)["points"]


def test_a_check_can_be_left_out_and_weights_can_change(changed: Callable[[Any], Any]) -> None:
    parts = changed(leave_out_the_first)
    assert (len(parts[0].checks), parts[0].points) == (5, 24)

    def weigh(words: Manifest) -> None:
        check(words).update(points=16.5)
        words["parts"][0]["points"] += 10.5

    assert changed(weigh)[0].points == 40.5
