"""Finds each student's submission in Moodle's download, packed or unpacked, by the names that
mod/assign writes.

    {full name}_{participant}_assignsubmission_file/{path}      since 4.1
    {full name}_{participant}_assignsubmission_file_/{path}     since 3.1
    {full name}_{participant}_assignsubmission_file_{file}      without folders
    {full name}_{participant}_assignsubmission_onlinetext...    a text typed into Moodle

A full name holds no "_", because Moodle writes blanks in their place; a group's comes before it,
with a hyphen.

Its grading worksheet says how late a submission is, in the site's language. The cell is made of
pieces (`assign_grading_table::col_status`):

    Submitted for grading - 2 days 3 hours late - Graded - Extension granted until: 20 November 2026

The time is counted from an extension, if there is one. It has the two largest units that aren't 0,
of years, days, hours, minutes and seconds (`format_time`).
"""

import re
from collections.abc import Iterable, Mapping
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from bounce_grader.classroom.intake.archive import is_folder, opened, zip_alone
from bounce_grader.classroom.intake.student import (
    Class,
    set_duplicates_aside,
    Student,
    Unmatched,
    Upload,
)
from bounce_grader.classroom.intake.uploads import not_named, take, typed_elsewhere
from bounce_grader.common.escaping import printable_name
from bounce_grader.common.files import fitting

ENTRY = re.compile(
    r"(?P<name>[^_/]+)_(?P<id>[0-9]{1,20})_assignsubmission_(?P<kind>file|onlinetext)"
    r"(?:_?/|_)(?P<file>.+)",
    re.DOTALL,
)
STATUS = (  # titles of the column
    *("Status", "Statut", "Estado", "Estatus", "Estat", "Stato", "Stav", "Tila", "Durum"),
    *("Állapot", "Stare", "Состояние", "Статус", "Стан", "Κατάσταση", "ステータス", "状态", "狀態", "상태"),
)
UNITS = {  # what the words for a unit begin with, by the days in it
    365: "year|jahr|an|añ|jaar|år|rok|vuo|yıl|év|год|рік|年|년",
    1: "day|tag|jour|día|dia|dies|giorn|dag|dzie|dni|den|dn|päiv|gün|nap|zi|день|дн|ημέρ|日|天|일",
    0: "hour|hr|stunde|heure|hora|hore|ora|ore|óra|uur|uren|timm|time|godz|hod|tunti|saat|час|годин"
    "|ώρ|時間|小时|小時|시간|min|мин|хв|λεπτ|perc|dakika|分|분|sec|sek|seg|saniye|сек|δευτ|秒|초",
}
FOLDER = re.compile(r"(?P<name>[^_/]+)_(?P<id>[0-9]{1,20})_assignsubmission_(?P<kind>\w+?)_?")


class Entry(NamedTuple):
    """The name of a file or folder in Moodle's download, split into its fields."""

    name: str
    participant: str
    kind: str  # "file" or "onlinetext"
    file: str  # its path in the submission; "" for a folder


def parse(entry: str) -> Entry | None:
    match = ENTRY.fullmatch(entry)
    return Entry(match["name"], match["id"], match["kind"], match["file"]) if match else None


def wrote_all(entries: Iterable[str]) -> bool:
    """Whether Moodle can have written all of these names."""
    return all(map(parse, entries))


def parse_folder(name: str) -> Entry | None:
    match = FOLDER.fullmatch(name)
    return Entry(match["name"], match["id"], match["kind"], "") if match else None


def days_late(status: str) -> int | None:
    """How many days are begun after the deadline, by a cell of the worksheet; None if the words
    aren't known. Full hours count, so that "2 days late" is two days."""
    pieces = status.split(" - ")
    late = pieces[1] if len(pieces) > 1 else ""
    if re.search(r"\d{4}|\d:\d", late):  # the date of an extension
        return 0
    days, begun = 0, False
    for number, word in re.findall(r"(\d+)\s+([^\W\d]+)", late):
        unit = next((d for d, words in UNITS.items() if re.match(words, word.lower())), None)
        if unit is None:
            return None
        days += int(number) * unit
        begun = begun or unit == 0
    return days + begun


def feedback_name(name: str, participant: str) -> str:
    """The name for a feedback page that Moodle's importer of feedback files takes, whichever its
    version: it splits at "_"."""
    return f"{printable_name(fitting(name, 150))}_{participant}_assignfeedback_file_feedback.html"


def read(path: Path, _people: Mapping[str, str]) -> Class:
    archive = opened(path)
    intake = Class("a Moodle download", service="moodle")
    files: dict[tuple[str, str], list[Upload]] = {}
    for number, name in enumerate(archive.names()):
        parsed = parse(name)
        if not parsed:
            intake.unmatched.append(Unmatched(name, not_named("Moodle", name)))
        elif parsed.kind == "onlinetext":
            page = feedback_name(parsed.name, parsed.participant)
            typed_elsewhere(intake, name, "Moodle", parsed.participant, page)
        elif not _is_inside(parsed.file):
            intake.unmatched.append(Unmatched(name, "points outside of the submission"))
        else:
            who = (parsed.participant, parsed.name)
            upload = Upload(name, parsed.name, parsed.participant, False, number, parsed.file, True)
            files.setdefault(who, []).append(upload)
    for (participant, name), uploads in files.items():
        page = feedback_name(name, participant)
        take(intake, archive, participant, name, uploads, page)
    return intake


def read_folders(children: list[Path]) -> Class:
    """Moodle's download, unpacked."""
    intake = Class("a Moodle download", service="moodle")
    for child in children:
        parsed = parse_folder(child.name) if is_folder(child) else None
        if not parsed:
            intake.unmatched.append(Unmatched(child.name, not_named("Moodle", child.name)))
            continue
        page = feedback_name(parsed.name, parsed.participant)
        if parsed.kind == "onlinetext":
            typed_elsewhere(intake, child.name, "Moodle", parsed.participant, page)
        else:
            there = zip_alone(child) or child
            intake.students.append(Student(parsed.participant, parsed.name, there, feedback=page))
    set_duplicates_aside(intake)
    return intake


def _is_inside(file: str) -> bool:
    parts_of = PurePosixPath(file).parts
    return not file.startswith("/") and ".." not in parts_of and "\\" not in file
