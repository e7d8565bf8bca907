"""Says in one line why a submission doesn't compile or link, and where: the compiler's first error
or the linker's, and what that usually means in this assignment.

The meanings are those of ./check, from student/given/check/compiler_errors.txt.
"""

import functools
import re
from pathlib import Path
from typing import NamedTuple

from bounce_grader.common.paths import HANDOUT
from bounce_grader.submission.submission import Place

EXPLAINED = HANDOUT / "given" / "check" / "compiler_errors.txt"
QUOTES = str.maketrans('‘’`"', "''''")


class Built(NamedTuple):
    """An object file or a runner; or one sentence that says why there is none, and the line that it
    is about if that is known. A submission can influence both texts."""

    path: Path | None
    problem: str = ""
    place: Place | None = None


# --- compilers ---


def of_compiler(printed: str, file: str) -> Built:
    """The first error that a compiler printed about a file."""
    errors = re.findall(r"^(.+?):(\d{1,10}):(\d{1,9}): (?:fatal )?error: (.*)$", printed, re.M)
    if not errors:
        return Built(None, f"{file}: {_without_a_place(printed)}")
    where, line, column, what = errors[0]
    place = Place(where, int(line), int(column))
    shouted = re.search(r'"([A-Z_0-9]{8,})"$', what)  # by Eigen
    error = shouted.group(1).replace("_", " ").lower() if shouted else what
    sentence = f"{place}: {error}"
    if where.startswith("/"):
        header = Path(str(place)).name
        note = re.search(rf"^{re.escape(file)}:(\d{{1,9}}):\d+: note: ", printed, re.M)
        place = Place(file, int(note[1]) if note else 1)
        sentence = f"{error}{f', asked for at {place}' if note else f' in {file}'} ({header})"
    if usual := meaning(what):
        sentence += f"{'' if sentence.endswith(('.', '?')) else '.'} {usual}"
    return Built(None, sentence, place)


def _without_a_place(printed: str) -> str:
    for error in re.findall(r"^(?:\S+: )?(?:fatal )?error: (.*)$", printed, re.MULTILINE):
        if not error.startswith(("clang frontend command failed", "unable to execute command")):
            return str(error)
    limits = "it takes more than 2 GB of memory, or 64 MB of files"
    fault = "or meets a fault of the compiler's own; take lines out until it compiles"
    return f"the compiler gave up on it: {limits}, {fault}"


def meaning(error: str) -> str:
    """A sentence; empty where the error isn't one of the commonest."""
    plain = error.translate(QUOTES)
    return next((sentence for piece, sentence in meanings() if piece in plain), "")


@functools.cache
def meanings() -> list[tuple[str, str]]:
    """Pairs of a message's piece and the sentence for it, below which the file has it indented."""
    found, sentence = [], ""
    for line in EXPLAINED.read_text(encoding="utf-8").splitlines():
        if line.startswith("  "):
            found += [(piece, sentence) for piece in line[2:].split(" | ")]
        else:
            sentence = line
    return found


# --- the linker ---


def of_linker(printed: str) -> Built:
    """The missing or duplicate symbol, looked for at line starts: long lines don't make it slow."""
    error = r"(?m)^ld\.lld: error: "
    referenced = r"(?:\n>>> referenced by (.+?):(\d{1,9}))?"
    if missing := re.search(rf"{error}undefined symbol: (.*){referenced}", printed):
        symbol, file, line = missing.groups()
        if not file:
            return Built(None, f"{symbol} is used, but no file that compiles defines it")
        place = Place(file, int(line))
        return Built(None, f"{place} uses {symbol}, which no file that compiles defines", place)
    if twice := re.search(rf"{error}duplicate symbol: (.*)", printed):
        return Built(None, f"{twice[1]} is defined in two files")
    large = "look for very large global arrays in them, and for lines of assembler"
    return Built(None, f"the parts can't be linked with each other: {large}")
