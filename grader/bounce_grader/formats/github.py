"""GitHub Actions: annotations at a submission's lines, a summary, and the score as an output."""

import os

from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import workflow
from bounce_grader.common.numbers import out_of, short
from bounce_grader.formats import markdown, sentences
from bounce_grader.grading.report import Report


def render(record: Report) -> str:
    """Workflow commands for standard output. Writes the score as an output of a workflow's step,
    and its summary, if this runs in one."""
    _append("GITHUB_OUTPUT", f"score={short(record['score'])}\n")
    _append("GITHUB_STEP_SUMMARY", markdown.render(record) + "\n")
    lines = [line for part in record["parts"] for line in _part(part)]
    lines += [workflow("warning", words, title="Speed") for words in sentences.speed_words(record)]
    if record["box"] != "full":
        words = "without a box" if record["box"] == "none" else "in the reduced box"
        lines.append(workflow("notice", f"graded {words}", title="Box"))
    total = f"{short(record['score'])}/{short(record['max_score'])}"
    lines.append(workflow("notice", total, title="Points"))
    return "\n".join(lines)


def refused(sentence: str) -> str:
    """The report on a submission that can't be read, without points."""
    return workflow("error", sentence, title="Not graded")


def _append(variable: str, text: str) -> None:
    path = os.environ.get(variable) or os.devnull  # where this is no step of a workflow
    try:
        with open(path, "a", encoding="utf-8") as file:
            file.write(text)
    except OSError as error:
        raise UsageError(f"{variable} names a file that can't be written: {error}") from error


def _part(part: sentences.Part) -> list[str]:
    """At most one annotation for a part, as GitHub shows ten of a kind; at a line if it's known."""
    if part["score"] == part["max_score"] and not part.get("remarks"):
        return []
    lines = [sentences.part_words(part)]
    graded = part["status"] == "graded"
    if graded or part["score"]:
        lines += sentences.mistake_words(part)
        lines += [f"lost: {check['title']}" for check in part["checks"] if not check["passed"]]
    place = part.get("place") or {"file": f"{part['stem']}.cpp", "line": 0, "column": 0}
    where = {"file": place["file"], "line": place["line"] or 1}
    where |= {"col": place["column"]} if place["column"] else {}
    kind, text = "warning" if graded else "error", "\n".join(lines).strip()
    return [workflow(kind, text, **where, title=f"Part {part['part']}: {out_of(part)}")]
