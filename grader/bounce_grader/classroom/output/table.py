"""Edits single cells of a CSV file from a service, and keeps every other byte."""

import io
import re
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
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
            raise UsageError(f"{self.name} is a zip or a workbook: give the grade book as CSV")
        self._encoding, text = self._decoded(data)
        if "\0" in text:
            raise UsageError(f"{self.name} isn't UTF-8: download it again, or save it as CSV UTF-8")
        self._start = BOM * text.startswith(BOM)
        body = text[len(self._start) :]
        self.delimiter = self._find_delimiter(body)
        self.rows = list(self._rows(body, self.delimiter))
        if not self.rows:
            raise UsageError(f"{self.name} is empty: export the grade book again")
        self.header = [self.rows[0].text(i) for i in range(len(self.rows[0].cells))]

    def encoded(self) -> bytes:
        lines = (self.delimiter.join(row.cells) + row.end for row in self.rows)
        return f"{self._start}{''.join(lines)}".encode(self._encoding)

    def _decoded(self, data: bytes) -> tuple[str, str]:
        """The encoding and the text. What is in neither UTF-8 nor UTF-16 is taken for Latin-1, which
        every byte fits."""
        encoding = UTF_16.get(data[:2], "utf-8")
        try:
            return encoding, data.decode(encoding)
        except UnicodeError as error:
            if encoding != "utf-8":
                raise UsageError(f"{self.name} is damaged: download it again") from error
            return "latin-1", data.decode("latin-1")

    def _find_delimiter(self, body: str) -> str:
        """As Canvas finds it: whichever gives the first three rows the same, larger number of cells;
        a comma if none does. Blackboard has tabs, too."""
        counts = {}
        for delimiter in (",", ";", "\t"):
            numbers = {len(row.cells) for row in islice(self._rows(body, delimiter), 3)}
            counts[delimiter] = max(numbers) if len(numbers) == 1 and max(numbers) > 1 else 0
        return max(counts, key=lambda delimiter: counts[delimiter])

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
