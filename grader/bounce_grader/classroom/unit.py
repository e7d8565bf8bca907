"""The one unit of work: grade one submission and leave its result as one file.

It can be run any number of times, anywhere, by anything: the file's name says what it follows
from, and the file is there whole or not at all.
"""

import json
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from bounce_grader import submission
from bounce_grader.classroom import layout
from bounce_grader.classroom.task import Task
from bounce_grader.errors import KitError, UsageError, about_one_submission
from bounce_grader.files import CLASS_FOLDER, write_whole

Record = dict[str, Any]


@dataclass(frozen=True)
class Outcome:
    """What a worker says about a task; the record itself is in the file."""

    key: str
    state: str  # "graded", "unreadable", or "failed", where the kit did
    message: str
    seconds: float


def grade_path(path: Path, task: Task) -> Record:
    from bounce_grader import box
    from bounce_grader.grade import Options, grade

    wanted = Options(box.kinds(task.trust), task.speed, jobs=1, answers=True)
    return grade(path, wanted)


def run(task: Task, grade: Callable[[Path, Task], Record] = grade_path) -> Outcome:
    """Never raises an Exception: a failure of the kit is an outcome, and leaves no file."""
    start = time.monotonic()
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


def _result(task: Task, grade: Callable[[Path, Task], Record]) -> dict[str, Any]:
    """A submission that can't be read is a verdict, too."""
    record: Record | None = None
    message = ""
    beside: list[str] = []
    with tempfile.TemporaryDirectory(prefix=CLASS_FOLDER) as name:
        path = Path(task.path)
        try:
            with about_one_submission(f"{path} can't be read"):
                path = layout.prepare(task, Path(name))
            record = grade(path, task)
            _require_a_part(record, "folder" if Path(task.path).is_dir() else "zip")
            beside = submission.read(path).helpers
        except UsageError as error:
            record = None
            message = str(error).replace(str(path), "the submission").replace(name, "")
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


def _require_a_part(record: Record, where: str) -> None:
    """A zip in the zip, or files under other names: for a person to look at, and no zero."""
    if all(part["status"] == "not_submitted" for part in record["parts"]):
        names = [name for name in record["ignored"] if not name.startswith("__MACOSX")]
        zipped = any(name.lower().endswith(".zip") for name in names)
        raise UsageError(
            "none of the four parts is there under its name"
            + (f", but {', '.join(names[:3])}" if names else "")
            + (f": a zip inside a {where} isn't opened" if zipped else "")
        )
