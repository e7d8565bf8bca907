"""Grades one submission, as any engine does it, and writes the result to one file.

The file is named by a hash of all that its grading follows from, and it is written whole or not at
all. So a submission can be graded any number of times and anywhere, and the results of several
versions of the kit lie side by side; set.json says which version's results count.
"""

import json
import os
from collections.abc import Callable
from datetime import datetime, timezone
from pathlib import Path, PurePosixPath
from typing import Any, NamedTuple

from bounce_grader import __version__
from bounce_grader.classroom.intake import uploads
from bounce_grader.classroom.intake.student import Student
from bounce_grader.common.errors import KitError, raise_if_full, UsageError
from bounce_grader.common.escaping import first_few, in_one_line, printable_name
from bounce_grader.common.files import digest, write_whole
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import ROOT, SCENES, SENTENCES
from bounce_grader.grading import fixtures
from bounce_grader.grading.record import Record
from bounce_grader.sandbox.budget import Budget
from bounce_grader.submission.submission import Submission

SET = "set.json"
PYTHON = ("build", "common", "grading", "sandbox", "submission", "classroom/intake")
CPP = ("judge", "runner", "box", "diagnosis", "words")
Result = dict[str, Any]


class Stamp(NamedTuple):
    """Digests of all that a result depends on, except the submission."""

    kit: str
    fixtures: str
    trust: bool = False  # whether no box would do
    sanitize: bool = False  # whether undefined behaviour is remarked


class Task(NamedTuple):
    """A submission to grade, in plain values that can be sent to any machine."""

    submission: str  # digest
    stamp: Stamp
    student: Student
    folder: Path  # of the results
    speed: bool

    @property
    def key(self) -> str:
        """Of the result."""
        return digest(self.submission, tuple(self.stamp))


Grade = Callable[[Submission, Task, Budget], Record]
# Returns why the kit failed, and there is no result; "" if there is one. Raises OSError if the disk
# is full: then no further result could be stored.
Unit = Callable[[Task], str]


def digest_of(student: Student) -> str:
    """A digest of what a submission holds, or of why it can't be read. Raises Damaged."""
    data: list[Any] = [os.path.isdir(student.path)]
    try:
        taken = uploads.read(student)
        data += [taken.sha256, taken.parts, taken.refused, taken.ignored]
    except uploads.Damaged:
        raise
    except UsageError as error:
        data.append(str(error).replace(str(student.path), ""))
    return digest(data)


def depends_on() -> tuple[list[Path], list[Path]]:
    """The kit's sources and its data (cases, known mistakes, buggy programs, scenes) that decide a
    result. Formats, tests and what only the handout has change no result."""
    rooms = (
        *(f"grader/bounce_grader/{room}" for room in PYTHON),
        *(f"grader/{room}" for room in CPP),
        *("tests/parts", "solution/src", "solution/exact", "solution/methods"),
        *("student/include", "student/given/examples"),
    )
    files = {file for room in rooms for file in (ROOT / room).rglob("*.*") if file.is_file()}
    files -= {*(ROOT / "tests/parts/linked").iterdir()}
    files -= {SENTENCES / "endings.txt", SENTENCES / "report.txt"}  # which reports are made with
    files = {file for file in files if "__pycache__" not in file.parts}
    one_by_one = ("grader/parts.json", "student/given/solve_lcp.cpp")
    sources = sorted([*files, *(ROOT / name for name in one_by_one), Path(__file__)])
    folders = (fixtures.PUBLIC, fixtures.hidden_folder(), SCENES)
    data = sorted(file for folder in folders for file in folder.rglob("*.*") if file.is_file())
    return sources, data


def stamp_now(trust: bool, sanitize: bool) -> Stamp:
    def of(files: list[Path]) -> str:
        held = [(str(file.relative_to(ROOT)), file.read_bytes()) for file in files]
        return digest(__version__, held)

    sources, data = depends_on()
    return Stamp(of(sources), of(data), trust, sanitize)


# --- one grading ---


def grade_submission(taken: Submission, task: Task, within: Budget) -> Record:
    from bounce_grader.grading.grade import grade, Options
    from bounce_grader.sandbox import box

    kinds, sanitize = box.kinds(task.stamp.trust), task.stamp.sanitize
    return grade(taken, Options(kinds, task.speed, sanitize, jobs=1, within=within))


def grade_one(task: Task, grade: Grade = grade_submission) -> str:
    """Grades a submission, as a Unit."""
    try:
        result = json.dumps(_result(task, grade))
        write_whole(task.folder / f"{task.key}.json", result, durable=True)
    except (KitError, OSError) as error:
        raise_if_full(error)
        return str(error)
    except Exception as error:  # an unforeseen fault of the kit
        return f"{type(error).__name__}: {error}"
    return ""


def _result(task: Task, grade: Grade) -> Result:
    """The content of the result's file. A submission that can't be read has a result, too."""
    result: Result = {
        "key": task.key,
        "at": datetime.now(timezone.utc).isoformat(timespec="seconds"),
        "submission": task.submission,
        **task.stamp._asdict(),
        "timed": task.speed,
    }
    within = Budget()  # reading counts, too
    try:
        taken = uploads.read(task.student)
        _require_a_part(taken)
        record, beside = grade(taken, task, within), _beside(taken)
        return result | {"state": "graded", "message": "", "record": record, "beside": beside}
    except UsageError as error:
        message = in_one_line(str(error).replace(str(task.student.path), "the submission"))
        return result | {"state": "unreadable", "message": message, "record": {}, "beside": []}


def _beside(taken: Submission) -> list[str]:
    """The sources that are no parts, and the headers that are named as a missing one."""
    missing = tuple(part.stem for part in parts() if part.number not in taken.parts)
    others = taken.files.keys() - {*taken.helpers, *taken.parts.values()}
    headers = (name for name in others if PurePosixPath(name).name.lower().startswith(missing))
    return list(map(printable_name, [*taken.helpers, *sorted(headers)]))


def _require_a_part(taken: Submission) -> None:
    """Raises UsageError if no part is found, as with other names: a person looks, before a zero."""
    if not taken.parts and not taken.refused:
        left = [name for name in taken.ignored if not name.startswith("__MACOSX")]
        names = [*_beside(taken), *map(printable_name, left)]
        others = f", but {first_few(names)}" if names else ""
        raise UsageError(f"none of the parts is there under its name{others}")


# --- the folder of results ---


def load(folder: Path, key: str, timed: bool = False) -> Result | None:
    """A valid result, or None. A timed one does without times, too: timing changes no score."""
    try:
        result: Result = json.loads((folder / f"{key}.json").read_bytes())
    except (OSError, ValueError):
        return None
    return result if result.get("key") == key and (result["timed"] or not timed) else None


def stamp_of(folder: Path) -> Stamp | None:
    """The stamp of the results that count; None if there are none yet."""
    try:
        data = json.loads((folder / SET).read_bytes())
        return Stamp(**{name: data[name] for name in Stamp._fields})
    except FileNotFoundError:
        return None
    except (ValueError, LookupError, TypeError) as error:
        raise UsageError(f"{folder / SET} is broken: choose another folder for --out") from error


def count(folder: Path, stamp: Stamp) -> None:
    """Makes the results with this stamp count."""
    write_whole(folder / SET, json.dumps({**stamp._asdict(), "version": __version__}), True)
