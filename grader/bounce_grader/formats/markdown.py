"""Markdown, for a comment on a pull request or the summary of a workflow."""

from bounce_grader import escape
from bounce_grader.formats import words
from bounce_grader.record import Record

LONGEST = 60_000  # characters; a comment on GitHub may have 65,536


def render(record: Record) -> str:
    lines = [
        f"## {words.of_points(record)} points",
        "",
        "| part | points | |",
        "| --- | ---: | --- |",
    ]
    for part in record["parts"]:
        score = f"{words.points(part['score'])} / {words.points(part['max_score'])}"
        said = escape.markdown(words.part_words(part))
        lines.append(f"| {part['part']}: {escape.markdown(part['title'])} | {score} | {said} |")
    for part in record["parts"]:
        said_of = [
            f"- Part {part['part']}: {escape.markdown(line)}" for line in words.mistake_words(part)
        ]
        lines += ["", *said_of] if said_of else []
    lines += [f"\n{escape.markdown(sentence)}" for sentence in words.speed_words(record)]
    text = "\n".join(lines) + "\n"
    for number, part, check in words.numbered(record):
        if not check["passed"] and check["message"]:
            detail = _check(number, check)
            if len(text) + len(detail) > LONGEST:
                return text + "\nMore checks failed than there is room for.\n"
            text += detail
    return text.rstrip("\n")


def _check(number: str, check: Record) -> str:
    heading = f"<details><summary>✗ {number} {escape.html(check['title'])}</summary>"
    hint = words.hint(check)
    return (
        f"\n{heading}\n\n{escape.markdown_block(check['message'])}\n"
        + (f"\nHint {escape.markdown(hint)}\n" if hint else "")
        + "\n</details>\n"
    )
