"""Posts points and pages to Canvas: first shown as a plan, and then done if the plan is the same.

Canvas itself tells which points and which page a student has, so a run that failed half-way goes on
where it stopped, and no comment is posted twice. The name of a page's file tells its content.
"""

import hashlib
import json
import re
from collections import defaultdict
from collections.abc import Iterable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any, NamedTuple

from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.intake.canvas_api import Canvas, name_of, Refused, Submission
from bounce_grader.classroom.intake.gradebook import Gradebook, Line
from bounce_grader.classroom.intake.table import number_in
from bounce_grader.classroom.output.points import fill, note, WRITTEN, Written
from bounce_grader.common.escaping import printable_name, terminal
from bounce_grader.common.files import read_object, write_whole
from bounce_grader.common.numbers import short

PLAN = "plan.json"
PAGE = re.compile(r"feedback-[0-9a-f]{8}")  # of a file's name, to which Canvas may add a number


class Change(NamedTuple):
    """What would be posted for one student; "" where nothing is."""

    user: str
    name: str
    before: str  # points
    points: str
    page: str  # the file's name


def show_or_post(canvas: Canvas, summaries: Sequence[Summary], options: Any, deducts: bool) -> int:
    """Prints what would change on Canvas; on request, posts it if it was shown before. Returns 1 if
    something is left to do. `deducts` says whether the kit deducts points for lateness."""
    out, upload = options.out, options.upload
    written = read_object(out / WRITTEN)
    finals = [one for summary in summaries for one in summary.finals]
    listed = list(canvas.submissions())
    book = _gradebook(canvas, listed)
    filled, sentences = fill(book, finals, False, written, options.overwrite)
    points = {line.ids[0]: short(value) for line, value in filled if number_in(line.there) != value}
    sentences[:0] = [*_level(listed, filled, points), *_twice(canvas, deducts)]
    page_of = {one.id: s.page_of(one) for s in summaries for one in s.finals}
    page_of |= {s.student.id: s.student.feedback for s in summaries if s.state == "unreadable"}
    changes = []
    for line, submission in zip(book.lines, listed):
        user = line.ids[0]
        page = page_of.get(user, "")
        is_new = _name(out, page) not in ("", _posted(submission))
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


def _gradebook(canvas: Canvas, listed: Iterable[Submission]) -> Gradebook:
    """The points are those that were entered: Canvas may have deducted some for lateness."""
    book = Gradebook("canvas", "the assignment on Canvas", canvas.assignment)
    for number, submission in enumerate(listed):
        there = _entered(submission)
        stays = "is excused, and gets no points" * bool(submission.get("excused"))
        ids = [str(submission["user_id"])]
        book.lines.append(Line(number, ids, name_of(submission), there, stays))
    return book


def _entered(submission: Submission) -> str:
    points = submission.get("entered_score", submission.get("score"))
    return "" if points is None else short(points)


def _posted(submission: Submission) -> str:
    """The newest page that a student has, by its name; "" if there is none."""
    comments = submission.get("submission_comments") or []
    files = [file for comment in comments for file in comment.get("attachments") or []]
    return next(iter(PAGE.findall(" ".join(str(f.get("display_name")) for f in files))[::-1]), "")


def _level(
    listed: Iterable[Submission], filled: Iterable[tuple[Line, float]], points: dict[str, str]
) -> list[str]:
    """Where Canvas gives all members of a group one grade, leaves one of them in `points`, or none if
    they differ. Returns a sentence on each such group."""
    have: dict[tuple[Any, str], dict[str, str]] = defaultdict(dict)  # by the group and the user
    values, sentences = {line.ids[0]: short(value) for line, value in filled}, []
    for submission in listed:
        settings, group = submission.get("assignment") or {}, submission.get("group") or {}
        apart = settings.get("grade_group_students_individually", True)
        if settings.get("group_category_id") and not apart and group.get("id"):
            user = str(submission["user_id"])
            have[group["id"], printable_name(str(group.get("name")))][user] = values.get(user, "no")
    for (_, name), members in have.items():
        differ = len({*members.values()}) > 1
        new = [user for user in members if user in points]
        for user in new if differ else new[1:]:
            del points[user]
        if differ:
            unlike = f"they have {' and '.join(dict.fromkeys(members.values()))} points"
            then = "choose individual grades there, or give them the same"
            sentences.append(f"{name}: Canvas gives its members one grade, but {unlike}: {then}")
        elif new:
            sentences.append(f"{name}: its points are posted once, for all of its members")
    return sentences


def _twice(canvas: Canvas, deducts: bool) -> list[str]:
    """A sentence if both Canvas and the kit deduct points for lateness."""
    with suppress(Refused):  # as where the course has no policy
        policy = canvas.call("GET", f"{canvas.course}/late_policy") if deducts else {}
        if (policy.get("late_policy") or {}).get("late_submission_deduction_enabled"):
            both = "Canvas deducts points for lateness by its late policy, and so does course.toml"
            return [f"{both}: they are deducted twice, unless you remove one of the two"]
    return []


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
        name = _name(out, change.page)

        def is_done() -> bool:
            now = canvas.call("GET", f"{path}?include[]=submission_comments")
            return name in ("", _posted(now)) and change.points in ("", _entered(now))

        fields = {"submission[posted_grade]": change.points} if change.points else {}
        try:
            if change.page:
                page = out / "feedback" / change.page
                file = _upload(canvas, f"{path}/comments/files", f"{name}.html", page.read_bytes())
                fields["comment[file_ids][]"] = str(file)
            canvas.call("PUT", path, fields, is_done)
        except Refused as error:
            refused.append(f"{change.name} ({change.user}): Canvas refused it ({error})")
    return refused


def _name(out: Path, page: str) -> str:
    """By its content, without its ending; "" if there is no page."""
    try:
        digest = hashlib.sha256((out / "feedback" / page).read_bytes()).hexdigest()
    except OSError:
        return ""
    return f"feedback-{digest[:8]}"


def _upload(canvas: Canvas, path: str, name: str, data: bytes) -> int:
    """Uploads a page for a comment, in Canvas's three steps. Returns its id."""
    asked = {"name": name, "size": str(len(data)), "content_type": "text/html"}
    page = {"file": (name, data, "text/html")}
    try:
        told = canvas.call("POST", path, asked)
        url, fields = str(told["upload_url"]), dict(told["upload_params"])
        body, made = canvas.request("POST", url, data=fields, files=page, allow_redirects=False)
        if made:  # asked for apart, as a redirection would lose the token
            body, _ = canvas.request("GET", made)
        return int(json.loads(body)["id"])
    except (KeyError, TypeError, ValueError):
        raise Refused("it doesn't say where the page goes, or gives no id for it") from None
