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


def users(*entries: str) -> list[str | None]:
    return [upload.user if upload else None for upload in canvas.read_all(entries).values()]


def test_a_name_that_ends_in_a_number_puts_no_file_into_anothers_submission() -> None:
    victim = "victimvera_123_5001_part1_contacts.cpp"
    assert users(victim, "mallory_123_99_6000_x.zip") == ["123", "99"]
    assert users("mallory_123_99_6000_x.zip", victim) == ["99", "123"]
    assert users("victimvera_LATE_123_5001_x.zip", "mallory_123_99_6000_x.zip") == ["123", "99"]
    assert users("vera_123_text.html", "mallory_123_99_6000_x.zip") == ["123", "99"]
    # Where both could be another's, a person has to look.
    assert users("vera_123_5001_7_x.zip", "mallory_123_99_6000_x.zip") == [None, None]
    # And where the alternative is somebody else's as well.
    assert users(victim, "doe_99_5000_x.zip", "mallory_123_99_6000_x.zip") == ["123", "99", None]


def test_a_groups_number_and_a_files_are_told_apart_by_what_else_there_is() -> None:
    assert users("team_7_99_6000_part1.cpp", "team_7_99_6001_part2.cpp") == ["99", "99"]
    near = ("doe_1_5990_x.zip", "roe_2_6010_x.zip")
    assert users(*near, "team_7_99_6000_x.zip")[2] == "99"
    assert users(*near, "poe_3_6001_20240001_hw.zip")[2] == "3"
    assert users("poe_3_6001_20240001_hw.zip", "noe_4_6002_20240002_hw.zip") == ["3", "4"]


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
