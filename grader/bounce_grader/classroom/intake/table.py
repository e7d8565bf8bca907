"""Reads CSV files, from services and from hand; and edits single cells of them, so that every other
byte stays."""

import io
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from bounce_grader.common.errors import UsageError

BOM = "\ufeff"
UTF_16 = {b"\xff\xfe": "utf-16-le", b"\xfe\xff": "utf-16-be"}  # often Blackboard's


@dataclass
class Row:
    """A row: its cells as the file has them, quotes and all, and what ends it."""

    cells: list[str]
    end: str  # "\\n", "\\r\\n", or nothing at the end of the file
    line: int

    def text(self, column: int) -> str:
        """What a cell says; "" if there is no such cell."""
        raw = self.cells[column] if column < len(self.cells) else ""
        return (raw[1:-1].replace('""', '"') if raw.startswith('"') else raw).strip()

    def texts(self) -> list[str]:
        return [self.text(column) for column in range(len(self.cells))]

    def put(self, column: int, text: str, delimiter: str) -> None:
        """Replaces a cell's text, quoted if it was before or if it has to be."""
        quoted = self.cells[column].startswith('"') or delimiter in text
        self.cells[column] = f'"{text}"' if quoted else text


class Table:
    """A CSV file whose cells can be filled in, and whose other bytes stay the same."""

    def __init__(self, path: Path) -> None:
        """Reads a file, with a first row at least. Raises UsageError if it isn't one."""
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
            self._encoding = "latin-1"  # which every byte fits
            text = data.decode(self._encoding)
        if "\0" in text:
            raise UsageError(f"{self.name} isn't UTF-8: download it again, or save it as CSV UTF-8")
        self._start = BOM * text.startswith(BOM)
        body = text[len(self._start) :]
        self.delimiter = max(",;\t", key=body.partition("\n")[0].count)
        self.rows = list(self._rows(body, self.delimiter))
        if not self.rows:
            raise UsageError(f"{self.name} is empty: export or write it again")
        self.header = self.rows[0].texts()

    def require_all_cells(self, rows: Iterable[Row], what_helps: str) -> None:
        """Raises UsageError if one of these rows hasn't as many cells as the first."""
        for row in rows:
            if len(row.cells) != len(self.header):
                raise UsageError(
                    f"{self.name} has {len(row.cells)} cells in line {row.line}, and "
                    f"{len(self.header)} in its first: {what_helps}"
                )

    def encoded(self) -> bytes:
        lines = (self.delimiter.join(row.cells) + row.end for row in self.rows)
        return f"{self._start}{''.join(lines)}".encode(self._encoding)

    def _rows(self, body: str, delimiter: str) -> Iterator[Row]:
        """Joins the lines of each record, whose cells may hold line ends within quotes."""
        cell = rf'(?:\A|{delimiter})((?:"[^"]*(?:"|\Z)|[^"{delimiter}])*)'
        record, first = "", 1
        for number, line in enumerate(io.StringIO(body, newline=""), 1):
            if not record:
                first = number
            record += line
            if record.count('"') % 2 == 0:
                text = record.rstrip("\r\n")
                yield Row(re.findall(cell, text), record[len(text) :], first)
                record = ""
        if record:
            raise UsageError(
                f"{self.name} has a quotation mark in line {first} that nothing closes"
            )
