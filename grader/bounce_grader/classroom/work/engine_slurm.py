"""Writes scripts for Slurm: an array job over chunks of submissions, and a job that collects the
results. It grades nothing itself."""

import json
import math
import shlex
import sys
from collections.abc import Generator, Sequence
from pathlib import Path
from typing import Any

from bounce_grader.classroom.work.task import Task
from bounce_grader.classroom.work.unit import Outcome
from bounce_grader.common.files import write_whole
from bounce_grader.common.paths import ROOT

FEWEST, MOST = 20, 50  # submissions per chunk: minutes of work, and little lost with a job
CHUNKS = 64  # the number of chunks, as far as these bounds allow

ARRAY = """#!/bin/sh
#SBATCH --job-name=bounce
#SBATCH --array=1-{chunks}
#SBATCH --cpus-per-task=2
#SBATCH --mem=4G
#SBATCH --time=01:00:00
#SBATCH --output={folder}/chunk-%a.log
# One chunk of the class. Running it again grades only what has no result. Python is isolated from
# the folder that this starts in, and has an environment of its own, as in ./kit.
start='import sys; sys.path.insert(0, sys.argv.pop(1)); import bounce_grader.classroom.work.chunk as chunk
sys.exit(chunk.main(sys.argv[1:]))'
exec /usr/bin/env -i PATH="$PATH" HOME="$HOME" TMPDIR="${{TMPDIR:-/tmp}}" \\
  /usr/bin/python3 -I -X utf8 -c "$start" {kit}/grader \\
  {folder}/chunk-"$SLURM_ARRAY_TASK_ID".json --jobs "${{SLURM_CPUS_PER_TASK:-2}}"
"""

COLLECT = """#!/bin/sh
#SBATCH --job-name=bounce-collect
#SBATCH --time=00:30:00
#SBATCH --output={folder}/collect.log
# Grade book, feedback and the class's page, from the results that are there.
cd {here} && exec {command}
"""

SUBMIT = """#!/bin/sh
# Hands both to Slurm; the second waits for the first.
set -eu
array=$(sbatch --parsable {folder}/grade.sbatch)
sbatch --dependency=afterany:"$array" {folder}/collect.sbatch
"""


def run(tasks: list[Task], out: Path) -> Generator[tuple[Task, Outcome], None, None]:
    """Writes the scripts. Yields nothing: the results come later, as files."""
    if tasks:
        folder = _new_folder(out / "slurm")
        _write(tasks, folder)
        print(
            f"kit: submissions that wait for a grading: {len(tasks)}; hand them to Slurm with\n"
            f"       sh {shlex.quote(str(folder / 'submit.sh'))}",
            file=sys.stderr,
        )
    yield from ()


def _new_folder(parent: Path) -> Path:
    """A new numbered folder. Those of earlier runs stay: their logs may say what went wrong."""
    number = 1
    while (parent / str(number)).exists():
        number += 1
    return parent / str(number)


def chunks(tasks: Sequence[Any]) -> list[Sequence[Any]]:
    size = min(MOST, max(FEWEST, math.ceil(len(tasks) / CHUNKS)))
    return [tasks[at : at + size] for at in range(0, len(tasks), size)]


def _write(tasks: list[Task], folder: Path) -> None:
    cut = chunks(tasks)
    for number, chunk in enumerate(cut, 1):
        data = json.dumps([task.as_json() for task in chunk])
        write_whole(folder / f"chunk-{number}.json", data)
    places = {
        "folder": shlex.quote(str(folder)),
        "kit": shlex.quote(str(ROOT)),
        "here": shlex.quote(str(Path.cwd())),
        "command": shlex.join([str(ROOT / "kit"), *sys.argv[1:]]),
        "chunks": len(cut),
    }
    for name, text in (("grade.sbatch", ARRAY), ("collect.sbatch", COLLECT), ("submit.sh", SUBMIT)):
        write_whole(folder / name, text.format(**places))
