"""./kit study: reads what is asked, and starts the study."""

import argparse
import os
from pathlib import Path

from bounce_grader.common.errors import UsageError
from bounce_grader.common.paths import BUILD


def run(options: argparse.Namespace) -> int:
    os.environ["OPENBLAS_NUM_THREADS"] = "1"  # numpy's matrices are small here: others only wait
    command, *scenes = options.questions or [""]
    if command == "simulate":
        from bounce_study.simulate import simulate

        if len(scenes) != 1:
            raise UsageError("name one scene: ./kit study simulate SCENE.json")
        tolerance = options.tolerance or "0.001"
        return simulate(Path(scenes[0]), tolerance, options.json, options.picture)
    if command == "bench":
        from bounce_study import bench

        if len(scenes) != 1:
            raise UsageError("name one program: ./kit study bench ADAPTER")
        return bench.run(Path(scenes[0]), (options.out or BUILD / "bench").absolute())
    if command == "scene":
        from bounce_study.simulate import TEMPLATE

        print(TEMPLATE)
        return 0
    if options.tolerance or options.json or options.picture:
        of_simulate = "--tolerance, --json and --picture"
        raise UsageError(f"{of_simulate} are for ./kit study simulate SCENE.json")
    from bounce_study import run as study

    files = {n: getattr(options, n) for n in ("squares", "ellipses") if getattr(options, n)}
    if files and options.questions != [study.MEASURED]:
        raise UsageError("--squares and --ellipses are for ./kit study measured")
    # Fewer rounds and steps lead to other conclusions, which no page should have that people read.
    usual = BUILD / "quick-study" if options.quick else study.STUDIES
    out = (options.out or usual).absolute()
    questions = tuple(options.questions)
    request = study.Request(out, options.quick, options.peers, questions, **files)
    if files and not options.out:  # the committed page is about the committed figures
        for table in study.measured_tables(request).values():
            print(table.to_string(index=False), end="\n\n")
        return 0
    return study.run(request)
