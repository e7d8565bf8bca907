"""GitHub Actions: annotations at files and lines of the submission, a summary, and the outputs of a
step. One output is the result that the action autograding-grading-reporter reads."""

import base64
import json
import os
from typing import Any

from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import workflow
from bounce_grader.common.numbers import out_of, short
from bounce_grader.formats import markdown, sentences
from bounce_grader.grading.record import Record

VERSION = 1  # of the reporter's format


def render(record: Record) -> str:
    """Workflow commands for standard output."""
    lines = [line for part in record["parts"] for line in _part(part)]
    lines += [workflow("warning", words, title="Speed") for words in sentences.speed_words(record)]
    if record["box"] != "full":
        words = "without a box" if record["box"] == "none" else "in the reduced box"
        lines.append(workflow("notice", f"graded {words}", title="Box"))
    report = {"totalPoints": record["score"], "maxPoints": record["max_score"]}
    total = f"Points {short(record['score'])}/{short(record['max_score'])}"
    lines.append(workflow("notice", total, title="Autograding complete"))
    lines.append(workflow("notice", json.dumps(report), title="Autograding report"))
    return "\n".join(lines)


def refused(sentence: str) -> str:
    """The report on a submission that can't be read, without points."""
    return workflow("error", sentence, title="Not graded")


def reporter_result(record: Record, pass_score: float = 0.0) -> str:
    """The result for the reporter, in base64, with a test for each check, because a test passes or
    fails as a whole. The reporter fails the job by the status, as the exit status of --min-score
    does."""
    report = {
        "version": VERSION,
        "status": "pass" if record["score"] >= pass_score else "fail",
        "max_score": record["max_score"],
        "tests": [_test(*numbered) for numbered in sentences.numbered(record)],
    }
    return base64.b64encode(json.dumps(report).encode()).decode()


def write_outputs(record: Record, pass_score: float = 0.0) -> None:
    """Writes the outputs and the summary of a workflow's step, if this runs in one."""
    result = f"result={reporter_result(record, pass_score)}\nscore={short(record['score'])}\n"
    _append("GITHUB_OUTPUT", result)
    _append("GITHUB_STEP_SUMMARY", markdown.render(record) + "\n")


def _append(variable: str, text: str) -> None:
    path = os.environ.get(variable)
    if not path:
        return
    try:
        with open(path, "a", encoding="utf-8") as file:
            file.write(text)
    except OSError as error:
        raise UsageError(f"{variable} names a file that can't be written: {error}") from error


def _test(number: str, part: Record, check: Record) -> dict[str, Any]:
    where = _where(check.get("place") or part.get("place"), part)
    return {
        "name": f"{number} {check['title']}",
        "status": "pass" if check["passed"] else "fail",
        "score": check["score"],
        "message": "" if check["passed"] else sentences.check_words(part, check),
        "test_code": "",
        "filename": where["file"],
        "line_no": where["line"],
        "duration": 0,
    }


def _part(part: Record) -> list[str]:
    """At most one annotation for a part, because GitHub shows only ten of each kind in a step. It
    points to a line if one is known."""
    if part["score"] == part["max_score"] and not part.get("remarks"):
        return []
    lines = [sentences.part_words(part)]
    graded = part["status"] == "graded"
    if graded or part["score"]:
        lines += sentences.mistake_words(part)
        lines += [f"lost: {check['title']}" for check in part["checks"] if not check["passed"]]
    where = _where(part.get("place"), part)
    where["line"] = where["line"] or 1
    kind, text = "warning" if graded else "error", "\n".join(lines).strip()
    return [workflow(kind, text, **where, title=f"Part {part['part']}: {out_of(part)}")]


def _where(place: Record | None, part: Record) -> dict[str, str | int]:
    """A file, a line of it (0: unknown), and the column if it is known."""
    if not place:
        return {"file": f"{part['stem']}.cpp", "line": 0}
    column = {"col": place["column"]} if place["column"] else {}
    return {"file": place["file"], "line": place["line"]} | column
