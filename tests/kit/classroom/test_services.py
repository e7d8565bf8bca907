"""Moodle's and Blackboard's downloads and grade files, with names as students have them."""

import html
import io
import tarfile
import zipfile
from pathlib import Path
from typing import Any

import pytest
import services
from bounce_grader.classroom.intake import moodle, students
from bounce_grader.common.errors import UsageError
from classes import download, grade_class, points_of, text_of
from conftest import write
from downloads import to_grade
from services import FIRST, NAMES, USERS


def a_zip(files: dict[str, bytes]) -> bytes:
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as archive:
        for name, text in files.items():
            archive.writestr(name, text)
    return data.getvalue()


def moodle_class(path: Path, form: str = "/", absent: int = -1) -> Path:
    """Every way of naming that Moodle has; the submissions are a file, some a zip."""
    entries: dict[str, bytes] = {}
    for number in range(len(NAMES)):
        if number == absent:
            continue
        text = {"part2_lcp.cpp": text_of(number)}
        files = text if number % 4 or form == "_" else {"hw.zip": a_zip(text)}
        entries |= {f"{services.moodle_prefix(number)}{form}{n}": t for n, t in files.items()}
    return download(path, [], entries)


def points(number: int, tmp_path: Path) -> str:
    return points_of(number, tmp_path)


@pytest.mark.parametrize("form", ["/", "_/", "_"])
@pytest.mark.usual(1)
def test_moodles_worksheet_gets_the_points_of_each_participant(tmp_path: Path, form: str) -> None:
    sheet = services.worksheet(
        tmp_path / "sheet.csv", {FIRST + 1: "7.00", FIRST + 2: "-"}, locked=5
    )
    before, out = sheet.read_bytes(), tmp_path / "out"
    source = moodle_class(tmp_path / "x.zip", form, absent=3)
    assert grade_class(source, out, gradebook=sheet) == 0
    filled = services.moodle_grades((out / "gradebook.csv").read_bytes())
    for number in range(len(NAMES)):
        name, grade = filled[FIRST + number]
        assert name == services.full_name(number)
        kept = {1: "7.00", 3: "", 5: ""}
        assert grade == kept.get(number, points(number, tmp_path))
    assert sheet.read_bytes() == before
    page = (out / "class.html").read_text()
    assert "keeps 7.00 in Grade" in page and "lets nobody change here" in page
    pages = services.moodle_feedback(out / "feedback.zip")
    assert pages.keys() == {FIRST + n for n in range(len(NAMES)) if n != 3}
    assert all(page.startswith(b"<!doctype html>") for page in pages.values())


def test_what_was_typed_gets_a_page_that_says_so(tmp_path: Path) -> None:
    of_moodle = {
        "Ann B_9_assignsubmission_onlinetext/onlinetext.html": b"",
        "Bo C_8_assignsubmission_file/part2_lcp.cpp": b"// x",
    }
    grade_class(download(tmp_path / "m.zip", [], of_moodle), tmp_path / "m")
    page = services.moodle_feedback(tmp_path / "m" / "feedback.zip")[9]
    assert b"text typed into Moodle" in page
    when = "2026-11-20-23-15-42"
    of_blackboard = services.blackboard_entries(0, when, {})
    of_blackboard |= services.blackboard_entries(1, when, {"part2_lcp.cpp": b"// x"})
    grade_class(download(tmp_path / "b.zip", [], of_blackboard), tmp_path / "b")
    pages = tmp_path / "b" / "feedback"
    assert "text typed into Blackboard" in (pages / f"{USERS[0]}.html").read_text()


@pytest.mark.parametrize("name", ["hw.tar.gz", "hw.tgz", "hw.tar.xz"])
def test_a_tar_is_graded_from_each_service(tmp_path: Path, name: str) -> None:
    data = io.BytesIO()
    with tarfile.open(fileobj=data, mode="w:xz" if name.endswith("xz") else "w:gz") as archive:
        info = tarfile.TarInfo("hw/part2_lcp.cpp")
        info.size = len(text_of(1))
        archive.addfile(info, io.BytesIO(text_of(1)))
    when = "2026-11-20-23-15-42"
    for entry in (
        f"doejane_1_2_{name}",
        f"Ann B_9_assignsubmission_file/{name}",
        f"HW 3_b_{USERS[0]}_attempt_{when}_{name}",
    ):
        receipt = services.blackboard_entries(0, when, {}) if when in entry else {}
        source = download(tmp_path / "x.zip", [], {entry: data.getvalue(), **receipt})
        (student,) = students.read(source).students
        assert to_grade(student).files == {"part2_lcp.cpp": text_of(1)}


def test_moodles_folders_may_be_unpacked_and_commas_are_kept(tmp_path: Path) -> None:
    for number in range(len(NAMES)):
        folder = tmp_path / "class" / services.moodle_prefix(number)
        write(folder, {"src/part2_lcp.cpp": text_of(number), "rotation-1.hpp": b""})
    write(tmp_path / "class" / "Ann B_9_assignsubmission_onlinetext", {"onlinetext.html": b""})
    sheet = services.worksheet(tmp_path / "sheet.csv", comma=True)
    found = students.read(tmp_path / "class")
    assert "rotation-1.hpp" in to_grade(found.students[0]).files
    assert [entry.user for entry in found.unmatched] == ["9"]
    assert found.unmatched[0].feedback == "Ann B_9_assignfeedback_file_feedback.html"
    assert grade_class(tmp_path / "class", tmp_path / "out", gradebook=sheet) == 0
    filled = services.moodle_grades((tmp_path / "out" / "gradebook.csv").read_bytes())
    assert all("," in grade for _, grade in filled.values())


def test_a_second_week_replaces_what_the_first_has_filled_in(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "out"
    source = moodle_class(tmp_path / "x.zip")
    grade_class(source, out, gradebook=services.worksheet(tmp_path / "sheet.csv"))
    capsys.readouterr()
    grade_class(source, out, gradebook=services.worksheet(tmp_path / "sheet.csv"))
    assert "lacks what an earlier run has filled in" in capsys.readouterr().out
    grades = {id: g for id, (_, g) in _filled(out).items()}
    with zipfile.ZipFile(source, "a") as archive:  # one hands in anew; another was corrected
        archive.writestr(f"{services.moodle_prefix(1)}/part1_contacts.cpp", b"// more")
    grades[FIRST + 2] = "12.34"
    again = services.worksheet(tmp_path / "again.csv", grades)
    grade_class(source, out, gradebook=again)
    assert "lacks what" not in capsys.readouterr().out
    now = {id: g for id, (_, g) in _filled(out).items()}
    assert now[FIRST + 2] == "12.34"
    assert {id for id in now if now[id] != grades[id]} <= {FIRST + 1}


EXTENSION = "Extension granted until: Friday, 20 November 2026, 11:15 PM"


@pytest.mark.parametrize(
    "status, days",
    [
        ("Submitted for grading", 0),
        ("Submitted for grading -  - ", 0),
        ("Submitted for grading - Graded -  - ", 0),
        (f"Submitted for grading - {EXTENSION}", 0),
        ("Submitted for grading - 45 secs late", 1),
        ("Submitted for grading - 5 mins 3 secs late - Graded", 1),
        ("Submitted for grading - 23 hours 59 mins late", 1),
        ("Submitted for grading - 1 day late", 1),
        ("Submitted for grading - 2 days 3 hours late", 3),
        (f"Submitted for grading - 1 day 1 hour late - Graded - {EXTENSION}", 2),
        ("Submitted for grading - 1 year 3 days late", 368),
        ("Zur Bewertung abgegeben - 36 Tage 10 Stunden zu spät -  - ", 37),
        ("Remis pour évaluation - 1 jour 2 heures en retard", 2),
        ("S'ha tramès per qualificar - 3 hores 20 minuts tard", 1),
        ("Ответы для оценки - Срок выполнения закончился 2 дн. 3 час. назад", 3),
        ("已经提交等待评分 - 2 天 3 小时 迟交", 3),
        ("Kutumwa - siku 2 masaa 3", None),
    ],
)
def test_days_late_are_read_from_moodles_words(status: str, days: int | None) -> None:
    assert moodle.days_late(status) == days


POLICY = {"course.toml": b"[late]\npercent_per_day = 10\n"}


def test_each_day_begun_of_moodles_worksheet_costs_points(tmp_path: Path) -> None:
    late = {FIRST: "2 days 3 hours late", FIRST + 1: "siku 2 masaa 3", FIRST + 2: "8 hours late"}
    statuses = {id: f"Submitted for grading - {words}" for id, words in late.items()}
    sheet = services.worksheet(tmp_path / "sheet.csv", statuses=statuses)
    out = write(tmp_path / "out", POLICY)
    assert grade_class(moodle_class(tmp_path / "x.zip"), out, gradebook=sheet) == 0
    cost = {FIRST: 30, FIRST + 1: 10, FIRST + 2: 10}
    for id, (_, grade) in _filled(out).items():
        assert float(grade) == max(0, float(points(id - FIRST, tmp_path)) - cost.get(id, 0))
    page = html.unescape((out / "class.html").read_text())
    vague = "can't be read from Moodle's files, and counts as one day unless"
    assert f"{vague} adjustments.csv says otherwise: José María de la Cruz y García<" in page


TELL_NOTHING = {
    "Moodle": {"Ann B_9_assignsubmission_file/part2_lcp.cpp": b"// x"},
    "Blackboard": services.blackboard_entries(0, "2026-11-20-23-15-42", {"part2_lcp.cpp": b"1"}),
}


@pytest.mark.parametrize("policy", [POLICY, {}])
@pytest.mark.parametrize("service", [*TELL_NOTHING, "folder"])
def test_where_nobody_tells_who_was_late_a_policy_is_answered(
    tmp_path: Path, service: str, policy: dict[str, bytes], capsys: pytest.CaptureFixture[str]
) -> None:
    source, out = tmp_path / "class", write(tmp_path / "out", policy)
    if service == "folder":
        write(source / "ann", {"part2_lcp.cpp": b"// x"})
    else:
        download(source, [], TELL_NOTHING[service])
    assert grade_class(source, out) == 0
    sentence = "doesn't say who was late"
    assert (sentence in capsys.readouterr().out) == bool(policy)
    assert (sentence in html.unescape((out / "class.html").read_text())) == bool(policy)


def _filled(out: Path) -> dict[int, tuple[str, str]]:
    return services.moodle_grades((out / "gradebook.csv").read_bytes())


def blackboard_class(path: Path) -> Path:
    entries: dict[str, bytes] = {}
    old, new = "2026-11-19-08-00-00", "2026-11-20-23-15-42"
    for number in range(len(NAMES)):
        files = {"part2_lcp.cpp": text_of(number)}
        entries |= services.blackboard_entries(number, old, {"part2_lcp.cpp": b"// older"})
        entries |= services.blackboard_entries(number, new, files)
    return download(path, [], entries)


@pytest.mark.parametrize("kind", ["utf-16", "utf-8"])
@pytest.mark.usual(1)
def test_blackboards_file_gets_the_points_of_each_user(tmp_path: Path, kind: str) -> None:
    suffix = "xls" if kind == "utf-16" else "csv"
    grades = {USERS[1]: "7", USERS[2]: "Needs Grading(0.00)"}
    sheet = services.blackboard_file(tmp_path / f"gc.{suffix}", grades, kind)
    source, out = blackboard_class(tmp_path / "x.zip"), tmp_path / "out"
    assert grade_class(source, out, gradebook=sheet, columns={0: "HW 3_b"}) == 0
    data = (out / f"gradebook.{suffix}").read_bytes()
    filled = services.blackboard_grades(data)
    for number, user in enumerate(USERS):
        assert filled[user] == ("7" if number == 1 else points(number, tmp_path))
    assert data[:2] == sheet.read_bytes()[:2] and not (out / "feedback.zip").exists()
    assert len(list((out / "feedback").iterdir())) == len(NAMES)


def test_no_files_name_makes_it_another_services_download(tmp_path: Path) -> None:
    names = {
        "doejane_1_11_part2_lcp.cpp": b"// a",
        "roerichard_2_21_part2_lcp.cpp": b"// b",
        "poeanna_3_31_x_attempt_2026-11-20-23-15-42_part2_lcp.cpp": b"// c",
        "moemax_4_41_x_12345_assignsubmission_file_part2_lcp.cpp": b"// d",
    }
    source = download(tmp_path / "c.zip", [], names)
    assert {s.id for s in students.read(source).students} >= {"1", "2"}
    assert students.read(source).service == "canvas"
    folder = write(tmp_path / "unpacked", names)
    assert students.read(folder).service == "canvas"


ALONE = {  # of one student, who has named the files after another service
    "canvas": {
        "mal_103_9001_hw_bob_attempt_2026-11-20-12-00-00_part2_lcp.cpp": b"// x",
        "mal_103_9002_hw_bob_attempt_2026-11-20-12-00-00.txt": b"Name: Bob Roe (bob)\n",
    },
    "moodle": {
        "Mal Ory_7_assignsubmission_file_hw_bob_attempt_2026-11-20-12-00-00_x.cpp": b"// x",
        "Mal Ory_7_assignsubmission_file_x_104_9001_part2_lcp.cpp": b"// y",
    },
    "blackboard": {
        "HW_3_12345_attempt_2026-11-20-12-00-00.txt": b"Name: Mal Ory (12345)\n",
        "HW_3_12345_attempt_2026-11-20-12-00-00_x_104_9001_part2_lcp.cpp": b"// x",
    },
}


@pytest.mark.parametrize("service", ALONE)
def test_who_hands_in_alone_cannot_make_it_another_services(tmp_path: Path, service: str) -> None:
    intake = students.read(download(tmp_path / "x.zip", [], ALONE[service]))
    assert intake.service == service
    (student,) = intake.students
    assert student.id == {"canvas": "103", "moodle": "7", "blackboard": "12345"}[service]


def test_no_files_name_makes_it_another_students_attempt(tmp_path: Path) -> None:
    mine, yours = "hw3_mal_attempt_2026-11-20-23-15-42", "jdoe_attempt_2027-01-01-00-00-00"
    source = download(
        tmp_path / "b.zip",
        [],
        {
            f"{mine}.txt": b"Name: Mal Ory (mal)\n",
            f"{mine}_part2_lcp.cpp": b"// x",
            f"{mine}_{yours}.txt": b"Name: Jane Doe (jdoe)\n",
            f"{mine}_{yours}_part2_lcp.cpp": b"// y",
            "hw3_roe_attempt_2026-11-20-23-15-42.txt": b"Name: Richard Roe (roe)\n",
            "hw3_roe_attempt_2026-11-20-23-15-42_part2_lcp.cpp": b"// z",
        },
    )
    intake = students.read(source)
    assert intake.service == "blackboard"
    assert [student.id for student in intake.students] == ["mal", "roe"]


def test_what_a_student_types_makes_nobody_another(tmp_path: Path) -> None:
    entries = services.blackboard_entries(0, "2026-11-20-23-15-42", {"part2_lcp.cpp": b"1"})
    head = "HW 3_b_mallory_attempt_2026-11-20-23-15-42"
    entries |= {f"{head}.txt": f"Name: x ({USERS[0]})\n".encode(), f"{head}_part2_lcp.cpp": b"2"}
    found = students.read(download(tmp_path / "x.zip", [], entries))
    assert sorted(student.id for student in found.students) == ["mallory", USERS[0]]


@pytest.mark.parametrize("name", ["Eve_7_assignsubmission_file/../../part2_lcp.cpp"])
def test_no_path_leads_out_of_a_submission(tmp_path: Path, name: str) -> None:
    entries = {name: b"1", "Ann_8_assignsubmission_file/part2_lcp.cpp": b"2"}
    found = students.read(download(tmp_path / "x.zip", [], entries))
    assert [student.id for student in found.students] == ["8"]
    assert found.unmatched[0].reason == "points outside of the submission"


@pytest.mark.parametrize(
    "spoil, more, sentence",
    [
        (lambda text: text.replace("4001", "x"), {}, None),
        (lambda text: text, {"columns": {0: "Marks"}}, "give --column one of 'Identifier'"),
        (lambda text: text, {"columns": {1: "Grade"}}, "--part-column fills Canvas's export alone"),
        (lambda text: text.replace("Yes,", "Yes"), {}, "in line 2, and 10 in its first"),
        (
            lambda text: text.replace("Participant 4", "Participant 9"),
            {},
            "none of the 20 students",
        ),
    ],
)
def test_a_spoilt_worksheet_is_refused_in_a_sentence(
    tmp_path: Path, spoil: Any, more: dict[str, Any], sentence: str | None
) -> None:
    sheet = services.worksheet(tmp_path / "sheet.csv")
    sheet.write_text(spoil(sheet.read_text()))
    source, out = moodle_class(tmp_path / "x.zip"), tmp_path / "out"
    if sentence is None:
        assert grade_class(source, out, gradebook=sheet, **more) == 0
        return
    with pytest.raises(UsageError) as refused:
        grade_class(source, out, gradebook=sheet, **more)
    assert sentence in str(refused.value) and "\n" not in str(refused.value)


def test_files_of_two_services_are_not_mixed(tmp_path: Path, users: list[int]) -> None:
    sheet = services.worksheet(tmp_path / "sheet.csv")
    with pytest.raises(UsageError, match="is a download from Canvas, and .* a file from Moodle"):
        grade_class(download(tmp_path / "x.zip", users), tmp_path / "out", gradebook=sheet)


def test_no_name_leads_a_page_out_of_its_folder(tmp_path: Path) -> None:
    head = "HW_u1_attempt_2026-11-20-23-15-42"
    entries = {f"{head}.txt": b"Name: ../../../x (u1)\n", f"{head}_part2_lcp.cpp": b"1"}
    out = tmp_path / "out"
    grade_class(download(tmp_path / "x.zip", [], entries), out)
    assert [page.name for page in (out / "feedback").iterdir()] == ["u1.html"]
