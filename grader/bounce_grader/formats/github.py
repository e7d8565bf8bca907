"""GitHub Actions: annotations at the student's files and lines, and what GitHub Classroom's
reporter reads."""

import base64
import json
import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import workflow
from bounce_grader.formats import markdown, sentences
from bounce_grader.formats.sentences import Place
from bounce_grader.grading.record import Record
from bounce_grader.submission import intake

VERSION = 1  # of the reporter's format


def render(record: Record, root: Path = Path()) -> str:
    """Workflow commands for standard output; `root` is where the files' names begin."""
    lines = [line for part in record["parts"] for line in _part(part, root)]
    lines += [_command("warning", "Speed", sentence) for sentence in sentences.speed_words(record)]
    report = {"totalPoints": record["score"], "maxPoints": record["max_score"]}
    total = f"Points {sentences.points(record['score'])}/{sentences.points(record['max_score'])}"
    lines.append(_command("notice", "Autograding complete", total))
    lines.append(_command("notice", "Autograding report", json.dumps(report)))
    return "\n".join(lines)


def refused(sentence: str) -> str:
    """For a submission that can't be read: no points are reported."""
    return _command("error", "Not graded", sentence)


def result(record: Record, root: Path = Path()) -> str:
    """The reporter's result, in base64: a test for each part."""
    full = record["score"] == record["max_score"]
    report = {
        "version": VERSION,
        "status": "pass" if full else "fail",
        "max_score": record["max_score"],
        "tests": [_test(part, root) for part in record["parts"]],
    }
    return base64.b64encode(json.dumps(report).encode()).decode()


def leave(record: Record, root: Path = Path()) -> None:
    """What a step of a workflow hands on, where this is one."""
    score = sentences.points(record["score"])
    _append("GITHUB_OUTPUT", f"result={result(record, root)}\nscore={score}\n")
    _append("GITHUB_STEP_SUMMARY", markdown.render(record) + "\n")


def _append(variable: str, text: str) -> None:
    if os.environ.get(variable):
        try:
            with open(os.environ[variable], "a", encoding="utf-8") as file:
                file.write(text)
        except OSError as error:
            raise UsageError(f"{variable} names a file that can't be written: {error}") from error


def _test(part: Record, root: Path) -> dict[str, Any]:
    place = _place_in([sentences.part_words(part)], part, root)
    return {
        "name": f"Part {part['part']}: {part['title']}",
        "status": "pass" if part["score"] == part["max_score"] else "fail",
        "score": part["score"],
        "message": "\n".join([sentences.part_words(part), *sentences.mistake_words(part)]),
        "test_code": "",
        "filename": place.file if place else f"{part['stem']}.cpp",
        "line_no": place.line if place else 0,
        "duration": 0,
    }


def _part(part: Record, root: Path) -> list[str]:
    """One annotation a part, at its line where that is known: GitHub shows ten of a kind a step."""
    if part["score"] == part["max_score"]:
        return []
    said = sentences.part_words(part)
    place = _place_in([said, *(check["message"] for check in part["checks"])], part, root)
    lost = [check["title"] for check in part["checks"] if not check["passed"]]
    score = f"{sentences.points(part['score'])} / {sentences.points(part['max_score'])}"
    title = f"Part {part['part']}: {score}"
    kind = "warning" if part["status"] == "graded" else "error"
    text = said if part["status"] == "graded" else f"{said}\n"
    if part["status"] == "graded" or part["score"]:
        known = sentences.mistake_words(part)
        text = "\n".join([said, *known, *(f"lost: {check}" for check in lost)])
    return [
        _command(kind, title, text.strip(), place or Place(f"{part['stem']}.cpp", 1, None), root)
    ]


def _command(
    kind: str, title: str, text: str, place: Place | None = None, root: Path = Path()
) -> str:
    where: dict[str, str | int] = {}
    if place:
        where = {"file": _in_repository(place.file, root), "line": place.line}
        where |= {"col": place.column} if place.column else {}
    return workflow(kind, text, **where, title=title)


def _place_in(texts: Iterable[str], part: Record, root: Path) -> Place | None:
    """The first in the part's own file or in another of the repository: a submission has its say in
    these texts, and could name any file."""
    own, there = f"{part['stem']}.cpp", _files(root)
    for place in filter(None, map(sentences.place_in, texts)):
        if Path(place.file).name == own or _in_repository(place.file, root) in there:
            return place
    return None


def _files(root: Path) -> list[str]:
    """Of a folder, as many and as deep as a submission may have them."""
    try:
        with intake.opened(root) as entries:
            return [entry.name for entry in entries] if root.is_dir() else []
    except UsageError:
        return []


def _in_repository(file: str, root: Path) -> str:
    """The grader names files from a submission's top folder; a repository may have that deeper."""
    there = _files(root)
    deeper = [path for path in there if path.endswith(f"/{file}")]
    return deeper[0] if len(deeper) == 1 and file not in there else file
