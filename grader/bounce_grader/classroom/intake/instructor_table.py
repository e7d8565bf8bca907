"""Reads the CSV files that an instructor writes by hand or in a spreadsheet program."""

import csv
import io
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

from bounce_grader.common.errors import UsageError


class TableRow(NamedTuple):
    """One row, with the line in which it ends."""

    line: int
    cells: dict[str, str]  # by column, stripped; "" where nothing is


def read(path: Path, needed: Iterable[str], more: Iterable[str] = ()) -> list[TableRow]:
    """The rows that aren't empty; none if there is no such file. Columns may be in any order, and
    separated by commas or semicolons. Raises UsageError."""
    if not path.exists():
        return []
    try:
        text = path.read_text("utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        raise UsageError(f"{path} can't be read ({error}): save it as CSV in UTF-8") from error
    first = text.partition("\n")[0]
    delimiter = ";" if first.count(";") > first.count(",") else ","
    try:
        reader = csv.reader(io.StringIO(text, newline=""), delimiter=delimiter, strict=True)
        rows = [(reader.line_num, row) for row in reader]
    except csv.Error as error:
        raise UsageError(f"{path} is no CSV ({error}): save it again as CSV in UTF-8") from error
    return _named(path, rows, list(needed), list(more))


def _named(
    path: Path, rows: list[tuple[int, list[str]]], needed: list[str], more: list[str]
) -> list[TableRow]:
    header = [cell.strip().lower() for cell in rows[0][1]] if rows else []
    missing = [column for column in needed if column not in header]
    if missing:
        raise UsageError(
            f"{path} has no column {missing[0]!r}: its first line names the columns, "
            f"{', '.join([*needed, *more])}"
        )
    unknown = [column for column in header if column not in (*needed, *more)]
    if unknown or len(set(header)) < len(header):
        odd = unknown[0] if unknown else "one twice"
        raise UsageError(f"{path} has the column {odd!r}: it takes {', '.join([*needed, *more])}")
    found = []
    for line, row in rows[1:]:
        cells = [cell.strip() for cell in row]
        if not any(cells):
            continue
        if len(cells) != len(header):
            raise UsageError(
                f"{path} has {len(cells)} cells in line {line}, and {len(header)} in its first: "
                "put texts with commas into quotation marks"
            )
        found.append(TableRow(line, dict.fromkeys(more, "") | dict(zip(header, cells))))
    return found
