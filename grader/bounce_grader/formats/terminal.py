"""The score record as text for a terminal."""

import sys
from functools import cache
from typing import TextIO

from bounce_grader.assignment.hints import headings
from bounce_grader.common.escaping import first_few, terminal
from bounce_grader.common.packages import find_installed
from bounce_grader.common.paths import HANDOUT
from bounce_grader.formats.sentences import STATUS_WORDS, where_to_read
from bounce_grader.grading import speed
from bounce_grader.grading.record import Record


def show(record: Record, stream: TextIO = sys.stdout) -> None:
    """Prints the report; in colour where the stream is a terminal."""
    if not stream.isatty():
        stream.writelines(f"{line}\n" for _, line in lines(record))
        return
    find_installed()
    from rich.console import Console
    from rich.text import Text

    console = Console(file=stream, highlight=False, soft_wrap=True)
    for style, line in lines(record):
        console.print(Text(line, style=style))


def lines(record: Record) -> list[tuple[str, str]]:
    """(style, text) for each line. Whatever comes from a submission is stripped of controls."""
    out = [("bold", f"Score {number(record['score'])} / {number(record['max_score'])}"), ("", "")]
    for part in record["parts"]:
        out += _part(part)
    if record.get("speed"):
        out += _speed(record["speed"])
    unusual = [name for name in record["ignored"] if name not in _handed_out()]
    if unusual:
        out.append(
            (
                "dim",
                f"Not used: {first_few(list(map(terminal, unusual)), more=record.get('ignored_more', 0))}",
            )
        )
    if record["box"] == "none":
        out.append(("yellow", "Graded without a box: this code could do whatever you can."))
    return out


@cache
def _handed_out() -> set[str]:
    return {path.relative_to(HANDOUT).as_posix() for path in HANDOUT.rglob("*")}


def _part(part: Record) -> list[tuple[str, str]]:
    score = f"{number(part['score'])} / {number(part['max_score'])}"
    heading = f"Part {part['part']}  {part['title']}"
    out = [("bold", f"{heading:<68}{score:>8}")]
    if part["status"] != "graded":
        out.append(("red", f"  {STATUS_WORDS[part['status']]}: {terminal(part['message'])}"))
    elif part["score"] < part["max_score"]:
        out.append(("", f"  {terminal(part['message'])}"))
    for mistake in part["mistakes"]:
        out.append(("yellow", f"  looks like: {mistake['title']}"))
        out.append(("", f"    {mistake['sentence']}"))
        out.append(("dim", f"    {where_to_read(mistake)}"))
    out += [("", f"  {sentence}") for sentence in part["patterns"]]
    if any(check["passed"] or check["message"] for check in part["checks"]):
        for check in part["checks"]:
            out += _check(check)
    if part["graded_with"] == "given" and part["score"] < part["max_score"]:
        out.append(
            ("dim", "  judged with the earlier parts given: a mistake there costs nothing here")
        )
    return [*out, ("", "")]


def _check(check: Record) -> list[tuple[str, str]]:
    mark, style = ("✓", "green") if check["passed"] else ("✗", "red")
    score = f"{number(check['score'])} / {number(check['max_score'])}"
    out = [(style, f"  {mark} {check['title']:<64}{score:>8}")]
    out += [("", f"      {terminal(line)}") for line in check["message"].split("\n") if line]
    if check["message"]:
        out.append(("dim", f"      hint {headings()[check['id']]}"))
    return out


def _speed(found: Record) -> list[tuple[str, str]]:
    error = found["largest_error"]
    accuracy = "largest error " + ("not finite" if error is None else f"{error:.1e}")
    said = [terminal(sentence) for sentence in speed.sentences(found)]
    if "submission_ns" not in found:
        why = "" if said else " (the parts don't run together)"
        return [("", line) for line in (f"Speed: not measured{why}; {accuracy}", *said, "")]
    time = f"{found['submission_ns']:.0f} ns a step, the solution {found['solution_ns']:.0f} ns"
    if "ratio" in found:
        time += f": {found['ratio']:.2f} times its time"
    else:
        time += ", not compared as the answers aren't right"
    return [("", line) for line in (f"Speed: {time}; {accuracy}", *said, "")]


def number(x: float) -> str:
    return f"{x:g}"
