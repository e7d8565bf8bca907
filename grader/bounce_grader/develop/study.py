"""./kit study: its options. The study itself is a package in solution/study/, beside its C++
sources."""

import argparse
import os
import sys
from pathlib import Path

from bounce_grader.common.errors import UsageError
from bounce_grader.common.paths import given_path, ROOT


def add(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "questions",
        nargs="*",
        metavar="QUESTION",
        help="tables to measure; all unless named. Or: simulate SCENE.json, its motion within a "
        "tolerance, and the least model and the cheapest method for it",
    )
    parser.add_argument(
        "--tolerance", metavar="METRES", help="of simulate: the largest error (default: 0.001)"
    )
    parser.add_argument(
        "--json", type=given_path, metavar="FILE", help="of simulate: the motion, and all else"
    )
    parser.add_argument(
        "--picture", type=given_path, metavar="FILE.svg", help="of simulate: the same, drawn"
    )
    parser.add_argument(
        "--out", type=given_path, metavar="FOLDER", help="what is written (default: docs/studies)"
    )
    parser.add_argument("--quick", action="store_true", help="fewer rounds and random scenes")
    parser.add_argument(
        "--peers", action="store_true", help="the engines that people use, too; installs them"
    )
    measured = parser.add_argument_group("measured impacts, for the question `measured`")
    measured.add_argument("--squares", type=given_path, metavar="FILE", help="drops of squares")
    measured.add_argument("--ellipses", type=given_path, metavar="FILE", help="impacts of ellipses")


def run(options: argparse.Namespace) -> int:
    sys.path.insert(0, str(ROOT / "solution" / "study"))
    os.environ["OPENBLAS_NUM_THREADS"] = "1"  # numpy's matrices are small here: others only wait
    if options.questions[:1] == ["simulate"]:
        return _simulate(options)
    if options.tolerance or options.json or options.picture:
        raise UsageError(
            "--tolerance, --json and --picture are for ./kit study simulate SCENE.json"
        )
    from bounce_study import run as study

    files = {n: getattr(options, n) for n in ("squares", "ellipses") if getattr(options, n)}
    if files and options.questions != [study.MEASURED]:
        raise UsageError("--squares and --ellipses are for ./kit study measured")
    out = (options.out or study.STUDIES).absolute()
    questions = tuple(options.questions)
    request = study.Request(out, options.quick, options.peers, questions, **files)
    if files and not options.out:  # the committed page is about the committed figures
        for table in study.measured_tables(request).values():
            print(table.to_string(index=False), end="\n\n")
        return 0
    return study.run(request)


def _simulate(options: argparse.Namespace) -> int:
    from bounce_study.simulate import simulate

    if len(options.questions) != 2:
        raise UsageError("name one scene: ./kit study simulate SCENE.json")
    tolerance = options.tolerance or "0.001"
    return simulate(Path(options.questions[1]), tolerance, options.json, options.picture)
