"""Reads the tables that bounce_study writes: CSV below comments that say where they are from."""

import csv
from dataclasses import dataclass
from pathlib import Path

from bounce_grader.common.errors import UsageError

Row = dict[str, str]


@dataclass(frozen=True)
class Table:
    name: str
    origin: dict[str, str]  # machine, compiler, flags, times, date
    rows: list[Row]

    def where(self, **values: str) -> list[Row]:
        return [row for row in self.rows if all(row[k] == v for k, v in values.items())]

    def distinct(self, column: str) -> list[str]:
        """Lists the values of a column in the order of their first rows."""
        return list(dict.fromkeys(row[column] for row in self.rows))

    def require(self, columns: tuple[str, ...]) -> None:
        for column in columns:
            if not self.rows or column not in self.rows[0]:
                raise UsageError(f"{self.name}.csv has no column {column}; measure it again")


Tables = dict[str, Table]


def read(file: Path) -> Table:
    """Reads a table; raises UsageError, naming the file, where it isn't one."""
    try:
        lines = file.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise UsageError(f"{file} can't be read: {error}") from error
    comments = [line[2:].partition(": ") for line in lines if line.startswith("# ")]
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    if any(None in row or None in row.values() for row in rows):
        raise UsageError(f"{file}: a row has another number of fields; measure it again")
    return Table(file.stem, {name: value for name, _, value in comments}, rows)


def number(row: Row, column: str) -> float:
    try:
        return float(row[column])
    except ValueError as error:
        raise UsageError(f"column {column}: {row[column]!r} is no number") from error


def numbers(rows: list[Row], column: str) -> list[float]:
    return [number(row, column) for row in rows]
