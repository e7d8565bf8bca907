"""What the services write into names and cells: whose a file is, and how late it came. The tables
have a row for each."""

import csv
import io
from collections.abc import Callable
from pathlib import Path

import pytest
from bounce_grader.classroom.intake import gradebook, services, students, uploads
from bounce_grader.classroom.intake.student import Upload
from bounce_grader.submission import submission
from conftest import write
from corpus import Member, zip_of


def table(name: str) -> list[list[str]]:
    text = (Path(__file__).parent / "names_in_downloads" / f"{name}.csv").read_text("utf-8")
    return list(csv.reader(io.StringIO(text, newline="")))[1:]


def fields(upload: Upload | None) -> list[str]:
    """What an entry's name says; nothing if the service doesn't write such names. Those of Canvas are
    of its lib/content_zipper.rb and spec/lib/content_zipper_spec.rb."""
    if upload is None:
        return []
    late, number = "late" if upload.late else "", str(upload.number or "")
    typed = upload.instead.removesuffix(" was typed")
    return [upload.name, upload.user, late, number, typed, upload.file]


READ: dict[str, Callable[[str], list[str]]] = {
    "canvas": lambda entry: fields(services.CANVAS.parse(entry)),
    "moodle": lambda entry: fields(services.MOODLE.parse(entry)),
    "blackboard": lambda entry: fields(services.BLACKBOARD.parse(entry)),
    "brightspace": lambda entry: fields(services.BRIGHTSPACE.parse(entry)),
    "sanitized": lambda name: [services.sanitized(name)],
    "part": lambda file: [submission.part_file(file) or ""],
}


@pytest.mark.parametrize("row", table("names"), ids=lambda row: "-".join(row[:2]))
def test_a_name_is_read(row: list[str]) -> None:
    service, entry, *expected = row
    read = READ[service](entry)
    assert read + [""] * (6 - len(read)) == expected


@pytest.mark.parametrize("status, seconds", table("lateness"))
def test_how_late_in_moodles_words(status: str, seconds: str) -> None:
    assert gradebook.seconds_late(status) == (int(seconds) if seconds else None)


@pytest.mark.parametrize("entries, people, users", table("whose_entries"))
def test_whose_a_file_is(entries: str, people: str, users: str) -> None:
    """A "?" where a person has to look: a name could put a file into another's submission."""
    given = dict(line.split("=") for line in people.split("; ") if line)
    named = {id: names.split(" / ") for id, names in given.items()}
    read = services.read_canvas(entries.split(" + "), named).values()
    assert ["?" if isinstance(one, str) else one.user for one in read] == users.split()


@pytest.mark.parametrize("included, handed_in_as, _", table("helper_files"))
def test_a_helper_keeps_its_name(tmp_path: Path, included: str, handed_in_as: str, _: str) -> None:
    text = f'#include "{included}"'.encode()
    named = {"doe_1_1_part1_contacts.cpp": text, f"doe_1_2_{handed_in_as}": b"// helps"}
    (student,) = students.read(write(tmp_path, named)).students
    assert included in uploads.read(student).files


def test_names_that_canvas_and_macos_write_in_utf_8_without_saying_so(tmp_path: Path) -> None:
    within = zip_of(Member(name.encode()) for name in ("größe.hpp", "part2_lcp.cpp"))
    write(tmp_path, {"x.zip": zip_of([Member("weißjürgen_1_2_hw.zip".encode(), within)])})
    (student,) = students.read(tmp_path / "x.zip").students
    assert student.feedback == "weißjürgen_1_2_feedback.html"
    files = uploads.read(student).files
    assert set(files) == {"größe.hpp", "part2_lcp.cpp"}


@pytest.mark.parametrize("letters", ["李" * 200, "ä" * 110, "n" * 200])
def test_the_name_of_a_page_fits_into_a_file_system_and_keeps_its_ids(letters: str) -> None:
    ids = f"{'9' * 20}_{'8' * 20}"
    upload = services.CANVAS.parse(f"{letters}_LATE_{ids}_photo.jpg")
    assert upload
    page = services.canvas_page([upload])
    assert len(page.encode()) < 240 and page.endswith(f"_LATE_{ids}_feedback.html")
    back = services.CANVAS.parse(page)
    assert back and (back.user, back.number) == ("9" * 20, int("8" * 20))
