"""Reads CSV files, from services and from hand; and changes cells of them."""

import csv
import io
from collections.abc import Iterable
from pathlib import Path
from typing import Any, NamedTuple

from bounce_grader.common.errors import UsageError

BOM = "\ufeff"
UTF_16 = {b"\xff\xfe": "utf-16-le", b"\xfe\xff": "utf-16-be"}  # often Blackboard's


def number_in(text: str) -> float | None:
    """The number that a cell holds, with a point or a comma; None if it holds none."""
    try:
        return float(text.strip().replace(",", "."))
    except ValueError:
        return None


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
        return f"{self._start}{text.getvalue()}".encode(self._encoding)
