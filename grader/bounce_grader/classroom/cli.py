"""The options of ./kit class."""

import argparse
from pathlib import Path
from typing import Any


def add(commands: Any) -> None:
    parser = commands.add_parser("class", help="grade a whole class")
    parser.add_argument(
        "submissions",
        type=Path,
        nargs="?",
        help="Canvas's download, a folder of folders or of zips, or a checkout of repositories",
    )
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="what is written")
    parser.add_argument(
        "--gradebook", type=Path, metavar="CSV", help="Canvas's exported grade book"
    )
    parser.add_argument("--column", metavar="TITLE", help="its column, as in 'HW3 (98765)'")
    parser.add_argument(
        "--part-column",
        action="append",
        default=[],
        metavar="N=TITLE",
        help="a column for part N; may be given for each part",
    )
    parser.add_argument(
        "--canvas",
        default="",
        metavar="COURSE/ASSIGNMENT",
        help="download the submissions by Canvas's API, with CANVAS_URL and CANVAS_TOKEN from the "
        "environment; shows what --upload would change there",
    )
    parser.add_argument(
        "--upload", action="store_true", help="post the points and pages that were shown to Canvas"
    )
    parser.add_argument(
        "--overwrite", action="store_true", help="replace other points that stand in the columns"
    )
    parser.add_argument(
        "--corpus",
        type=Path,
        nargs="+",
        default=[],
        metavar="FOLDER",
        help="other years' submissions, among which near-copies are looked for, too",
    )
    parser.add_argument("--jobs", type=int, default=0, metavar="N", help="gradings side by side")
    parser.add_argument("--engine", choices=["local", "dask"], default="local")
    parser.add_argument("--scheduler", default="", metavar="ADDRESS", help="of Dask")
    again = parser.add_mutually_exclusive_group()
    again.add_argument(
        "--regrade",
        metavar="FILTER",
        help="grade again beside the old results, and show the differences: all, student=NAME, "
        "status=STATUS or score<POINTS",
    )
    again.add_argument("--apply", action="store_true", help="take over what --regrade has shown")
    parser.add_argument(
        "--speed", action="store_true", help="chart speed against accuracy; takes twice as long"
    )
    parser.add_argument(
        "--sanitize",
        action="store_true",
        help="remark undefined behaviour in parts with all points; takes twelve times as long",
    )
    parser.add_argument(
        "--reveal",
        action="store_true",
        help="put the expected answers of hidden cases into the feedback; may be added later",
    )
    parser.add_argument(
        "--trust-submission", action="store_true", help="grade without a box where none can be had"
    )
    parser.set_defaults(command=_class)


def _class(options: argparse.Namespace) -> int:
    from bounce_grader.classroom import run
    from bounce_grader.classroom.grading.request import Request
    from bounce_grader.common.errors import UsageError

    if options.regrade == "":
        raise UsageError("--regrade needs a FILTER, as in --regrade all")
    if options.part_column and not options.gradebook:
        raise UsageError("--part-column needs --gradebook, Canvas's export")
    if options.engine == "dask" and not options.scheduler:
        raise UsageError("--engine dask needs --scheduler ADDRESS, as in tcp://10.0.0.1:8786")
    if options.jobs < 0:
        raise UsageError(f"--jobs takes a number of gradings, not {options.jobs}")
    if bool(options.canvas) == bool(options.submissions):
        raise UsageError("give either the submissions or --canvas COURSE/ASSIGNMENT")
    if options.upload and not options.canvas:
        raise UsageError("--upload needs --canvas COURSE/ASSIGNMENT")
    if options.canvas and options.gradebook:
        raise UsageError("--canvas posts the points by itself: leave --gradebook out")
    request = Request(
        submissions=options.submissions or options.out.absolute(),
        canvas=options.canvas,
        upload=options.upload,
        out=options.out.absolute(),
        gradebook=options.gradebook,
        columns=_columns(options),
        overwrite=options.overwrite,
        corpus=tuple(options.corpus),
        engine=options.engine,
        jobs=options.jobs,
        scheduler=options.scheduler,
        speed=options.speed,
        sanitize=options.sanitize,
        trust=options.trust_submission,
        reveal=options.reveal,
        regrade=options.regrade or "",
        apply=options.apply,
    )
    return run.run(request)


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
