"""Writes the results of a class: the grade book, grades.csv and the page about the class."""

import json
from collections.abc import Sequence
from pathlib import Path

from bounce_grader.classroom.grading.log import Log
from bounce_grader.classroom.grading.near_copies import Similar
from bounce_grader.classroom.grading.summary import Final, Summary
from bounce_grader.classroom.intake.instructor_files import Course, ROSTER
from bounce_grader.classroom.intake.student import Class
from bounce_grader.classroom.output import grades, page
from bounce_grader.classroom.output.final import adjusted
from bounce_grader.classroom.output.gradebook import Gradebook
from bounce_grader.common.escaping import csv_row
from bounce_grader.common.files import read_object, write_whole
from bounce_grader.common.manifest import full_points

TITLE = "Bouncing"
WRITTEN = "written.json"  # the points that runs have filled in: what differs, a person has changed


def write_gradebook(
    path: Path,
    submitted: Class,
    summaries: Sequence[Summary],
    book: Gradebook | None,
    title: str,
    log: Log,
    overwrite: bool,
) -> list[str]:
    """Writes the grade book, filled in or made up, for everyone who has a score: a missing one must
    not become a zero. A submission that is known by its GitHub login alone gets no points: its
    student could have chosen somebody else's id as a login. Returns sentences for the instructor.
    """
    given: list[Final] = []
    left_out = []
    for summary in summaries:
        for one in summary.finals:
            if submitted.logins and not one.listed:
                left_out.append(f"{one.id} isn't in {ROSTER}: the points are in grades.csv")
            else:
                # Without a grade book, nobody is known by more than the service's name.
                of_service = not book and not one.listed
                name = summary.student.name if of_service else one.name or summary.student.shown
                given.append(one._replace(name=name))
    if book is None:
        return _make_up(path, given, title or TITLE, log)
    without = {u.user: f"{u.name} {u.reason}" for u in submitted.unmatched if u.user}
    without |= {s.student.id: s.message for s in summaries if s.score is None}
    written = path.with_name(WRITTEN)
    filled = book.fill(
        given, without, submitted.service == "canvas", read_object(written), overwrite
    )
    write_whole(path, filled.data)
    write_whole(written, json.dumps(filled.written, indent=1, sort_keys=True))
    return [*filled.sentences, *left_out]


def _make_up(path: Path, given: Sequence[Final], title: str, log: Log) -> list[str]:
    """Writes a new grade book that Canvas can import, which matches students by ID; but never over
    one that this module didn't make: it may be Canvas's, or edited by a person."""
    if path.exists() and not log.has_made_up(path.read_bytes()):
        return [
            f"{path.name} is one that was filled before, and stays as it was: give --gradebook and "
            "--column to fill it anew"
        ]
    header = ["Student", "ID", "SIS Login ID", "Section", title]
    most = full_points()
    rows = [header, ["    Points Possible", "", "", "", f"{most:.2f}"]]
    for one in sorted(given, key=lambda one: (one.name, one.id)):
        canvas, login = (one.id, "") if one.id.isdigit() else ("", one.id)
        rows.append([one.name, canvas, login, "", f"{one.points[0]:.2f}"])
    data = "".join(map(csv_row, rows)).encode()
    log.make_up(data)
    write_whole(path, data)
    return []


def write_tables(
    out: Path,
    submitted: Class,
    summaries: Sequence[Summary],
    near: Similar,
    sentences: Sequence[str],
    course: Course,
) -> None:
    write_whole(out / "grades.csv", "\ufeff" + grades.table(summaries))
    write_whole(out / "class.html", page.render(submitted, summaries, near, sentences, course))
