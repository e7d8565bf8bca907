"""Says what a compiler's error usually means in this assignment, in the words of the handout."""

import functools
import re

from bounce_grader.common.paths import HANDOUT

FILE = HANDOUT / "given" / "check" / "compiler_errors.txt"
LONGEST = 2000  # of an error, in characters


def meaning(error: str) -> str:
    """A sentence; empty where the error isn't one of the commonest."""
    for pattern, sentence in _meanings():
        if pattern.search(error[:LONGEST]):
            return sentence
    return ""


@functools.cache
def _meanings() -> list[tuple[re.Pattern[str], str]]:
    """The patterns are indented, below their sentence."""
    found, sentence = [], ""
    for line in FILE.read_text(encoding="utf-8").splitlines():
        if line.startswith("  "):
            found.append((re.compile(line[2:]), sentence))
        else:
            sentence = line
    return found
