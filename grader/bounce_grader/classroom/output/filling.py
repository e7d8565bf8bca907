"""The rules for filling points into any service's column: what a person has entered there stays."""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from bounce_grader.classroom.output.table import Row, Table
from bounce_grader.common.errors import UsageError


@dataclass(frozen=True)
class Marks:
    """A student's points."""

    name: str
    points: Mapping[int, float]  # key 0 is the total, key n is part n
    from_canvas: bool = False  # the id and the name are those of a Canvas download


# A column's title -> the service's id -> all points that runs have filled in there.
Written = Mapping[str, Mapping[str, list[str]]]


@dataclass
class Filled:
    """A filled-in grade book, as bytes of its file."""

    data: bytes
    sentences: list[str]  # what the instructor should know
    written: Written = field(default_factory=dict)


def read(path: Path) -> bytes:
    """Raises UsageError if the file can't be read."""
    try:
        return path.read_bytes()
    except OSError as error:
        raise UsageError(f"{path} can't be read: {error.strerror}") from error


def number_in(text: str) -> float | None:
    try:
        return float(text.strip().replace(",", "."))
    except ValueError:
        return None


def is_ours(there: float | None, points: float, before: Iterable[float | None]) -> bool:
    """Whether these points come from this grading or from an earlier run."""
    return there is not None and there in (points, *before)


def kept(there: str, points: str, title: str = "") -> str:
    """What is said of points that a person has entered, and that stay."""
    place = f" in {title}" if title else ""
    return f"keeps {there}{place}, where the grading gives {points}; --overwrite replaces it"


def why_kept(text: str, title: str, points: str, before: list[str], overwrite: bool) -> str:
    """Why a cell with this text isn't filled in; "" if it is."""
    if not text or overwrite:
        return ""
    ours = is_ours(number_in(text), float(points), map(number_in, before))
    return "" if ours else kept(text, points, title)


def put(table: Table, row: Row, column: int, points: str, comma: bool) -> None:
    text = points.replace(".", ",") if comma else points
    row.cells[column].put(text, table.delimiter)


def has_decimal_comma(rows: Iterable[Row], columns: Iterable[int]) -> bool:
    """Whether points are written as 87,5, and none as 87.5."""
    columns = list(columns)
    texts = [row.cells[column].text.strip() for row in rows for column in columns]
    with_points = any(re.fullmatch(r"\d+\.\d+", text) for text in texts)
    return not with_points and any(re.fullmatch(r"\d+,\d+", text) for text in texts)


def require_whole(rows: Iterable[Row], cells: int, name: str, remedy: str) -> None:
    """Raises UsageError if a row has more or fewer cells than the header."""
    for row in rows:
        if len(row.cells) != cells:
            raise UsageError(
                f"{name} has {len(row.cells)} cells in line {row.line}, and {cells} in its "
                f"first: {remedy}"
            )


def perhaps_old(name: str, emptied: int) -> list[str]:
    """What to say if cells lack the points that an earlier run has filled in: points that were
    corrected since then can't be seen, and would be replaced."""
    if not emptied:
        return []
    cells = f"{emptied} cell{'s' if emptied > 1 else ''}"
    return [
        f"{name} lacks what an earlier run has filled into {cells}: if that is imported, export "
        "the grades again, or corrections made there since then are lost"
    ]


def not_filled(who: str, why: str | None) -> str:
    """What is said of a student without points; `why` is None if nothing was submitted."""
    nothing = "no submission" if why is None else f"no score, because {why}"
    return f"{who} has {nothing}: the cell stays as it was"


def not_listed(marks: Mapping[str, Marks], listed: Iterable[str], name: str) -> list[str]:
    """A sentence for each student with points whom the file doesn't list."""
    return [
        f"{marks[id].name} ({id}) is graded, but isn't in {name}"
        for id in sorted(marks.keys() - set(listed))
    ]
