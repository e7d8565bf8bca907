"""What an instructor writes by hand: adjustments, lateness, whose a submission is. It changes
points after the grading, and never records."""

import csv
import html
import io
from pathlib import Path
from typing import Any

import pytest
import stand_in
from bounce_grader.common.errors import UsageError
from bounce_grader.submission import submission
from classes import COLUMN, book, column, download, grade_class, points_of, text_of
from conftest import solution_files, write


def rows_of(out: Path) -> dict[str, dict[str, str]]:
    text = (out / "grades.csv").read_text("utf-8-sig")
    return {row["id"]: row for row in csv.DictReader(io.StringIO(text))}


def graded(tmp_path: Path, users: list[int], files: dict[str, str], **more: Any) -> dict[str, str]:
    """The column after the class is graded with these files in the output folder."""
    out = tmp_path / "out"
    write(out, {name: text.encode() for name, text in files.items()})
    export = book(tmp_path / "export.csv", users)
    source = more.pop("source", None) or download(tmp_path / "x.zip", users)
    assert grade_class(source, out, gradebook=export, columns={0: COLUMN}, **more) == 0
    return column(out / "gradebook.csv")


HEADER = "student,points,percent,late_days,cap,drop,reason,comment\n"


@pytest.mark.parametrize(
    "row, change",
    [
        ("101,-5,,,,,late by a week,", lambda points: points - 5),
        ("101,,-10,,,,late,", lambda points: points - 10),
        ('101,"2,5",,,,,a good question,', lambda points: points + 2.5),
        ("101,-500,,,,,copied,", lambda points: 0),
        ("101,,,,7,,a copy,", lambda points: min(points, 7)),
        ("l101,-4,,,,,by the login,", lambda points: points - 4),
    ],
)
@pytest.mark.usual(3)
def test_points_are_changed_for_one_student_with_the_reason(
    tmp_path: Path, users: list[int], row: str, change: Any
) -> None:
    plain = {str(user): float(points_of(user, tmp_path)) for user in users}
    for _ in range(2):  # it outlives the next run
        filled = graded(tmp_path, users, {"adjustments.csv": HEADER + row + "\n"})
        assert {id: float(points) for id, points in filled.items()} == {
            **plain,
            "101": change(plain["101"]),
        }
    out = tmp_path / "out"
    assert float(rows_of(out)["101"]["score"]) == plain["101"]
    reason = row.split(",")[-2]
    page = (out / "feedback" / "doejane_101_1010_feedback.html").read_text()
    assert (reason in page) == (change(plain["101"]) != plain["101"])
    assert "In the end" not in (out / "feedback" / "doejane_102_1020_feedback.html").read_text()


def test_a_dropped_check_gives_its_points_to_everybody(tmp_path: Path, users: list[int]) -> None:
    check = "part1.GivesTheNormalColumn"
    filled = graded(tmp_path, users, {"adjustments.csv": HEADER + f"*,,,,,{check},unclear,\n"})
    for user in users:
        folder = write(tmp_path / "alone" / str(user), {"part2_lcp.cpp": text_of(user)})
        record = stand_in.record_of(submission.read(folder))
        checks = {c["id"]: c for part in record["parts"] for c in part["checks"]}
        lost = checks[check]["max_score"] - checks[check]["score"]
        assert float(filled[str(user)]) == record["score"] + lost


POLICY = '[late]\npercent_per_day = 10\nat_most_percent = 25\ntitle = "no"\n'


def late_class(path: Path, users: list[int]) -> Path:
    late = {f"roe_LATE_{user}_{user}0_part2_lcp.cpp": text_of(user) for user in users}
    return download(path, [], late)


def test_lateness_costs_what_the_policy_says_and_an_extension_nothing(tmp_path: Path) -> None:
    users = [201, 202, 203, 204]
    plain = {user: float(points_of(user, tmp_path)) for user in users}
    files = {
        "course.toml": "[late]\npercent_per_day = 10\nat_most_percent = 25\n",
        "adjustments.csv": HEADER
        + "202,,,0,,,an extension,\n203,,,2,,,two days,\n204,,,9,,,nine days,\n",
    }
    source = late_class(tmp_path / "late.zip", users)
    filled = graded(tmp_path, users, files, source=source)
    expected = {201: 10, 202: 0, 203: 20, 204: 25}
    assert {u: float(filled[str(u)]) for u in users} == {
        u: max(0, plain[u] - cost) for u, cost in expected.items()
    }
    page = (tmp_path / "out" / "feedback" / "roe_LATE_203_2030_feedback.html").read_text()
    assert "2 days late, 20 %" in page
    extended = (tmp_path / "out" / "feedback" / "roe_LATE_202_2020_feedback.html").read_text()
    assert "an extension" in extended


@pytest.mark.parametrize(
    "files, sentence",
    [
        ({"adjustments.csv": "student,reason\n"}, None),
        ({"adjustments.csv": "who,points\n"}, "has no column 'student'"),
        ({"adjustments.csv": HEADER + "101,5\n"}, "has 2 cells in line 2, and 8 in its first"),
        ({"adjustments.csv": HEADER + "101,five,,,,,x,\n"}, "points should be a number, and is"),
        ({"adjustments.csv": HEADER + "101,nan,,,,,x,\n"}, "points should be a number, and is"),
        ({"adjustments.csv": HEADER + "101,5,,,,,,\n"}, "line 2: the reason is missing"),
        ({"adjustments.csv": HEADER + "101,,,,,,x,\n"}, "line 2: it changes nothing"),
        ({"adjustments.csv": HEADER + "101,,,1.5,,,x,\n"}, "late_days is a whole number"),
        ({"adjustments.csv": HEADER + "101,,,,,part1.X,x,\n"}, "there is no check 'part1.X'"),
        ({"adjustments.csv": HEADER + '101,"5,,,,,x,\n'}, "is no CSV"),
        ({"course.toml": "late = 3\n"}, "holds 'late'"),
        ({"course.toml": "[late]\npercent_per_day = 200\n"}, "a number from 0 to 100"),
        ({"course.toml": POLICY}, "holds title = no under"),
        ({"course.toml": "x = [\n"}, "can't be read as TOML"),
        ({"roster.csv": "submission,id\n101,\n"}, "lacks the submission or the id in line 2"),
        ({"roster.csv": "submission,id\na,7\nb,7\n"}, "has the id 7 in lines 2 and 3"),
    ],
)
def test_what_is_wrong_in_a_file_is_said_before_anything_is_graded(
    tmp_path: Path, users: list[int], files: dict[str, str], sentence: str | None
) -> None:
    if sentence is None:
        graded(tmp_path, users, files)
        return
    with pytest.raises(UsageError) as refused:
        graded(tmp_path, users, files)
    assert sentence in str(refused.value) and "\n" not in str(refused.value)
    assert not (tmp_path / "out" / "results").exists()


def test_a_student_without_a_submission_is_told(
    tmp_path: Path, users: list[int], capsys: pytest.CaptureFixture[str]
) -> None:
    source = download(tmp_path / "x.zip", users[:-1])
    graded(tmp_path, users, {"adjustments.csv": HEADER + "110,5,,,,,ill,\n"}, source=source)
    assert "110 has no submission: the adjustment (ill) changes nothing" in capsys.readouterr().out


def test_every_member_of_a_group_gets_the_points_and_each_their_own_changes(
    tmp_path: Path,
) -> None:
    group = {"teamone_301_3010_part2_lcp.cpp": text_of(301)}
    points = float(points_of(301, tmp_path))
    files = {
        "roster.csv": 'submission,id,name\nTeam One,301,"Doe, Jane"\nTeam One,302,"Roe, Max"\n',
        "adjustments.csv": HEADER + "302,-3,,,,,did less,\n",
    }
    source = download(tmp_path / "x.zip", [], group)
    filled = graded(tmp_path, [301, 302, 303], files, source=source)
    assert (float(filled["301"]), float(filled["302"])) == (points, max(0, points - 3))
    assert filled["303"] == ""
    page = (tmp_path / "out" / "feedback" / "teamone_301_3010_feedback.html").read_text()
    assert "Roe, Max" in page and "did less" in page


def test_a_group_that_takes_anothers_name_costs_nobody_points(tmp_path: Path) -> None:
    """Members that hand in apart, under one name, are told."""
    uploads = {
        "teamone_302_3010_part2_lcp.cpp": text_of(302),
        "TeamOne_303_6660_part2_lcp.cpp": b"// nothing",
    }
    source = download(tmp_path / "y.zip", [], uploads)
    roster = 'submission,id,name\nteam one,302,"Roe, Max"\nteam one,303,"Poe, Ann"\n'
    filled = graded(tmp_path, [302, 303], {"roster.csv": roster}, source=source)
    assert "0.00" not in filled.values()
    rows = rows_of(tmp_path / "out")
    assert any("points of several submissions" in row["needs a look"] for row in rows.values())


BOOK = f"Student,ID,SIS Login ID,Section,{COLUMN}\n    Points Possible,,,,100\n"
NAMED = '"Victim, Ann",302,ann,S,\n"Mallory, Max",666,mal,S,\n"Roe, Max",303,max,S,\n'


def of_book(tmp_path: Path, files: dict[str, str], uploads: dict[str, bytes]) -> dict[str, str]:
    """The column of a grade book with names."""
    out, export = tmp_path / "out", tmp_path / "named.csv"
    write(out, {name: text.encode() for name, text in files.items()})
    export.write_text(BOOK + NAMED)
    source = download(tmp_path / "z.zip", [], uploads)
    assert grade_class(source, out, gradebook=export, columns={0: COLUMN}) == 0
    return column(out / "gradebook.csv")


@pytest.mark.parametrize("uploader", ["666", "777"], ids=["known", "not in the grade book"])
def test_who_is_no_member_of_a_group_neither_gives_nor_takes_its_points(
    tmp_path: Path, uploader: str
) -> None:
    files = {"roster.csv": "submission,id\nteam one,302\nteam one,303\n"}
    stranger = {f"teamone_{uploader}_6660_part2_lcp.cpp": b"// nothing"}
    own = {"mallorymax_666_7770_part2_lcp.cpp": text_of(1)} if uploader != "666" else {}
    filled = of_book(tmp_path, files, stranger | own)
    assert filled["302"] == filled["303"] == "" and filled["666"]
    group = {"teamone_302_8880_part2_lcp.cpp": text_of(302)}
    filled = of_book(tmp_path, files, stranger | own | group)
    assert filled["302"] == filled["303"] != ""


@pytest.mark.parametrize("handed_in", [False, True])
def test_what_is_written_for_a_name_is_not_for_who_takes_it(
    tmp_path: Path, handed_in: bool
) -> None:
    files = {"adjustments.csv": HEADER + '"Roe, Max",5,,,,,ill: see the dean,\n'}
    uploads = {"roemax_666_6660_part2_lcp.cpp": b"// nothing"}
    if handed_in:
        uploads["roemax_303_3030_part2_lcp.cpp"] = b"// nothing"
    filled = of_book(tmp_path, files, uploads)
    own = float(filled["666"])  # of the same text
    assert filled["303"] == (f"{own + 5:.2f}" if handed_in else "")
    page = tmp_path / "out" / "feedback" / "roemax_666_6660_feedback.html"
    assert "dean" not in page.read_text()


def checkout(tmp_path: Path, logins: list[str]) -> Path:
    folder = tmp_path / "hw3-submissions"
    for login in logins:
        write(folder / f"hw3-{login}", {**solution_files(), ".git/HEAD": b""})
    return folder


def test_logins_get_points_in_the_grade_book_only_through_the_roster(tmp_path: Path) -> None:
    """One student has chosen another's id for a login."""
    folder = checkout(tmp_path, ["jdoe", "102", "stranger"])
    files = {"roster.csv": "submission;id;name\njdoe;101;\n102;103;Roe, Max\n"}
    filled = graded(tmp_path, [101, 102, 103], files, source=folder)
    assert filled["102"] == "" and filled["101"] == filled["103"] != ""
    out = tmp_path / "out"
    assert [row["student"] for row in rows_of(out).values()] == [
        "Doe, Jane",
        "Roe, Max",
        "stranger",
    ]
    assert "in roster.csv: the points are in grades.csv" in (out / "class.html").read_text()


def test_an_id_of_the_grade_book_is_nobodys_login(tmp_path: Path) -> None:
    folder = checkout(tmp_path, ["jdoe", "101", "doejane"])
    files = {
        "roster.csv": 'submission,id,name\njdoe,101,"Doe, Jane"\ndoejane,102,"Roe, Max"\n',
        "adjustments.csv": HEADER + '101,-7,,,,,by id,\n"Doe, Jane",-2,,,,,by name,\n',
    }
    graded(tmp_path, [101, 102], files, source=folder)
    changes = {id: row["adjustments"] for id, row in rows_of(tmp_path / "out").items()}
    assert changes == {"jdoe": "by id -7, by name -2", "101": "", "doejane": ""}


def changes_without_a_book(tmp_path: Path, source: Path, files: dict[str, str]) -> dict[str, str]:
    out = tmp_path / "out"
    write(out, {name: text.encode() for name, text in files.items()})
    grade_class(source, out)
    return {id: row["adjustments"] for id, row in rows_of(out).items() if row["adjustments"]}


def test_an_id_of_the_roster_is_nobodys_login(tmp_path: Path) -> None:
    source = checkout(tmp_path, ["ann", "101", "doejane"])
    files = {
        "roster.csv": 'submission,id,name\nann,101,"Doe, Jane"\n',
        "adjustments.csv": HEADER + '101,-7,,,,,by id,\n"Doe, Jane",-2,,,,,by name,\n',
    }
    assert changes_without_a_book(tmp_path, source, files) == {"ann": "by id -7, by name -2"}


@pytest.mark.parametrize("handed_in", [True, False])
def test_an_id_is_nobodys_name(tmp_path: Path, handed_in: bool) -> None:
    entries = {"101_102_assignsubmission_file_part2_lcp.cpp": text_of(102)}
    if handed_in:
        entries["Doe Jane_101_assignsubmission_file_part2_lcp.cpp"] = text_of(101)
    source = download(tmp_path / "x.zip", [], entries)
    files = {"adjustments.csv": HEADER + "101,-7,,,,,ill,\n"}
    expected = {"101": "ill -7"} if handed_in else {}
    assert changes_without_a_book(tmp_path, source, files) == expected
    left_out = "adjustments.csv, line 2: nobody here is '101', so it changes nothing"
    assert (left_out in html.unescape((tmp_path / "out" / "class.html").read_text())) != handed_in


@pytest.mark.parametrize("named_by", ["students", "the grade book"])
def test_a_name_of_two_persons_changes_nothing_and_stops_nothing(
    tmp_path: Path, named_by: str
) -> None:
    """Students can choose their names, and one may have chosen another's."""
    uploads = {f"doejane_{id}_{id}0_part2_lcp.cpp": text_of(id) for id in (101, 102)}
    source = download(tmp_path / "x.zip", [], {**uploads, "roe_103_1030_part2_lcp.cpp": b"3"})
    out, book = tmp_path / "out", tmp_path / "named.csv"
    lines = '"Doe, Jane",-7,,,,,copied,\n103,5,,,,,ill,\n'
    write(out, {"adjustments.csv": (HEADER + lines).encode()})
    if named_by == "the grade book":
        book.write_text(BOOK + '"Doe, Jane",101,j,S,\n"Doe, Jane",102,d,S,\n"Roe, M",103,m,S,\n')
        assert grade_class(source, out, gradebook=book, columns={0: COLUMN}) == 0
    else:
        assert grade_class(source, out) == 0
    rows = rows_of(out)
    assert {id: row["adjustments"] for id, row in rows.items()} == {
        "101": "",
        "102": "",
        "103": "ill +5",
    }
    why = "line 2: 'Doe, Jane' is the name of 2 persons (101, 102), and changes nothing"
    assert why in rows["101"]["needs a look"] and why in rows["102"]["needs a look"]
    assert "persons" not in rows["103"]["needs a look"]
    # Once for both, who need a look, and once for the line.
    assert html.unescape((out / "class.html").read_text()).count(why) == 2


def test_names_are_those_of_the_grade_book(tmp_path: Path) -> None:
    export = f"Student,ID,SIS Login ID,Section,{COLUMN}\n    Points Possible,,,,100\n"
    names = {"401": "O'Brien-Łukasz, Zoë", "402": "Prince", "403": "=cmd|'x'!A1, Eve"}
    export += "".join(f'"{name}",{id},l{id},S,\n' for id, name in names.items())
    (tmp_path / "export.csv").write_text(export)
    entries = {"obrienłukaszzoë_401_1_part2_lcp.cpp": b"1", "prince_402_2_part2_lcp.cpp": b"2"}
    entries["cmdxa1eve_403_3_part2_lcp.cpp"] = b"3"
    out, source = tmp_path / "out", download(tmp_path / "x.zip", [], entries)
    grade_class(source, out, gradebook=tmp_path / "export.csv", columns={0: COLUMN})
    rows = rows_of(out)
    assert rows["401"]["student"] == names["401"] and rows["402"]["student"] == "Prince"
    assert rows["403"]["student"] == "'" + names["403"]
    assert "Brien-Łukasz, Zoë" in (out / "class.html").read_text()
    assert sorted(rows, key=list(rows).index) == ["403", "401", "402"]
