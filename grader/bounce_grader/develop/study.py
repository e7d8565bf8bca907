"""./kit study: its options. The study itself is a package in solution/study/, beside its C++
sources."""

import argparse
import os
import sys
from pathlib import Path

from bounce_grader.common.errors import UsageError
from bounce_grader.common.paths import given_path, ROOT


def add(parser: argparse.ArgumentParser) -> None:
    option = parser.add_argument
    asked = (
        "tables to measure; all unless named. Or: simulate SCENE.json, its motion within a "
        "tolerance, and the least model and the cheapest method for it"
    )
    option("questions", nargs="*", metavar="QUESTION", help=asked)
    largest = "of simulate: the largest error (default: 0.001)"
    option("--tolerance", metavar="METRES", help=largest)
    files = {
        "--json FILE": "of simulate: the motion, and all else",
        "--picture FILE.svg": "of simulate: the same, drawn",
        "--out FOLDER": "what is written (default: docs/studies)",
        "--squares FILE": "of the question `measured`: drops of squares",
        "--ellipses FILE": "of the question `measured`: impacts of ellipses",
    }
    for words, help in files.items():
        name, metavar = words.split()
        option(name, type=given_path, metavar=metavar, help=help)
    option("--quick", action="store_true", help="fewer rounds and random scenes")
    engines = "the engines that people use, too; installs them"
    option("--peers", action="store_true", help=engines)


def run(options: argparse.Namespace) -> int:
    sys.path.insert(0, str(ROOT / "solution" / "study"))
    os.environ["OPENBLAS_NUM_THREADS"] = "1"  # numpy's matrices are small here: others only wait
    command, *scenes = options.questions or [""]
    if command == "simulate":
        from bounce_study.simulate import simulate

        if len(scenes) != 1:
            raise UsageError("name one scene: ./kit study simulate SCENE.json")
        tolerance = options.tolerance or "0.001"
        return simulate(Path(scenes[0]), tolerance, options.json, options.picture)
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
