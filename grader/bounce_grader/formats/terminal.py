"""The score record as text for a terminal."""

import os
import sys

from bounce_grader.common.escaping import first_few, terminal
from bounce_grader.common.numbers import out_of, scientific
from bounce_grader.common.paths import HANDOUT
from bounce_grader.formats import sentences
from bounce_grader.grading import speed
from bounce_grader.grading.report import Report

STYLES = {"": "", "bold": "1", "dim": "2", "red": "31", "green": "32", "yellow": "33"}


def render(record: Report) -> str:
    """The report; in colour on a terminal."""
    if not sys.stdout.isatty() or os.environ.get("NO_COLOR"):
        return "".join(f"{line}\n" for _, line in lines(record))
    return "".join(f"\33[{STYLES[style]}m{line}\33[0m\n" for style, line in lines(record))


def lines(record: Report) -> list[tuple[str, str]]:
    """The report's lines, as (style, text); a submission's text without control characters."""
    out = [("bold", f"Score {out_of(record)}"), ("", "")]
    for part in record["parts"]:
        out += _part(part)
    if cases := sentences.about_cases(record):
        out += [("", terminal(line)) for line in (*cases, "")]
    if record.get("speed"):
        out += _speed(record["speed"])
    given = HANDOUT.rglob("*") if record["ignored"] else ()
    handed_out = {path.relative_to(HANDOUT).as_posix() for path in given}
    if unusual := [name for name in record["ignored"] if name not in handed_out]:
        files = first_few([*map(terminal, unusual)], more=record.get("ignored_more", 0))
        out.append(("dim", f"Not used: {files}"))
    if record["box"] == "none":
        words = "Graded without a sandbox: the submitted code could do anything you can."
        out.append(("yellow", words))
    return out


def _part(part: sentences.Part) -> list[tuple[str, str]]:
    heading = f"Part {part['part']}  {part['title']}"
    out = [("bold", f"{heading:<68}{out_of(part):>8}")]
    if part["status"] != "graded":
        status = sentences.STATUS_WORDS[part["status"]]
        out.append(("red", f"  {status}: {terminal(part['message'])}"))
    elif part["score"] < part["max_score"]:
        out.append(("", f"  {terminal(part['message'])}"))
    out += [("yellow", f"  remark, no points: {terminal(r)}") for r in part.get("remarks", [])]
    for mistake in part["mistakes"]:
        out.append(("yellow", f"  Looks like: {mistake['title']}"))
        out.append(("", f"    {mistake['sentence']}"))
        out.append(("dim", f"    {mistake['where']}"))
    out += [("", f"  {sentence}") for sentence in part["patterns"]]
    if sentences.has_run(part):
        for check in part["checks"]:
            out += _check(check)
    if sentences.had_help(part):
        words = "graded with correct earlier parts in place of yours: your mistakes there cost nothing here"
        out.append(("dim", f"  {words}"))
    return [*out, ("", "")]


def _check(check: sentences.Part) -> list[tuple[str, str]]:
    mark, style = ("✓", "green") if check["passed"] else ("✗", "red")
    out = [(style, f"  {mark} {check['title']:<64}{out_of(check):>8}")]
    out += [("", f"      {terminal(line)}") for line in check["message"].split("\n") if line]
    if check["message"] and (hint := check["hint"]["heading"]):
        out.append(("dim", f"      hint {hint}"))
    return out


def _speed(measured: sentences.Part) -> list[tuple[str, str]]:
    error = measured["largest_error"]
    accuracy = "largest error " + ("not finite" if error is None else scientific(error))
    curves = [terminal(sentence) for sentence in speed.sentences(measured)]
    if "submission_ns" not in measured:
        time = "not measured" + ("" if curves else " (the parts don't run together)")
    else:
        own, solutions = measured["submission_ns"], measured["solution_ns"]
        ratio = f"{measured['ratio']:.2f} times its time"
        time = f"{own:.0f} ns a step, the solution {solutions:.0f} ns: {ratio}"
    return [("", line) for line in (f"Speed: {time}; {accuracy}", *curves, "")]
