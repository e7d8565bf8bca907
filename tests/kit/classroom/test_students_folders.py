"""Submissions in folders: unpacked, side by side, or as checkouts."""

import zipfile
from pathlib import Path

import pytest
from bounce_grader.classroom.intake import students
from bounce_grader.common.errors import UsageError
from conftest import write
from downloads import download, to_grade


def test_an_unpacked_download_is_read_as_well(tmp_path: Path) -> None:
    folder = write(tmp_path / "submissions", {"doe_1_1_part2_lcp.cpp": b"// x"})
    (folder / "roe_2_2_part2_lcp.cpp").symlink_to("/etc/passwd")
    found = students.read(folder)
    assert {s.id for s in found.students} == {"1", "2"}
    linked = next(s for s in found.students if s.id == "2")
    with pytest.raises(UsageError, match="link"):
        to_grade(linked).files


def test_a_folder_of_folders_and_zips(tmp_path: Path) -> None:
    folder = write(tmp_path / "all", {"anna/part2_lcp.cpp": b"// x", "notes.txt": b""})
    write(folder, {".cache/x": b"", "__MACOSX/x": b""})
    download(folder / "ben.zip", {"part2_lcp.cpp": b"// y"})
    found = students.read(folder)
    assert [(s.id, s.feedback) for s in found.students] == [
        ("anna", "anna.html"),
        ("ben", "ben.html"),
    ]
    assert {u.name for u in found.unmatched} == {"notes.txt", ".cache", "__MACOSX"}
    assert to_grade(found.students[1]).files == {"part2_lcp.cpp": b"// y"}


@pytest.mark.parametrize("top", ["hw3-submissions", "checkout"])
def test_a_checkout_is_named_by_login(tmp_path: Path, top: str) -> None:
    for login in ("anna", "anton", "ben-w"):
        write(tmp_path / top / f"hw3-{login}", {"part2_lcp.cpp": b"// x", ".git/HEAD": b""})
    found = students.read(tmp_path / top)
    assert [s.id for s in found.students] == ["anna", "anton", "ben-w"]
    assert found.logins


def test_a_students_own_repository_makes_no_checkout_of_a_class(tmp_path: Path) -> None:
    write(tmp_path / "hw/103", {"part2_lcp.cpp": b"// x", ".git/HEAD": b""})
    for id in ("100", "101"):
        with zipfile.ZipFile(tmp_path / f"hw/{id}.zip", "w") as archive:
            archive.writestr("part2_lcp.cpp", "// x")
    found = students.read(tmp_path / "hw")
    assert [s.id for s in found.students] == ["100", "101", "103"] and not found.logins


def test_a_folder_without_a_repository_is_listed_in_a_checkout(tmp_path: Path) -> None:
    """Its neighbours keep their logins."""
    top = tmp_path / "hw3-submissions"
    for login in ("anna", "anton", "ben"):
        write(top / f"hw3-{login}", {"part2_lcp.cpp": b"// x", ".git/HEAD": b""})
    write(top / "notes", {"x.txt": b""})
    found = students.read(top)
    assert [s.id for s in found.students] == ["anna", "anton", "ben"]
    assert found.source == "a checkout of repositories, named 'hw3-' and a login"
    (left,) = found.unmatched
    assert (left.name, left.reason) == ("notes", "is no repository, as the others are")


def test_a_folder_that_holds_one_zip_is_that_zip(tmp_path: Path) -> None:
    write(tmp_path / "all" / "anna", {".DS_Store": b""})
    download(tmp_path / "all" / "anna" / "hw.zip", {"part2_lcp.cpp": b"// y"})
    (student,) = students.read(tmp_path / "all").students
    assert student.id == "anna"
    assert to_grade(student).files == {"part2_lcp.cpp": b"// y"}


def test_folders_that_are_no_class_are_refused(tmp_path: Path) -> None:
    around = write(tmp_path / "hw3", {"out/log.jsonl": b"", "out/results/set.json": b"{}"})
    whole = download(around / "submissions.zip", {"doe_1_1_part2_lcp.cpp": b"// x"})
    with pytest.raises(UsageError, match=f"holds a Canvas download: give {whole}"):
        students.read(around)
    for name in ("part1_contacts.cpp", "src/part1_contacts.cpp"):
        one = write(tmp_path / "one" / name.split("/")[0], {name: b"// x", "docs/x": b""})
        with pytest.raises(UsageError, match="is one submission, and no class: ./kit grade"):
            students.read(one)
    write(tmp_path / "home", {"music/a.mp3": b"", "letters/b.txt": b""})
    with pytest.raises(UsageError, match="no folder or zip in .* holds a part"):
        students.read(tmp_path / "home")


def test_results_among_the_submissions_are_no_submission(tmp_path: Path) -> None:
    top = write(tmp_path / "all", {"anna/part2_lcp.cpp": b"// x", "out/log.jsonl": b""})
    write(top / "out" / "results", {"set.json": b"{}"})
    found = students.read(top)
    assert [s.id for s in found.students] == ["anna"]
    assert found.unmatched[0].reason == "was written by ./kit class, and is no submission"


def test_neither_a_folder_nor_a_zip_of_its_name_is_graded_and_the_others_are(
    tmp_path: Path,
) -> None:
    folder = write(tmp_path / "all", {"anna/part2_lcp.cpp": b"// x", "ben/part2_lcp.cpp": b"// z"})
    download(folder / "anna.zip", {"part2_lcp.cpp": b"// y"})
    found = students.read(folder)
    assert [student.id for student in found.students] == ["ben"]
    assert [(u.name, u.reason) for u in found.unmatched] == [
        ("anna", "could be anna and anna.zip: keep one of them")
    ]


def test_a_students_zip_with_names_as_canvas_gives_them_is_no_download(tmp_path: Path) -> None:
    folder = write(tmp_path / "all", {"anna/part2_lcp.cpp": b"// x"})
    download(folder / "ben.zip", {"doe_1_2_part1_contacts.cpp": b"// loaded, and handed in again"})
    assert [student.id for student in students.read(folder).students] == ["anna", "ben"]
