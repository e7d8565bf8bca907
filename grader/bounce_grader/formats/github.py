"""GitHub Actions: annotations at files and lines of the submission, a summary, and the outputs of a
step. One output is the result that the action autograding-grading-reporter reads."""

import base64
import json
import os
import re
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import workflow
from bounce_grader.common.numbers import out_of, short
from bounce_grader.formats import markdown, sentences
from bounce_grader.formats.sentences import Place
from bounce_grader.grading.record import Record
from bounce_grader.submission import folders

VERSION = 1  # of the reporter's format
Files = tuple[str, ...]  # names of all files in the repository


def render(record: Record, root: Path = Path()) -> str:
    """Workflow commands for standard output. `root` is the folder that was graded, as in the
    repository."""
    files = _files(root)
    lines = [line for part in record["parts"] for line in _part(part, files)]
    lines += [_command("warning", "Speed", sentence) for sentence in sentences.speed_words(record)]
    if record["box"] != "full":
        words = "without a box" if record["box"] == "none" else "in the reduced box"
        lines.append(_command("notice", "Box", f"graded {words}"))
    report = {"totalPoints": record["score"], "maxPoints": record["max_score"]}
    total = f"Points {short(record['score'])}/{short(record['max_score'])}"
    lines.append(_command("notice", "Autograding complete", total))
    lines.append(_command("notice", "Autograding report", json.dumps(report)))
    return "\n".join(lines)


def refused(sentence: str) -> str:
    """The report on a submission that can't be read, without points."""
    return _command("error", "Not graded", sentence)


def reporter_result(record: Record, root: Path = Path(), pass_score: float = 0.0) -> str:
    """The result for the reporter, in base64, with a test for each check, because a test passes or
    fails as a whole. The reporter fails the job by the status, as the exit status of --min-score
    does."""
    files = _files(root)
    report = {
        "version": VERSION,
        "status": "pass" if record["score"] >= pass_score else "fail",
        "max_score": record["max_score"],
        "tests": [_test(*numbered, files) for numbered in sentences.numbered(record)],
    }
    return base64.b64encode(json.dumps(report).encode()).decode()


def write_outputs(record: Record, root: Path = Path(), pass_score: float = 0.0) -> None:
    """Writes the outputs and the summary of a workflow's step, if this runs in one."""
    result = f"result={reporter_result(record, root, pass_score)}\nscore={short(record['score'])}\n"
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


def _test(number: str, part: Record, check: Record, files: Files) -> dict[str, Any]:
    words = sentences.check_words(part, check)
    place = _place_in([check["message"], sentences.part_words(part)], part, files)
    return {
        "name": f"{number} {check['title']}",
        "status": "pass" if check["passed"] else "fail",
        "score": check["score"],
        "message": "" if check["passed"] else words,
        "test_code": "",
        "filename": _in_repository(place.file, files) if place else f"{part['stem']}.cpp",
        "line_no": place.line if place else 0,
        "duration": 0,
    }


def _part(part: Record, files: Files) -> list[str]:
    """At most one annotation for a part, because GitHub shows only ten of each kind in a step. It
    points to a line if one is known."""
    if part["score"] == part["max_score"] and not part.get("remarks"):
        return []
    lines = [sentences.part_words(part)]
    place = _place_in([*lines, *(check["message"] for check in part["checks"])], part, files)
    place = place or Place(f"{part['stem']}.cpp", 1, None)
    graded = part["status"] == "graded"
    if graded or part["score"]:
        lines += sentences.mistake_words(part)
        lines += [f"lost: {check['title']}" for check in part["checks"] if not check["passed"]]
    title, text = f"Part {part['part']}: {out_of(part)}", "\n".join(lines).strip()
    return [_command("warning" if graded else "error", title, text, place, files)]


def _command(
    kind: str, title: str, text: str, place: Place | None = None, files: Files = ()
) -> str:
    where: dict[str, str | int] = {}
    if place:
        where = {"file": _in_repository(place.file, files), "line": place.line}
        where |= {"col": place.column} if place.column else {}
    return workflow(kind, text, **where, title=title)


def _place_in(texts: Iterable[str], part: Record, files: Files) -> Place | None:
    """The first place that is in the part's own file or in another file of the repository. The
    texts come from the submission, which could name any file."""
    own = f"{part['stem']}.cpp"
    for place in filter(None, map(sentences.place_in, texts)):
        if Path(place.file).name == own or _in_repository(place.file, files) in files:
            return place
    return None


def _files(root: Path) -> Files:
    """The names of the files in a folder, without what is in archives there, which would be
    unpacked for nothing. Empty if it is no folder, or can't be listed."""
    try:
        with folders.opened(root) as entries:
            return tuple(entry.name for entry in entries)
    except UsageError:
        return ()


def _in_repository(file: str, files: Files) -> str:
    """The path of a file in the repository. The grader's paths begin at the submission's top
    folder, which may be deeper in the repository, and are cut off at a blank or another unusual
    sign."""
    whole = re.compile(rf"(?:.*[^\w.-])?{re.escape(file)}", re.DOTALL)
    deeper = list(filter(whole.fullmatch, files))
    return deeper[0] if len(deeper) == 1 and file not in files else file
