"""Writes the results of a class: grade book, grades, feedback and the page about the class."""

import io
import json
import zipfile
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any, NamedTuple

from bounce_grader.classroom.grading import results
from bounce_grader.classroom.grading.log import Log
from bounce_grader.classroom.grading.near_copies import Similar
from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.intake import canvas
from bounce_grader.classroom.intake.course import Course
from bounce_grader.classroom.intake.student import Class
from bounce_grader.classroom.output import gradebook, grades, history, page
from bounce_grader.classroom.output.final import adjusted
from bounce_grader.classroom.output.gradebook import Gradebook, Marks, Written
from bounce_grader.common.errors import about_one_submission, UsageError
from bounce_grader.common.files import write_whole
from bounce_grader.common.manifest import parts
from bounce_grader.formats import html
from bounce_grader.grading.previous import compared, Previous
from bounce_grader.grading.record import with_answers, without_answers

TITLE = "Bouncing"
NEW_PAGES = "feedback-new.zip"
WRITTEN = "written.json"  # the points that runs have filled in: what differs, a person has changed


def write(
    out: Path,
    submitted: Class,
    summaries: list[Summary],
    book: Gradebook | None,
    name: str,
    title: str,
    near: Similar,
    log: Log,
    adjustments_left_out: Sequence[str] = (),
    overwrite: bool = False,
    course: Course = Course(),
) -> list[str]:
    """Writes everything but the feedback. Returns sentences for the instructor, about adjustments
    and the grade book."""
    marks, left_out = _marks(submitted, summaries)
    if book is None:
        sentences = _make_up_gradebook(out / name, marks, title or TITLE, log)
    else:
        written = _read_written(out / WRITTEN)
        filled = book.fill(marks, _without_score(submitted, summaries), written, overwrite)
        write_whole(out / name, filled.data)
        write_whole(out / WRITTEN, json.dumps(filled.written, indent=1, sort_keys=True))
        sentences = [*filled.sentences, *left_out]
    sentences = [*adjustments_left_out, *adjusted(summaries), *sentences]
    write_whole(out / "grades.csv", "\ufeff" + grades.table(summaries))
    write_whole(out / "class.html", page.render(submitted, summaries, near, sentences, course))
    return sentences


def _read_written(path: Path) -> Written:
    try:
        written = json.loads(path.read_text())
        return {
            str(title): {str(id): list(map(str, points)) for id, points in by_id.items()}
            for title, by_id in written.items()
        }
    except (OSError, ValueError, AttributeError, TypeError):
        return {}  # then what stands in the grade book is kept, and listed


def _marks(submitted: Class, summaries: list[Summary]) -> tuple[dict[str, Marks], list[str]]:
    """The points of everyone who has a score, by id; a missing score must not become a zero. A
    submission that is known by its GitHub login alone gets none: its student could have chosen
    somebody else's id as a login."""
    marks: dict[str, Marks] = {}
    left_out = []
    for summary in summaries:
        student = summary.student
        for one in summary.finals:
            if submitted.logins and not one.listed:
                left_out.append(f"{student.id} isn't in roster.csv: the points are in grades.csv")
                continue
            from_canvas = not one.listed and submitted.service == "canvas"
            name = one.name or student.shown if one.listed else student.name
            marks[one.id] = Marks(name, one.points, from_canvas)
    return marks, left_out


def _without_score(submitted: Class, summaries: list[Summary]) -> dict[str, str]:
    """The reasons of submissions that got no score, by id."""
    entries = {u.user: f"{u.name} {u.reason}" for u in submitted.unmatched if u.user}
    return entries | {s.student.id: s.message for s in summaries if s.score is None}


def _make_up_gradebook(path: Path, marks: Mapping[str, Marks], title: str, log: Log) -> list[str]:
    """Writes a new grade book, but never over one that this module didn't make: it may be Canvas's,
    or edited by a person."""
    if path.exists() and not log.has_made_up(path.read_bytes()):
        return [
            f"{path.name} is one that was filled before, and stays as it was: give --gradebook and "
            "--column to fill it anew"
        ]
    data = gradebook.of_marks(marks, title, sum(part.points for part in parts()))
    log.make_up(data)
    write_whole(path, data)
    return []


class Feedback(NamedTuple):
    """What became of the feedback pages."""

    without: dict[str, str]  # the reasons for missing pages, by student's id
    to_upload: str  # a sentence: which zip has what students haven't got yet; "" if there is none


def write_feedback(
    out: Path, submitted: Class, summaries: list[Summary], reveal: bool = False
) -> Feedback:
    """Writes a feedback page for each submission, and for Canvas and Moodle a zip of the pages that
    they can import. Removes pages of earlier runs whose submissions are gone. Only with `reveal` do
    pages hold the expected answers of hidden cases."""
    folder = out / "feedback"
    folder.mkdir(exist_ok=True)
    pages: list[str] = []
    without: dict[str, str] = {}
    ids = {summary.student.id for summary in summaries}
    known = history.read(out)
    for entry in submitted.unmatched:
        if entry.feedback and entry.user not in ids:
            with suppress(UsageError), about_one_submission("there is no page"):
                write_whole(folder / entry.feedback, html.refused(entry.page_text))
                pages += [entry.feedback] if entry.feedback not in pages else []
    for summary in summaries:
        result = results.load(out / "results", summary.key)
        try:
            with about_one_submission("there is no feedback page, as it can't be written"):
                if result:
                    earlier = history.before(out, known.get(summary.student.id, []), result)
                    text = _page(summary, result, reveal, earlier)
                    write_whole(folder / summary.student.feedback, text)
                    pages.append(summary.student.feedback)
        except UsageError as error:
            without[summary.student.id] = str(error)
    history.add(out, known, summaries)
    for page_file in folder.glob("*.html"):
        if page_file.name not in pages and _is_ours(page_file):
            page_file.unlink()
    if submitted.service not in ("canvas", "moodle"):
        return Feedback(without, "")
    to_canvas = submitted.service == "canvas"
    zipped = [name for name in pages if not to_canvas or canvas.parse(name)]
    return Feedback(without, _write_zips(out, folder, zipped))


def _write_zips(out: Path, folder: Path, pages: list[str]) -> str:
    """All pages; and those that changed since the last time, because Canvas adds a comment for each
    page that it is given. Returns which to upload."""
    whole = out / "feedback.zip"
    before: dict[str, bytes] = {}
    with suppress(OSError, zipfile.BadZipFile), zipfile.ZipFile(whole) as archive:
        before = {name: archive.read(name) for name in archive.namelist()}
    changed = [name for name in pages if before.get(name) != (folder / name).read_bytes()]
    if before and changed:
        write_whole(out / NEW_PAGES, _zip(folder, changed))
    write_whole(whole, _zip(folder, pages))
    if not pages:
        return ""
    if not changed:
        old = f", and {NEW_PAGES} is an older one" if (out / NEW_PAGES).exists() else ""
        return f"No page has changed since the last run: there is nothing new to upload{old}."
    number = f"{len(changed)} page{'s' * (len(changed) > 1)}"
    if not before:
        return f"Upload {whole.name}, with {number}."
    return (
        f"Upload {NEW_PAGES}, with {number} that changed since the last run, before you give the "
        "command again: it has only what changed since then."
    )


def _is_ours(page_file: Path) -> bool:
    with page_file.open("rb") as stream:
        return f"<title>{html.TITLE}".encode() in stream.read(200)


def _page(summary: Summary, result: dict[str, Any], reveal: bool, earlier: Previous | None) -> str:
    if result["record"]:
        record = (with_answers if reveal else without_answers)(result["record"])
        record = compared(record, earlier)
        student = summary.student
        return html.render(record, student.shown, student.unused, _in_the_end(summary))
    return html.refused(result["message"])


def _in_the_end(summary: Summary) -> list[html.InTheEnd]:
    """The final points of each member, if any are changed."""
    if not summary.is_adjusted:
        return []
    several = len(summary.finals) > 1
    return [
        html.InTheEnd(
            (one.name or one.id) if several else "",
            one.points[0],
            [(a.points, a.reason, a.comment) for a in one.applied],
        )
        for one in summary.finals
    ]


def _zip(folder: Path, pages: list[str]) -> bytes:
    """The same pages give the same bytes, whenever they were written."""
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as archive:
        for name in pages:
            page_file = (folder / name).read_bytes()
            archive.writestr(zipfile.ZipInfo(name), page_file, zipfile.ZIP_DEFLATED)
    return data.getvalue()
