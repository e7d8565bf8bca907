"""Posts points and pages to Canvas: first shown as a plan, and then done if the plan is the same.

OUT/uploaded.json is written after each student, so that a run that failed half-way goes on where it
stopped, and no comment is posted twice.
"""

import hashlib
import json
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.intake.canvas_api import Canvas, Refused
from bounce_grader.classroom.intake.student import Unmatched
from bounce_grader.classroom.output import gradebook
from bounce_grader.classroom.output.gradebook import is_ours
from bounce_grader.common.escaping import terminal
from bounce_grader.common.files import read_object, write_whole
from bounce_grader.common.numbers import short

UPLOADED = "uploaded.json"
PLAN = "plan.json"
# By user: the "points" that were posted, and the "page"'s digest.
Uploaded = dict[str, dict[str, Any]]


class Change(NamedTuple):
    """What would be posted for one student; None where nothing is."""

    user: str
    name: str
    before: float | None
    points: float | None
    page: str | None  # the file's name


def show_or_post(
    canvas: Canvas,
    out: Path,
    summaries: Sequence[Summary],
    entries: Iterable[Unmatched],
    upload: bool,
    overwrite: bool,
) -> int:
    """Prints what would change on Canvas, and posts it on request if that was shown before. Returns
    1 if something is left to do."""
    changes, kept = _plan(canvas, out, summaries, entries, overwrite)
    if upload and _were_shown(out, changes):
        refused = _post(canvas, out, changes)
        posted = len(changes) - len(refused)
        print(f"Students whose points or pages were posted: {posted} of {len(changes)}.")
        _print([*refused, *kept])
        return int(bool(refused))
    write_whole(out / PLAN, json.dumps(changes))
    print(f"Students whose points or pages would change on Canvas: {len(changes)}.")
    _print([*map(_words, changes), *kept])
    if upload:
        print("This wasn't shown before: give the same command again to post it.")
    elif changes:
        print("Nothing is posted yet: add --upload.")
    return int(upload)


def _print(lines: Iterable[str]) -> None:
    print("".join(f"  {terminal(line)}\n" for line in lines), end="")


def _plan(
    canvas: Canvas,
    out: Path,
    summaries: Sequence[Summary],
    entries: Iterable[Unmatched],
    overwrite: bool,
) -> tuple[list[Change], list[str]]:
    """The changes, and sentences about points that stay because a person has entered them. A
    student who submitted nothing that can be graded gets a page that says so, and no points."""
    now = {str(s["user_id"]): s for s in canvas.all(f"{canvas.path}/submissions?per_page=100")}
    uploaded = read_object(out / UPLOADED)
    finals = [(one, s.student.feedback) for s in summaries for one in s.finals]
    wanted: list[tuple[str, str, float | None, str]] = [
        (one.id, one.name, round(one.points, 2), page) for one, page in finals
    ]
    graded = {one.id for one, _ in finals}
    others = [entry for entry in entries if entry.user in now and entry.user not in graded]
    wanted += [(entry.user, entry.name, None, entry.feedback) for entry in others]
    changes, kept = [], []
    for id, name, points, page in wanted:
        there, done = now.get(id), uploaded.get(id, {})
        if there is None:
            kept.append(f"{name or id} ({id}) isn't in the assignment on Canvas")
            continue
        before = there.get("score")
        if points is None or there.get("excused") or before == points:
            posted = None
        elif before is None or overwrite or is_ours(before, points, done.get("points", [])):
            posted = points
        else:
            kept.append(f"{name} ({id}) {gradebook.kept(short(before), short(points))}")
            posted = None
        is_new = _digest(out, page) not in ("", done.get("page"))
        if posted is not None or is_new:
            changes.append(Change(id, name, before, posted, page if is_new else None))
    return changes, kept


def _words(change: Change) -> str:
    before = "nothing" if change.before is None else short(change.before)
    points = "" if change.points is None else f"{before} -> {short(change.points)} points"
    what = " and ".join(filter(None, [points, "a page" * bool(change.page)]))
    return f"{change.name or change.user} ({change.user}): {what}"


def _were_shown(out: Path, changes: list[Change]) -> bool:
    """Whether all of these changes are among those that were shown last."""
    try:
        shown = [Change(*fields) for fields in json.loads((out / PLAN).read_text())]
    except (OSError, ValueError, TypeError):
        shown = []
    return all(change in shown for change in changes)


def _post(canvas: Canvas, out: Path, changes: list[Change]) -> list[str]:
    """Posts the changes. Returns a sentence for each that Canvas refused."""
    uploaded = read_object(out / UPLOADED)
    refused = []
    for change in changes:
        path = f"{canvas.path}/submissions/{change.user}"
        done = uploaded.setdefault(change.user, {"points": [], "page": ""})
        fields = {}
        try:
            if change.page:
                file = _upload(canvas, f"{path}/comments/files", out / "feedback" / change.page)
                fields["comment[file_ids][]"] = str(file)
            if change.points is not None:
                fields["submission[posted_grade]"] = short(change.points)
                done["points"] = [*done["points"], change.points]
                _write(out, uploaded)  # so that it counts as ours if the answer is lost
            canvas.call("PUT", path, fields)
        except Refused as error:
            refused.append(f"{change.name} ({change.user}): Canvas refused it ({error})")
            continue
        if change.page:
            done["page"] = _digest(out, change.page)
        _write(out, uploaded)
    return refused


def _write(out: Path, uploaded: Uploaded) -> None:
    write_whole(out / UPLOADED, json.dumps(uploaded, indent=1, sort_keys=True), durable=True)


def _digest(out: Path, page: str) -> str:
    try:
        return hashlib.sha256((out / "feedback" / page).read_bytes()).hexdigest()
    except OSError:
        return ""


def _upload(canvas: Canvas, path: str, file: Path) -> int:
    """Uploads a page for a comment, in Canvas's three steps. Returns its id."""
    data = file.read_bytes()
    told = canvas.call(
        "POST", path, {"name": "feedback.html", "size": str(len(data)), "content_type": "text/html"}
    )
    try:
        url, fields = str(told["upload_url"]), dict(told["upload_params"])
    except (KeyError, TypeError, ValueError):
        raise Refused("it names no address for the page") from None
    page = {"file": ("feedback.html", data, "text/html")}
    body, _ = canvas.request("POST", url, data=fields, files=page)
    try:
        return int(json.loads(body)["id"])
    except (KeyError, TypeError, ValueError):
        raise Refused("it takes the page, and gives no id") from None
