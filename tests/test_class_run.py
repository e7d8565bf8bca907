"""A class from its download to its grade book, with a stand-in for grading that is quick."""

import csv
import io
import json
import os
import random
import signal
import subprocess
import sys
import tempfile

import time
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import stand_in
from bounce_grader import cli, submission
from bounce_grader.classroom import grading, log, results, run
from bounce_grader.errors import KitError, UsageError
from conftest import ROOT, solution_files, write

COLUMN = "HW3 (98765)"
STAND_IN = ROOT / "tests" / "stand_in.py"


def text_of(user: int) -> bytes:
    return f"// part 2 of {user}\n".encode()


def download(path: Path, users: list[int], extra: dict[str, bytes] | None = None) -> Path:
    with zipfile.ZipFile(path, "w") as archive:
        for user in users:
            archive.writestr(f"doejane_{user}_{user}0_part2_lcp.cpp", text_of(user))
        for name, data in (extra or {}).items():
            archive.writestr(name, data)
    return path


def book(path: Path, users: list[int]) -> Path:
    lines = [f"Student,ID,SIS Login ID,Section,{COLUMN}", "    Points Possible,,,,100.00"]
    lines += [f'"Doe, Jane",{user},l{user},S,' for user in users]
    path.write_text("\n".join(lines) + "\n")
    return path


def points_of(user: int, tmp_path: Path) -> str:
    """What the stand-in gives, worked out without the class."""
    folder = write(tmp_path / "alone" / str(user), {"part2_lcp.cpp": text_of(user)})
    return f"{stand_in.record_of(submission.read(folder))['score']:.2f}"


def column(path: Path) -> dict[str, str]:
    rows = list(csv.reader(io.StringIO(path.read_text())))
    return {row[1]: row[4] for row in rows[2:]}


def graded(out: Path) -> list[str]:
    return [line["result"] for line in log.read(out / "log.jsonl") if line["event"] == "graded"]


def grade_class(source: Path, out: Path, **more: Any) -> int:
    return run.run(stand_in.request(source, out, **more))


@pytest.fixture
def users() -> list[int]:
    return list(range(101, 111))


def test_writes_all_that_it_promises(tmp_path: Path, users: list[int]) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    export = book(tmp_path / "export.csv", [*users, 999])
    before = export.read_bytes()
    assert grade_class(source, out, gradebook=export, columns={0: COLUMN}) == 0
    expected = {str(user): points_of(user, tmp_path) for user in users}
    assert column(out / "gradebook.csv") == {**expected, "999": ""}
    assert export.read_bytes() == before
    rows = list(csv.DictReader(io.StringIO((out / "grades.csv").read_text("utf-8-sig"))))
    assert {row["id"]: f"{float(row['score']):.2f}" for row in rows} == expected
    assert len(list((out / "feedback").iterdir())) == len(users)
    with zipfile.ZipFile(out / "feedback.zip") as archive:
        assert archive.read("doejane_101_1010_feedback.html").startswith(b"<!doctype html>")
    assert "Doe, Jane (999) has no submission" in (out / "class.html").read_text()
    assert sorted(graded(out)) == sorted(results.keys(out / "results"))


def test_a_second_run_grades_nothing_and_writes_the_same(
    tmp_path: Path, users: list[int], capsys: pytest.CaptureFixture[str]
) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    grade_class(source, out)
    names = ("gradebook.csv", "grades.csv", "class.html")
    first = [(out / name).read_bytes() for name in names]
    written = {f.name: f.stat().st_mtime_ns for f in (out / "results").iterdir()}
    capsys.readouterr()
    grade_class(source, out)
    assert [(out / name).read_bytes() for name in names] == first
    assert {f.name: f.stat().st_mtime_ns for f in (out / "results").iterdir()} == written
    assert len(graded(out)) == len(users)


def test_answers_of_hidden_cases_are_on_the_pages_where_that_is_asked_for(
    tmp_path: Path, users: list[int]
) -> None:
    """Later, too, and without grading anything again."""
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    answer = "expected phi = 0.8128"
    for reveal in (False, True, False):
        grade_class(source, out, reveal=reveal)
        pages = [page.read_text() for page in (out / "feedback").iterdir()]
        with zipfile.ZipFile(out / "feedback.zip") as archive:
            pages += [archive.read(name).decode() for name in archive.namelist()]
        assert [answer in page for page in pages] == [reveal] * 2 * len(users)
        others = [out / "class.html", out / "grades.csv", out / "gradebook.csv"]
        assert not any(answer in file.read_text() for file in others)
    assert len(graded(out)) == len(users)


def test_times_are_added_to_grades_that_are_there(tmp_path: Path, users: list[int]) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    timed = ["Nothing was timed" not in text for text in _pages_of_three_runs(source, out)]
    assert timed == [False, True, True]  # times that are there stay
    assert len(graded(out)) == 2 * len(users)
    grades = (out / "grades.csv").read_text()
    grade_class(source, out, regrade="all", speed=True)
    grade_class(source, out, apply=True)
    assert (out / "grades.csv").read_text() == grades


def _pages_of_three_runs(source: Path, out: Path) -> Iterator[str]:
    """Without, with, and again without times."""
    for speed in (False, True, False):
        grade_class(source, out, speed=speed)
        yield (out / "class.html").read_text()


def test_only_what_is_new_is_graded(tmp_path: Path, users: list[int]) -> None:
    out = tmp_path / "out"
    grade_class(download(tmp_path / "x.zip", users[:9]), out)
    grade_class(download(tmp_path / "x.zip", users), out)
    assert len(graded(out)) == len(set(graded(out))) == len(users)


def test_equal_submissions_share_a_result(tmp_path: Path) -> None:
    same = {f"roe_{user}_{user}0_part2_lcp.cpp": b"// the same" for user in (201, 202)}
    out = tmp_path / "out"
    grade_class(download(tmp_path / "x.zip", [], same), out)
    assert len(graded(out)) == 1
    assert len(list((out / "feedback").iterdir())) == 2


def test_a_grading_that_kills_its_worker_costs_nobody_else(
    tmp_path: Path, users: list[int], capsys: pytest.CaptureFixture[str]
) -> None:
    bad = {
        "roe_301_3010_part2_lcp.cpp": b"// kills its grader",
        "poe_302_3020_part2_lcp.cpp": b"// breaks the kit",
    }
    out = tmp_path / "out"
    assert grade_class(download(tmp_path / "x.zip", users, bad), out) == 3
    said = capsys.readouterr().out
    assert "roe (301): the kit failed: its process ended with status -9" in said
    assert "poe (302): the kit failed: no compiler" in said
    got = column(out / "gradebook.csv")
    assert got == {str(user): points_of(user, tmp_path) for user in users}
    failed = [line for line in log.read(out / "log.jsonl") if line["event"] == "failed"]
    assert len(failed) == 2 * grading.TRIES
    assert not any("roe" in page.name for page in (out / "feedback").iterdir())


def test_a_students_failure_is_a_result_and_is_not_tried_again(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    encrypted = {"roe_301_3010_hw.zip": b"PK\x03\x04 and then nothing"}
    out = tmp_path / "out"
    source = download(tmp_path / "x.zip", [101], encrypted)
    assert grade_class(source, out) == 0
    assert "roe (301): the submission is broken" in capsys.readouterr().out
    assert "301" not in column(out / "gradebook.csv")
    page = (out / "feedback" / "roe_301_3010_feedback.html").read_text()
    assert "Not graded" in page and str(tmp_path) not in page
    grade_class(source, out)
    assert len(graded(out)) == 2


def test_a_broken_result_is_graded_again(tmp_path: Path, users: list[int]) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    grade_class(source, out)
    first = (out / "gradebook.csv").read_bytes()
    torn, empty, *_ = sorted(f for f in (out / "results").iterdir() if f.name != "set.json")
    torn.write_bytes(torn.read_bytes()[:100])
    empty.write_bytes(b"")
    (out / "gradebook.csv").unlink()
    grade_class(source, out)
    assert (out / "gradebook.csv").read_bytes() == first


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


def test_regrading_shows_what_would_change_before_it_does(
    tmp_path: Path,
    users: list[int],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    grade_class(source, out)
    spoilt = next(f for f in (out / "results").iterdir() if f.name != "set.json")
    old = json.loads(spoilt.read_bytes())
    first = old["record"]["parts"][0]
    check = next(check for check in first["checks"] if check["passed"])
    check["score"], check["passed"] = 0, False
    old["record"]["score"] -= check["max_score"]
    first["score"] -= check["max_score"]
    spoilt.write_text(json.dumps(old))
    grade_class(source, out)
    before = (out / "gradebook.csv").read_bytes()
    capsys.readouterr()

    monkeypatch.setattr(results, "__version__", "99")
    assert grade_class(source, out, regrade="all") == 0
    said = capsys.readouterr().out
    assert "10 submissions were graded again; 1 differ." in said
    assert f"  {check['id']}: 0 -> {check['max_score']:g}" in said
    assert (out / "gradebook.csv").read_bytes() == before

    assert grade_class(source, out, apply=True) == 0
    expected = {str(user): points_of(user, tmp_path) for user in users}
    assert column(out / "gradebook.csv") == expected
    assert len(results.keys(out / "results-1")) == len(results.keys(out / "results")) == 10
    assert any(line["event"] == "applied" for line in log.read(out / "log.jsonl"))


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


def test_ctrl_c_says_how_to_go_on_wherever_it_comes(
    tmp_path: Path,
    users: list[int],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    def stop(*_: object) -> None:
        raise KeyboardInterrupt

    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    for place in ("similar.find", "task_of", "students.read"):
        monkeypatch.setattr(f"bounce_grader.classroom.run.{place}", stop)
        assert grade_class(source, out) == 130
        assert "Run the same command again to go on." in capsys.readouterr().err


def test_pages_of_what_is_gone_go(tmp_path: Path) -> None:
    out = tmp_path / "out"
    first = {"roe_301_3010_part2_lcp.cpp": b"// one", "poe_302_3020_part2_lcp.cpp": b"// x"}
    grade_class(download(tmp_path / "x.zip", [], first), out)
    (out / "feedback" / "mine.html").write_text("<title>of the teacher</title>")
    again = {"roe_301_3011_part2_lcp-1.cpp": b"// two"}
    grade_class(download(tmp_path / "x.zip", [], again), out)
    pages = {page.name for page in (out / "feedback").iterdir()}
    assert pages == {"roe_301_3011_feedback.html", "mine.html"}


def test_who_handed_in_no_file_to_grade_gets_a_page(tmp_path: Path) -> None:
    """Canvas takes back those that have the number of an attachment."""
    odd = {"roe_301_text.html": b"see my mail", "poe_302_3020_photo.jpg": b""}
    odd |= {"roe_101_text.html": b"and a remark"}
    out = tmp_path / "out"
    grade_class(download(tmp_path / "x.zip", [101], odd), out)
    pages = {page.name: page.read_text() for page in (out / "feedback").iterdir()}
    assert pages.keys() == {
        "doejane_101_1010_feedback.html",
        "roe_301_text_feedback.html",
        "poe_302_3020_feedback.html",
    }
    assert "Hand in the four parts" in pages["roe_301_text_feedback.html"]
    assert "photo.jpg is no C++ source and no zip" in pages["poe_302_3020_feedback.html"]
    with zipfile.ZipFile(out / "feedback.zip") as archive:
        assert set(archive.namelist()) == pages.keys() - {"roe_301_text_feedback.html"}
    assert "<b>3</b>submissions" in (out / "class.html").read_text()


def test_what_may_be_a_missing_part_needs_a_look(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    part = "part2_lcp.cpp"
    odd = {
        f"roe_301_1_{part}": b"// 1",
        "roe_301_2_part1.rar": b"Rar!",
        f"roe_302_3_{part}": b"// 2",
        "roe_302_4_part1.cpp": b"// misnamed",
        f"roe_303_5_{part}": b"// 3",
        "roe_303_6_part1_contacts.cpp.txt": b"// misnamed",
    }
    zipped = download(tmp_path / "in.zip", [], {part: b"// 4", "part1.rar": b"Rar!"})
    odd["roe_304_7_hw.zip"] = zipped.read_bytes()
    out = tmp_path / "out"
    grade_class(download(tmp_path / "x.zip", [101], odd), out)
    said = capsys.readouterr().out
    assert "4 need a look" in said
    for looks in (said, (out / "class.html").read_text()):
        assert looks.count("parts 1 and 3 and 4 not there, but ") == 4
        assert looks.count("part1.rar") >= 2
        assert "part1.cpp is no part by its name" in looks
        assert "part1_contacts.cpp.txt" in looks


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
    with pytest.raises(UsageError, match=sentence):
        grade_class(source, out, **words)


def test_regrading_before_grading_is_refused(tmp_path: Path, users: list[int]) -> None:
    with pytest.raises(UsageError, match="holds no results yet"):
        grade_class(download(tmp_path / "x.zip", users), tmp_path / "out", regrade="all")


def test_a_grade_book_that_was_filled_stays_in_a_run_without_one(
    tmp_path: Path, users: list[int], capsys: pytest.CaptureFixture[str]
) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    export = book(tmp_path / "export.csv", users)
    grade_class(source, out)
    grade_class(download(tmp_path / "y.zip", users[:5]), out)
    assert len(column(out / "gradebook.csv")) == 5  # a made-up one follows the class
    grade_class(source, out, gradebook=export, columns={0: COLUMN})
    filled = (out / "gradebook.csv").read_bytes()
    capsys.readouterr()
    assert grade_class(source, out) == 0
    assert (out / "gradebook.csv").read_bytes() == filled
    assert "stays as it was: give --gradebook" in capsys.readouterr().out


def test_who_handed_in_what_has_no_score_is_told_from_who_handed_in_nothing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    odd = {
        "roe_301_text.html": b"see my mail",
        "roe_302_3020_photo.jpg": b"",
        "roe_303_3030_hw.zip": b"PK\x03\x04 and then nothing",
    }
    export = book(tmp_path / "export.csv", [101, 301, 302, 303, 304])
    out = tmp_path / "out"
    source = download(tmp_path / "x.zip", [101], odd)
    grade_class(source, out, gradebook=export, columns={0: COLUMN})
    said = capsys.readouterr().out
    assert "(301) has no score, because roe_301_text.html is text typed into Canvas" in said
    assert "(302) has no score, because roe_302_3020 holds nothing that can be graded" in said
    assert "(303) has no score, because the submission is broken" in said
    assert "(304) has no submission: the cell stays as it was" in said


@pytest.mark.parametrize(
    "words, sentence",
    [
        (["--regrade", ""], "--regrade needs a FILTER"),
        (["--part-column", "1=A"], "--part-column needs --gradebook"),
        (["--part-column", "1=A", "--part-column", "1=B", "--gradebook", "x"], "twice for part 1"),
    ],
)
def test_options_that_would_be_lost_are_refused(
    tmp_path: Path, words: list[str], sentence: str, capsys: pytest.CaptureFixture[str]
) -> None:
    source = download(tmp_path / "x.zip", [101])
    assert cli.main(["class", str(source), "--out", str(tmp_path / "out"), *words]) == 2
    assert sentence in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_the_export_itself_is_never_overwritten(tmp_path: Path, users: list[int]) -> None:
    export = book(tmp_path / "gradebook.csv", users)
    before = export.read_bytes()
    with pytest.raises(UsageError, match="would be overwritten"):
        grade_class(
            download(tmp_path / "x.zip", users), tmp_path, gradebook=export, columns={0: COLUMN}
        )
    assert export.read_bytes() == before


def test_a_wrong_grade_book_stops_the_run_before_it_begins(
    tmp_path: Path, users: list[int]
) -> None:
    export = book(tmp_path / "export.csv", users)
    with pytest.raises(UsageError, match="no column"):
        grade_class(
            download(tmp_path / "x.zip", users),
            tmp_path / "out",
            gradebook=export,
            columns={0: "HW4 (1)"},
        )
    assert not (tmp_path / "out").exists()


def test_one_run_at_a_time(tmp_path: Path, users: list[int]) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    with started(source, out, seconds=0.5):
        wait_for(lambda: (out / "results" / "set.json").exists())
        with pytest.raises(UsageError, match="another run is under way"):
            grade_class(source, out)


def started(source: Path, out: Path, seconds: float = 0.0) -> Any:
    environment = {**os.environ, "PYTHONPATH": f"{ROOT / 'grader'}:{ROOT / 'tests'}"}
    command = [sys.executable, str(STAND_IN), str(source), str(out), str(seconds)]
    return subprocess.Popen(
        command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )


def wait_for(happened: Any, seconds: float = 60.0) -> None:
    end = time.monotonic() + seconds
    while not happened():
        assert time.monotonic() < end
        time.sleep(0.01)


@pytest.fixture
def short_folder() -> Iterator[Path]:
    """Sockets are made in TMPDIR, and their paths may have a hundred letters."""
    with tempfile.TemporaryDirectory() as name:
        yield Path(name)


def test_ctrl_c_stops_and_says_how_to_go_on(
    tmp_path: Path, users: list[int], short_folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    monkeypatch.setenv("TMPDIR", str(short_folder))
    process = started(source, out, seconds=2)
    wait_for(lambda: len(results.keys(out / "results")) >= 2)
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=30)
    assert process.returncode != 0
    assert "of 10 submissions are graded and kept. Run the same command again to go on." in said
    assert not [left for left in short_folder.iterdir() if left.name.startswith("bounce-")]
    there = results.keys(out / "results")
    assert 2 <= len(there) < 10
    assert grade_class(source, out) == 0
    assert len(graded(out)) == len(set(graded(out))) == 10


def test_gradings_end_with_the_class(tmp_path: Path, users: list[int]) -> None:
    """Where it is killed, nothing goes on behind its back."""
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    process = started(source, out, seconds=2.0)
    wait_for(lambda: len(results.keys(out / "results")) >= 1)
    process.kill()
    process.communicate()
    there = results.keys(out / "results")
    time.sleep(3.0)
    assert results.keys(out / "results") == there


@pytest.mark.parametrize(
    "number, kills",
    [
        pytest.param(20, 4, marks=pytest.mark.slow),
        pytest.param(100, 20, marks=pytest.mark.long),
    ],
)
def test_survives_being_killed_at_any_moment(tmp_path: Path, number: int, kills: int) -> None:
    """No result is lost, none is there twice, none half, and the grade book is as if undisturbed."""
    users = list(range(101, 101 + number))
    source = download(tmp_path / "x.zip", users)
    export = book(tmp_path / "export.csv", users)
    chance = random.Random(number)
    out = tmp_path / "out"
    known: set[str] = set()
    for _ in range(kills):
        process = started(source, out, seconds=0.02)
        time.sleep(chance.uniform(0.05, 1.5))
        process.kill()
        process.communicate()
        there = results.keys(out / "results")
        assert known <= there
        known = {key for key in there if results.load(out / "results", key)}
        assert known == there, "a result is half-written"
    grade_class(source, out, gradebook=export, columns={0: COLUMN})
    assert len(graded(out)) == len(set(graded(out))) == number
    left = [file for file in out.rglob(".*.part")]
    for file in left:
        os.utime(file, (0, 0))
    grade_class(source, tmp_path / "calm", gradebook=export, columns={0: COLUMN})
    for name in ("gradebook.csv", "grades.csv", "class.html"):
        assert (out / name).read_bytes() == (tmp_path / "calm" / name).read_bytes()
    grade_class(source, out)
    assert not any(file.exists() for file in left)


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """A file system of half a megabyte."""
    folder = tmp_path / "disk"
    folder.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=512k", "tmpfs", str(folder)]
    if subprocess.run(mount, capture_output=True, check=False).returncode != 0:
        pytest.skip("mounting needs root")
    yield folder
    subprocess.run(["umount", str(folder)], check=True)


def test_a_full_disk_loses_nothing(
    tmp_path: Path, users: list[int], small_disk: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    source, out = download(tmp_path / "x.zip", users), small_disk / "out"
    grade_class(download(tmp_path / "y.zip", users[:4]), out)
    before = {f: f.read_bytes() for f in out.rglob("*.json")}
    filler = small_disk / "filler"
    with pytest.raises(OSError), filler.open("wb", buffering=0) as file:
        while True:
            file.write(bytes(1024))
    capsys.readouterr()
    with pytest.raises(KitError, match="is full: make room, and run the same command again"):
        grade_class(source, out)
    for kept, data in before.items():
        assert kept.read_bytes() == data
    for key in results.keys(out / "results"):
        assert results.load(out / "results", key)
    filler.unlink()
    assert grade_class(source, out) == 0
    expected = {str(user): points_of(user, tmp_path) for user in users}
    assert column(out / "gradebook.csv") == expected
    assert len(graded(out)) == len(set(graded(out))) == 10


def test_names_are_only_text(tmp_path: Path) -> None:
    """Umlauts, an apostrophe, a formula, a mark that turns the line round, and markup."""
    folder = tmp_path / "all"
    names = ["=HYPERLINK('x')", "O'Brien", "Müller", "a\u202eb", "<b>bold", "a&b,c;d"]
    for name in names:
        write(folder / name, {"part2_lcp.cpp": name.encode()})
    out = tmp_path / "out"
    grade_class(folder, out)
    rows = list(csv.DictReader(io.StringIO((out / "grades.csv").read_text("utf-8-sig"))))
    shown = {row["student"] for row in rows}
    assert shown == {"'=HYPERLINK('x')", "O'Brien", "Müller", "a\ufffdb", "<b>bold", "a&b,c;d"}
    page = (out / "class.html").read_text()
    assert "<b>bold" not in page and "\u202e" not in page and "&lt;b&gt;bold" in page
    assert {f.name for f in (out / "feedback").iterdir()} == {f"{name}.html" for name in names}


def test_names_that_are_no_text_are_names_all_the_same(tmp_path: Path) -> None:
    folder = tmp_path / "all"
    odd = os.fsdecode(b"ann\xe4")
    write(folder, {f"{odd}/part2_lcp.cpp": b"// x", f"{odd}/notes\udcfc.txt": b""})
    out = tmp_path / "out"
    assert grade_class(folder, out) == 0
    assert {f.name for f in (out / "feedback").iterdir()} == {f"{odd}.html"}
    assert "ann\ufffd" in (out / "class.html").read_text()
    assert "notes\ufffd.txt" in (out / "grades.csv").read_text()


def test_a_page_of_a_thousand_is_small(tmp_path: Path) -> None:
    entries = {f"doe{user}_{user}_{user}0_part2_lcp.cpp": text_of(user) for user in range(1000)}
    source = download(tmp_path / "x.zip", [], entries)
    from bounce_grader.classroom import page, students
    from bounce_grader.classroom.similar import Pair, Similar
    from bounce_grader.classroom.summary import of_result

    found = students.read(source)
    summaries = []
    for student in found.students:
        folder = write(tmp_path / "one", {"part2_lcp.cpp": text_of(int(student.id))})
        record = stand_in.record_of(submission.read(folder))
        result = {"state": "graded", "message": "", "record": record}
        summaries.append(of_result(student, "0" * 64, result))
    pairs = tuple(Pair("1", "2", 90) for _ in range(200))
    text = page.render(found, summaries, Similar(pairs, 40), [])
    assert len(text.encode()) < 3_000_000
    assert "http" not in text.replace("http-equiv", "")
    assert text.count("<circle cx=") + text.count("l8 8m0-8l-8 8") == 1000
    assert text.count('<path class="way ') == 1002


def test_the_command_takes_it_all(tmp_path: Path, users: list[int]) -> None:
    """The whole way once, with real gradings of the solution, through ./kit's own options."""
    with zipfile.ZipFile(tmp_path / "x.zip", "w") as archive:
        for number, (name, text) in enumerate(solution_files().items()):
            archive.writestr(f"doejane_12_{number + 1}_{name}", text)
    export = book(tmp_path / "export.csv", [12])
    out = tmp_path / "out"
    arguments = ["class", str(tmp_path / "x.zip"), "--out", str(out), "--gradebook", str(export)]
    assert cli.main([*arguments, "--column", COLUMN]) == 0
    assert column(out / "gradebook.csv") == {"12": "100.00"}
    assert cli.main([*arguments, "--column", COLUMN, "--part-column", "5=x"]) == 2


@pytest.mark.parametrize("changed", ["grader/bounce_grader/judging.py", "tests/cases.cpp"])
def test_another_kit_is_known_wherever_it_lies(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, changed: str
) -> None:
    """As in a folder that is named like one of its own."""
    root = tmp_path / "classroom" / "formats"
    for name in ("ROOT", "CONTRACT", "HANDOUT"):
        monkeypatch.setattr(results, name, root)
    write(root, {changed: b"1", "grader/bounce_grader/formats/html.py": b""})
    before = results._kit_digest()
    write(root, {"grader/bounce_grader/formats/html.py": b"changed"})
    assert results._kit_digest() == before
    write(root, {changed: b"2"})
    assert results._kit_digest() != before
