"""Puts an instructor's comments beside the lines of code that they are about. Of each line, its text is
noted in the column `code` of comments.csv: so a comment follows its line through whatever is handed
in later."""

from collections.abc import Sequence
from pathlib import Path

from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.intake import uploads
from bounce_grader.classroom.intake.instructor_files import COMMENTS
from bounce_grader.classroom.intake.student import Comment
from bounce_grader.classroom.intake.table import in_csv, Table
from bounce_grader.classroom.output.people import People
from bounce_grader.common.errors import UsageError
from bounce_grader.common.files import write_whole
from bounce_grader.common.manifest import parts

AROUND = 2  # lines that are shown before and after
LONGEST = 200  # letters of a line that are noted


def place(out: Path, people: People, summaries: Sequence[Summary]) -> list[str]:
    """Gives each submission its comments. Returns a sentence for each that can't be shown."""
    of = {summary.student.id: summary for summary in summaries if summary.score is not None}
    sentences, noted = [], {}
    for row in people.comments:
        meant = {student.id for _, student in people.meant_by(row.student)} & of.keys()
        found = _found(row, of[min(meant)]) if meant else f"nothing of {row.student!r} is graded"
        if isinstance(found, str):
            sentences.append(f"{COMMENTS}, line {row.row}: {found}, so it isn't shown")
            continue
        of[min(meant)].comments.append(found)
        if not row.code:
            noted[row.row] = found.code
    if noted:
        _note(out / COMMENTS, noted)
    return sentences


def _found(row: Comment, summary: Summary) -> Comment | str:
    """The comment with its line and the code around it, as they are now; or why there is none."""
    who = summary.student.who
    try:
        taken = uploads.read(summary.student)
    except UsageError as error:
        return f"{who} can't be read now ({error})"
    named = {part.file: taken.parts.get(part.number, "") for part in parts()}
    file = named.get(row.file) or row.file
    every = [name for name in taken.files if name == file or name.endswith(f"/{file}")]
    if len(every) != 1:
        return f"{who} has {f'{len(every)} files' if every else 'no file'} {row.file}"
    lines = taken.files[every[0]].decode(errors="replace").rstrip().split("\n")
    texts = [in_csv(line.strip()[:LONGEST].strip()) for line in lines]
    if not row.code and not "".join(texts[row.line - 1 : row.line]):
        what = "is empty" if row.line <= len(lines) else "is beyond its end"
        return f"line {row.line} of {row.file} by {who} {what}"
    code = row.code or texts[row.line - 1]
    there = [number for number, text in enumerate(texts, 1) if text == code]
    if not there:
        return f"{row.file} by {who} no longer has the line {code!r}"
    line = min(there, key=lambda number: abs(number - row.line))
    first = max(1, line - AROUND)
    shown = tuple(enumerate((text.rstrip() for text in lines[first - 1 : line + AROUND]), first))
    return row._replace(line=line, code=code, shown=shown)


def _note(path: Path, noted: dict[int, str]) -> None:
    """Fills the column `code`, by the lines of the file."""
    table = Table(path)
    header = [title.lower() for title in table.header]
    if "code" not in header:
        for row in table.rows:
            row.cells.append("" if row is not table.rows[0] else "code")
        header.append("code")
    for row in table.rows:
        if row.line in noted:
            row.cells[header.index("code")] = noted[row.line]
    write_whole(path, table.encoded(), durable=True)
