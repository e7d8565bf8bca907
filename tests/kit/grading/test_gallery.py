"""The gallery of submissions: each must get exactly the points that a person wrote down for it.

tests/submissions/README.md says what a folder holds.
"""

import json
import shutil
from functools import partial
from pathlib import Path
from typing import Any

import on_paper
import pytest
from bounce_grader.common.paths import STUBS
from bounce_grader.formats import terminal
from bounce_grader.grading import fixtures, judging
from bounce_grader.grading.grade import grade, Options
from bounce_grader.grading.known_mistakes import check_ids, expected
from bounce_grader.grading.report import report
from conftest import ROOT, SOLUTION, lost, points
from handed_in import points_without, submission_of

GALLERY = ROOT / "tests" / "submissions"
LARGEST_RECORD = 100_000  # characters, whatever a submission holds
KINDS = ("accepted", "mistakes", "rarely_wrong", "undefined", "broken", "hostile")


def folders(kind: str) -> list[Path]:
    return sorted(folder for folder in (GALLERY / kind).iterdir() if folder.is_dir())


ALL = [folder for kind in KINDS for folder in folders(kind)]
MISTAKES = folders("mistakes")
RIGHT = [SOLUTION, *folders("accepted")]
BESIDE_STUBS = [folder for folder in RIGHT if [*folder.rglob("part[34]*.cpp")]]


def each(folders: list[Path]) -> pytest.MarkDecorator:
    """A test of each folder in the long run, without the solution's parts around it."""
    rows = [pytest.param(folder, id=folder.name, marks=pytest.mark.long) for folder in folders]
    return pytest.mark.parametrize("folder", rows)


def name_of(folder: Path) -> str:
    return f"{folder.parent.name}/{folder.name}"


@pytest.mark.parametrize("folder", ALL, ids=name_of)
def test_gets_what_it_should(folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A mistake is named as itself, or as its twin with the same answers; nothing else is. What
    sanitizers add to a crash takes ten times as long as the grading: the long run tries it."""
    monkeypatch.setattr(judging, "with_cause", lambda part, judged, *_: judged)
    record = grade(submission_of(folder, tmp_path / "submission"))
    gets(expected(folder), record)
    named = [name for part in record["parts"] for name in part["mistakes"]]
    if folder.parent.name in ("mistakes", "rarely_wrong"):
        can_be_found_on_paper(record, expected(folder).get("on_paper", True))
    mistakes = [folder.name] if folder in MISTAKES else []
    assert named == [expected(folder).get("recognised_as", name) for name in mistakes]


def can_be_found_on_paper(record: dict[str, Any], is_shown: bool) -> None:
    """Each part with wrong numbers: by a case with three numbers at most, beside which stands what
    is right by the oracle."""
    for part in filter(on_paper.lost_by_numbers, report(record)["parts"]):
        smallest = part["smallest"]
        assert bool(smallest) == is_shown, part
        if not smallest:
            continue
        assert on_paper.numbers_to_think_of(smallest) <= 3, smallest
        assert on_paper.is_right(part["part"], smallest), smallest
        assert smallest["got"] != smallest["expected"]


REMARKED = [folder for folder in folders("undefined") if "remark" in expected(folder)]


@pytest.mark.parametrize("folder", REMARKED, ids=name_of)
def test_undefined_behaviour_is_remarked(folder: Path) -> None:
    """Without the other parts, which would be looked at, too."""
    text = terminal.render(report(grade(folder, Options(sanitize=True))))
    assert f"  remark, no points: {expected(folder)['remark']}" in text


def test_a_part_that_only_gcc_takes_is_remarked(tmp_path: Path) -> None:
    """Its sanitizers' code calls clang's library."""
    part = shutil.copytree(GALLERY / "undefined" / "part1_random_number_too_large", tmp_path / "in")
    file = part / "part1_contacts.cpp"
    file.write_text(f"#ifdef __clang__\n#error\n#endif\n{file.read_text()}")
    text = terminal.render(report(grade(part, Options(sanitize=True))))
    assert "remark, no points: part1_contacts.cpp:13: an integer grows" in text


@each(RIGHT)
def test_a_right_part_gets_no_remark(folder: Path) -> None:
    record = grade(folder, Options(sanitize=True))
    assert_all_points(record)
    remarks = [remark["id"] for part in record["parts"] for remark in part["remarks"]]
    assert set(remarks) <= {"defines_main"}


# Its part 3 calls a function of its part 1, and doesn't link without it.
NEEDS_PART_1 = GALLERY / "accepted" / "helper_defined_in_part1"


@each(BESIDE_STUBS)
def test_a_right_part_loses_nothing_beside_stubs(folder: Path, tmp_path: Path) -> None:
    if folder == NEEDS_PART_1:
        pytest.skip("it doesn't link without its own part 1")
    submission = shutil.copytree(folder, tmp_path / "submission")
    for stub in sorted(STUBS.glob("part[12]*.cpp")):
        for path in [submission / stub.name, *submission.rglob(stub.name)]:
            shutil.copy(stub, path)
    assert_all_points({"parts": grade(submission)["parts"][2:]})


@pytest.fixture(scope="module")
def hidden_of_secrets(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    found = [tmp_path_factory.mktemp("secret") / "hidden" for _ in range(5)]
    for number, folder in enumerate(found):
        fixtures.write("hidden", folder, f"secret {number}")
    return found


@each(RIGHT)
def test_a_right_part_loses_nothing_under_any_secret(
    folder: Path, hidden_of_secrets: list[Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    for hidden in hidden_of_secrets:
        monkeypatch.setattr(fixtures, "hidden_folder", partial(Path, hidden))
        assert_all_points(grade(folder))


def assert_all_points(record: dict[str, Any]) -> None:
    """Of the parts that are there."""
    own = [part for part in record["parts"] if part["status"] != "not_submitted"]
    assert own and all(part["score"] == part["max_score"] for part in own), own


CRASHING = [folder for folder in ALL if "crashed" in expected(folder).get("status", {}).values()]
# Those that attack the box, or write a file in it.
IN_BOTH = [folder for folder in ALL if "reduced" in expected(folder)]
OTHERWISE = [(folder, "full") for folder in CRASHING] + [(folder, "reduced") for folder in IN_BOTH]


@pytest.mark.long
@pytest.mark.parametrize("folder, box", OTHERWISE, ids=lambda x: getattr(x, "name", x))
def test_gets_what_it_should_with_a_crashs_cause_and_in_each_box(
    folder: Path, box: str, tmp_path: Path
) -> None:
    submission = submission_of(folder, tmp_path / "submission")
    record = grade(submission, Options(boxes=(box,)))
    assert record["box"] == box
    words = expected(folder)
    gets(words | words["reduced"] if box == "reduced" else words, record)


def gets(words: dict[str, Any], record: dict[str, Any]) -> None:
    statuses = {f"part{p['part']}": p["status"] for p in record["parts"] if p["status"] != "graded"}
    text, ids = terminal.render(report(record)), check_ids(words["lost"])
    assert points(record) == points_without(ids), text
    assert lost(record) == sorted(ids) and statuses == words.get("status", {}), text
    assert all(sentence in text for sentence in words.get("says", [])), text
    assert not any(sentence in text for sentence in words.get("never", [])), text
    assert len(json.dumps(record)) < LARGEST_RECORD, text
