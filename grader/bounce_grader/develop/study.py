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
        "--json", type=Path, metavar="FILE", help="of simulate: times, q, v, bound and horizon"
    )
    parser.add_argument(
        "--out", type=Path, metavar="FOLDER", help="what is written (default: docs/studies)"
    )
    parser.add_argument("--quick", action="store_true", help="fewer rounds and coarser maps")
    parser.add_argument(
        "--peers", action="store_true", help="the engines that people use, too; installs them"
    )
    parser.set_defaults(command=_study)


def _study(options: argparse.Namespace) -> int:
    sys.path.insert(0, str(ROOT / "solution" / "study"))
    from bounce_study import run

    if options.questions[:1] == ["simulate"]:
        return _simulate(options)
    if options.tolerance or options.json:
        raise UsageError("--tolerance and --json belong to ./kit study simulate SCENE.json")
    out = options.out or run.STUDIES
    return run.run(
        run.Request(out.absolute(), options.quick, options.peers, tuple(options.questions))
    )


def _simulate(options: argparse.Namespace) -> int:
    from bounce_study.simulate import simulate

    if len(options.questions) != 2 or options.tolerance is None:
        raise UsageError("write ./kit study simulate SCENE.json --tolerance METRES [--json FILE]")
    return simulate(Path(options.questions[1]), options.tolerance, options.json)
