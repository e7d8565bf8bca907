"""Files as Moodle and Blackboard write them, and readers that follow their importers."""

import csv
import io
import re
import zipfile
from pathlib import Path

# As students have them: accents, apostrophes, one name, two surnames, other directions, no letters.
NAMES = [
    ("Zoë", "Łukasz-O’Brien"),
    ("José María", "de la Cruz y García"),
    ("Søren", "Ångström"),
    ("Jane", "Doe, Jr."),
    ("", "Prince"),
    ("محمد", "الأحمد"),
    ("דוד", "כהן"),
    ("李", "小龍"),
    ("Anna 🎓", "Émilie"),
    ("=cmd|' /C calc'!A0", "Eve"),
    ("Bobby", '"); DROP TABLE'),
    ("D'Arcy", "O'Neil"),
    ("Nguyễn", "Thị Ánh"),
    ("Jane", "Doe"),
    ("jane", "doe"),
    ("Max_Power", "Under_score"),
    ("../..", "etc"),
    ("<b>Bold</b>", "& Sons"),
    ("İpek", "Işık"),
    ("a" * 80, "b" * 80),
]
FIRST = 4001  # of the participants
MOODLE = ["Identifier", "Full name", "Email address", "Status", "Grade", "Maximum Grade"]
MOODLE += ["Grade can be changed", "Last modified (submission)", "Last modified (grade)"]
MOODLE += ["Feedback comments"]


def full_name(number: int) -> str:
    return " ".join(filter(None, NAMES[number]))


def worksheet(
    path: Path,
    grades: dict[int, str] = {},
    locked: int = -1,
    comma: bool = False,
    statuses: dict[int, str] = {},
) -> Path:
    """As mod/assign/feedback/offline writes it."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(MOODLE)
    most = "100,00" if comma else "100.00"
    for number in range(len(NAMES)):
        id, can = FIRST + number, "No" if number == locked else "Yes"
        status = statuses.get(id, "Submitted for grading -  - ")
        row = [f"Participant {id}", full_name(number), f"s{id}@x.org", status]
        writer.writerow([*row, grades.get(id, ""), most, can, "Friday, 20 November", "-", ""])
    path.write_text("\ufeff" + text.getvalue())
    return path


def moodle_prefix(number: int) -> str:
    """clean_filename takes out what no file's name may have."""
    name = re.sub(r'[&<>"`|\':\\/]', "", full_name(number).replace("_", " ")).replace("..", "")
    return f"{name}_{FIRST + number}_assignsubmission_file"


def moodle_grades(data: bytes) -> dict[int, tuple[str, str]]:
    """As assignfeedback_offline_grade_importer: the columns by their titles, the student by the
    number after "Participant "."""
    rows = list(csv.reader(io.StringIO(data.decode("utf-8-sig"), newline="")))
    grade, id = rows[0].index("Grade"), rows[0].index("Identifier")
    assert "Last modified (grade)" in rows[0]
    return {int(row[id][len("Participant ") :]): (row[1], row[grade]) for row in rows[1:]}


def moodle_feedback(path: Path) -> dict[int, bytes]:
    """As assignfeedback_file_zip_importer, before and after 4.1."""
    found: dict[int, bytes] = {}
    with zipfile.ZipFile(path) as archive:
        for name in archive.namelist():
            assert not name.startswith((".", "~")) and "/" not in name
            info = name.split("_", 4)
            assert len(info) == 5 and info[2:4] == ["assignfeedback", "file"], name
            assert info[1].isdigit() and info[4] == "feedback.html"
            assert int(info[1]) not in found
            found[int(info[1])] = archive.read(name)
    return found


BLACKBOARD = ["Last Name", "First Name", "Username", "Student ID", "Last Access", "Availability"]
COLUMN = "HW 3_b [Total Pts: 100 Score] |98765"
USERS = [f"u_{number}" if number % 3 else f"u{number}" for number in range(len(NAMES))]


def blackboard_file(path: Path, grades: dict[str, str] = {}, kind: str = "utf-16") -> Path:
    """As Grade Center's "Work offline" writes it: tabs in UTF-16, or commas."""
    text = io.StringIO()
    delimiter = "\t" if kind == "utf-16" else ","
    writer = csv.writer(text, delimiter=delimiter, quoting=csv.QUOTE_ALL, lineterminator="\n")
    writer.writerow([*BLACKBOARD, "Total [Total Pts: up to 200 Score] |1", COLUMN])
    for number, (first, last) in enumerate(NAMES):
        user = USERS[number]
        row = [last, first, user, f"{7000 + number}", "2026-11-20 10:00:00", "Yes", ""]
        writer.writerow([*row, grades.get(user, "")])
    data = text.getvalue()
    path.write_bytes(data.encode("utf-16") if kind == "utf-16" else b"\xef\xbb\xbf" + data.encode())
    return path


def blackboard_grades(data: bytes) -> dict[str, str]:
    utf_16 = data.startswith(b"\xff\xfe")
    text = data.decode("utf-16" if utf_16 else "utf-8-sig")
    rows = list(csv.reader(io.StringIO(text, newline=""), delimiter="\t" if utf_16 else ","))
    user, column = rows[0].index("Username"), rows[0].index(COLUMN)
    assert all(len(row) == len(rows[0]) for row in rows)
    return {row[user]: row[column] for row in rows[1:]}


def blackboard_entries(number: int, when: str, files: dict[str, bytes]) -> dict[str, bytes]:
    head = f"HW 3_b_{USERS[number]}_attempt_{when}"
    text = f"Name: {full_name(number)} ({USERS[number]})\nAssignment: HW 3_b\n"
    text += "Submission Field:\nName: Mallory (u_1)\n"
    entries = {f"{head}.txt": text.encode()}
    return entries | {f"{head}_{name}": data for name, data in files.items()}
