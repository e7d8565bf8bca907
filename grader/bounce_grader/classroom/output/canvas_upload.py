"""Posts points and pages to Canvas: first shown as a plan, and then done if the plan is the same.

OUT/written.json is written after each student, so that a run that failed half-way goes on where it
stopped, and no comment is posted twice.
"""

import hashlib
import json
from collections.abc import Iterable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any, NamedTuple

from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.intake.canvas_api import Canvas, name_of, Refused
from bounce_grader.classroom.intake.gradebook import Gradebook, Line
from bounce_grader.classroom.intake.table import number_in
from bounce_grader.classroom.output.points import fill, note, WRITTEN, Written
from bounce_grader.common.escaping import terminal
from bounce_grader.common.files import read_object, write_whole
from bounce_grader.common.numbers import short

PLAN = "plan.json"
PAGES = "pages"  # in written.json: the digest of the page that each user has, by assignment


class Change(NamedTuple):
    """What would be posted for one student; "" where nothing is."""

    user: str
    name: str
    before: str  # points
    points: str
    page: str  # the file's name


def show_or_post(canvas: Canvas, summaries: Sequence[Summary], options: Any) -> int:
    """Prints what would change on Canvas; on request, posts it if it was shown before. Returns 1 if
    something is left to do."""
    out, upload = options.out, options.upload
    written = read_object(out / WRITTEN)
    finals = [one for summary in summaries for one in summary.finals]
    book = _gradebook(canvas)
    filled, sentences = fill(book, finals, False, written, options.overwrite)
    points = {line.ids[0]: short(value) for line, value in filled if number_in(line.there) != value}
    posted_pages = written.setdefault(f"{PAGES} {canvas.assignment}", {})
    page_of = {one.id: s.page_of(one) for s in summaries for one in s.finals}
    page_of |= {s.student.id: s.student.feedback for s in summaries if s.state == "unreadable"}
    changes = []
    for line in book.lines:
        user = line.ids[0]
        page = page_of.get(user, "")
        is_new = _digest(out, page) not in ("", posted_pages.get(user))
        change = Change(user, line.person, line.there, points.get(user, ""), page * is_new)
        changes += [change] * bool(change.points or change.page)
    shown = []  # last
    with suppress(OSError, ValueError):
        shown = json.loads((out / PLAN).read_text())
    if upload and all(list(change) in shown for change in changes):
        refused = _post(canvas, out, changes, written)
        posted = len(changes) - len(refused)
        print(f"Students whose points or pages were posted: {posted} of {len(changes)}.")
        _print([*refused, *sentences])
        return int(bool(refused))
    write_whole(out / PLAN, json.dumps(changes))
    print(f"Students whose points or pages would change on Canvas: {len(changes)}.")
    _print([*map(_words, changes), *sentences])
    if upload:
        print("This wasn't shown before: give the same command again to post it.")
    elif changes:
        print("Nothing is posted yet: add --upload.")
    return int(upload)


def _print(lines: Iterable[str]) -> None:
    print("".join(f"  {terminal(line)}\n" for line in lines), end="")


def _gradebook(canvas: Canvas) -> Gradebook:
    book = Gradebook("canvas", "the assignment on Canvas", canvas.assignment)
    for number, submission in enumerate(canvas.submissions()):
        there = "" if submission.get("score") is None else short(submission["score"])
        stays = "is excused, and gets no points" * bool(submission.get("excused"))
        ids = [str(submission["user_id"])]
        book.lines.append(Line(number, ids, name_of(submission), there, stays))
    return book


def _words(change: Change) -> str:
    points = f"{change.before or 'nothing'} -> {change.points} points" if change.points else ""
    what = " and ".join(filter(None, [points, "a page" * bool(change.page)]))
    return f"{change.name or change.user} ({change.user}): {what}"


def _post(canvas: Canvas, out: Path, changes: list[Change], written: Written) -> list[str]:
    """Posts the changes. Returns a sentence for each that Canvas refused."""
    note(out, written)  # so that points count as ours if the answer is lost
    refused = []
    for change in changes:
        path = f"{canvas.path}/submissions/{change.user}"
        fields = {"submission[posted_grade]": change.points} if change.points else {}
        try:
            if change.page:
                file = _upload(canvas, f"{path}/comments/files", out / "feedback" / change.page)
                fields["comment[file_ids][]"] = str(file)
            canvas.call("PUT", path, fields)
        except Refused as error:
            refused.append(f"{change.name} ({change.user}): Canvas refused it ({error})")
            continue
        if change.page:
            written[f"{PAGES} {canvas.assignment}"][change.user] = _digest(out, change.page)
            note(out, written)
    return refused


def _digest(out: Path, page: str) -> str:
    try:
        return hashlib.sha256((out / "feedback" / page).read_bytes()).hexdigest()
    except OSError:
        return ""


def _upload(canvas: Canvas, path: str, file: Path) -> int:
    """Uploads a page for a comment, in Canvas's three steps. Returns its id."""
    data = file.read_bytes()
    asked = {"name": "feedback.html", "size": str(len(data)), "content_type": "text/html"}
    page = {"file": ("feedback.html", data, "text/html")}
    try:
        told = canvas.call("POST", path, asked)
        url, fields = str(told["upload_url"]), dict(told["upload_params"])
        body, _ = canvas.request("POST", url, data=fields, files=page)
        return int(json.loads(body)["id"])
    except (KeyError, TypeError, ValueError):
        raise Refused("it doesn't say where the page goes, or gives no id for it") from None
