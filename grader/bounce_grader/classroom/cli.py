"""The options of ./kit class."""

import argparse
from functools import partial

from bounce_grader.common.errors import UsageError
from bounce_grader.common.paths import given_path


def add(parser: argparse.ArgumentParser) -> None:
    option = parser.add_argument
    handed_in = "Canvas's download, a folder of folders or of zips, or a checkout of repositories"
    option("submissions", type=given_path, nargs="?", help=handed_in)
    option("--out", type=given_path, required=True, metavar="DIR", help="what is written")
    option("--gradebook", type=given_path, metavar="CSV", help="Canvas's exported grade book")
    option("--column", default="", metavar="TITLE", help="its column, as in 'HW3 (98765)'")
    canvas = (
        "download the submissions by Canvas's API, with CANVAS_URL and CANVAS_TOKEN from the "
        "environment; shows what --upload would change there"
    )
    option("--canvas", default="", metavar="COURSE/ASSIGNMENT", help=canvas)
    corpus = "other years' submissions, among which near-copies are looked for, too"
    option("--corpus", type=given_path, nargs="+", default=[], metavar="FOLDER", help=corpus)
    option("--jobs", type=int, metavar="N", help="gradings side by side")
    option("--dask", default="", metavar="ADDRESS", help="grade on the workers of this scheduler")
    flag = partial(option, action="store_true")
    flag("--upload", help="post the points and pages that were shown to Canvas")
    flag("--overwrite", help="replace other points that stand in the column")
    flag("--apply", help="let the results of this version of the kit count, in place of another's")
    flag("--speed", help="chart speed against accuracy; takes twice as long")
    sanitize = "remark undefined behaviour in parts with all points; takes twelve times as long"
    flag("--sanitize", help=sanitize)
    reveal = "put the expected answers of hidden cases into the feedback; may be added later"
    flag("--reveal", help=reveal)
    flag("--trust-submission", help="grade without a box where none can be had")


def run(options: argparse.Namespace) -> int:
    from bounce_grader.classroom.run import run as grade_class

    given, canvas, book = options.submissions, options.canvas, options.gradebook
    out, column, jobs = options.out.resolve(), options.column, options.jobs
    inside = given and given.resolve() in (out, *out.parents)
    for wrong, sentence in (
        (jobs is not None and jobs < 1, f"--jobs takes 1 or more, not {jobs}"),
        (bool(canvas) == bool(given), "give either the submissions or --canvas COURSE/ASSIGNMENT"),
        (inside, f"{options.out} is among the submissions: give a folder elsewhere by --out"),
        (options.out.is_file(), f"{options.out} is a file: give a folder by --out"),
        (column and not book, "--column is of a grade book: give that by --gradebook"),
        (options.upload and not canvas, "--upload needs --canvas COURSE/ASSIGNMENT"),
        (canvas and book, "--canvas posts the points by itself: leave --gradebook out"),
    ):
        if wrong:
            raise UsageError(sentence)
    options.out, options.jobs = options.out.absolute(), jobs or 0
    return grade_class(options)
