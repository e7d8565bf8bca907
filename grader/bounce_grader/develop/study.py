"""./kit study: its options. The study itself is a package in solution/study/, beside its C++
sources."""

import argparse
import sys
from pathlib import Path
from typing import Any

from bounce_grader.common.errors import UsageError
from bounce_grader.common.paths import ROOT


def add(commands: Any) -> None:
    parser = commands.add_parser("study", help="measure the methods: tables, charts and pages")
    parser.add_argument(
        "questions",
        nargs="*",
        metavar="QUESTION",
        help="tables to measure; all unless named. Or: simulate SCENE.json, its motion within a "
        "tolerance",
    )
    parser.add_argument("--tolerance", metavar="METRES", help="of simulate: the largest error")
    parser.add_argument(
        "--json",
        type=Path,
        metavar="FILE",
        help="of simulate: times, q, v, bound and horizon; of measured: what its page is made of",
    )
    parser.add_argument(
        "--out", type=Path, metavar="FOLDER", help="what is written (default: docs/studies)"
    )
    parser.add_argument("--quick", action="store_true", help="fewer rounds and coarser maps")
    parser.add_argument(
        "--peers", action="store_true", help="the engines that people use, too; installs them"
    )
    measured = parser.add_argument_group("measured impacts and drops, for the question `measured`")
    measured.add_argument("--squares", type=Path, metavar="FILE", help="drops of squares")
    measured.add_argument("--ellipses", type=Path, metavar="FILE", help="impacts of ellipses")
    parser.set_defaults(command=_study)


def _study(options: argparse.Namespace) -> int:
    sys.path.insert(0, str(ROOT / "solution" / "study"))
    from bounce_study import measured_part, run
    from bounce_study.simulate import simulate

    if options.questions[:1] == ["simulate"]:
        if len(options.questions) != 2 or options.tolerance is None:
            raise UsageError(
                "write ./kit study simulate SCENE.json --tolerance METRES [--json FILE]"
            )
        return simulate(Path(options.questions[1]), options.tolerance, options.json)
    if options.tolerance:
        raise UsageError("--tolerance is for ./kit study simulate SCENE.json")
    files = measured_part.Files(options.squares, options.ellipses, options.json)
    wrong = files.others and options.questions != [measured_part.NAME]
    if wrong or (files.json and measured_part.NAME not in options.questions):
        raise UsageError(
            "--squares and --ellipses are for ./kit study measured, and --json for it and for "
            "./kit study simulate SCENE.json"
        )
    if files.others and not options.out:  # the committed page is about the committed figures
        return measured_part.report(files, options.quick)
    out = options.out or run.STUDIES
    questions = tuple(options.questions)
    return run.run(run.Request(out.absolute(), options.quick, options.peers, questions, files))
