"""./kit class: grades a class, step by step."""

import errno
import fcntl
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any, TextIO

from bounce_grader.classroom.grading import grading, near_copies, results
from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.intake import course, gradebook, students
from bounce_grader.classroom.intake.canvas_api import Canvas, download
from bounce_grader.classroom.output import canvas_upload, comments, earlier, feedback, page, points
from bounce_grader.classroom.output.people import People
from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.escaping import csv_row, terminal
from bounce_grader.common.files import read_object, remove_abandoned, write_whole
from bounce_grader.grading import self_check
from bounce_grader.sandbox.box import kinds

MOST_LINES = 20  # of a kind on the terminal; class.html has them all
Options = Any  # as the command line has them
UNIT = results.grade_one  # what grades one; tests have a quicker one


def run(options: Options) -> int:
    """Returns 0, or 3 if the kit failed on a submission, which then has no score."""
    _require_sense(options)
    options.out = options.out.absolute()
    try:
        given = _read(options)
        with _locked(options.out):
            remove_abandoned(options.out)
            return _run(options, *given)
    except KeyboardInterrupt:
        print("kit: stopped; the same command goes on from here", file=sys.stderr)
        return 130
    except OSError as error:
        if error.errno != errno.ENOSPC:
            raise
        where = f"the disk with {options.out} or with the temporary files"
        raise KitError(f"{where} is full: make room, and run the same command again") from error


def _require_sense(options: Options) -> None:
    """Raises UsageError for options that don't go together."""
    given, canvas, book = options.submissions, options.canvas, options.gradebook
    out, column, jobs = options.out.resolve(), options.column, options.jobs
    inside = given and given.resolve() in (out, *out.parents)
    for wrong, sentence in (
        (jobs is not None and jobs < 1, f"--jobs takes 1 or more, not {jobs}"),
        (bool(canvas) == bool(given), "give either the submissions or --canvas COURSE/ASSIGNMENT"),
        (inside, f"{options.out} is among the submissions: give a folder elsewhere by --out"),
        (options.out.is_file(), f"{options.out} is a file: give a folder by --out"),
        (column and not book, "--column is a column of the gradebook: give --gradebook as well"),
        (options.upload and not canvas, "--upload needs --canvas COURSE/ASSIGNMENT"),
        (canvas and book, "--canvas posts the points by itself: leave --gradebook out"),
    ):
        if wrong:
            raise UsageError(sentence)


def _read(options: Options) -> tuple[Canvas | None, People, list[Summary]]:
    """Reads and checks everything before anything is graded or written: the assignment on Canvas,
    the people of the course, and other years' submissions. Raises UsageError."""
    read_object(options.out / points.WRITTEN)
    book = gradebook.Gradebook()
    if options.gradebook:
        if options.gradebook.resolve() == _filled_in(options).resolve():
            where = f"{options.gradebook} would be overwritten"
            raise UsageError(f"{where}: give another folder as --out")
        book = gradebook.read(options.gradebook, options.column)
    people = People(options.out, book)
    corpus = [other for folder in options.corpus for other in near_copies.corpus(folder)]
    canvas = Canvas(options.canvas) if options.canvas else None
    best = people.course.attempt == "best"
    if canvas:
        intake = download(canvas, options.out, best)
    else:
        intake = students.read(options.submissions, people.names(), best)
    intake.strays += people.assign(intake)
    points.require_same_class(book, intake)
    return canvas, people, corpus


def _filled_in(options: Options) -> Path:
    """The path of the filled-in gradebook. Blackboard's file keeps its ending."""
    own = options.gradebook.suffix.lower()
    return Path(options.out / f"gradebook{own if own in ('.xls', '.txt') else '.csv'}")


def _locked(out: Path) -> TextIO:
    """Lets only one run write to the output folder, until this file is closed or the process ends."""
    try:
        out.mkdir(mode=0o700, parents=True, exist_ok=True)  # it will hold points and answers
        lock = open(out / ".lock", "w")
    except OSError as error:
        raise UsageError(f"{out} can't be written: {error.strerror}") from error
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError as error:
        raise UsageError(f"another run is under way in {out}: wait for it") from error
    return lock


def _run(options: Options, canvas: Canvas | None, people: People, corpus: list[Summary]) -> int:
    intake, out, folder, speed = people.intake, options.out, options.out / "results", options.speed
    self_check.require_sound_judge(kinds(options.trust_submission))
    stamp = results.stamp_now(options.trust_submission, options.sanitize)
    tasks = [results.Task(results.digest_of(s), stamp, s, folder, speed) for s in intake.students]
    there = results.stamp_of(folder)
    summaries = grading.grade(tasks, UNIT, options.jobs, options.dask, options.reveal)
    status = 3 if any(summary.state == "failed" for summary in summaries) else 0
    if there and there != stamp and not options.apply:
        print("\n".join(grading.differences(there, tasks, summaries)))
        return status
    results.count(folder, stamp)
    summaries = people.give_points(summaries)
    task_of = {task.key: task for task in tasks}
    earlier.note_fewer(out, [task_of[one.key] for one in summaries], summaries)
    if people.course.slip_days:
        used = {one.id: one.slip_days for summary in summaries for one in summary.finals}
        lines = (csv_row([id, days]) for id, days in sorted(used.items()))
        write_whole(out / course.SLIP_DAYS, "\ufeffstudent,days\r\n" + "".join(lines))
    sentences = [*intake.strays, *comments.place(out, people, summaries)]
    near = near_copies.find(summaries, corpus)
    pages = feedback.write(out, summaries)
    written = ["grades.csv", "class.html", "feedback/"]
    if people.book.table:
        path = _filled_in(options)
        sentences += points.write(path, people, summaries, options.overwrite)
        written.insert(0, path.name)
    rows = [summary.row() for summary in summaries]
    table = map(csv_row, [rows[0].keys(), *(row.values() for row in rows)])
    write_whole(out / "grades.csv", "\ufeff" + "".join(table))
    write_whole(out / "class.html", page.render(summaries, near, sentences, people.course.title))
    graded = sum(summary.state == "graded" for summary in summaries)
    print(f"{graded} of {len(summaries)} submissions graded ({intake.source}).")
    looks = [f"{who}: {why}" for who, why in page.looks(summaries)]
    _print(looks, sentences, page.of_near_copies(near))
    print(f"Written to {out}: {', '.join(written)}")
    if canvas:
        deducts = people.course.percent_per_day > 0
        return max(status, canvas_upload.show_or_post(canvas, summaries, options, deducts))
    if to_upload := feedback.zip_new(out, intake.service, pages):
        print(to_upload)
    return status


def _print(*kinds: Sequence[str]) -> None:
    """Prints the first lines of each kind of what a person should look at."""
    for lines in kinds:
        print("".join(f"  {terminal(line)}\n" for line in lines[:MOST_LINES]), end="")
    if more := sum(len(lines[MOST_LINES:]) for lines in kinds):
        print(f"  and {more} more, in class.html")
