"""Classroom 50's result.json (its wiki: Advanced Autograding), for a runner of the course's own.
The service's runner adds who handed it in. Scores are whole numbers there: points that aren't are
scaled."""

import os
from datetime import datetime, timezone
from typing import Any

from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import json_document, printable
from bounce_grader.formats import sentences
from bounce_grader.grading.record import Record

SCHEMA = "classroom50/result/v1"
FIELDS = {
    "classroom": "CLASSROOM",
    "assignment": "ASSIGNMENT",
    "submission": "SUBMISSION_TAG",
    "commit": "COMMIT_URL",
    "release": "RELEASE_URL",
}
SCALES = (1, 2, 4, 5, 10, 100)


def render(record: Record) -> str:
    missing = [variable for variable in FIELDS.values() if not os.environ.get(variable)]
    if missing:
        raise UsageError(f"{missing[0]} isn't set: Classroom 50's runner sets it for an autograder")
    checks = [check["max_score"] for part in record["parts"] for check in part["checks"]]
    scale = next((s for s in SCALES if all((p * s) % 1 == 0 for p in checks)), SCALES[-1])
    tests = [_test(*numbered, scale) for numbered in sentences.numbered(record)]
    result = {
        "schema": SCHEMA,
        **{field: os.environ[variable] for field, variable in FIELDS.items()},
        "review": os.environ.get("REVIEW_URL") or os.environ["COMMIT_URL"],
        "datetime": datetime.now(timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ"),
        "score": sum(test["score"] for test in tests),
        "max-score": sum(test["max-score"] for test in tests),
        "tests": tests,
    }
    return json_document(result, indent=1)


def _test(number: str, part: Record, check: Record, scale: int) -> dict[str, Any]:
    return {
        "test-name": f"{number} {check['title']}",
        "passed": check["passed"],
        "score": round(check["score"] * scale),
        "max-score": round(check["max_score"] * scale),
        "output": printable(sentences.check_words(part, check)),
    }
