"""Fills one column of the grade file of Moodle (its offline grading worksheet) or of Blackboard.

Both are tables with a row for each student. Moodle's importer (mod/assign/feedback/offline) finds
its columns by their titles, in the site's language, and a student by the number at the end of the
first cell. Blackboard's file is often UTF-16 with tabs.
"""

import re
from collections.abc import Iterable, Mapping
from pathlib import Path

from bounce_grader.classroom.intake import moodle
from bounce_grader.classroom.output import filling, table as tables
from bounce_grader.classroom.output.filling import Filled, Marks, number_in, Written
from bounce_grader.classroom.output.table import Row
from bounce_grader.common.errors import UsageError
from bounce_grader.common.numbers import short

UTF_16 = {b"\xff\xfe": "utf-16-le", b"\xfe\xff": "utf-16-be"}
PARTICIPANT = re.compile(r'"?[^\W\d][^",;]*?\s?\d+"?[,;]')  # Moodle's first cell: Participant 12345
TOTAL_PTS = "[Total Pts"
TOTAL = re.compile(r"\[Total Pts: ([\d.,]+)[^\]]*\]\s*\|\s*\d+\s*$")  # of a Blackboard column


class Worksheet:
    """Raises UsageError if it can't be filled in."""

    def __init__(self, path: Path, title: str, max_points: float) -> None:
        self._name = path.name
        data = filling.read(path)
        self._encoding = UTF_16.get(data[:2], "")
        self._mark = data[:2] if self._encoding else b""
        try:
            plain = data[2:].decode(self._encoding).encode() if self._encoding else data
        except UnicodeError as error:
            raise UsageError(f"{path.name} is damaged: download it again") from error
        self._table = tables.parse(plain, path.name)
        self._header = [cell.text.strip() for cell in self._table.rows[0].cells]
        blackboard = "Username" in self._header and any(map(TOTAL.search, self._header))
        self.service = "blackboard" if blackboard else "moodle"
        self._rows = self._table.rows[1:]
        again = "download it again"
        filling.require_whole(self._rows, len(self._header), self._name, again)
        self._column = self._find_column(title)
        self._max_points = max_points

    def people(self, canvas_ids_only: bool = False) -> dict[str, str]:
        """The names of all students, by their ids."""
        rows = self._by_id()
        return {id: self._person(of_id[0]) for id, of_id in rows.items() if len(of_id) == 1}

    def same_person(self) -> dict[str, str]:
        return {id: id for id in self.people()}

    def days_late(self) -> dict[str, int | None]:
        """How many days each student is late, by id; None if the words aren't known. Empty if the
        file doesn't tell."""
        column = next((i for i, title in enumerate(self._header) if title in moodle.STATUS), None)
        if self.service != "moodle" or column is None:
            return {}
        rows = self._by_id()
        return {id: moodle.days_late(of_id[0].cells[column].text) for id, of_id in rows.items()}

    def require_some_of(self, ids: Iterable[str], canvas_ids_only: bool = False) -> None:
        """Raises UsageError if no student with one of these ids is in the file."""
        wanted = list(ids)
        if wanted and not self._by_id().keys() & set(wanted):
            raise UsageError(
                f"none of the {len(wanted)} students who handed in is in {self._name}: is it the "
                "file of another assignment or course?"
            )

    def fill(
        self,
        marks: Mapping[str, Marks],
        without: Mapping[str, str] = {},
        written: Written = {},
        overwrite: bool = False,
    ) -> Filled:
        """Fills in the points, by the rules of Gradebook.fill."""
        title = self._header[self._column]
        now = {title: {id: list(points) for id, points in written.get(title, {}).items()}}
        comma = self._has_decimal_comma()
        emptied = 0  # cells without the points that an earlier run has filled in
        sentences = self._points_possible()
        by_id = self._by_id()
        for id, rows in by_id.items():
            who = f"{self._person(rows[0])} ({id})"
            if id not in marks:
                sentences.append(filling.not_filled(who, without.get(id)))
            elif len(rows) > 1:
                sentences.append(f"{self._name} has {len(rows)} rows for {id}: none is filled")
            else:
                points = f"{marks[id].points[0]:.2f}"
                before = now[title].get(id, [])
                problem = self._problem(rows[0], points, before, overwrite)
                if problem:
                    sentences.append(f"{who} {problem}")
                    continue
                emptied += bool(before and not self._has_points(rows[0]))
                now[title][id] = [*before, *([points] if points not in before else [])]
                filling.put(self._table, rows[0], self._column, points, comma)
        sentences += filling.not_listed(marks, by_id, self._name)
        sentences = [*filling.perhaps_old(self._name, emptied), *sentences]
        others = {other: by for other, by in written.items() if other != title}
        return Filled(self._bytes(), sentences, {**others, **now})

    def _problem(self, row: Row, points: str, before: list[str], overwrite: bool) -> str:
        """Why the cell stays as it is; "" if it doesn't."""
        changeable = self._index("Grade can be changed")
        if changeable is not None and row.cells[changeable].text.strip().lower() == "no":
            return "has a grade that Moodle lets nobody change here: the cell stays as it was"
        text = row.cells[self._column].text.strip() if self._has_points(row) else ""
        return filling.why_kept(text, self._header[self._column], points, before, overwrite)

    def _has_points(self, row: Row) -> bool:
        text = row.cells[self._column].text.strip()
        return text not in ("", "-") and not text.startswith("Needs Grading")

    def _bytes(self) -> bytes:
        plain = self._table.bytes()
        return self._mark + plain.decode().encode(self._encoding) if self._encoding else plain

    def _by_id(self) -> dict[str, list[Row]]:
        rows: dict[str, list[Row]] = {}
        for row in self._rows:
            id = self._id(row)
            if id:
                rows.setdefault(id, []).append(row)
        return rows

    def _id(self, row: Row) -> str:
        if self.service == "blackboard":
            return row.cells[self._header.index("Username")].text.strip()
        number = re.search(r"\d+$", row.cells[0].text.strip())
        return number.group() if number else ""

    def _person(self, row: Row) -> str:
        """As "Doe, Jane" where the file tells first and last names apart."""
        names = [self._index(title) for title in ("Last Name", "First Name")]
        found = [row.cells[column].text.strip() for column in names if column is not None]
        full = self._index("Full name")
        if self.service == "moodle" and full is not None:
            return row.cells[full].text.strip()
        return ", ".join(filter(None, found)) or self._id(row)

    def _index(self, title: str) -> int | None:
        return self._header.index(title) if title in self._header else None

    def _find_column(self, title: str) -> int:
        if self.service == "moodle":
            titles = [title or "Grade"]
        else:
            own = [text for text in self._header if TOTAL.search(text)]
            titles = [text for text in own if title in (text, _short_title(text))]
            if not title and len(own) == 1:
                titles = own
        found = [i for i, text in enumerate(self._header) if text in titles and i > 0]
        if len(found) == 1:
            return found[0]
        known = [text for text in self._header if self.service == "moodle" or TOTAL.search(text)]
        raise UsageError(
            f"{self._name} has {len(found) or 'no'} column{'s' * (len(found) != 1)} "
            f"{title or 'that is meant'!r}: give --column one of {', '.join(map(repr, known))}"
        )

    def _has_decimal_comma(self) -> bool:
        maximum = self._index("Maximum Grade")
        columns = [self._column, *([maximum] if maximum is not None else [])]
        return filling.has_decimal_comma(self._rows, columns)

    def _points_possible(self) -> list[str]:
        title = self._header[self._column]
        total, maximum = TOTAL.search(title), self._index("Maximum Grade")
        if total:
            texts = {total.group(1)}
        else:
            texts = (
                {row.cells[maximum].text for row in self._rows} if maximum is not None else set()
            )
        others = sorted(
            {n for n in map(number_in, texts) if n is not None and n != self._max_points}
        )
        return [
            f"{self.service.capitalize()} has {short(points)} points possible for {title}, the kit "
            f"{short(self._max_points)}: change it there"
            for points in others
        ]


def is_worksheet(path: Path) -> bool:
    """Whether the file is Moodle's or Blackboard's, and not Canvas's."""
    data = filling.read(path)
    if data[:2] in UTF_16:
        return True
    lines = data.removeprefix(tables.BOM).decode("utf-8", "replace").splitlines()
    moodle = any(map(PARTICIPANT.match, lines[1:]))
    canvas = lines and re.match(r"\W*(Student|LastName)\b", lines[0])
    return bool(lines and TOTAL_PTS in lines[0] or moodle and not canvas)


def _short_title(text: str) -> str:
    return text.partition(f" {TOTAL_PTS}")[0].strip()
