"""The names of files in Canvas's download."""

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


BOOK = frozenset({"99", "123", "3", "4"})


def users(*entries: str, ids: frozenset[str] = BOOK) -> list[str | None]:
    read = canvas.read_all(entries, ids).values()
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
    ],
)
def test_no_name_puts_a_file_into_anothers_submission(attack: str) -> None:
    """If two of its readings are of students in the grade book, a person has to look at it."""
    victim = ["victimvera_123_5001_part1_contacts.cpp", "victimvera_123_5002_part2_lcp.cpp"]
    assert users(*victim, attack) == ["123", "123", None]
    assert users(attack) == [None] and users(attack, ids=frozenset()) == [None]


def test_the_grade_book_tells_whose_it_is() -> None:
    files = ("poe_3_6001_20240001_hw.zip", "noe_4_6002_20240002_hw.zip", "team_7_99_6000_x.zip")
    assert users(*files) == ["3", "4", "99"]
    assert users(*files, ids=frozenset()) == [None, None, None]
    assert users("anon_abc_5_6_a.zip", "anon_abc_6_7_b.zip") == ["anon_abc", "anon_abc"]
    [upload] = canvas.read_all(["mal_LATE_99_6000_20240001_x.zip"], BOOK).values()
    assert upload == Upload(
        "mal_LATE_99_6000_20240001_x.zip", "mal", "99", True, 6000, "20240001_x.zip"
    )


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
