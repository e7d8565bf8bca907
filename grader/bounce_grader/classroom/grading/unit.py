"""The unit of work of every engine: grades one submission, and writes its result to one file.

It can be run any number of times and anywhere: the name of the file is a hash of all that the
result depends on, and the file is written whole or not at all.
"""

import errno
import json
from collections.abc import Callable
from datetime import datetime, timezone
from functools import partial
from typing import Any

from bounce_grader.classroom.grading import results
from bounce_grader.classroom.grading.results import Result, Task
from bounce_grader.classroom.intake import uploads
from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.escaping import first_few, printable_name
from bounce_grader.common.files import write_whole
from bounce_grader.grading.record import sentence
from bounce_grader.sandbox.budget import Budget
from bounce_grader.submission.submission import Submission

Record = dict[str, Any]
Grade = Callable[[Submission, Task], Record]
# Returns why the kit failed, and there is no result; "" if there is one. Raises OSError if the disk is
# full: then no further result could be stored.
Unit = Callable[[Task], str]


def grade_submission(taken: Submission, task: Task, within: Budget) -> Record:
    from bounce_grader.grading.grade import grade, Options
    from bounce_grader.sandbox import box

    kinds, sanitize = box.kinds(task.stamp.trust), task.stamp.sanitize
    wanted = Options(kinds, task.speed, sanitize, jobs=1, within=within)
    return grade(taken, wanted)


def run(task: Task, grade: Grade | None = None) -> str:
    """Grades a submission, as a Unit."""
    grade = grade or partial(grade_submission, within=Budget())  # reading counts, too
    try:
        result = _result(task, grade)
        write_whole(results.path_of(task.folder, task.key), json.dumps(result), durable=True)
    except (KitError, OSError) as error:
        if isinstance(error, OSError) and error.errno == errno.ENOSPC:
            raise
        return str(error)
    except Exception as error:  # an unforeseen fault of the kit
        return f"{type(error).__name__}: {error}"
    return ""


def _result(task: Task, grade: Grade) -> Result:
    """The content of the result's file. A submission that can't be read has a result, too."""
    record: Record | None = None
    message = ""
    beside: list[str] = []
    try:
        taken = uploads.read(task.student.path, task.student.uploads)
        _require_a_part(taken)
        record = grade(taken, task)
        beside = list(map(printable_name, taken.helpers))
    except UsageError as error:
        message = sentence(str(error).replace(str(task.student.path), "the submission"))
    return {
        "key": task.key,
        "at": datetime.now(timezone.utc).isoformat(timespec="seconds"),
        "submission": task.submission,
        **task.stamp._asdict(),
        "timed": task.speed,
        "state": "graded" if record else "unreadable",
        "message": message,
        "record": record,
        "beside": beside,
    }


def _require_a_part(taken: Submission) -> None:
    """Raises UsageError if no part is found, as with other names: a person should look at it,
    rather than it getting a zero."""
    if not taken.parts and not taken.refused:
        left = [name for name in taken.ignored if not name.startswith("__MACOSX")]
        names = list(map(printable_name, [*taken.helpers, *left]))
        others = f", but {first_few(names)}" if names else ""
        raise UsageError(f"none of the parts is there under its name{others}")
