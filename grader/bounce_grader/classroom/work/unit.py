"""The one unit of work: grade one submission and leave its result as one file.

It can be run any number of times, anywhere, by anything: the file's name says what it follows
from, and the file is there whole or not at all.
"""

import json
import os
import time
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from bounce_grader.classroom.intake import handed_in
from bounce_grader.classroom.work.task import Task
from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.escaping import printable_name
from bounce_grader.common.files import write_whole
from bounce_grader.grading.record import sentence
from bounce_grader.sandbox.budget import Budget
from bounce_grader.submission.submission import Submission

Record = dict[str, Any]
Grade = Callable[[Submission, Task], Record]


@dataclass(frozen=True)
class Outcome:
    """What a worker says about a task; the record itself is in the file."""

    key: str
    state: str  # "graded", "unreadable", or "failed", where the kit did
    message: str
    seconds: float


def grade_submission(taken: Submission, task: Task, within: Budget) -> Record:
    from bounce_grader.grading.grade import grade, Options
    from bounce_grader.sandbox import box

    wanted = Options(box.kinds(task.trust), task.speed, jobs=1, answers=True, within=within)
    return grade(taken, wanted)


def run(task: Task, grade: Grade | None = None) -> Outcome:
    """Never raises an Exception: a failure of the kit is an outcome, and leaves no file."""
    start = time.monotonic()
    grade = grade or partial(grade_submission, within=Budget())  # reading it takes of it, too
    try:
        result = _result(task, grade)
        path = result_path(Path(task.results), task.key)
        write_whole(path, json.dumps(result), durable=True)
        state, message = result["state"], result["message"]
    except (KitError, OSError) as error:
        state, message = "failed", str(error)
    except Exception as error:  # a fault of the kit's that nobody has thought of
        state, message = "failed", f"{type(error).__name__}: {error}"
    return Outcome(task.key, state, message, round(time.monotonic() - start, 3))


def result_path(folder: Path, key: str) -> Path:
    return folder / f"{key}.json"


def _result(task: Task, grade: Grade) -> dict[str, Any]:
    """A submission that can't be read is a verdict, too."""
    record: Record | None = None
    message = ""
    beside: list[str] = []
    path = Path(task.path)
    try:
        taken = handed_in.read(path, task.uploads)
        _require_a_part(taken, "folder" if os.path.isdir(path) else "zip")
        record = grade(taken, task)
        beside = list(map(printable_name, taken.helpers))
    except UsageError as error:
        message = sentence(str(error).replace(str(path), "the submission"))
    return {
        "key": task.key,
        "submission": task.submission,
        "kit": task.stamp.kit,
        "fixtures": task.stamp.fixtures,
        "options": task.stamp.options,
        "state": "graded" if record else "unreadable",
        "message": message,
        "record": record,
        "beside": beside,
    }


def _require_a_part(taken: Submission, where: str) -> None:
    """A zip in the zip, or files under other names: for a person to look at, and no zero."""
    if not taken.parts and not taken.refused:
        names = [name for name in taken.ignored if not name.startswith("__MACOSX")]
        zipped = any(name.lower().endswith(".zip") for name in names)
        raise UsageError(
            "none of the parts is there under its name"
            + (f", but {', '.join(map(printable_name, names[:3]))}" if names else "")
            + (f": a zip inside a {where} isn't opened" if zipped else "")
        )
