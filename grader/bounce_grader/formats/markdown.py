"""Markdown, for a comment on a pull request or the summary of a workflow."""

from bounce_grader.common import escaping
from bounce_grader.common.numbers import out_of
from bounce_grader.formats import sentences
from bounce_grader.grading.report import Report

LONGEST = 60_000  # characters; a comment on GitHub may have 65,536


def render(record: Report) -> str:
    lines = [f"## {out_of(record)} points", "", "| part | points | |", "| --- | ---: | --- |"]
    for part in record["parts"]:
        title, words = map(escaping.markdown, (part["title"], sentences.part_words(part)))
        lines.append(f"| {part['part']}: {title} | {out_of(part)} | {words} |")
    for part in record["parts"]:
        mistakes = map(escaping.markdown, sentences.mistake_words(part))
        items = [f"- Part {part['part']}: {mistake}" for mistake in mistakes]
        lines += ["", *items] if items else []
    first = sentences.first_to_do(record)
    lines += ["", escaping.markdown(first)] if first else []
    lines += [f"\n{escaping.markdown(words)}" for words in sentences.speed_words(record)]
    text = "\n".join(lines) + "\n"
    for number, part, check in sentences.numbered(record):
        if not check["passed"] and check["message"]:
            detail = _check(number, part, check)
            if len(text) + len(detail) > LONGEST:
                return text + "\nMore checks failed than there is room for.\n"
            text += detail
    return text.rstrip("\n")


def _check(number: str, part: sentences.Part, check: sentences.Part) -> str:
    heading = f"<details><summary>✗ {number} {escaping.html(check['title'])}</summary>"
    hint = check["hint"]["heading"]
    advice = f"\nHint {escaping.markdown(hint)}\n" if hint else ""
    return f"\n{heading}\n\n{escaping.markdown_block(check['message'])}\n{advice}\n</details>\n"
