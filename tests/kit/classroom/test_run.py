"""A class from its download to its grade book, with a quick stand-in for grading."""

import csv
import io
import zipfile
from collections.abc import Iterator
from pathlib import Path

import pytest
from bounce_grader import cli
from bounce_grader.classroom import run
from bounce_grader.classroom.work import results
from bounce_grader.common.errors import UsageError
from classes import COLUMN, book, column, download, grade_class, graded, points_of, text_of
from conftest import solution_files, write


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


@pytest.mark.parametrize(
    "same, sentence",
    [
        (0, ""),
        (1, "One of them equals another letter for letter: equal ones are graded once."),
        (2, "2 of them equal others letter for letter: equal ones are graded once."),
    ],
)
def test_equal_submissions_are_graded_once_and_that_is_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], same: int, sentence: str
) -> None:
    copies = {f"roe_{user}_{user}0_part2_lcp.cpp": text_of(101) for user in range(201, 201 + same)}
    grade_class(download(tmp_path / "x.zip", [101], copies), tmp_path / "out")
    said = capsys.readouterr()
    assert "1 of 1 graded" in said.err
    first, second = said.out.splitlines()[:2]
    assert first == f"{1 + same} of {1 + same} submissions graded (a Canvas download)."
    assert second == sentence or not sentence


def test_no_row_of_the_grade_book_is_found_by_a_login_that_students_choose(tmp_path: Path) -> None:
    checkout = tmp_path / "hw3-submissions"
    for login in ("101", "jdoe"):
        write(checkout / f"hw3-{login}", {**solution_files(), ".git/HEAD": b""})
    export = book(tmp_path / "export.csv", [101])
    with pytest.raises(UsageError, match="can't be matched with GitHub logins"):
        grade_class(checkout, tmp_path / "out", gradebook=export, columns={0: COLUMN})


def test_corrections_in_the_grade_book_outlive_the_next_weeks(
    tmp_path: Path, users: list[int]
) -> None:
    """One is corrected in Canvas, one hands in anew; both exports come from Canvas again."""
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    book(tmp_path / "export.csv", users)
    grade_class(source, out, gradebook=tmp_path / "export.csv", columns={0: COLUMN})
    filled = (out / "gradebook.csv").read_text()
    first = column(out / "gradebook.csv")
    corrected = filled.replace(f",{first['101']}", ",12.34", 1)
    assert corrected != filled
    (tmp_path / "export.csv").write_text(corrected)
    for _ in range(2):
        grade_class(source, out, gradebook=tmp_path / "export.csv", columns={0: COLUMN})
        assert column(out / "gradebook.csv") == {**first, "101": "12.34"}
    assert "keeps 12.34 in" in (out / "class.html").read_text()
    more = {"gradebook": tmp_path / "export.csv", "columns": {0: COLUMN}, "overwrite": True}
    grade_class(source, out, **more)
    assert column(out / "gradebook.csv") == first


def test_only_pages_that_changed_go_back_again(
    tmp_path: Path, users: list[int], capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    grade_class(download(tmp_path / "x.zip", users[:-1]), out)
    assert not (out / "feedback-new.zip").exists()
    assert "\nUpload feedback.zip, with 9 pages.\n" in capsys.readouterr().out
    for said in ("Upload feedback-new.zip, with 1 page that changed", "No page has changed"):
        grade_class(download(tmp_path / "y.zip", users), out)
        assert f"\n{said} since the last run" in capsys.readouterr().out
        with zipfile.ZipFile(out / "feedback-new.zip") as archive:
            assert archive.namelist() == ["doejane_110_1100_feedback.html"]
        with zipfile.ZipFile(out / "feedback.zip") as archive:
            assert len(archive.namelist()) == len(users)


def test_an_anonymous_download_and_anothers_grade_book_are_refused(
    tmp_path: Path, users: list[int]
) -> None:
    text = solution_files()["part2_lcp.cpp"]
    with zipfile.ZipFile(tmp_path / "anonymous.zip", "w") as archive:
        archive.writestr("anon_a1B2c_9_part2_lcp.cpp", text)
    export = book(tmp_path / "export.csv", [999])
    with pytest.raises(UsageError, match="is of an anonymous assignment"):
        grade_class(
            tmp_path / "anonymous.zip", tmp_path / "a", gradebook=export, columns={0: COLUMN}
        )
    with pytest.raises(UsageError, match="none of the 10 students"):
        grade_class(
            download(tmp_path / "x.zip", users),
            tmp_path / "b",
            gradebook=export,
            columns={0: COLUMN},
        )


def test_a_second_run_grades_nothing_and_writes_the_same(
    tmp_path: Path, users: list[int], capsys: pytest.CaptureFixture[str]
) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    grade_class(source, out)
    names = ("gradebook.csv", "grades.csv", "class.html", "feedback.zip")
    first = [(out / name).read_bytes() for name in names]
    written = {f.name: f.stat().st_mtime_ns for f in (out / "results").iterdir()}
    capsys.readouterr()
    grade_class(source, out)
    assert [(out / name).read_bytes() for name in names] == first
    with zipfile.ZipFile(out / "feedback.zip") as archive:
        assert {page.date_time for page in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}
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
    assert timed == [False, True, True]  # existing times are kept
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


def test_the_command_takes_it_all(tmp_path: Path, users: list[int]) -> None:
    """One complete run, with real gradings of the solution, through the options of ./kit."""
    with zipfile.ZipFile(tmp_path / "x.zip", "w") as archive:
        for number, (name, text) in enumerate(solution_files().items()):
            archive.writestr(f"doejane_12_{number + 1}_{name}", text)
    export = book(tmp_path / "export.csv", [12])
    out = tmp_path / "out"
    arguments = ["class", str(tmp_path / "x.zip"), "--out", str(out), "--gradebook", str(export)]
    assert cli.main([*arguments, "--column", COLUMN]) == 0
    assert column(out / "gradebook.csv") == {"12": "100.00"}
    assert cli.main([*arguments, "--column", COLUMN, "--part-column", "5=x"]) == 2


def test_no_kind_of_line_pushes_another_off_the_terminal() -> None:
    """A student's forty oddly named uploads leave room for what concerns others."""
    odd, copies = [f"odd {i}" for i in range(99)], ["two are alike"]
    assert run._shared([odd, [], ["a remark"], copies], 40) == [*odd[:38], "a remark", *copies]
    assert run._shared([odd, odd, [], copies], 9) == [*odd[:4], *odd[:4], *copies]
    assert run._shared([[], copies, [], []], 9) == copies


def test_a_remark_with_a_file_of_such_a_name_hides_no_line_of_another_student() -> None:
    own = "Doe, Jane (1) has no score, because part 1: crashed: the cell stays as it was"
    named = "x (1) because part 1: crashed: .txt is no C++ source and no zip"
    of_another = (
        f"Roe, Max (2) has no score, because it holds nothing: {named}: the cell stays as it was"
    )
    assert run._is_said([own], "(1)", "part 1: crashed")
    assert not run._is_said([of_another], "(1)", "part 1: crashed")


def test_the_output_folder_is_its_owners_alone(tmp_path: Path) -> None:
    with run._locked(tmp_path / "out"):
        assert (tmp_path / "out").stat().st_mode & 0o077 == 0
