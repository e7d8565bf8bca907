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
from bounce_grader.common.escaping import terminal
from bounce_grader.common.files import read_object, write_whole
from bounce_grader.common.numbers import short

UPLOADED = "uploaded.json"
PLAN = "plan.json"
Uploaded = dict[str, dict[str, Any]]  # by user: "points" that were posted, and the "page"'s digest


class Change(NamedTuple):
    """What would be posted for one student; None where nothing is."""

    user: str
    name: str
    before: float | None
    points: float | None
    page: str | None  # the file's name


def plan(
    canvas: Canvas,
    out: Path,
    summaries: Sequence[Summary],
    unmatched: Iterable[Unmatched],
    overwrite: bool,
) -> tuple[list[Change], list[str]]:
    """The changes, and sentences about points that stay because a person has entered them. A
    student who submitted nothing that can be graded gets a page that says so, and no points."""
    now = {str(s["user_id"]): s for s in canvas.all(f"{canvas.path}/submissions?per_page=100")}
    uploaded = read_object(out / UPLOADED)
    changes, kept = [], []
    for summary in summaries:
        for one in summary.finals:
            there = now.get(one.id)
            if there is None:
                kept.append(f"{one.name or one.id} ({one.id}) isn't in the assignment on Canvas")
                continue
            done = uploaded.get(one.id, {})
            before, points = there.get("score"), round(one.points[0], 2)
            ours = before is None or gradebook.is_ours(before, points, done.get("points", []))
            posted: float | None = points if before != points else None
            if there.get("excused"):
                posted = None
            elif posted is not None and not ours and not overwrite:
                why = gradebook.kept(short(before or 0.0), short(points))
                kept.append(f"{one.name} ({one.id}) {why}")
                posted = None
            page = summary.student.feedback
            is_new = _digest(out, page) not in ("", done.get("page"))
            if posted is not None or is_new:
                changes.append(Change(one.id, one.name, before, posted, page if is_new else None))
    graded = {one.id for summary in summaries for one in summary.finals}
    for entry in unmatched:
        is_new = _digest(out, entry.feedback) not in ("", uploaded.get(entry.user, {}).get("page"))
        if is_new and entry.user in now and entry.user not in graded:
            before = now[entry.user].get("score")
            changes.append(Change(entry.user, entry.name, before, None, entry.feedback))
    return changes, kept


def show(changes: list[Change]) -> list[str]:
    lines = []
    for change in changes:
        before = "nothing" if change.before is None else short(change.before)
        points = "" if change.points is None else f"{before} -> {short(change.points)} points"
        page = "a page" if change.page else ""
        what = " and ".join(filter(None, [points, page]))
        lines.append(terminal(f"{change.name or change.user} ({change.user}): {what}"))
    return lines


def were_shown(out: Path, changes: list[Change]) -> bool:
    """Whether all of these changes are among those that were shown last."""
    try:
        shown = {json.dumps(change) for change in json.loads((out / PLAN).read_text())}
    except (OSError, ValueError):
        shown = set()
    return all(json.dumps(change) in shown for change in changes)


def remember_shown(out: Path, changes: list[Change]) -> None:
    write_whole(out / PLAN, json.dumps(changes))


def post(canvas: Canvas, out: Path, changes: list[Change]) -> list[str]:
    """Posts the changes. Returns a sentence for each that Canvas refused."""
    uploaded = read_object(out / UPLOADED)
    refused = []
    for change in changes:
        path = f"{canvas.path}/submissions/{change.user}"
        done = uploaded.setdefault(change.user, {"points": [], "page": ""})
        try:
            fields = {}
            if change.points is not None:
                fields["submission[posted_grade]"] = short(change.points)
            if change.page:
                file = _upload(canvas, f"{path}/comments/files", out / "feedback" / change.page)
                fields["comment[file_ids][]"] = str(file)
            if change.points is not None:
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
