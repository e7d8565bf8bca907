"""Writes the feedback pages; and for Canvas, Moodle and Brightspace, zips of those that they import."""

import zipfile
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path

from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.intake.services import CANVAS
from bounce_grader.common.errors import about_one_submission, UsageError
from bounce_grader.common.files import write_whole, zipped
from bounce_grader.formats import html


def write(out: Path, summaries: Sequence[Summary]) -> dict[str, str]:
    """Writes a page for each submission. Returns them by name, and notes which can't be written."""
    (out / "feedback").mkdir(exist_ok=True)
    pages: dict[str, str] = {}
    for summary in summaries:
        name = summary.student.feedback
        if name and summary.state != "failed":
            try:
                with about_one_submission("there is no feedback page, as it can't be written"):
                    page = _page(summary)
                    write_whole(out / "feedback" / name, page)
                    pages[name] = page
            except UsageError as error:
                summary.notes.append(str(error))
    return pages


def _page(summary: Summary) -> str:
    if not summary.record:
        return html.refused(summary.message)
    student = summary.student
    in_the_end = summary.finals if any(final.applied for final in summary.finals) else ()
    return html.render(summary.record, student.shown, student.unused, *in_the_end)


def zip_new(out: Path, service: str, pages: Mapping[str, str]) -> str:
    """Zips the pages that no earlier zip has as they are now: Canvas adds a comment for each page
    that it is given. Returns what to upload; "" if the service takes no zip."""
    if service == "brightspace":  # into the folders of its download
        pages = {f"{name.removesuffix('.html')}/feedback.html": pages[name] for name in pages}
    elif service != "moodle":
        pages = {name: pages[name] for name in pages if service == "canvas" and CANVAS.parse(name)}
    earlier = sorted(out.glob("feedback-[0-9][0-9][0-9].zip"))
    before: dict[str, bytes] = {}
    for path in earlier:
        with suppress(zipfile.BadZipFile), zipfile.ZipFile(path) as archive:
            before |= {name: archive.read(name) for name in archive.namelist()}
    now = {name: (page.encode(), 0o644) for name, page in pages.items()}
    changed = {name: page for name, page in now.items() if before.get(name) != page[0]}
    if changed:
        last = earlier[-1].stem[-3:] if earlier else "0"
        path = out / f"feedback-{int(last) + 1:03}.zip"
        write_whole(path, zipped(changed, True))
        number = f"{len(changed)} page{'s' * (len(changed) > 1)}"
        return f"Upload {path.name}, with {number} that no earlier zip has."
    return "No page has changed since the last zip." if pages else ""
