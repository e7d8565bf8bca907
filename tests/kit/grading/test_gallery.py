"""The gallery of submissions: each must get exactly the points that a person wrote down for it.

tests/submissions/README.md says what a folder holds.
"""

import io
import json
import shutil
from pathlib import Path
from typing import Any

import pytest
from bounce_grader.common.manifest import parts
from bounce_grader.formats import terminal
from bounce_grader.grading.grade import grade, Options
from bounce_grader.grading.known_mistakes import gallery, known
from conftest import ROOT, SOLUTION, lost, points

GALLERY = ROOT / "tests" / "submissions"
KINDS = ("accepted", "mistakes", "broken", "hostile")


def folders(kind: str) -> list[Path]:
    return sorted(folder for folder in (GALLERY / kind).iterdir() if folder.is_dir())


ALL = [folder for kind in KINDS for folder in folders(kind)]


def name_of(folder: Path) -> str:
    return f"{folder.parent.name}/{folder.name}"


def expected_of(folder: Path) -> dict[str, Any]:
    expected: dict[str, Any] = json.loads((folder / "expected.json").read_text())
    return expected


def submission_of(folder: Path, to: Path) -> Path:
    """The folder over the solution; or the folder alone, where it says so."""
    if not expected_of(folder).get("alone"):
        shutil.copytree(SOLUTION, to)
    ignore = shutil.ignore_patterns("expected.json", "*.md")
    shutil.copytree(folder, to, dirs_exist_ok=True, ignore=ignore)
    return to


def shown(record: dict[str, Any]) -> str:
    stream = io.StringIO()
    terminal.show(record, stream)
    return stream.getvalue()


def named(record: dict[str, Any]) -> list[str]:
    """The known mistakes that the record names."""
    return [mistake["name"] for part in record["parts"] for mistake in part["mistakes"]]


def known_as(folder: Path) -> list[str]:
    """A mistake is named as itself, or as the twin that has the same numbers; nothing else is."""
    own = [folder.name] if folder.parent.name == "mistakes" else []
    return [expected_of(folder).get("recognised_as", name) for name in own]


# One in twelve, and the rest in the whole run.
SOME = [pytest.param(f, marks=[pytest.mark.slow] if i % 12 else []) for i, f in enumerate(ALL)]


@pytest.mark.parametrize("folder", SOME, ids=name_of)
def test_gets_what_it_should(folder: Path, tmp_path: Path) -> None:
    record = grade(submission_of(folder, tmp_path / "submission"))
    gets(expected_of(folder), record)
    assert named(record) == known_as(folder), shown(record)


BOXED = [folder for folder in folders("hostile") if "reduced" in expected_of(folder)]


@pytest.mark.slow
@pytest.mark.parametrize("folder", BOXED, ids=name_of)
def test_gets_what_it_should_in_the_reduced_box(folder: Path, tmp_path: Path) -> None:
    """Those whose attack is on what a box holds."""
    expected = expected_of(folder)
    submission = submission_of(folder, tmp_path / "submission")
    record = grade(submission, Options(boxes=("reduced",)))
    assert record["box"] == "reduced"
    gets({**expected, **expected["reduced"]}, record)


def gets(expected: dict[str, Any], record: dict[str, Any]) -> None:
    statuses = {f"part{p['part']}": p["status"] for p in record["parts"] if p["status"] != "graded"}
    text = shown(record)
    got = (points(record), lost(record), statuses)
    assert got == (
        expected["points"],
        sorted(expected.get("lost", [])),
        expected.get("status", {}),
    ), text
    for sentence in expected.get("says", []):
        assert sentence in text
    for sentence in expected.get("never", []):
        assert sentence not in text


@pytest.mark.parametrize("folder", ALL, ids=name_of)
def test_is_written_down_rightly(folder: Path) -> None:
    """Points and lost checks belong together, so that neither was copied from a grader's mouth."""
    expected = expected_of(folder)
    gone = set(expected.get("lost", []))
    assert gone <= {check.id for part in parts() for check in part.checks}
    assert expected["points"] == [
        sum(check.points for check in part.checks if check.id not in gone) for part in parts()
    ]


@pytest.mark.parametrize(
    "kind, least", [("accepted", 12), ("mistakes", 120), ("broken", 16), ("hostile", 85)]
)
def test_the_gallery_is_large_enough(kind: str, least: int) -> None:
    assert len(folders(kind)) >= least


def test_every_right_submission_has_all_points() -> None:
    for folder in folders("accepted"):
        assert sum(expected_of(folder)["points"]) == 100, folder.name


def test_every_mistake_is_in_the_fixtures() -> None:
    """Raises with a sentence that says what a folder lacks."""
    alone = {m.name for m in gallery() if m.recognised_as == m.name}
    assert alone == set(known()), "run ./kit fixtures"


def test_a_mistake_loses_points_in_one_part_alone() -> None:
    for folder in folders("mistakes"):
        got = expected_of(folder)["points"]
        assert sum(p < part.points for p, part in zip(got, parts())) == 1, folder.name
