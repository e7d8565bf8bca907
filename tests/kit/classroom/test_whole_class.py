"""Whole classes with real gradings: one with every oddity, and one in which every tenth attacks."""

import csv
import io
import os
import subprocess
import zipfile
from pathlib import Path
from typing import Any

import pytest
from bounce_grader import cli
from bounce_grader.classroom.intake.canvas import sanitized
from bounce_grader.develop import synthetic_class
from bounce_grader.develop.synthetic_class import zip_bytes, Made
from clusters import Cluster, needs_dask
from conftest import solution_files

COLUMN = "HW3 (98765)"
NAMES = ("gradebook.csv", "grades.csv", "class.html")
ODD_NAMES = {
    7001: "Müller-Lüdenscheidt, Jürgen",
    7002: "O'Brien, Aoife",
    7003: '=HYPERLINK("http://x";"y"), Eve',
    7004: "Doe\u202e, Jane",
    7005: "Doe, Jane",
    7006: "Doe, Jane",  # another one
}


def solution(user: int) -> dict[str, bytes]:
    """The solution with full points; all have the same comment, so that it is compiled once."""
    return solution_files()


def odd_entries(archive: zipfile.ZipFile) -> dict[int, float | None]:
    """Entries that a download may have, and the points each user should get; None for none."""
    points: dict[int, float | None] = {}
    attachment = 900_000

    def put(user: int, name: str, files: dict[str, bytes], worth: float | None) -> None:
        nonlocal attachment
        points[user] = worth
        for file, data in files.items():
            attachment += 1
            archive.writestr(f"{sanitized(name)}_{user}_{attachment}_{file}", data)

    for user, name in ODD_NAMES.items():
        put(user, name, solution(user), 100)
    wrong = b"#error an older one"
    twice = {"part1_contacts.cpp": wrong, **solution(0), "part1_contacts-1.cpp": wrong}
    twice["part1_contacts-2.cpp"] = twice.pop("part1_contacts.cpp")
    put(
        7101,
        "Twice, Ann",
        {**twice, "part1_contacts-2.cpp": solution(0)["part1_contacts.cpp"]},
        100,
    )
    inner = zip_bytes({"again.zip": zip_bytes(solution(0))})
    put(7102, "Zipzip, Ann", {"hw.zip": inner}, 100)
    put(7103, "Broken, Ann", {"hw.zip": b"PK\x03\x04 and then nothing"}, None)
    put(7104, "Rar, Ann", {"hw.rar": b"Rar!"}, None)
    put(7105, "Photo, Ann", {"part1.jpg": b"\xff\xd8"}, None)
    three = {n: t for n, t in solution(0).items() if n != "part4_simulate.cpp"}
    put(7106, "Three, Ann", three, 90)
    huge = {**solution(0), "part2_lcp.cpp": b" " * (2 << 20)}
    put(7107, "Huge, Ann", huge, 70)
    put(7108, "Mac, Ann", {"hw.zip": zip_bytes({**solution(0), "__MACOSX/._x.cpp": b"\0"})}, 100)
    put(7109, "team 7", solution(0), 100)
    copy = {**solution(0), "part1_contacts (1).cpp": solution(0)["part1_contacts.cpp"]}
    del copy["part1_contacts.cpp"]
    put(7112, "Copy, Ann", {"hw.zip": zip_bytes(copy)}, 100)
    stale = zip_bytes({**solution(0), "arm.cpp": b"#error"})
    put(7113, "Zips, Ann", {"hw.zip": stale, "hw-1.zip": zip_bytes(three)}, 90)
    archive.writestr("textann_7110_text.html", "<p>see above</p>")
    archive.writestr("linkann_LATE_7111_link.html", "<p>there</p>")
    archive.writestr("anon_a1b2c_950001_part1_contacts.cpp", b"int x;")
    archive.writestr("readme.txt", b"")
    return {**points, 7110: None, 7111: None}


def book_of(users: dict[int, float | None], names: dict[int, str]) -> str:
    """The grade book, also with a student without a submission, an excused one, and one without the
    assignment."""
    lines = [f"Student,ID,SIS Login ID,Section,{COLUMN},Note", "    Points Possible,,,,100.00,"]
    for user in users:
        name = names.get(user, "Roe, Ann").replace('"', '""')
        lines.append(f'"{name}",{user},l{user},S,,')
    lines += ['"None, Nell",8001,l8001,S,,', '"Excused, Ed",7106,l7106,S,EX,']
    lines = [line for line in lines if not line.endswith("7106,l7106,S,,")]
    lines += ['"Free, Fay",8002,l8002,S,N/A,']
    return "\ufeff" + "".join(f"{line}\r\n" for line in lines)


def kit_class(folder: Path) -> dict[str, str]:
    arguments = ["class", str(folder / "submissions.zip"), "--out", str(folder / "out")]
    arguments += ["--gradebook", str(folder / "export.csv"), "--column", COLUMN]
    assert cli.main(arguments) == 0
    text = (folder / "out" / "gradebook.csv").read_text("utf-8-sig")
    rows = list(csv.reader(io.StringIO(text)))
    column = rows[0].index(COLUMN)
    return {row[1]: row[column] for row in rows[2:]}


def class_of_forty(folder: Path) -> dict[int, float | None]:
    """Writes the download and the export, and returns the points of each student."""
    made = list(synthetic_class.students(22, ("accepted", "mistakes", "broken"), 6001))
    source = synthetic_class.canvas_zip(folder / "submissions.zip", made)
    with zipfile.ZipFile(source, "a") as archive:
        odd = odd_entries(archive)
    everybody: dict[int, float | None] = {student.user: student.points for student in made}
    everybody |= odd
    assert len(everybody) >= 39
    names = {**ODD_NAMES, **{student.user: student.sortable_name for student in made}}
    (folder / "export.csv").write_bytes(book_of(everybody, names).encode())
    return everybody


@pytest.mark.long
def test_a_class_of_forty_with_every_oddity(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    everybody = class_of_forty(tmp_path)
    got = kit_class(tmp_path)

    expected = {str(u): "" if p is None else f"{p:.2f}" for u, p in everybody.items()}
    expected |= {"7106": "EX", "8001": "", "8002": "N/A"}
    assert got == expected
    export = (tmp_path / "export.csv").read_bytes()
    filled = (tmp_path / "out" / "gradebook.csv").read_bytes()
    assert filled.replace(b",EX,", b",,").count(b"\r\n") == export.count(b"\r\n")
    assert filled.startswith(b"\xef\xbb\xbf") and b'"=HYPERLINK(""http://x"";""y""), Eve"' in filled

    said = capsys.readouterr().out
    for sentence in (
        "rarann_7104",
        "hw.rar is a RAR archive, which isn't opened: the parts are needed",
        "part1.jpg is no C++ source and no zip",
        "the submission is broken",
        "is text typed into Canvas",
        "is an address typed into Canvas",
        "'readme.txt' isn't named as Canvas names submissions",
        "None, Nell (8001) has no submission: the cell stays as it was",
        "Excused, Ed (7106) stays EX",
        "Roe, Ann (7109) has the points of team7: if that is a group",
        "(anon_a1b2c) is graded, but isn't in export.csv",
    ):
        assert sentence in said, sentence
    assert "\u202e" not in said
    page = (tmp_path / "out" / "class.html").read_text()
    assert "\u202e" not in page and page.count("<script") == 1  # the page's own
    pages = {file.name for file in (tmp_path / "out" / "feedback").iterdir()}
    assert len(pages) == len({name for name in pages}) >= 33
    for name in pages:
        assert (tmp_path / "out" / "feedback" / name).read_text().startswith("<!doctype html>")


def run_chunks(folder: Path) -> None:
    """The array's script, as Slurm would run it."""
    for number in range(1, 1 + len(list(folder.glob("chunk-*.json")))):
        environment = {**os.environ, "SLURM_ARRAY_TASK_ID": str(number)}
        subprocess.run(["sh", str(folder / "grade.sbatch")], env=environment, check=True)


@needs_dask
@pytest.mark.long
def test_a_class_of_forty_is_the_same_on_a_cluster(cluster: Cluster, tmp_path: Path) -> None:
    class_of_forty(tmp_path)
    arguments = ["class", str(tmp_path / "submissions.zip")]
    arguments += ["--gradebook", str(tmp_path / "export.csv"), "--column", COLUMN, "--out"]
    assert cli.main([*arguments, str(tmp_path / "local")]) == 0
    cluster.worker()
    cluster.worker()
    dask = ["--engine", "dask", "--scheduler", cluster.address]
    assert cli.main([*arguments, str(tmp_path / "dask"), *dask]) == 0
    slurm = [*arguments, str(tmp_path / "slurm"), "--engine", "slurm"]
    assert cli.main(slurm) == 0
    run_chunks(tmp_path / "slurm" / "slurm" / "1")
    assert cli.main(slurm) == 0
    for name in NAMES:
        local = (tmp_path / "local" / name).read_bytes()
        assert (tmp_path / "dask" / name).read_bytes() == local, name
        assert (tmp_path / "slurm" / name).read_bytes() == local, name


def others(folder: Path, made: list[Made]) -> dict[str, str]:
    folder.mkdir()
    synthetic_class.canvas_zip(folder / "submissions.zip", made)
    (folder / "export.csv").write_text(synthetic_class.gradebook_csv(made))
    return kit_class(folder)


@pytest.mark.parametrize(
    "number",
    [pytest.param(10, marks=pytest.mark.long), pytest.param(100, marks=pytest.mark.long)],
)
def test_an_attacker_in_ten_costs_the_others_nothing(tmp_path: Path, number: int) -> None:
    made: list[Made] = list(synthetic_class.students(number, ("accepted", "mistakes"), 6001))
    hostile = list(synthetic_class.students(number // 10, ("hostile",), 6901))
    mixed = [hostile[i // 10] if i % 10 == 9 else student for i, student in enumerate(made)]
    got: dict[str, Any] = others(tmp_path / "mixed", mixed)
    assert got == {str(student.user): f"{student.points:.2f}" for student in mixed}
    peaceful = others(tmp_path / "peaceful", made)
    both = got.keys() & peaceful.keys()
    assert len(both) == number - number // 10
    assert {user: got[user] for user in both} == {user: peaceful[user] for user in both}
