"""Keeps which results each student has had, in OUT/history.json, so that a page can say what has
changed since the submission before."""

import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from bounce_grader.classroom.grading import results
from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.common.files import write_whole
from bounce_grader.grading.previous import Previous, of_record

NAME = "history.json"
History = dict[str, list[str]]  # a student's id -> keys of results, oldest first


def read(out: Path) -> History:
    try:
        data = json.loads((out / NAME).read_text())
        return {str(id): list(map(str, keys)) for id, keys in data.items()}
    except (OSError, ValueError, AttributeError, TypeError):
        return {}  # then no page says what has changed


def add(out: Path, history: History, summaries: Iterable[Summary]) -> None:
    for summary in summaries:
        keys = history.setdefault(summary.student.id, [])
        if summary.score is not None and keys[-1:] != [summary.key]:
            keys.append(summary.key)
    write_whole(out / NAME, json.dumps(history, indent=1, sort_keys=True))


def before(out: Path, keys: list[str], result: dict[str, Any]) -> Previous | None:
    """The newest result of another submission of the same student's."""
    for key in reversed(keys):
        for folder in sorted(out.glob("results*")):
            earlier = results.load(folder, key)
            if earlier and earlier["record"] and earlier["submission"] != result["submission"]:
                return of_record(earlier["record"])
    return None
