"""Edits single cells of a CSV file from a service, and keeps every other byte."""

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path

from bounce_grader.common.errors import UsageError

BOM = b"\xef\xbb\xbf"
UTF_16 = {b"\xff\xfe": "utf-16-le", b"\xfe\xff": "utf-16-be"}  # often Blackboard's


@dataclass
class Cell:
    """A cell with its bytes, so that what isn't filled in stays as it was."""

    raw: bytes  # including quotes

    @property
    def quoted(self) -> bool:
        return self.raw.startswith(b'"')

    @property
    def text(self) -> str:
        raw = self.raw[1:-1].replace(b'""', b'"') if self.quoted else self.raw
        try:
            return raw.decode()
        except UnicodeDecodeError:
            return raw.decode("latin-1")

    def put(self, text: str, delimiter: bytes) -> None:
        """Replaces the text, quoted if it was before or if it has to be."""
        raw = text.encode()
        self.raw = b'"' + raw + b'"' if self.quoted or delimiter in raw else raw


@dataclass
class Row:
    """A row, with the bytes that end it."""

    cells: list[Cell]
    end: bytes  # "\\n", "\\r\\n", or nothing at the end of the file
    line: int


@dataclass
class Table:
    """A CSV file whose cells can be filled in, and whose other bytes stay the same."""

    start: bytes  # a byte order mark, or nothing
    delimiter: bytes
    encoding: str  # "" where cells are kept as the bytes that they are
    rows: list[Row] = field(default_factory=list)

    def header(self) -> list[str]:
        return [cell.text.strip() for cell in self.rows[0].cells]

    def bytes(self) -> bytes:
        lines = (self.delimiter.join(cell.raw for cell in row.cells) + row.end for row in self.rows)
        body = b"".join(lines)
        return self.start + (body.decode().encode(self.encoding) if self.encoding else body)


def read(path: Path) -> Table:
    """Reads a CSV file, with a first row at least. Raises UsageError if it isn't one."""
    name = path.name
    try:
        data = path.read_bytes()
    except OSError as error:
        raise UsageError(f"{path} can't be read: {error.strerror}") from error
    encoding = UTF_16.get(data[:2], "")
    start = data[:2] if encoding else BOM if data.startswith(BOM) else b""
    body = data[len(start) :]
    try:
        body = body.decode(encoding).encode() if encoding else body
    except UnicodeError as error:
        raise UsageError(f"{name} is damaged: download it again") from error
    if b"\0" in body:
        raise UsageError(f"{name} isn't UTF-8: download it again, or save it as CSV UTF-8")
    table = Table(start, _delimiter(body, name), encoding)
    table.rows = list(_rows(body, table.delimiter, name))
    if not table.rows:
        raise UsageError(f"{name} is empty: export the grade book again")
    return table


def _delimiter(body: bytes, name: str) -> bytes:
    """As Canvas finds it: whichever gives the first three rows the same, larger number of cells; a
    comma if none does. Blackboard has tabs, too."""
    counts = {}
    for delimiter in (b",", b";", b"\t"):
        numbers = {len(row.cells) for row in islice(_rows(body, delimiter, name), 3)}
        counts[delimiter] = numbers.pop() if len(numbers) == 1 and max(numbers) > 1 else 0
    return max(counts, key=lambda delimiter: counts[delimiter])


def _cells(line: bytes, delimiter: bytes) -> list[bytes]:
    """The cells of one record, which may hold line ends within quotes."""
    return re.findall(rb'(?:\A|%b)((?:"[^"]*(?:"|\Z)|[^"%b])*)' % (delimiter, delimiter), line)


def _rows(body: bytes, delimiter: bytes, name: str) -> Iterator[Row]:
    record, first = b"", 1
    for number, line in enumerate(body.splitlines(keepends=True), 1):
        if not record:
            first = number
        record += line
        if record.count(b'"') % 2 == 0:
            text = record.rstrip(b"\r\n")
            cells = [Cell(raw) for raw in _cells(text, delimiter)]
            yield Row(cells, record[len(text) :], first)
            record = b""
    if record:
        raise UsageError(f"{name} has a quotation mark in line {first} that nothing closes")
