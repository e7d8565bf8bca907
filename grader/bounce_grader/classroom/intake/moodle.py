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
from collections.abc import Sequence

from bounce_grader.classroom.intake.archive import Archive, not_named
from bounce_grader.classroom.intake.student import Names, Upload
from bounce_grader.common.escaping import printable_name
from bounce_grader.common.files import fitting

TITLE = "Moodle"
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


def parse(entry: str) -> Upload | None:
    match = ENTRY.fullmatch(entry)
    if not match:
        return None
    typed = "text" if match["kind"] == "onlinetext" else ""
    return Upload(entry, match["name"], match["id"], match["file"], typed=typed)


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


def page_of(uploads: Sequence[Upload]) -> str:
    """The name for a feedback page that Moodle's importer of feedback files takes, whichever its
    version: it splits at "_"."""
    name = printable_name(fitting(uploads[0].name, 150))
    return f"{name}_{uploads[0].user}_assignfeedback_file_feedback.html"


def read(archive: Archive, _people: Names) -> dict[str, Upload | str]:
    """Each entry; or why it is of nobody."""
    return {entry: parse(entry) or not_named(TITLE) for entry in archive.names()}
