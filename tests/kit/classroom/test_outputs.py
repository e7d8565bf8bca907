"""The outputs of a class: pages, names and the grade book, and options that would spoil them."""

import csv
import io
import os
import zipfile
from pathlib import Path

import pytest
import stand_in
from bounce_grader import cli
from bounce_grader.common.errors import UsageError
from bounce_grader.submission import submission
from classes import COLUMN, book, column, download, grade_class, text_of
from conftest import write


# --- pages ---


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
    """Canvas imports only pages whose names have the id of an attachment."""
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
    assert (
        "Hand in the parts, part1_contacts.cpp to part4_simulate.cpp"
        in pages["roe_301_text_feedback.html"]
    )
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
        assert looks.count("parts 1, 3 and 4 not there, but ") == 4
        assert looks.count("part1.rar") >= 2
        assert "part1.cpp is no part by its name" in looks
        assert "part1_contacts.cpp.txt" in looks


def test_parts_of_other_names_alone_are_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    odd = {f"roe_301_{number}_Part {number}.cpp": b"// misnamed" for number in (1, 2, 3, 4)}
    out = tmp_path / "out"
    grade_class(download(tmp_path / "x.zip", [101], odd), out)
    reason = "none of the parts is there under its name, but Part 1.cpp, Part 2.cpp, Part 3.cpp"
    assert f"{reason}, Part 4.cpp" in capsys.readouterr().out
    assert reason in next((out / "feedback").glob("roe_301_*")).read_text()


def test_a_page_of_a_thousand_is_small(tmp_path: Path) -> None:
    entries = {f"doe{user}_{user}_{user}0_part2_lcp.cpp": text_of(user) for user in range(1000)}
    source = download(tmp_path / "x.zip", [], entries)
    from bounce_grader.classroom.intake import students
    from bounce_grader.classroom.output import page
    from bounce_grader.classroom.work.near_copies import Pair, Similar
    from bounce_grader.classroom.work.summary import of_result

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
    assert text.count('<path class="curve ') == 1002


# --- names ---


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


# --- the grade book ---


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


def test_an_export_older_than_the_last_import_is_said(
    tmp_path: Path, users: list[int], capsys: pytest.CaptureFixture[str]
) -> None:
    source, out = download(tmp_path / "x.zip", users), tmp_path / "out"
    export = book(tmp_path / "export.csv", users)
    said = []
    for newer in (False, False, True):
        if newer:
            export.write_bytes((out / "gradebook.csv").read_bytes())
        grade_class(source, out, gradebook=export, columns={0: COLUMN})
        said.append("lacks what an earlier run has filled in" in capsys.readouterr().out)
    assert said == [False, True, False]


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
    once = ("roe_301_text.html", "roe_302_3020", "the submission is broken")
    assert [said.count(name) for name in once] == [1, 1, 1]  # and not again below


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
