"""./kit class: grades a class, step by step."""

import errno
import fcntl
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

from bounce_grader.classroom.grading import grading, near_copies, regrade, results
from bounce_grader.classroom.grading.log import Log
from bounce_grader.classroom.grading.near_copies import Similar
from bounce_grader.classroom.grading.request import Request
from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.grading.results import Stamp, Task
from bounce_grader.classroom.intake import adjustments, canvas_api, course, roster, students
from bounce_grader.classroom.intake.canvas import is_name_of
from bounce_grader.classroom.intake.canvas_api import Canvas
from bounce_grader.classroom.intake.roster import Roster
from bounce_grader.classroom.intake.student import Class, Student
from bounce_grader.classroom.output import canvas_upload, final, outputs, page, table
from bounce_grader.classroom.output.final import Meant, Rules
from bounce_grader.classroom.output.gradebook import Gradebook
from bounce_grader.classroom.output.gradebook_canvas import CanvasGradebook
from bounce_grader.classroom.output.gradebook_others import (
    BlackboardWorksheet,
    is_blackboard,
    is_moodle,
    MoodleWorksheet,
)
from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.escaping import first_few, printable_name, terminal
from bounce_grader.common.files import remove_abandoned
from bounce_grader.common.manifest import parts

MOST_LINES = 20  # of a kind on the terminal; class.html has them all


def run(request: Request) -> int:
    """Returns 0, or 3 if the kit failed on a submission, which then has no score."""
    try:
        return _whole(request)
    except KeyboardInterrupt:
        print(
            "kit: stopped; what is graded is kept. Run the same command again to go on.",
            file=sys.stderr,
        )
        return 130


def _whole(request: Request) -> int:
    book = _gradebook(request)
    others = book.people(own_ids_only=False) if book else {}
    same_person = book.same_person() if book else {}
    listed = roster.read(request.out).named(others, same_person)
    own = (course.read(request.out), listed, adjustments.read(request.out))
    for folder in request.corpus:
        students.read(folder)  # so that a wrong one is said now
    canvas = _canvas(request)
    if canvas:
        intake = canvas_api.download(canvas, request.out)
    else:
        assert request.submissions
        intake = students.read(request.submissions, book.people() if book else {})
    _require_the_same_service(request, book, intake)
    people = {**others, **listed.people()}
    names = {same_person[id]: name for id, name in people.items() if id in same_person}
    rules = Rules(*own, same_person, names, intake.logins)
    if book and intake.logins and not rules.roster:
        raise UsageError(
            f"{request.gradebook} can't be matched with GitHub logins, which students choose: "
            f"write {request.out / roster.NAME}, whose columns submission and id say whose each "
            "login is; or leave --gradebook out, and take the points from grades.csv"
        )
    _name_persons(intake, book, rules.roster)
    if book:
        _require_students_of(book, request, intake, rules.roster)
    is_told = _find_out_lateness(intake, book)
    meant = final.meant_by(rules, intake.students, others)
    meant.left_out = [*final.unknown_lateness(rules.course, intake, is_told), *meant.left_out]
    with _locked(request.out):
        remove_abandoned(request.out)
        log = Log(request.out / "log.jsonl")
        try:
            return _run(request, intake, book, log, rules, meant, canvas)
        except OSError as error:
            if error.errno != errno.ENOSPC:
                raise
            raise KitError(
                f"the disk with {request.out} or with the temporary files is full: make room, and "
                "run the same command again. What is graded is kept"
            ) from error
        finally:
            log.close()


def _run(
    request: Request,
    intake: Class,
    book: Gradebook | None,
    log: Log,
    rules: Rules,
    meant: Meant,
    canvas: Canvas | None,
) -> int:
    folder = request.out / "results"
    regrade.finish(request.out)
    stamp = results.stamp_now(request.trust, request.sanitize)
    tasks = [
        results.task_of(s, stamp, folder, request.speed, request.trust) for s in intake.students
    ]
    if request.regrade:
        return _regrade(request, request.regrade, tasks, stamp, log)
    if request.apply:
        regrade.apply(request.out, tasks, stamp, log)
    results.begin(folder, stamp)
    failed = grading.grade_missing(tasks, request, log)
    summaries = grading.summarize(tasks, failed)
    summaries = final.with_finals(summaries, rules, meant)
    readable = [s.student for s in summaries if s.state != "unreadable"]
    near = near_copies.find(readable, request.trust, request.corpus)
    feedback = outputs.write_feedback(request.out, intake, summaries, request.reveal)
    for reasons in (near.incomplete, feedback.without):
        summaries = [
            s.with_note(reasons[s.student.id]) if s.student.id in reasons else s for s in summaries
        ]
    remarks = outputs.write(
        request.out,
        intake,
        summaries,
        book,
        _filled_in(request).name,
        request.columns.get(0, ""),
        near,
        log,
        meant.left_out,
        request.overwrite,
        rules.course,
    )
    status = _say(request, intake, summaries, book, remarks, _alike(near, summaries))
    if feedback.to_upload and not canvas:
        print(feedback.to_upload)
    return max(status, _to_canvas(request, canvas, intake, summaries) if canvas else 0)


def _canvas(request: Request) -> Canvas | None:
    if not request.canvas:
        return None
    token = canvas_api.token_of_environment()
    return Canvas(os.environ.get("CANVAS_URL", ""), request.canvas, token)


def _to_canvas(request: Request, canvas: Canvas, intake: Class, summaries: list[Summary]) -> int:
    """Shows what would change on Canvas, and posts it if that was shown before. Returns 1 if
    something is left to do."""
    changes, kept = canvas_upload.plan(
        canvas, request.out, summaries, intake.unmatched, request.overwrite
    )
    shown = canvas_upload.were_shown(request.out, changes)
    canvas_upload.remember_shown(request.out, changes)
    if request.upload and shown:
        refused = canvas_upload.post(canvas, request.out, changes)
        posted = len(changes) - len(refused)
        print(f"Students whose points or pages were posted: {posted} of {len(changes)}.")
        print("".join(f"  {terminal(line)}\n" for line in [*refused, *kept]), end="")
        return int(bool(refused))
    print(f"Students whose points or pages would change on Canvas: {len(changes)}.")
    lines = [*canvas_upload.show(changes), *map(terminal, kept)]
    print("".join(f"  {line}\n" for line in lines), end="")
    if request.upload:
        print("This wasn't shown before: give the same command again to post it.")
        return 1
    if changes:
        print("Nothing is posted yet: add --upload.")
    return 0


def _require_the_same_service(request: Request, book: Gradebook | None, intake: Class) -> None:
    """Raises UsageError if the submissions and the grade book come from different services, where
    the same id can be that of different students."""
    if book and intake.service and book.service != intake.service:
        raise UsageError(
            f"{request.submissions} is a download from {intake.service.capitalize()}, and "
            f"{request.gradebook} a file from {book.service.capitalize()}: give both from one"
        )


def _name_persons(intake: Class, book: Gradebook | None, listed: Roster) -> None:
    """Gives each submission the name of its person, as the roster or the grade book has it. In a
    Canvas download, a group has the id of one of its members, but a name of its own."""
    people = book.people(intake.service == "canvas") if book else {}

    def name_of(student: Student) -> str:
        own = listed.members_of(student)
        if own:
            names = [member.name for member in own]
            return " and ".join(names) if all(names) else ""
        if intake.logins:
            return ""
        person = people.get(student.id, "")
        of_group = intake.service == "canvas" and not is_name_of(person, student.name)
        return "" if of_group else person or (student.name if intake.service else "")

    intake.students = [replace(s, person=name_of(s) or s.person) for s in intake.students]
    intake.students.sort(key=lambda student: (student.shown.casefold(), student.id))


def _find_out_lateness(intake: Class, book: Gradebook | None) -> bool:
    """Gives each submission the lateness that the grade book has. Returns whether the service tells
    who was late."""
    late = book.days_late() if book else {}
    intake.students = [
        replace(s, late=late[s.id] != 0, late_days=late[s.id] or 0) if s.id in late else s
        for s in intake.students
    ]
    return intake.service == "canvas" or bool(late)


def _alike(near: Similar, summaries: list[Summary]) -> list[str]:
    """A sentence for each of the nearest copies."""
    names = page.names_of(summaries)
    sentences = [
        f"{' and '.join(page.pair_names(pair, names))} have {page.pair_share(pair)} in common: "
        "look whether one is a copy"
        for pair in near.pairs
    ]
    return sentences + [f"{near.more} more pairs stand out"] * bool(near.more)


def _gradebook(request: Request) -> Gradebook | None:
    """The grade book, which is read and checked before anything is graded or written."""
    if request.gradebook is None:
        return None
    if request.gradebook.resolve() == _filled_in(request).resolve():
        raise UsageError(f"{request.gradebook} would be overwritten: give another folder as --out")
    max_points = {0: sum(part.points for part in parts()), **{p.number: p.points for p in parts()}}
    file = table.read(request.gradebook)
    services = [(is_blackboard, BlackboardWorksheet), (is_moodle, MoodleWorksheet)]
    kind = next((book for wrote, book in services if wrote(file)), CanvasGradebook)
    return kind(file, request.gradebook.name, request.columns, max_points)


def _filled_in(request: Request) -> Path:
    """The path of the filled-in grade book. Blackboard's file keeps its ending."""
    own = request.gradebook.suffix.lower() if request.gradebook else ""
    return request.out / f"gradebook{own if own in ('.xls', '.txt') else '.csv'}"


def _require_students_of(book: Gradebook, request: Request, intake: Class, listed: Roster) -> None:
    ids = [student.id for student in intake.students]
    members = [member.id for student in intake.students for member in listed.members_of(student)]
    if members:
        book.require_some_of(members, own_ids_only=False)
        return
    if all(id.startswith("anon_") for id in ids):
        raise UsageError(
            f"{request.submissions} is of an anonymous assignment, whose names are in no grade "
            "book: "
            "post the grades in Canvas, and download the submissions again; or leave --gradebook "
            "out"
        )
    book.require_some_of(ids, own_ids_only=intake.service == "canvas")


@contextmanager
def _locked(out: Path) -> Iterator[None]:
    """Locks the output folder, so that only one run writes to it. The lock ends with the
    process."""
    try:
        out.mkdir(mode=0o700, parents=True, exist_ok=True)  # it will hold points and answers
        lock = os.open(out / ".lock", os.O_CREAT | os.O_RDWR, 0o644)
    except OSError as error:
        raise UsageError(f"{out} can't be written: {error.strerror}") from error
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError as error:
        os.close(lock)
        raise UsageError(f"another run is under way in {out}: wait for it, or stop it") from error
    try:
        yield
    finally:
        os.close(lock)


def _regrade(request: Request, chosen: str, tasks: list[Task], stamp: Stamp, log: Log) -> int:
    again = regrade.begin(request.out, chosen, tasks, stamp)
    failed = grading.grade_missing(again, request, log)
    if failed:
        raise KitError(
            f"submissions that could not be graded again: {len(failed)}; nothing is changed"
        )
    print("\n".join(regrade.differences(request.out, again)))
    return 0


def _say(
    request: Request,
    intake: Class,
    summaries: list[Summary],
    book: Gradebook | None,
    remarks: list[str],
    copies: list[str],
) -> int:
    """Says what came out. Who is in the grade book and has no score is named by the remarks on it."""
    graded = [s for s in summaries if s.state == "graded"]
    looks = sum(bool(s.needs_a_look) for s in summaries)
    print(f"{len(graded)} of {intake.handed_in} submissions graded ({intake.source}).")
    if equal := len(graded) - len({s.key for s in graded}):
        whose = f"{equal} of them equal others" if equal > 1 else "One of them equals another"
        print(f"{whose} letter for letter: equal ones are graded once.")
    if looks or intake.unmatched:
        print(
            f"{looks} need a look, {len(intake.unmatched)} can't be graded or aren't matched; "
            f"{request.out / 'class.html'} says which, and why."
        )
    failed = [f"{s.student.shown} ({s.student.id})" for s in summaries if s.state == "failed"]
    if failed:
        print(f"The kit failed on {terminal(first_few(failed))}: run the same command again.")
    in_book = book.people(intake.service == "canvas") if book else {}
    not_graded = [
        f"{printable_name(unmatched.name)!r} {unmatched.reason}"
        for unmatched in intake.unmatched
        if unmatched.user not in in_book
    ]
    to_look_at = [
        f"{s.student.shown} ({s.student.id}): {'; '.join(s.needs_a_look)}"
        for s in summaries
        if s.needs_a_look and (s.state == "graded" or s.student.id not in in_book)
    ]
    more = 0
    for lines in (not_graded, to_look_at, remarks, copies):
        print("".join(f"  {terminal(line)}\n" for line in lines[:MOST_LINES]), end="")
        more += len(lines[MOST_LINES:])
    if more:
        print(f"  and {more} more, in class.html")
    print(
        f"Written to {request.out}: {_filled_in(request).name}, grades.csv, class.html, feedback/"
    )
    return 3 if failed else 0
