"""./kit class: grades a class, step by step."""

import errno
import fcntl
import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

from bounce_grader.classroom.grading import grading, near_copies, regrade, results, unit
from bounce_grader.classroom.grading.near_copies import Similar
from bounce_grader.classroom.grading.results import Task
from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.grading.unit import Unit
from bounce_grader.classroom.intake import canvas_api, instructor_files, students
from bounce_grader.classroom.intake.canvas_api import Canvas
from bounce_grader.classroom.intake.instructor_files import Course, ROSTER
from bounce_grader.classroom.intake.people import People
from bounce_grader.classroom.intake.student import Class, Student
from bounce_grader.classroom.output import canvas_upload, feedback, final, gradebook
from bounce_grader.classroom.output import gradebook_services, grades, page
from bounce_grader.classroom.output.final import Assigned
from bounce_grader.classroom.output.gradebook import Gradebook
from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.escaping import first_few, printable_name, terminal
from bounce_grader.common.files import read_object, remove_abandoned, write_whole

MOST_LINES = 20  # of a kind on the terminal; class.html has them all


@dataclass(frozen=True)
class Request:
    """The options of ./kit class, as cli.py has them."""

    submissions: Path | None  # None with --canvas
    out: Path
    gradebook: Path | None = None
    column: str = ""
    dask: str = ""
    jobs: int = 0
    speed: bool = False
    sanitize: bool = False
    trust: bool = False
    reveal: bool = False
    overwrite: bool = False
    canvas: str = ""  # COURSE/ASSIGNMENT
    upload: bool = False
    corpus: Sequence[Path] = ()
    regrade: bool = False
    apply: bool = False
    unit: Unit = unit.run  # what grades one; tests have a quicker one


class Given(NamedTuple):
    """All that is given: read and checked before anything is graded or written."""

    intake: Class
    book: Gradebook | None
    canvas: Canvas | None
    course: Course
    assigned: Assigned
    corpus: list[Student]


def run(request: Request) -> int:
    """Returns 0, or 3 if the kit failed on a submission, which then has no score."""
    try:
        given = _read(request)
        with _locked(request.out):
            remove_abandoned(request.out)
            return _run(request, given)
    except KeyboardInterrupt:
        print(
            "kit: stopped; what is graded is kept. Run the same command again to go on.",
            file=sys.stderr,
        )
        return 130
    except OSError as error:
        if error.errno != errno.ENOSPC:
            raise
        raise KitError(
            f"the disk with {request.out} or with the temporary files is full: make room, and run "
            "the same command again. What is graded is kept"
        ) from error


def _read(request: Request) -> Given:
    """Raises UsageError if something can't be read, or doesn't belong together."""
    book = _gradebook(request)
    names = book.people(own_ids_only=False) if book else {}
    roster = instructor_files.roster(request.out)
    people = People(roster, names, book.same_person() if book else {})
    course = instructor_files.course(request.out)
    adjustments = instructor_files.adjustments(request.out)
    corpus = [student for folder in request.corpus for student in near_copies.corpus(folder)]
    canvas = None
    if request.submissions:
        own = book.people() if book else {}
        named = {id: [name, *people.groups_of(id)] for id, name in own.items()}
        intake = students.read(request.submissions, named)
    else:
        token = canvas_api.token_of_environment()
        read_object(request.out / canvas_upload.UPLOADED)
        canvas = Canvas(os.environ.get("CANVAS_URL", ""), request.canvas, token)
        intake = canvas_api.download(canvas, request.out)
    people.assign(intake)
    if book:
        _require_same_class(book, request, intake)
        _find_out_lateness(intake, book)
    assigned = final.assign(adjustments, people, intake.students)
    assigned.sentences.extend(people.without_submission(intake.students))
    return Given(intake, book, canvas, course, assigned, corpus)


def _gradebook(request: Request) -> Gradebook | None:
    if request.gradebook is None:
        return None
    if request.gradebook.resolve() == _filled_in(request).resolve():
        raise UsageError(f"{request.gradebook} would be overwritten: give another folder as --out")
    read_object(request.out / gradebook.WRITTEN)  # refused, if it is broken, before any grading
    return gradebook_services.read(request.gradebook, request.column)


def _filled_in(request: Request) -> Path:
    """The path of the filled-in grade book. Blackboard's file keeps its ending."""
    own = request.gradebook.suffix.lower() if request.gradebook else ""
    return request.out / f"gradebook{own if own in ('.xls', '.txt') else '.csv'}"


def _require_same_class(book: Gradebook, request: Request, intake: Class) -> None:
    """Raises UsageError if submissions and grade book can't be of one class. In files of different
    services, the same id can be that of different students."""
    if intake.service and book.service != intake.service:
        raise UsageError(
            f"{request.submissions} is a download from {intake.service.capitalize()}, and "
            f"{request.gradebook} a file from {book.service.capitalize()}: give both from one"
        )
    members = [member for student in intake.students for member in student.members]
    listed = [member for member in members if member.listed]
    if intake.logins and not (request.out / ROSTER).exists():
        raise UsageError(
            f"{request.gradebook} can't be matched with GitHub logins, which students choose: "
            f"write {request.out / ROSTER}, whose columns submission and id say whose each "
            "login is; or leave --gradebook out, and take the points from grades.csv"
        )
    if not listed and all(member.id.startswith("anon_") for member in members):
        raise UsageError(
            f"{request.submissions} is of an anonymous assignment, whose names are in no grade "
            "book: post the grades in Canvas, and download the submissions again; or leave "
            "--gradebook out"
        )
    book.require_some_of(listed if intake.logins else members, intake.service == "canvas")


def _find_out_lateness(intake: Class, book: Gradebook) -> None:
    """Gives each submission the lateness that the grade book has."""
    late = book.days_late()
    intake.tells_lateness = intake.tells_lateness or bool(late)
    intake.students = [
        replace(s, late=late[s.id] != 0, late_days=late[s.id] or 0) if s.id in late else s
        for s in intake.students
    ]


@contextmanager
def _locked(out: Path) -> Iterator[None]:
    """Locks the output folder, so that only one run writes to it. The lock ends with the
    process."""
    try:
        out.mkdir(mode=0o700, parents=True, exist_ok=True)  # it will hold points and answers
        lock = open(out / ".lock", "w")
    except OSError as error:
        raise UsageError(f"{out} can't be written: {error.strerror}") from error
    with lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            raise UsageError(
                f"another run is under way in {out}: wait for it, or stop it"
            ) from error
        yield


def _run(request: Request, given: Given) -> int:
    out, intake, assigned = request.out, given.intake, given.assigned
    stamp = results.stamp_now(request.trust, request.sanitize)
    folder = out / "results"
    tasks = [results.task_of(s, stamp, folder, request.speed) for s in intake.students]
    if request.regrade:
        return _regrade(request, folder, tasks)
    if request.apply:
        regrade.stamp_before(folder)
    results.begin(folder, stamp, take_over=request.apply)
    failed = grading.grade_missing(tasks, request.unit, request.jobs, request.dask)
    summaries = grading.summarize(tasks, failed)
    summaries = final.with_finals(summaries, assigned, given.course, intake.logins)
    readable = [s.student for s in summaries if s.state != "unreadable"]
    near = near_copies.find(readable, given.corpus)
    pages = feedback.write(out, intake, summaries, request.reveal)
    for reasons in (near.incomplete, pages.without):
        summaries = [
            s.with_note(reasons[s.student.id]) if s.student.id in reasons else s for s in summaries
        ]
    sentences = [
        *final.unknown_lateness(given.course, intake, assigned.own),
        *assigned.sentences,
        *final.adjusted(summaries),
    ]
    if given.book:
        path = _filled_in(request)
        sentences += gradebook.write(path, intake, summaries, given.book, request.overwrite)
    write_whole(out / "grades.csv", "\ufeff" + grades.table(summaries))
    text = page.render(intake, summaries, near, sentences, given.course)
    write_whole(out / "class.html", text)
    _print(request, given, summaries, sentences, near)
    if pages.to_upload and not given.canvas:
        print(pages.to_upload)
    status = 3 if any(s.state == "failed" for s in summaries) else 0
    if not given.canvas:
        return status
    wanted = (request.upload, request.overwrite)
    left = canvas_upload.show_or_post(given.canvas, out, summaries, intake.unmatched, *wanted)
    return max(status, left)


def _regrade(request: Request, folder: Path, tasks: Sequence[Task]) -> int:
    there = regrade.stamp_before(folder)
    failed = grading.grade_missing(tasks, request.unit, request.jobs, request.dask)
    if failed:
        raise KitError(
            f"submissions that could not be graded again: {len(failed)}; nothing is changed"
        )
    print("\n".join(regrade.differences(there, tasks)))
    return 0


def _print(
    request: Request,
    given: Given,
    summaries: Sequence[Summary],
    sentences: Sequence[str],
    near: Similar,
) -> None:
    """Prints what came out. Who is in the grade book and has no score is named by the sentences on
    it."""
    intake, book = given.intake, given.book
    graded = [s for s in summaries if s.state == "graded"]
    looks = [s for s in summaries if s.needs_a_look]
    print(f"{len(graded)} of {intake.handed_in} submissions graded ({intake.source}).")
    counts = {
        "without a score": intake.handed_in - len(graded),
        "graded": sum(s.state == "graded" for s in looks),
        "not matched": sum(not unmatched.user for unmatched in intake.unmatched),
    }
    if any(counts.values()):
        to_look_at = ", ".join(f"{count} {what}" for what, count in counts.items() if count)
        print(f"To look at: {to_look_at}; {request.out / 'class.html'} says why.")
    failed = [f"{s.student.shown} ({s.student.id})" for s in summaries if s.state == "failed"]
    if failed:
        names = terminal(first_few(failed, separator="; "))
        print(f"The kit failed on {names}: run the same command again.")
    in_book = book.people(intake.service == "canvas") if book else {}
    not_graded = [
        f"{printable_name(unmatched.name)!r} {unmatched.reason}"
        for unmatched in intake.unmatched
        if unmatched.user not in in_book
    ]
    reasons = [
        f"{s.student.shown} ({s.student.id}): {'; '.join(s.needs_a_look)}"
        for s in looks
        if s.state == "graded" or s.student.id not in in_book
    ]
    more = 0
    for lines in (not_graded, reasons, sentences, page.of_near_copies(near, summaries)):
        print("".join(f"  {terminal(line)}\n" for line in lines[:MOST_LINES]), end="")
        more += len(lines[MOST_LINES:])
    if more:
        print(f"  and {more} more, in class.html")
    own = [_filled_in(request).name] if book else []
    written = ", ".join([*own, "grades.csv", "class.html", "feedback/"])
    print(f"Written to {request.out}: {written}")
