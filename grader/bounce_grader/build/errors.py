"""Says in one line why a submission doesn't compile or link, and where: the compiler's first error
or the linker's, and what that usually means in this assignment.

The meanings are those of ./check, from student/given/check/compiler_errors.txt. Where Eigen refuses
two shapes, they are read from the types in the compiler's note, such as

'Eigen::MatrixBase<Eigen::Matrix<double, 3, 2, 0>>::operator*<Eigen::Matrix<double, 3, 1, 0>>'
"""

import functools
import re
from pathlib import Path
from typing import NamedTuple

from bounce_grader.common.paths import HANDOUT
from bounce_grader.submission.submission import Place

EXPLAINED = HANDOUT / "given" / "check"
QUOTES = str.maketrans('‘’`"', "''''")
LONGEST, DEEPEST = 10_000, 40  # of a note, and of the types in one another
PRODUCT = "operator*"
REFUSED = {
    PRODUCT: "a {left} and a {right} can't be multiplied",
    "operator+": "a {left} and a {right} can't be added",
    "operator-": "a {right} can't be subtracted from a {left}",
    "operator+=": "a {right} can't be added to a {left}",
    "operator-=": "a {right} can't be subtracted from a {left}",
    "operator=": "a {right} can't be assigned to a {left}",
    "Matrix": "a {right} can't be assigned to a {left}",
    "cwiseProduct": "a {left} and a {right} can't be multiplied entry by entry",
    "dot": "a {left} and a {right} have no scalar product",
}


class Built(NamedTuple):
    """An object file or a runner; or one sentence that says why there is none, and the line that it
    is about, if that is known: any text that the submission made a compiler write."""

    path: Path | None
    problem: str = ""
    place: Place | None = None


# --- compilers ---


def of_compiler(printed: str, file: str) -> Built:
    """The first error that a compiler printed about a file."""
    errors = re.findall(r"^(.+?):(\d{1,9}):(\d{1,9}): (?:fatal )?error: (.*)$", printed, re.MULTILINE)
    if not errors:
        return Built(None, f"{file}: {_without_a_place(printed)}")
    where, line, column, what = errors[0]
    place = Place(where, int(line), int(column))
    shouted = re.search(r'"([A-Z_0-9]{8,})"$', what)  # by Eigen
    error = shouted.group(1).replace("_", " ").lower() if shouted else what
    sentence = f"{place}: {error}"
    if where.startswith("/"):
        header = Path(str(place)).name
        note = re.search(rf"^{re.escape(file)}:(\d{{1,9}}):\d+: note: (.*)$", printed, re.MULTILINE)
        place = Place(file, int(note.group(1)) if note else 1)
        sentence = f"{error} in {file} ({header})"
        if note:
            error = _misfit(note.group(2)) or error
            sentence = f"{error}, asked for at {place} ({header})"
    usual = meaning(what)
    stop = "" if sentence.endswith((".", "?")) else "."
    return Built(None, f"{sentence}{stop} {usual}" if usual else sentence, place)


def _without_a_place(printed: str) -> str:
    for error in re.findall(r"^(?:\S+: )?(?:fatal )?error: (.*)$", printed, re.MULTILINE):
        if not error.startswith("clang frontend command failed"):
            return str(error)
    return (
        "the compiler gave up on it: it takes more than 2 GB of memory, or "
        "meets a fault of the compiler's own; take lines out until it compiles"
    )


def meaning(error: str, file: str = "compiler_errors.txt") -> str:
    """A sentence; empty where the error isn't one of the commonest."""
    plain = error.translate(QUOTES)
    return next((sentence for piece, sentence in meanings(file) if piece in plain), "")


@functools.cache
def meanings(file: str) -> list[tuple[str, str]]:
    """Pairs of a piece of a message and the sentence that explains it. In the file, the pieces are
    indented below their sentence."""
    found, sentence = [], ""
    for line in (EXPLAINED / file).read_text(encoding="utf-8").splitlines():
        if line.startswith("  "):
            found.append((line[2:], sentence))
        else:
            sentence = line
    return found


# --- shapes of Eigen ---

Shape = tuple[int, int]


def _misfit(note: str) -> str:
    """What is refused of two shapes that don't fit; empty if the note doesn't tell."""
    quoted = re.search(r"'Eigen::(.*)'", note[:LONGEST])
    if not quoted:
        return ""
    _, left, rest = _type(quoted.group(1))
    call = re.match(r"::(operator(?:[*+=-]|[+-]=)|\w+)<", rest)
    if not call or call.group(1) not in REFUSED:
        return ""
    _, right, _ = _type(rest[call.end() :])
    if not left or not right or 0 in (*left, *right):
        return ""
    if left[1] == right[0] if call.group(1) == PRODUCT else left == right:
        return ""
    words = {"left": f"{left[0]}x{left[1]}", "right": f"{right[0]}x{right[1]}"}
    return REFUSED[call.group(1)].format(**words)


def _type(text: str, depth: int = 0) -> tuple[str, Shape | None, str]:
    """The type at the begin of a text: its name without namespaces and const, or a number; its rows
    and columns, 0 where it doesn't say them; and the text that follows it."""
    begin = re.match(r"\s*(?:const )?(?:\w+::)*(-?\w*)(?: const)?", text)
    name, rest = (begin.group(1), text[begin.end() :]) if begin else ("", text)
    names: list[str] = []
    shapes: list[Shape] = []
    if rest.startswith("<") and depth < DEEPEST:
        while rest[:1] in ("<", ","):
            argument, shape, rest = _type(rest[1:], depth + 1)
            names.append(argument)
            shapes += [shape] if shape else []
        rest = rest[1:]  # the closing bracket
    if name in ("Matrix", "Array", "Block"):
        sizes = [int(size) if re.fullmatch(r"\d{1,6}", size) else 0 for size in names[1:3]]
        shapes = [(sizes[0], sizes[1])] if len(sizes) == 2 else []
    if not shapes:
        return name, None, rest
    rows, columns = shapes[0]
    if name == "Product" and len(shapes) == 2:
        columns = shapes[1][1]
    of_name = {"Transpose": (columns, rows), "DiagonalWrapper": (rows, rows)}
    return name, of_name.get(name, (rows, columns)), rest


# --- the linker ---


def of_linker(printed: str) -> Built:
    """The missing or duplicate symbol. It is looked for at line starts only, so that a submission's
    long lines don't make it slow."""
    error = r"(?m)^ld\.lld: error: "
    referenced = r"(?:\n>>> referenced by (.+?):(\d{1,9}))?"
    missing = re.search(rf"{error}undefined symbol: (.*){referenced}", printed)
    if missing and missing.group(2):
        place = Place(missing.group(2), int(missing.group(3)))
        words = f"{place} uses {missing.group(1)}, which no file that compiles defines"
        return Built(None, words, place)
    if missing:
        return Built(None, f"{missing.group(1)} is used, but no file that compiles defines it")
    twice = re.search(rf"{error}duplicate symbol: (.*)", printed)
    if twice:
        return Built(None, f"{twice.group(1)} is defined in two files")
    return Built(None, 
        "the parts can't be linked with each other: look for lines of assembler in them"
    )
