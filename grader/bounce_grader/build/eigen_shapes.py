"""Says which shapes don't fit, from the types of Eigen in a compiler's note, such as

'Eigen::MatrixBase<Eigen::Matrix<double, 3, 2, 0>>::operator*<Eigen::Matrix<double, 3, 1, 0>>'
"""

import re
from typing import NamedTuple

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

Shape = tuple[int, int]


class Type(NamedTuple):
    """A C++ type with its template arguments, as a compiler's note writes it."""

    name: str  # without namespaces and const
    arguments: tuple["Type", ...] = ()


def misfit(note: str) -> str:
    """What is refused of two shapes that don't fit; empty if the note doesn't tell."""
    quoted = re.search(r"'Eigen::(.*)'", note[:LONGEST])
    if not quoted:
        return ""
    first, rest = _type(quoted.group(1), 0)
    call = re.match(r"::(operator(?:[*+=-]|[+-]=)|\w+)(?=<)", rest)
    if not call or call.group(1) not in REFUSED:
        return ""
    arguments = _type("_" + rest[call.end() :], 0)[0].arguments
    left, right = _shape(first), _shape(arguments[0]) if arguments else None
    if not left or not right or 0 in (*left, *right) or _fit(call.group(1), left, right):
        return ""
    words = {"left": f"{left[0]}x{left[1]}", "right": f"{right[0]}x{right[1]}"}
    return REFUSED[call.group(1)].format(**words)


def _fit(operation: str, left: Shape, right: Shape) -> bool:
    return left[1] == right[0] if operation == PRODUCT else left == right


def _type(text: str, depth: int) -> tuple[Type, str]:
    """The type at the begin of a text, and what follows it."""
    begin = re.match(r"\s*(?:const )?(?:\w+::)*(-?\w*)(?: const)?", text)
    name, rest = (begin.group(1), text[begin.end() :]) if begin else ("", text)
    arguments: list[Type] = []
    if rest.startswith("<") and depth < DEEPEST:
        while rest[:1] in ("<", ","):
            argument, rest = _type(rest[1:], depth + 1)
            arguments.append(argument)
        rest = rest[1:]  # the closing bracket
    return Type(name, tuple(arguments)), rest


def _shape(of: Type) -> Shape | None:
    """Rows and columns, as far as the type says them."""
    inner = [shape for shape in map(_shape, of.arguments) if shape]
    if of.name in ("Matrix", "Array", "Block"):
        sizes = [argument.name for argument in of.arguments[1:3]]
        return (_size(sizes[0]), _size(sizes[1])) if len(sizes) == 2 else None
    if of.name == "Transpose" and inner:
        return inner[0][1], inner[0][0]
    if of.name == "Product" and len(inner) == 2:
        return inner[0][0], inner[1][1]
    if of.name == "DiagonalWrapper" and inner:
        return inner[0][0], inner[0][0]
    return inner[0] if inner else None


def _size(word: str) -> int:
    return int(word) if re.fullmatch(r"\d{1,6}", word) else 0
