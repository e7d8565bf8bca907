"""Markdown, for a comment on a pull request or the summary of a workflow."""

from bounce_grader.common import escaping
from bounce_grader.formats import sentences
from bounce_grader.grading.record import Record

LONGEST = 60_000  # characters; a comment on GitHub may have 65,536


def render(record: Record) -> str:
    lines = [
        f"## {sentences.of_points(record)} points",
        "",
        "| part | points | |",
        "| --- | ---: | --- |",
    ]
    for part in record["parts"]:
        score = f"{sentences.points(part['score'])} / {sentences.points(part['max_score'])}"
        said = escaping.markdown(sentences.part_words(part))
        lines.append(f"| {part['part']}: {escaping.markdown(part['title'])} | {score} | {said} |")
    for part in record["parts"]:
        said_of = [
            f"- Part {part['part']}: {escaping.markdown(line)}"
            for line in sentences.mistake_words(part)
        ]
        lines += ["", *said_of] if said_of else []
    lines += [f"\n{escaping.markdown(sentence)}" for sentence in sentences.speed_words(record)]
    text = "\n".join(lines) + "\n"
    for number, part, check in sentences.numbered(record):
        if not check["passed"] and check["message"]:
            detail = _check(number, check)
            if len(text) + len(detail) > LONGEST:
                return text + "\nMore checks failed than there is room for.\n"
            text += detail
    return text.rstrip("\n")


def _check(number: str, check: Record) -> str:
    heading = f"<details><summary>✗ {number} {escaping.html(check['title'])}</summary>"
    hint = sentences.hint(check)
    return (
        f"\n{heading}\n\n{escaping.markdown_block(check['message'])}\n"
        + (f"\nHint {escaping.markdown(hint)}\n" if hint else "")
        + "\n</details>\n"
    )
