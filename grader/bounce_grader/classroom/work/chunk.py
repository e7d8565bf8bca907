"""Grades one chunk of a class on a cluster's node: main([FILE, "--jobs", N])."""

import argparse
import json
from pathlib import Path

from bounce_grader.classroom.work import engine_local, results, task
from bounce_grader.common.escaping import terminal


def main(arguments: list[str]) -> int:
    parser = argparse.ArgumentParser(prog="chunk")
    parser.add_argument("file", type=Path)
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args(arguments)
    tasks = [task.from_json(words) for words in json.loads(options.file.read_text())]
    missing = [t for t in tasks if not results.load(Path(t.results), t.key)]
    failed = 0
    for done, outcome in engine_local.run(missing, options.jobs):
        line = f"{done.key[:12]} {outcome.state} {outcome.seconds} s {outcome.message}"
        print(terminal(line), flush=True)
        failed += outcome.state == "failed"
    return 3 if failed else 0
