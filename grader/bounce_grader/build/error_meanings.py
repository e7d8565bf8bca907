"""Says what a compiler's error or a crash usually means in this assignment, in the words of the
handout."""

import functools

from bounce_grader.common.paths import HANDOUT

FOLDER = HANDOUT / "given" / "check"
QUOTES = str.maketrans('‘’`"', "''''")


def meaning(error: str, file: str = "compiler_errors.txt") -> str:
    """A sentence; empty where the error isn't one of the commonest."""
    plain = error.translate(QUOTES)
    return next((sentence for piece, sentence in meanings(file) if piece in plain), "")


@functools.cache
def meanings(file: str) -> list[tuple[str, str]]:
    """Pairs of a piece of a message and the sentence that explains it. In the file, the pieces are
    indented below their sentence."""
    found, sentence = [], ""
    for line in (FOLDER / file).read_text(encoding="utf-8").splitlines():
        if line.startswith("  "):
            found.append((line[2:], sentence))
        else:
            sentence = line
    return found
