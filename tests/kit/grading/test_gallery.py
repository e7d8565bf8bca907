"""The gallery of submissions: each must get exactly the points that a person wrote down for it.

tests/submissions/README.md says what a folder holds.
"""

import io
import shutil
from pathlib import Path
from typing import Any

import pytest
from bounce_grader.build.compile import compile_all
from bounce_grader.build.linking import link_alone, link_together
from bounce_grader.common.files import temporary_folder
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import STUBS, WORK_FOLDER
from bounce_grader.formats import terminal
from bounce_grader.grading import gallery, known_mistakes, sanitizing
from bounce_grader.grading.fixtures import write as write_fixtures
from bounce_grader.grading.gallery import expected, Expected, in_reduced_box
from bounce_grader.grading.grade import grade, Options
from bounce_grader.grading.judging import judge
from bounce_grader.sandbox import box as boxes
from bounce_grader.submission.submission import read
from conftest import ROOT, SOLUTION, lost, points

GALLERY = ROOT / "tests" / "submissions"
KINDS = ("accepted", "mistakes", "rarely_wrong", "undefined", "broken", "hostile")


def folders(kind: str) -> list[Path]:
    return sorted(folder for folder in (GALLERY / kind).iterdir() if folder.is_dir())


ALL = [folder for kind in KINDS for folder in folders(kind)]
MISTAKES = folders("mistakes")
every_accepted = pytest.mark.parametrize(
    "folder", [pytest.param(f, id=f.name, marks=pytest.mark.long) for f in folders("accepted")]
)


def name_of(folder: Path) -> str:
    return f"{folder.parent.name}/{folder.name}"


def submission_of(folder: Path, to: Path) -> Path:
    """The solution with the folder's files laid over it; or the folder alone, if it says so."""
    if not expected(folder).get("alone"):
        shutil.copytree(SOLUTION, to)
    ignore = shutil.ignore_patterns("expected.json", "*.md")
    shutil.copytree(folder, to, dirs_exist_ok=True, ignore=ignore)
    return to


def shown(record: dict[str, Any]) -> str:
    stream = io.StringIO()
    terminal.show(record, stream)
    return stream.getvalue()


@pytest.mark.parametrize("folder", ALL, ids=name_of)
def test_gets_what_it_should(folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A mistake is named as itself, or as its twin with the same answers; nothing else is. What
    sanitizers add to a crash takes ten times as long as the grading: the long run tries it."""
    monkeypatch.setattr(sanitizing, "with_cause", lambda part, judged, *_: judged)
    record = grade(submission_of(folder, tmp_path / "submission"))
    gets(expected(folder), record)
    named = [mistake["name"] for part in record["parts"] for mistake in part["mistakes"]]
    mistakes = [folder.name] if folder in MISTAKES else []
    assert named == [expected(folder).get("recognised_as", name) for name in mistakes]


CRASHING = [folder for folder in ALL if "crashed" in expected(folder).get("status", {}).values()]


@pytest.mark.long
@pytest.mark.parametrize("folder", CRASHING, ids=name_of)
def test_a_crash_gets_the_same_with_its_cause(folder: Path, tmp_path: Path) -> None:
    gets(expected(folder), grade(submission_of(folder, tmp_path / "submission")))


REMARKED = [folder for folder in folders("undefined") if "remark" in expected(folder)]
SOME_REMARKED = [  # sanitizers take long: two in each run
    pytest.param(folder, id=folder.name, marks=[pytest.mark.long] * (number > 1))
    for number, folder in enumerate(REMARKED)
]


@pytest.mark.parametrize("folder", SOME_REMARKED)
def test_undefined_behaviour_is_remarked(folder: Path) -> None:
    """Without the other parts, which would be looked at, too."""
    text = shown(grade(folder, Options(sanitize=True)))
    assert f"  remark, no points: {expected(folder)['remark']}" in text


@every_accepted
def test_a_right_submission_gets_no_remark(folder: Path, tmp_path: Path) -> None:
    record = grade(submission_of(folder, tmp_path / "submission"), Options(sanitize=True))
    assert not any(part["remarks"] for part in record["parts"]), shown(record)


# Its part 3 calls a function of its part 1, and doesn't link without it.
NEEDS_PART_1 = GALLERY / "accepted" / "helper_defined_in_part1"


@every_accepted
def test_a_right_part_loses_nothing_beside_stubs(folder: Path, tmp_path: Path) -> None:
    if folder == NEEDS_PART_1:
        pytest.skip("it doesn't link without its own part 1")
    submission = submission_of(folder, tmp_path / "submission")
    for stub in sorted(STUBS.glob("part[12]*.cpp")):
        for path in submission.rglob(stub.name):
            shutil.copy(stub, path)
    assert points(grade(submission))[2:] == [30, 10]


WRONG = [f for f in (*MISTAKES, *folders("rarely_wrong")) if not f.name.startswith("part4")]
RIGHT = [f for f in folders("accepted") if f != NEEDS_PART_1 and not expected(f).get("alone")]


@pytest.mark.parametrize("number, wrong", enumerate(WRONG), ids=lambda x: getattr(x, "name", ""))
@pytest.mark.long
def test_a_wrong_part_costs_the_right_ones_nothing(
    number: int, wrong: Path, tmp_path: Path
) -> None:
    """The right ones are of another submission each time."""
    submission = submission_of(RIGHT[number % len(RIGHT)], tmp_path / "submission")
    for file in wrong.glob("*.cpp"):
        shutil.copy(file, submission)
    lost_parts = {check.split(".")[0] for check in lost(grade(submission))}
    assert lost_parts == {wrong.name.split("_")[0]}


@pytest.fixture(scope="module")
def hidden_of_secrets(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    found = [tmp_path_factory.mktemp("secret") / "hidden" for _ in range(5)]
    for number, folder in enumerate(found):
        write_fixtures("hidden", folder, f"secret {number}")
    return found


@every_accepted
def test_a_right_submission_loses_nothing_under_any_secret(
    folder: Path, tmp_path: Path, hidden_of_secrets: list[Path]
) -> None:
    """With its own earlier parts, or with given ones, as a grading tries it."""
    submission, box = read(submission_of(folder, tmp_path / "submission")), boxes.choose()
    with temporary_folder(WORK_FOLDER) as work:
        box.give(work)
        objects = compile_all(submission, work, box, 1)
        together = link_together(objects, work / "together", box)
        for part in parts():
            alone = link_alone(part, objects, work / part.stem, box)
            for hidden in hidden_of_secrets:
                assert any(
                    runner.path
                    and judge(part, runner.path, given, hidden, box).score(part) == part.points
                    for runner, given in ((together, False), (alone, bool(part.calls)))
                )


IN_BOTH = [folder for folder in ALL if "reduced" in expected(folder)]


@pytest.mark.long
@pytest.mark.parametrize("folder", IN_BOTH, ids=name_of)
def test_gets_what_it_should_in_the_reduced_box(folder: Path, tmp_path: Path) -> None:
    """For submissions that attack the box, or write a file in it."""
    submission = submission_of(folder, tmp_path / "submission")
    record = grade(submission, Options(boxes=("reduced",)))
    assert record["box"] == "reduced"
    gets(in_reduced_box(expected(folder)), record)


def gets(words: Expected, record: dict[str, Any]) -> None:
    statuses = {f"part{p['part']}": p["status"] for p in record["parts"] if p["status"] != "graded"}
    text = shown(record)
    assert points(record) == gallery.points(words["lost"]), text
    assert lost(record) == sorted(words["lost"]) and statuses == words.get("status", {}), text
    assert all(sentence in text for sentence in words.get("says", [])), text
    assert not any(sentence in text for sentence in words.get("never", [])), text


def test_every_mistake_is_in_the_fixtures_and_loses_points_in_one_part_alone() -> None:
    """Raises with a sentence that says what a folder lacks."""
    alone = {m.name for m in known_mistakes.gallery() if m.recognised_as == m.name}
    assert alone == set(known_mistakes.known()), "run ./kit fixtures"
    for folder in MISTAKES:
        left = gallery.points(expected(folder)["lost"])
        assert sum(p < part.points for p, part in zip(left, parts())) == 1, folder.name
