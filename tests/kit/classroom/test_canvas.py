"""The names of files in Canvas's download."""

from collections.abc import Mapping

import pytest
from bounce_grader.classroom.intake import canvas
from bounce_grader.classroom.intake.canvas import TextEntry, Upload


# The names are Canvas's own: lib/content_zipper.rb, spec/lib/content_zipper_spec.rb.
@pytest.mark.parametrize(
    "entry, expected",
    [
        ("doejane_12345_678_part1.cpp", ("doejane", "12345", False, 678, "part1.cpp")),
        ("doejane_LATE_12345_678_a-1.cpp", ("doejane", "12345", True, 678, "a-1.cpp")),
        ("müller_lüdenscheid_7_8_x.cpp", ("müller_lüdenscheid", "7", False, 8, "x.cpp")),
        ("doe_1_2_my_2_3_file.cpp", ("doe", "1", False, 2, "my_2_3_file.cpp")),
        ("anon_a1B2c_9_x.cpp", ("", "anon_a1B2c", False, 9, "x.cpp")),
        ("LATE_anon_a1B2c_9_x.cpp", ("", "anon_a1B2c", True, 9, "x.cpp")),
        ("李伟_5_6_x.cpp", ("李伟", "5", False, 6, "x.cpp")),
        ("late_1_2_x.cpp", ("late", "1", False, 2, "x.cpp")),
    ],
)
def test_reads_the_names_that_canvas_writes(
    entry: str, expected: tuple[str, str, bool, int, str]
) -> None:
    name, user, late, attachment, file = expected
    assert canvas.parse(entry) == Upload(entry, name, user, late, attachment, file)


BOOK = {"99": "Mallory", "123": "Victim, Vera", "3": "Poe", "4": "Noe"}


def users(*entries: str, people: Mapping[str, str] = BOOK) -> list[str | None]:
    read = canvas.read_all(entries, people).values()
    return [upload.user if upload else None for upload in read]


@pytest.mark.parametrize(
    "attack",
    [
        "mallory_123_99_6000_x.zip",  # of user 99
        "victimvera_123_99_6000_x.zip",
        "victimvera_123_5999_99_6000_x.zip",
        "victimvera_123_99_6000_99_6000_x.zip",
        "mallory_123_5999_LATE_99_6000_x.zip",
        "mallory_LATE_123_5999_99_6000_x.zip",
        "123_5999_99_6000_x.zip",
        "mallory_99_6000_123_text.html",
        # Of users who aren't in the grade book.
        "eve_100_6000_123_7000_evil.cpp",
        "victimvera_123_100_6000_x.zip",
        "lorymal_anon_7_200_9011_part1_contacts.cpp",
    ],
)
def test_no_name_puts_a_file_into_anothers_submission(attack: str) -> None:
    """It could be of several: a person has to look at it."""
    victim = ["victimvera_123_5001_part1_contacts.cpp", "victimvera_123_5002_part2_lcp.cpp"]
    assert users(*victim, attack) == ["123", "123", None]
    assert users(attack, people={}) == [None]


def test_the_grade_book_tells_whose_it_is() -> None:
    files = ("poe_3_6001_20240001_hw.zip", "noe_4_6002_20240002_hw.zip", "team_7_99_6000_x.zip")
    assert users(*files) == ["3", "4", None]
    assert users(*files, people={}) == [None, None, None]
    assert users("anon_abc_5_6_a.zip", "anon_abc_6_7_b.zip") == ["anon_abc", "anon_abc"]
    late = "mallory_LATE_99_6000_20240001_x.zip"
    [upload] = canvas.read_all([late], BOOK).values()
    assert upload == Upload(late, "mallory", "99", True, 6000, "20240001_x.zip")


def test_a_student_whose_name_is_a_number() -> None:
    files = tuple(f"20231234_7_{n}_part{n}_x.cpp" for n in range(5001, 5005))
    people = {"7": "20231234", "8": "Doe, Jane"}
    assert users(*files, people=people) == ["7"] * 4
    assert users(*files, "someone_7_9_x.cpp", people=people) == [None] * 4 + ["7"]


@pytest.mark.parametrize("kind", ["text", "link"])
def test_knows_what_was_typed_into_canvas(kind: str) -> None:
    assert canvas.parse(f"doe_LATE_12_{kind}.html") == TextEntry("doe", "12", True, kind)
    assert canvas.parse(f"anon_x1y2z_{kind}.html") == TextEntry("", "anon_x1y2z", False, kind)


@pytest.mark.parametrize("entry", ["part1.cpp", "doe_12_x.cpp", "readme.txt", "a_b_c_d.cpp", ""])
def test_other_names_are_nobodys(entry: str) -> None:
    assert canvas.parse(entry) is None


def test_a_name_as_canvas_writes_it() -> None:
    assert canvas.sanitized("Doe, Jane") == "doejane"
    assert canvas.sanitized("O'Brien-Müller, Ana_12_x") == "obrienmüllerana12x"
    assert canvas.sanitized("कुमार, संजय") == "कुमारसंजय"


def test_the_name_of_a_page_fits_into_a_file_system() -> None:
    ids = f"{'9' * 20}_{'8' * 20}"
    upload = canvas.parse(f"{'ä' * 110}_LATE_{ids}_photo.jpg")
    assert isinstance(upload, Upload)
    page = canvas.feedback_name((upload,))
    assert len(page.encode()) < 240 and page.endswith(f"_LATE_{ids}_feedback.html")
