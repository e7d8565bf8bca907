"""Compares a record with the previous one: which checks were gained, and which are lost now."""

import json
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any, NamedTuple

from bounce_grader.common.errors import UsageError
from bounce_grader.common.manifest import parts
from bounce_grader.grading.record import Record


class Previous(NamedTuple):
    """What is known of the previous record."""

    score: float
    passed: Mapping[str, bool]  # by the check's id


def of_record(record: Mapping[str, Any]) -> Previous:
    checks = [check for part in record["parts"] for check in part["checks"]]
    return Previous(float(record["score"]), {c["id"]: bool(c["passed"]) for c in checks})


def compared(record: Record, before: Previous | None) -> Record:
    """The record, with what has changed since the previous one; unchanged if there is none."""
    if before is None:
        return record
    now = of_record(record).passed
    known = [id for id in now if id in before.passed]
    changes = {
        "score": before.score,
        "gained": [id for id in known if now[id] and not before.passed[id]],
        "lost": [id for id in known if before.passed[id] and not now[id]],
    }
    return {**record, "before": changes}


def read(path: Path) -> Previous | None:
    """Reads the previous record; or Gradescope's submission_metadata.json, where the newest
    previous submission with a result counts. None if that file has no result. Raises UsageError."""
    try:
        data = json.loads(path.read_text("utf-8"))
        if "previous_submissions" in data:
            return _of_gradescope(data["previous_submissions"])
        return of_record(data)
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise UsageError(
            f"{path} is neither a score record nor Gradescope's submission_metadata.json "
            f"({type(error).__name__})"
        ) from error


def _of_gradescope(submissions: list[dict[str, Any]]) -> Previous | None:
    """The newest result of ours. Another autograder of the assignment may have written results too:
    those have another shape, and are passed over."""
    ids = {
        f"{part.number}.{number}": check.id
        for part in parts()
        for number, check in enumerate(part.checks, 1)
    }
    newest_first = sorted(
        submissions, key=lambda s: str(s.get("submission_time", "")), reverse=True
    )
    for submission in newest_first:
        with suppress(KeyError, TypeError, ValueError, AttributeError):
            if submission.get("autograder_error"):
                continue
            tests = submission["results"]["tests"]
            passed = {
                ids[t["number"]]: t["status"] == "passed" for t in tests if t["number"] in ids
            }
            if passed:
                return Previous(sum(float(test["score"]) for test in tests), passed)
    return None
