"""Writes the feedback pages; and for Canvas and Moodle, zips of the pages that they can import."""

import zipfile
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

from bounce_grader.classroom.grading import results
from bounce_grader.classroom.grading.results import Result
from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.intake import canvas
from bounce_grader.classroom.intake.student import Class
from bounce_grader.common.errors import about_one_submission, UsageError
from bounce_grader.common.files import write_whole, zipped
from bounce_grader.formats import html
from bounce_grader.grading.record import with_answers, without_answers

NEW_PAGES = "feedback-new.zip"
MODE = 0o644  # of pages in a zip


class Feedback(NamedTuple):
    """What became of the feedback pages."""

    without: dict[str, str]  # the reasons for missing pages, by student's id
    to_upload: str  # a sentence: which zip has what students haven't got yet; "" if there is none


def write(out: Path, submitted: Class, summaries: Sequence[Summary], reveal: bool) -> Feedback:
    """Writes a page for each submission, and for whoever handed in what can't be graded. Removes
    pages of earlier runs whose submissions are gone. Only with `reveal` do pages hold the expected
    answers of hidden cases."""
    folder = out / "feedback"
    folder.mkdir(exist_ok=True)
    pages: dict[str, None] = {}  # names, in order
    without: dict[str, str] = {}
    ids = {summary.student.id for summary in summaries}
    for entry in submitted.unmatched:
        if entry.feedback and entry.user not in ids:
            with suppress(UsageError), about_one_submission("there is no page"):
                write_whole(folder / entry.feedback, html.refused(entry.page_text))
                pages[entry.feedback] = None
    for summary in summaries:
        id, name = summary.student.id, summary.student.feedback
        result = results.load(out / "results", summary.key)
        try:
            with about_one_submission("there is no feedback page, as it can't be written"):
                if result:
                    write_whole(folder / name, _page(summary, result, reveal))
                    pages[name] = None
        except UsageError as error:
            without[id] = str(error)
    for page_file in folder.glob("*.html"):
        if page_file.name not in pages and _is_ours(page_file):
            page_file.unlink()
    if submitted.service not in ("canvas", "moodle"):
        return Feedback(without, "")
    zipped = [name for name in pages if submitted.service == "moodle" or canvas.parse(name)]
    return Feedback(without, _write_zips(out, folder, zipped))


def _page(summary: Summary, result: Result, reveal: bool) -> str:
    if not result["record"]:
        return html.refused(result["message"])
    record = (with_answers if reveal else without_answers)(result["record"])
    student = summary.student
    in_the_end = summary.finals if summary.is_adjusted else ()
    return html.render(record, student.shown, student.unused, in_the_end)


def _is_ours(page_file: Path) -> bool:
    with page_file.open("rb") as stream:
        return f"<title>{html.TITLE}".encode() in stream.read(200)


def _write_zips(out: Path, folder: Path, pages: Sequence[str]) -> str:
    """All pages; and those that changed since the last time, because Canvas adds a comment for each
    page that it is given. Returns which to upload."""
    whole = out / "feedback.zip"
    before: dict[str, tuple[bytes, int]] = {}
    with suppress(OSError, zipfile.BadZipFile), zipfile.ZipFile(whole) as archive:
        before = {name: (archive.read(name), MODE) for name in archive.namelist()}
    now = {name: ((folder / name).read_bytes(), MODE) for name in pages}
    changed = {name: page for name, page in now.items() if before.get(name) != page}
    if before and changed:
        write_whole(out / NEW_PAGES, zipped(changed, True))
    write_whole(whole, zipped(now, True))
    number = f"{len(changed)} page{'s' * (len(changed) > 1)}"
    if not pages:
        return ""
    if not changed:
        last = NEW_PAGES if (out / NEW_PAGES).exists() else whole.name
        return f"No page has changed since the last run: upload {last} unless you have done that."
    if not before:
        return f"Upload {whole.name}, with {number}."
    return (
        f"Upload {NEW_PAGES}, with {number} that changed since the last run, before you give the "
        "command again: it has only what changed since then."
    )
