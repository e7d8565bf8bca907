"""The options of ./kit class."""

import argparse
from pathlib import Path
from typing import Any


def add(commands: Any) -> None:
    parser = commands.add_parser("class", help="grade a whole class")
    parser.set_defaults(command=_class)
    option = parser.add_argument
    handed_in = "Canvas's download, a folder of folders or of zips, or a checkout of repositories"
    option("submissions", type=Path, nargs="?", help=handed_in)
    option("--out", type=Path, required=True, metavar="DIR", help="what is written")
    option("--gradebook", type=Path, metavar="CSV", help="Canvas's exported grade book")
    option("--column", metavar="TITLE", help="its column, as in 'HW3 (98765)'")
    of_part = {"action": "append", "default": [], "metavar": "N=TITLE"}
    option("--part-column", **of_part, help="a column for part N; may be given for each part")
    canvas = (
        "download the submissions by Canvas's API, with CANVAS_URL and CANVAS_TOKEN from the "
        "environment; shows what --upload would change there"
    )
    option("--canvas", default="", metavar="COURSE/ASSIGNMENT", help=canvas)
    flag(option, "--upload", "post the points and pages that were shown to Canvas")
    flag(option, "--overwrite", "replace other points that stand in the columns")
    corpus = "other years' submissions, among which near-copies are looked for, too"
    option("--corpus", type=Path, nargs="+", default=[], metavar="FOLDER", help=corpus)
    option("--jobs", type=int, default=0, metavar="N", help="gradings side by side")
    option("--engine", choices=["local", "dask"], default="local")
    option("--scheduler", default="", metavar="ADDRESS", help="of Dask")
    again = parser.add_mutually_exclusive_group().add_argument
    chosen = (
        "grade again beside the old results, and show the differences: all, student=NAME, "
        "status=STATUS or score<POINTS"
    )
    again("--regrade", metavar="FILTER", help=chosen)
    flag(again, "--apply", "take over what --regrade has shown")
    flag(option, "--speed", "chart speed against accuracy; takes twice as long")
    sanitize = "remark undefined behaviour in parts with all points; takes twelve times as long"
    flag(option, "--sanitize", sanitize)
    reveal = "put the expected answers of hidden cases into the feedback; may be added later"
    flag(option, "--reveal", reveal)
    flag(option, "--trust-submission", "grade without a box where none can be had", dest="trust")


def flag(option: Any, name: str, help: str, **more: Any) -> None:
    option(name, action="store_true", help=help, **more)


def _class(options: argparse.Namespace) -> int:
    from bounce_grader.classroom import run
    from bounce_grader.classroom.grading.request import Request
    from bounce_grader.common.errors import UsageError

    for wrong, sentence in (
        (options.regrade == "", "--regrade needs a FILTER, as in --regrade all"),
        (
            options.part_column and not options.gradebook,
            "--part-column needs --gradebook, Canvas's export",
        ),
        (
            options.engine == "dask" and not options.scheduler,
            "--engine dask needs --scheduler ADDRESS, as in tcp://10.0.0.1:8786",
        ),
        (options.jobs < 0, f"--jobs takes a number of gradings, not {options.jobs}"),
        (
            bool(options.canvas) == bool(options.submissions),
            "give either the submissions or --canvas COURSE/ASSIGNMENT",
        ),
        (
            options.submissions and options.out.resolve() == options.submissions.resolve(),
            f"{options.out} holds the submissions: give another folder by --out",
        ),
        (options.out.is_file(), f"{options.out} is a file: give a folder by --out"),
        (options.upload and not options.canvas, "--upload needs --canvas COURSE/ASSIGNMENT"),
        (
            options.canvas and options.gradebook,
            "--canvas posts the points by itself: leave --gradebook out",
        ),
    ):
        if wrong:
            raise UsageError(sentence)
    options.out = options.out.absolute()
    options.columns = _columns(options)
    names = Request.__dataclass_fields__.keys()
    return run.run(Request(**{n: value for n, value in vars(options).items() if n in names}))


def _columns(options: argparse.Namespace) -> dict[int, str]:
    from bounce_grader.common.errors import UsageError
    from bounce_grader.common.manifest import parts

    columns = {0: options.column} if options.column else {}
    known = {str(part.number): part.number for part in parts()}
    for words in options.part_column:
        number, _, title = words.partition("=")
        if number not in known or not title:
            raise UsageError(f"--part-column takes 1=TITLE to {len(known)}=TITLE, not {words!r}")
        if known[number] in columns:
            raise UsageError(f"--part-column is given twice for part {number}: give one")
        columns[known[number]] = title
    return columns
