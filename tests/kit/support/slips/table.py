"""Counts what is said of programs with known slips: rightly named, silent, falsely said.

The programs are C++ functions with switches (part1.cpp and the others here); the program `slips`
runs them, and prints what the recogniser says. truth.json holds, by part and slip, what is true of
it: names of known mistakes, and words of which a sentence must hold one to name the slip. A known
mistake that is said of a program and stands with none of its slips is false. "a and b" holds what
is true of two slips together alone: pairs whose numbers are exactly those of other mistakes.
"""

import json
import re
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import Any, NamedTuple

from bounce_grader.common.paths import BUILD, FIXTURES
from bounce_grader.sandbox import processes

TRUTH = Path(__file__).with_name("truth.json")
PAIRS = 250  # of random slips, for each part and style
LIMITS = processes.Limits(300, 3000, memory=2 << 30, file_size=0, output=64 << 20)
INPUTS = re.compile(r"Where only (.+?) is changed, ")
HEAD = "| part | style | programs | rightly named | silent | falsely said |"


class Said(NamedTuple):
    """What is said of one program. A false sentence is one that is true of none of its slips."""

    part: int
    style: str
    slips: tuple[str, ...]
    mistakes: tuple[str, ...]
    patterns: tuple[str, ...]
    truth: tuple[str, ...]  # of all its slips

    @property
    def false(self) -> tuple[str, ...]:
        return tuple(name for name in self.mistakes if name not in self.truth)

    @property
    def is_named(self) -> bool:
        if self.mistakes:
            return not self.false
        return any(_says(words, text) for words in self.truth for text in self.patterns)


def _says(words: str, text: str) -> bool:
    """Whether a sentence holds these words, or says what an input does ("unchanged by l")."""
    effect, _, name = words.partition(" by ")
    match = INPUTS.match(text)
    if effect not in ("changed", "unchanged") or not match:
        return words in text
    is_unchanged = text.endswith("should change.")
    return name in re.split(", | or ", match[1]) and is_unchanged == (effect == "unchanged")


def said(pairs: int = PAIRS) -> list[Said]:
    """What is said of every wrong program. Raises AssertionError if a slip has no truth."""
    command = [str(BUILD / "slips"), str(FIXTURES / "public"), str(pairs)]
    result = processes.run(command, LIMITS)
    assert result.ok, result.err
    rows = map(json.loads, result.out.splitlines())
    truth = json.loads(TRUTH.read_text(encoding="utf-8"))
    return [_said(row, truth[str(row["part"])]) for row in rows if not row["right"]]


def _said(row: dict[str, Any], truth: dict[str, list[str]]) -> Said:
    unknown = [slip for slip in row["slips"] if slip not in truth]
    assert not unknown, f"truth.json lacks {unknown}"
    held = [*row["slips"], " and ".join(row["slips"])]
    return Said(
        part=row["part"],
        style=row["style"],
        slips=tuple(row["slips"]),
        mistakes=tuple(row["mistakes"]),
        patterns=tuple(row["patterns"]),
        truth=tuple(words for slips in held for words in truth.get(slips, [])),
    )


def table(rows: Iterable[Said]) -> str:
    """The table of docs/grading.md, of single slips and of pairs."""
    rows = list(rows)
    lines = []
    for number, words in ((1, "One slip:"), (2, "Two slips at once:")):
        lines += [words, "", HEAD, "| --- | --- | ---: | ---: | ---: | ---: |"]
        chosen = [row for row in rows if len(row.slips) == number]
        for part, style in sorted({(row.part, row.style) for row in chosen}):
            of_style = [r for r in chosen if (r.part, r.style) == (part, style)]
            lines.append(_line(str(part), style, of_style))
        lines += [_line("all", "", chosen), ""]
    return "\n".join(lines)


def _line(part: str, style: str, rows: list[Said]) -> str:
    count = Counter("false" if r.false else "named" if r.is_named else "silent" for r in rows)
    numbers = (len(rows), count["named"], count["silent"], count["false"])
    return f"| {part} | {style} | " + " | ".join(map(str, numbers)) + " |"
