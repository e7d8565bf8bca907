"""Grading a class again: the changes are shown first, and applied on request."""

import json
from pathlib import Path
from typing import Any

import pytest
from bounce_grader.classroom.work import log, results
from bounce_grader.common.errors import UsageError
from bounce_grader.common.manifest import parts
from classes import book, COLUMN, column, download, grade_class, graded, points_of
from conftest import write


def test_results_of_another_kit_are_refused_and_kept(
    tmp_path: Path, users: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    grade_class(source, out)
    before = {f: f.read_bytes() for f in out.rglob("*.*") if f.is_file() and f.name != "log.jsonl"}
    monkeypatch.setattr(results, "__version__", "99")
    with pytest.raises(UsageError, match="another version of the kit: add --regrade all"):
        grade_class(source, out)
    assert {f: f.read_bytes() for f in before} == before


@pytest.mark.parametrize(
    "changed",
    [
        "grader/bounce_grader/grading/judging.py",
        "grader/bounce_grader/classroom/work/unit.py",
        "grader/runner/prelude.sed",
        "tests/parts/cases.cpp",
    ],
)
def test_another_kit_is_known_wherever_it_lies(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, changed: str
) -> None:
    """Even in a folder with the name of one of the kit's own."""
    root = tmp_path / "classroom" / "formats"
    folders = {"ROOT": root, "CONTRACT": root / "student/include", "HANDOUT": root / "student"}
    for name, folder in folders.items():
        monkeypatch.setattr(results, name, folder)
    needed = ("grader/bounce_grader/classroom/work/unit.py", "grader/parts.json")
    later = ("grader/bounce_grader/formats/html.py", "tests/kit/judge/judge_test.cpp")
    write(root, {name: b"0" for name in (*needed, *later)})
    write(root, {changed: b"1"})
    before = results._kit_digest()
    write(root, {name: b"changed" for name in later})
    assert results._kit_digest() == before
    write(root, {changed: b"2"})
    assert results._kit_digest() != before


def spoil_one(out: Path) -> dict[str, Any]:
    """Makes one stored result another than what grading gives. Returns the check that fails in
    it."""
    spoilt = next(f for f in sorted((out / "results").iterdir()) if f.name != "set.json")
    old = json.loads(spoilt.read_bytes())
    first = old["record"]["parts"][0]
    check: dict[str, Any] = next(check for check in first["checks"] if check["passed"])
    check["score"], check["passed"] = 0, False
    old["record"]["score"] -= check["max_score"]
    first["score"] -= check["max_score"]
    spoilt.write_text(json.dumps(old))
    return check


def test_regrading_without_a_difference_leaves_nothing_in_the_way(
    tmp_path: Path, users: list[int], capsys: pytest.CaptureFixture[str]
) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    grade_class(source, out)
    for chosen in ("all", "student=101"):
        capsys.readouterr()
        assert grade_class(source, out, regrade=chosen) == 0
        assert "There is nothing to take over." in capsys.readouterr().out
    assert len(results.keys(out / "regrade")) == 1


def weigh(out: Path, weights: dict[str, float]) -> None:
    """Makes the stored results those of a kit where checks have other points."""
    for file in (out / "results").iterdir():
        if file.name == "set.json":
            continue
        result = json.loads(file.read_bytes())
        record = result["record"]
        for part in record["parts"]:
            for check in part["checks"]:
                check["max_score"] = weights.get(check["id"], check["max_score"])
                check["score"] = check["max_score"] * check["passed"]
            part["score"] = sum(check["score"] for check in part["checks"])
        record["score"] = sum(part["score"] for part in record["parts"])
        file.write_text(json.dumps(result))


def test_new_weights_are_told_once_and_then_who_has_other_points(
    tmp_path: Path, users: list[int], capsys: pytest.CaptureFixture[str]
) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    grade_class(source, out)
    one, other = parts()[0].checks[:2]
    weigh(out, {one.id: one.points + 2, other.id: other.points - 2})
    capsys.readouterr()
    grade_class(source, out, regrade="all")
    lines = capsys.readouterr().out.splitlines()
    assert lines[1:3] == [
        f"  {one.id} gives {one.points + 2:g} -> {one.points:g} points",
        f"  {other.id} gives {other.points - 2:g} -> {other.points:g} points",
    ]
    told = lines[3:-1]
    assert f"other result: {len(told)}." in lines[0] and not any(line[0] == " " for line in told)
    for line in told:
        before, now = line.rpartition(": ")[2].split(" -> ")
        assert abs(float(before) - float(now)) == 2


def test_regrading_shows_what_would_change_before_it_does(
    tmp_path: Path,
    users: list[int],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    grade_class(source, out)
    check = spoil_one(out)
    grade_class(source, out)
    before = (out / "gradebook.csv").read_bytes()
    capsys.readouterr()

    monkeypatch.setattr(results, "__version__", "99")
    export = {"gradebook": book(tmp_path / "export.csv", users), "columns": {0: COLUMN}}
    assert grade_class(source, out, regrade="all", **export) == 0
    said = capsys.readouterr().out
    assert "Submissions graded again: 10; with another result: 1." in said
    assert "\nDoe, Jane (1" in said
    assert said.count("->") == 2 and f"  {check['id']}: failed -> passed" in said
    assert (out / "gradebook.csv").read_bytes() == before

    assert grade_class(source, out, apply=True) == 0
    expected = {str(user): points_of(user, tmp_path) for user in users}
    assert column(out / "gradebook.csv") == expected
    assert len(results.keys(out / "results-1")) == len(results.keys(out / "results")) == 10
    assert any(line["event"] == "applied" for line in log.read(out / "log.jsonl"))


def test_a_student_whom_only_the_grade_book_tells_is_missed_aloud(
    tmp_path: Path, users: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A file's own number makes its name in the download that of one of two users."""
    odd = {"doejane_120_5000_3_part2_lcp.cpp": b"// whose?"}
    source, out = download(tmp_path / "x.zip", users, odd), tmp_path / "out"
    export = {"gradebook": book(tmp_path / "export.csv", [*users, 120]), "columns": {0: COLUMN}}
    grade_class(source, out, **export)
    monkeypatch.setattr(results, "__version__", "99")
    grade_class(source, out, regrade="all")
    with pytest.raises(UsageError, match=r"hasn't graded all \(doejane\): .* same --gradebook"):
        grade_class(source, out, **export, apply=True)
    grade_class(source, out, **export, regrade="all")
    assert grade_class(source, out, **export, apply=True) == 0


def test_regrading_some_keeps_the_others(tmp_path: Path, users: list[int]) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    grade_class(source, out)
    assert grade_class(source, out, regrade="student=101") == 0
    assert len(results.keys(out / "regrade")) == 1
    assert grade_class(source, out, apply=True) == 0
    assert len(results.keys(out / "results")) == 10


def test_grading_again_is_in_the_log_though_the_kit_is_the_same(
    tmp_path: Path, users: list[int]
) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    grade_class(source, out)
    grade_class(source, out, regrade="student=101")
    assert len(graded(out)) == len(users) + 1


@pytest.mark.parametrize("chosen", ["student=Doe, Jane", "student=Doe*", "student=101"])
@pytest.mark.usual(1)
def test_a_student_is_chosen_by_the_name_of_the_grade_book(
    tmp_path: Path, users: list[int], chosen: str
) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    grade_class(source, out)
    assert grade_class(source, out, regrade=chosen) == 0
    assert len(results.keys(out / "regrade")) == (1 if "101" in chosen else len(users))


def test_a_set_that_was_not_taken_over_is_not_dropped(tmp_path: Path, users: list[int]) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    grade_class(source, out)
    spoil_one(out)
    grade_class(source, out, regrade="all")
    with pytest.raises(UsageError, match="holds what was graded again for 'all'"):
        grade_class(source, out, regrade="student=101")
    assert len(results.keys(out / "regrade")) == len(users)


def test_a_set_that_waits_for_slurm_shows_no_differences(
    tmp_path: Path, users: list[int], capsys: pytest.CaptureFixture[str]
) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    grade_class(source, out)
    capsys.readouterr()
    assert grade_class(source, out, regrade="student=101", engine="slurm") == 0
    said = capsys.readouterr().out
    assert said == "1 wait for a grading; then give the same command again.\n"


def test_an_exchange_that_was_cut_short_is_finished(tmp_path: Path, users: list[int]) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    grade_class(source, out)
    grade_class(source, out, regrade="all")
    (out / "regrade" / "apply").touch()
    (out / "results").rename(out / "results-1")
    grade_class(source, out)
    assert len(results.keys(out / "results")) == 10 and not (out / "regrade").exists()


@pytest.mark.parametrize(
    "words, sentence",
    [
        ({"regrade": "student"}, "doesn't know 'student'"),
        ({"regrade": "status=timed_out"}, "chooses no submission"),
        ({"apply": True}, "nothing to take over"),
        ({"gradebook": Path("x.csv")}, "needs --column"),
    ],
)
def test_wrong_usage_is_said_in_a_sentence(
    tmp_path: Path, users: list[int], words: dict[str, Any], sentence: str
) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    grade_class(source, out)
    if "gradebook" in words:
        words = {"gradebook": tmp_path / words["gradebook"]}
        words["gradebook"].write_text("Student,ID,SIS Login ID,Section\n")
    with pytest.raises(UsageError, match=sentence):
        grade_class(source, out, **words)


def test_regrading_before_grading_is_refused(tmp_path: Path, users: list[int]) -> None:
    with pytest.raises(UsageError, match="holds no results yet"):
        grade_class(download(tmp_path / "x.zip", users), tmp_path / "out", regrade="all")
