"""Says what a compiler's error usually means in this assignment, in the words of the handout."""

import functools

from bounce_grader.common.paths import HANDOUT

FILE = HANDOUT / "given" / "check" / "compiler_errors.txt"
QUOTES = str.maketrans('‘’`"', "''''")


def meaning(error: str) -> str:
    """A sentence; empty where the error isn't one of the commonest."""
    plain = error.translate(QUOTES)
    return next((sentence for piece, sentence in _meanings() if piece in plain), "")


@functools.cache
def _meanings() -> list[tuple[str, str]]:
    """Pairs of a piece of a compiler's message and the sentence that explains it. In the file, the
    pieces are indented below their sentence."""
    found, sentence = [], ""
    for line in FILE.read_text(encoding="utf-8").splitlines():
        if line.startswith("  "):
            found.append((line[2:], sentence))
        else:
            sentence = line
    return found
