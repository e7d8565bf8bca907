"""The grade book: one column is filled, and every other byte stays."""

import csv
import io
from pathlib import Path

import pytest
from bounce_grader.classroom.output import gradebook
from bounce_grader.classroom.output.gradebook import Filled, Gradebook, Marks
from bounce_grader.common.errors import UsageError

COLUMN = "HW3 (98765)"
MOST = {0: 100.0, 1: 30.0, 2: 30.0, 3: 30.0, 4: 10.0}
EXPORT = '''Student,ID,SIS User ID,SIS Login ID,Section,Quiz (11),HW3 (98765),Final Score
,,,,,Manual Posting,,
    Points Possible,,,,,10.00,100.00,(read only)
"Doe, Jane",12,u12,jdoe,"Sec ""A""",7.50,,81.2
"Roe, Jörg",13,u13,jroe,S,,"55.00",
"Poe, Ann",14,u14,apoe,S,,EX,
"Moe, Sam",15,u15,smoe,S,,,
'''


def marks(**points: float) -> dict[str, Marks]:
    """u12=87.5, by Canvas's id."""
    return {id[1:]: Marks("", {0: x, 1: 20.0, 4: 7.5}) for id, x in points.items()}


def fill(
    tmp_path: Path,
    text: str | bytes,
    given: dict[str, Marks],
    columns: dict[int, str] | None = None,
) -> Filled:
    path = tmp_path / "export.csv"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return Gradebook(path, columns or {0: COLUMN}, MOST).fill(given, overwrite=True)


def refusal(tmp_path: Path, text: str | bytes, column: str = COLUMN) -> str:
    with pytest.raises(UsageError) as refused:
        fill(tmp_path, text, {}, {0: column})
    assert "\n" not in str(refused.value)
    return str(refused.value)


def test_fills_the_cells_and_nothing_else(tmp_path: Path) -> None:
    filled = fill(tmp_path, EXPORT, marks(u12=87.5, u13=55, u14=10))
    assert filled.data.decode() == EXPORT.replace("7.50,,81.2", "7.50,87.50,81.2")
    assert filled.written == {COLUMN: {"12": ["87.50"], "13": ["55.00"]}}
    assert "Poe, Ann (14) stays EX in HW3 (98765)" in filled.sentences
    assert "Moe, Sam (15) has no submission: the cell stays as it was" in filled.sentences


def test_points_that_a_person_has_changed_are_kept(tmp_path: Path) -> None:
    path = tmp_path / "export.csv"
    path.write_text(EXPORT)
    book = {0: COLUMN}
    kept = Gradebook(path, book, MOST).fill(marks(u13=60))
    assert kept.data.decode() == EXPORT and kept.written == {}
    assert (
        f"Roe, Jörg (13) keeps 55.00 in {COLUMN}, where the grading gives 60.00; "
        "--overwrite replaces it" in kept.sentences
    )
    after = EXPORT.replace('"55.00"', '"60.00"')
    replaced = Gradebook(path, book, MOST).fill(marks(u13=60), overwrite=True)
    assert replaced.data.decode() == after
    ours = {COLUMN: {"13": ["55.0"]}}
    again = Gradebook(path, book, MOST).fill(marks(u13=60), written=ours)
    assert again.data.decode() == after and again.written == {COLUMN: {"13": ["55.0", "60.00"]}}


@pytest.mark.parametrize("text", ["85%", "B+", "MI", "excused", "nan"])
def test_words_in_a_cell_are_kept(tmp_path: Path, text: str) -> None:
    path = tmp_path / "export.csv"
    path.write_text(EXPORT.replace('"55.00"', text))
    filled = Gradebook(path, {0: COLUMN}, MOST).fill(marks(u13=50))
    assert filled.data == path.read_bytes()
    assert any(f"keeps {text} in {COLUMN}" in sentence for sentence in filled.sentences)


def test_points_of_any_earlier_run_are_replaced(tmp_path: Path) -> None:
    """The export is of before the last run, as where a command is repeated."""
    path = tmp_path / "export.csv"
    path.write_text(EXPORT)
    written = {COLUMN: {"13": ["55.00", "100.00"]}}
    again = Gradebook(path, {0: COLUMN}, MOST).fill(marks(u13=100), written=written)
    assert again.data.decode() == EXPORT.replace('"55.00"', '"100.00"')


def test_a_grade_book_without_one_of_the_students_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "export.csv"
    path.write_text(EXPORT)
    book = Gradebook(path, {0: COLUMN}, MOST)
    book.require_some_of(["12", "99"], canvas_ids_only=True)
    with pytest.raises(UsageError, match="none of the 2 students who handed in is in export.csv"):
        book.require_some_of(["jdoe", "99"], canvas_ids_only=True)
    book.require_some_of(["jdoe", "99"], canvas_ids_only=False)


def test_a_student_chooses_no_name_that_changes_the_grade_book(tmp_path: Path) -> None:
    odd = '"Points Possible, Eve",16,u16,eve,S,,3.00,\n'
    text = EXPORT.replace('"Moe, Sam"', odd + '"Moe, Sam"')
    assert b",S,,3.00," in fill(tmp_path, text, marks(u16=3)).data
    book = Gradebook(tmp_path / "export.csv", {0: COLUMN}, MOST)
    assert not any("points possible" in sentence for sentence in book.fill({}).sentences)
    assert book.people()["16"] == "Points Possible, Eve"
    header, _, _, first, *others = EXPORT.splitlines(keepends=True)
    lines = header + first.replace("Doe, Jane", "Aaa\nEve; a; b") + "".join(others)
    assert b",S,,3.00," in fill(tmp_path, lines, marks(u15=3)).data


@pytest.mark.parametrize("start", [b"", b"\xef\xbb\xbf"])
@pytest.mark.parametrize("end", ["\n", "\r\n"])
@pytest.mark.parametrize("last", [True, False])
def test_keeps_mark_line_ends_and_last_line(
    tmp_path: Path, start: bytes, end: str, last: bool
) -> None:
    text = EXPORT if last else EXPORT.rstrip("\n")
    data = start + text.replace("\n", end).encode()
    assert fill(tmp_path, data, {}).data == data
    changed = fill(tmp_path, data, marks(u12=1)).data
    assert changed == data.replace(b"7.50,,81.2", b"7.50,1.00,81.2")


SEMICOLONS = """Student;ID;SIS Login ID;Section;Quiz (11);HW3 (98765)
    Points Possible;;;;10,00;100,00
Doe, Jane;12;jdoe;S;7,50;
"""
NOTES = SEMICOLONS.replace("Section", "Section;Notes").replace("Possible;", "Possible;;")
POINTS_ELSEWHERE = NOTES.replace(";S;", ";1.2;3.4;")  # in the section and a note


@pytest.mark.parametrize("text", [SEMICOLONS, POINTS_ELSEWHERE], ids=["plain", "points elsewhere"])
def test_semicolons_and_decimal_commas_are_kept(tmp_path: Path, text: str) -> None:
    filled = fill(tmp_path, text, marks(u12=87.5))
    assert filled.data.decode() == text.replace("7,50;\n", "7,50;87,50\n")


def test_a_decimal_comma_between_commas_is_quoted(tmp_path: Path) -> None:
    text = EXPORT.replace("10.00,100.00", '"10,00","100,00"').replace("7.50", '"7,50"')
    text = text.replace('"55.00"', '"55,00"').replace("81.2", '"81,2"')
    filled = fill(tmp_path, text, marks(u12=87.5, u13=60))
    rows = list(csv.reader(io.StringIO(filled.data.decode())))
    assert [row[6] for row in rows[3:5]] == ["87,50", "60,00"]


def test_names_over_two_lines_and_with_quotes_stay(tmp_path: Path) -> None:
    name = '"Doe ""the\nRoe"", =HYPERLINK(""http://x"")\u202e"'
    text = EXPORT.replace('"Doe, Jane"', name)
    filled = fill(tmp_path, text, marks(u12=3))
    assert filled.data.decode() == text.replace("7.50,,81.2", "7.50,3.00,81.2")


def test_bytes_that_are_no_utf8_stay(tmp_path: Path) -> None:
    data = EXPORT.encode("latin-1")
    filled = fill(tmp_path, data, marks(u13=60))
    assert filled.data == data.replace(b"55.00", b"60.00")


def test_columns_for_the_parts_as_well(tmp_path: Path) -> None:
    text = EXPORT.replace("Final Score", "Part 4 (99)").replace("(read only)", "10.00")
    filled = fill(tmp_path, text, marks(u12=87.5), {0: COLUMN, 4: "Part 4 (99)"})
    assert ",7.50,87.50,7.50\n" in filled.data.decode()


@pytest.mark.parametrize("id", ["u12", "jdoe", "12"])
def test_a_student_is_found_by_any_id(tmp_path: Path, id: str) -> None:
    filled = fill(tmp_path, EXPORT, {id: Marks("jane", {0: 5.0})})
    assert ",7.50,5.00,81.2" in filled.data.decode()


def test_a_title_alone_is_enough_where_it_is_the_only_one(tmp_path: Path) -> None:
    filled = fill(tmp_path, EXPORT, marks(u12=5), {0: "HW3"})
    assert ",7.50,5.00,81.2" in filled.data.decode()


def test_who_is_graded_and_not_in_the_book_is_said(tmp_path: Path) -> None:
    filled = fill(tmp_path, EXPORT, {"99": Marks("ghost", {0: 5.0})})
    assert "ghost (99) is graded, but isn't in export.csv" in filled.sentences
    assert filled.data.decode() == EXPORT


def test_other_points_possible_are_said(tmp_path: Path) -> None:
    filled = fill(tmp_path, EXPORT.replace("100.00", "50.00"), {})
    assert "Canvas has 50 points possible for HW3 (98765), the kit 100" in filled.sentences[0]


def test_the_points_of_a_group_are_said(tmp_path: Path) -> None:
    given = {"12": Marks("team7", {0: 5.0}, True), "13": Marks("jörgroe", {0: 6.0}, True)}
    said = " ".join(fill(tmp_path, EXPORT, given).sentences)
    assert "Doe, Jane (12) has the points of team7: if that is a group" in said
    assert "jörgroe" not in said


@pytest.mark.parametrize(
    "name, canvas_name",
    [
        ("Mu\u0308ller, Jo\u0308rg", "müllerjörg"),
        ("Müller, Jörg", "mu\u0308llerjo\u0308rg"),
        ("कुमार, संजय", "कुमारसंजय"),
    ],
)
def test_a_name_with_marks_on_its_letters_is_no_group(
    tmp_path: Path, name: str, canvas_name: str
) -> None:
    text = EXPORT.replace("Roe, Jörg", name)
    said = fill(tmp_path, text, {"13": Marks(canvas_name, {0: 6.0}, True)}).sentences
    assert not any("if that is a group" in sentence for sentence in said)


def test_why_somebody_has_no_score_is_said(tmp_path: Path) -> None:
    path = tmp_path / "export.csv"
    path.write_text(EXPORT)
    filled = Gradebook(path, {0: COLUMN}, MOST).fill({}, {"15": "it is a photograph"})
    sentence = "Moe, Sam (15) has no score, because it is a photograph: the cell stays as it was"
    assert sentence in filled.sentences
    assert "Doe, Jane (12) has no submission: the cell stays as it was" in filled.sentences
    assert filled.data.decode() == EXPORT


def test_a_name_in_two_columns_is_read(tmp_path: Path) -> None:
    text = (
        "LastName,FirstName,ID,SIS Login ID,Section,HW3 (98765)\n"
        "    Points Possible,,,,,100.00\n"
        "Doe,Jane,12,jdoe,S,\n"
        "Roe,Jörg,13,jroe,S,\n"
    )
    filled = fill(tmp_path, text, {"12": Marks("doejane", {0: 5.0}, True)})
    assert filled.data.decode() == text.replace("jdoe,S,", "jdoe,S,5.00")
    assert filled.sentences == ["Roe, Jörg (13) has no submission: the cell stays as it was"]


@pytest.mark.parametrize("title", ["HW3 (98765)", "HW3"])
def test_one_column_for_two_is_refused(tmp_path: Path, title: str) -> None:
    with pytest.raises(UsageError, match="two of the columns to fill are the same"):
        fill(tmp_path, EXPORT, {}, {0: COLUMN, 1: title})


def test_two_rows_of_one_student_are_both_left(tmp_path: Path) -> None:
    text = EXPORT.replace(",13,u13", ",12,u13")
    filled = fill(tmp_path, text, marks(u12=5))
    assert filled.data.decode() == text
    assert "export.csv has 2 rows for 12: none is filled" in filled.sentences


def test_canvas_ids_come_before_logins(tmp_path: Path) -> None:
    """Somebody's login may be somebody else's id."""
    filled = fill(tmp_path, EXPORT.replace("jroe", "12"), marks(u12=5))
    assert filled.data.decode() == EXPORT.replace("jroe", "12").replace("7.50,,", "7.50,5.00,")


@pytest.mark.parametrize(
    "text, column, sentence",
    [
        (EXPORT, "HW4 (3)", "has no column 'HW4 (3)': it has 'HW3 (98765)'"),
        (EXPORT.replace("Quiz (11)", COLUMN), COLUMN, "has 2 columns named"),
        (EXPORT.replace("Quiz (11)", "HW3 (5)"), "HW3", "has 2 columns named"),
        (EXPORT, "Final Score", "read only"),
        (EXPORT.replace("(read only)", ""), "Final Score", "read only"),
        (EXPORT, "Student", "'Student' in export.csv says who a student is"),
        (EXPORT, "ID", "takes no points"),
        (EXPORT, "SIS Login ID", "takes no points"),
        (EXPORT, "Section", "takes no points: it has 'Quiz (11)', 'HW3 (98765)'"),
        (EXPORT.replace("Student,ID", "Name,Number"), COLUMN, "isn't a grade book of Canvas's"),
        (EXPORT.replace("u15,smoe,", "u15,"), COLUMN, "has 7 cells in line 7, and 8 in its first"),
        (EXPORT.replace('S,,"55.00"', 'S,,"55.00'), COLUMN, "quotation mark in line 5"),
        ("", COLUMN, "is empty"),
        (EXPORT.encode("utf-16"), COLUMN, "isn't UTF-8"),
    ],
)
def test_a_grade_book_that_cannot_be_filled_is_refused(
    tmp_path: Path, text: str | bytes, column: str, sentence: str
) -> None:
    assert sentence in refusal(tmp_path, text, column)


def test_a_book_that_is_not_there_is_said(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="can't be read"):
        Gradebook(tmp_path / "nowhere.csv", {0: COLUMN}, MOST)


def test_a_book_of_its_own_is_one_that_canvas_takes() -> None:
    """Canvas's importer asks for these headings (lib/gradebook_importer.rb)."""
    data = gradebook.of_marks(
        {"12": Marks("doejane", {0: 87.5}), "jroe": Marks("=1+1", {0: 5.0})}, "HW3 (98765)", 100
    )
    rows = list(csv.reader(io.StringIO(data.decode())))
    assert rows == [
        ["Student", "ID", "SIS Login ID", "Section", "HW3 (98765)"],
        ["    Points Possible", "", "", "", "100.00"],
        ["'=1+1", "", "jroe", "", "5.00"],
        ["doejane", "12", "", "", "87.50"],
    ]


def test_a_row_that_two_submissions_mean_is_filled_by_none(tmp_path: Path) -> None:
    both = {"jdoe": Marks("jane", {0: 100.0}), "12": Marks("enaj", {0: 0.0})}
    filled = fill(tmp_path, EXPORT, both)
    assert filled.data.decode() == EXPORT
    assert any("is meant by jane (jdoe) and enaj (12): none" in line for line in filled.sentences)


def test_canvas_names_students_by_its_own_ids_alone(tmp_path: Path) -> None:
    """A login in the place of an id comes from a name that a student chose."""
    graded = {
        "12": Marks("doejane", {0: 100.0}, from_canvas=True),
        "u12": Marks("oejaned", {0: 0.0}, from_canvas=True),
    }
    filled = fill(tmp_path, EXPORT, graded)
    assert filled.data.decode() == EXPORT.replace("7.50,,81.2", "7.50,100.00,81.2")
    assert any("oejaned (u12) is graded, but isn't in" in line for line in filled.sentences)
