"""Writes the feedback pages; and for Canvas, Moodle and Brightspace, zips of those that they import."""

import zipfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from functools import partial
from pathlib import Path

from bounce_grader.classroom.grading.summary import MEMBERS, Summary
from bounce_grader.classroom.intake.services import CANVAS
from bounce_grader.common.errors import about_one_submission, UsageError
from bounce_grader.common.files import write_whole, zipped
from bounce_grader.formats import html

EACH_MEMBER = "As graded. What counts for each member is on a page of their own."


def write(out: Path, summaries: Sequence[Summary]) -> dict[str, str]:
    """Writes a page for each submission, and one for each member of a group. Returns them by name,
    and notes which can't be written."""
    (out / "feedback").mkdir(exist_ok=True)
    pages: dict[str, str] = {}
    for summary in summaries:
        if summary.student.feedback and summary.state != "failed":
            try:
                with about_one_submission("there is no feedback page, as it can't be written"):
                    for name, page in _pages(summary):
                        write_whole(out / "feedback" / name, page)
                        pages[name] = page
            except UsageError as error:
                summary.notes.append(str(error))
    return pages


def _pages(summary: Summary) -> Iterator[tuple[str, str]]:
    """By name. A group's page says what counts if that is the same for each member."""
    student, finals = summary.student, summary.finals
    if not summary.record:
        yield student.feedback, html.refused(summary.message)
        return
    page = partial(html.render, summary.record, unused=student.unused, comments=summary.comments)
    same = len({(one.points, one.applied) for one in finals}) == 1
    note = "" if same or not finals else EACH_MEMBER
    yield student.feedback, page(student.shown, final=finals[0] if same else None, note=note)
    for one in finals if len(student.members) > 1 else ():
        yield summary.page_of(one), page(one.name or one.id, final=one)


def zip_new(out: Path, service: str, pages: Mapping[str, str]) -> str:
    """Zips the pages that no earlier zip has as they are now: Canvas adds a comment for each page
    that it is given. Returns what to upload; "" if the service takes no zip."""
    own = f"{MEMBERS}/"  # an upload would show these to the whole group
    differ = any(EACH_MEMBER in page for page in pages.values())
    others = f" No zip has the pages of groups' members: they are in feedback/{own}" * differ
    pages = {name: page for name, page in pages.items() if not name.startswith(own)}
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
        return f"Upload {path.name}, with {number} that no earlier zip has.{others}"
    return f"No page has changed since the last zip.{others}" if pages else ""
