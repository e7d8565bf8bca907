"""Reads CSV files, from services and from hand; and changes cells of them."""

import csv
import io
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import csv_row

BOM = "\ufeff"
UTF_16 = {b"\xff\xfe": "utf-16-le", b"\xfe\xff": "utf-16-be"}  # often Blackboard's


def number_in(text: str) -> float | None:
    """The number that a cell holds, with a point or a comma; None if it holds none."""
    try:
        return float(text.strip().replace(",", "."))
    except ValueError:
        return None


def in_csv(text: str) -> str:
    """A text as a cell holds it, which no spreadsheet takes for a formula."""
    return next(csv.reader([csv_row([text.replace("\n", " ")])]))[0]


class Row(NamedTuple):
    """A row, and the line in which it ends."""

    line: int
    cells: list[str]

    def text(self, column: int) -> str:
        """What a cell says; "" if there is no such cell."""
        return self.cells[column].strip() if column < len(self.cells) else ""

    def texts(self) -> list[str]:
        return [cell.strip() for cell in self.cells]


class Table:
    """A CSV file with at least one row. Writing it keeps its encoding, delimiter, line ends and
    cells, except those that were changed."""

    def __init__(self, path: Path) -> None:
        """Raises UsageError if it isn't such a file."""
        self.name = path.name
        try:
            data = path.read_bytes()
        except OSError as error:
            raise UsageError(f"{path} can't be read: {error.strerror}") from error
        if data.startswith(b"PK"):  # a zip, as an Excel workbook is
            raise UsageError(f"{self.name} is a zip or a workbook: save it as CSV")
        self._encoding = UTF_16.get(data[:2], "utf-8")
        try:
            text = data.decode(self._encoding)
        except UnicodeError:
            # Windows-1252, as long as it knows every byte, as Latin-1 does.
            undefined = set(data) & set(b"\x81\x8d\x8f\x90\x9d")
            self._encoding = "latin-1" if undefined else "cp1252"
            text = data.decode(self._encoding)
        self._start, body = BOM * text.startswith(BOM), text.removeprefix(BOM)
        self._style: dict[str, Any] = {
            "delimiter": max(",;\t", key=body.partition("\n")[0].count),
            "lineterminator": "\r\n" if "\r\n" in body else "\n",
            "quoting": csv.QUOTE_ALL if body.startswith('"') else csv.QUOTE_MINIMAL,
        }
        lines = io.StringIO(body, newline="")
        reader = csv.reader(lines, **self._style, strict=True)
        try:
            self.rows = [Row(reader.line_num, cells) for cells in reader]
        except csv.Error as error:
            where = f"{self.name} is no CSV, as its line {reader.line_num} shows ({error})"
            raise UsageError(f"{where}: download it again, or save it as CSV UTF-8") from error
        if not self.rows:
            raise UsageError(f"{self.name} is empty: export or write it again")
        self.header = self.rows[0].texts()

    def require_all_cells(self, rows: Iterable[Row], what_helps: str) -> None:
        """Raises UsageError if one of these rows hasn't as many cells as the first."""
        for row in rows:
            if len(row.cells) != len(self.header):
                cells = f"{len(row.cells)} cells in line {row.line}, and {len(self.header)}"
                raise UsageError(f"{self.name} has {cells} in its first: {what_helps}")

    def encoded(self) -> bytes:
        text = io.StringIO(newline="")
        csv.writer(text, **self._style).writerows(row.cells for row in self.rows)
        try:
            return f"{self._start}{text.getvalue()}".encode(self._encoding)
        except UnicodeEncodeError:  # what was added isn't in Latin-1
            return f"{BOM}{text.getvalue()}".encode()


def rows_of(
    path: Path, needed: Sequence[str], more: Sequence[str], moved: Mapping[str, str] = {}
) -> list[tuple[int, dict[str, str]]]:
    """The line and the cells, by column, of each row that isn't empty, in a file that an instructor
    writes; none without such a file. Columns may be in any order; `moved` says where to put what was
    in columns that are no more. Raises UsageError."""
    if not path.exists():
        return []
    table = Table(path)
    header = [title.lower() for title in table.header]
    if not set(needed) <= set(header) <= {*needed, *more} or len(set(header)) < len(header):
        others = f", and any of {', '.join(more)}" if more else ""
        takes = f"it takes {' and '.join(needed)}{others}, each once"
        hints = "".join(f"; {moved[title]}" for title in header if title in moved)
        raise UsageError(f"{path} has the columns {', '.join(header)}: {takes}{hints}")
    rows = [row for row in table.rows[1:] if any(row.texts())]
    table.require_all_cells(rows, "put texts with commas into quotation marks")
    empty = dict.fromkeys(more, "")
    return [(row.line, empty | dict(zip(header, row.texts()))) for row in rows]
