"""Checks the recognition of mistakes on the gallery: each mistake must be recognised as itself, or
as its twin with the same answers, and no right part as a mistake."""

import json
import os
import tempfile
from collections import Counter
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from bounce_grader.common.errors import KitError
from bounce_grader.common.manifest import parts, Part
from bounce_grader.common.paths import BUILD, FIXTURES, ROOT
from bounce_grader.grading import known_mistakes
from bounce_grader.grading.known_mistakes import Answers
from bounce_grader.sandbox import processes
from bounce_grader.submission import submission

ACCEPTED = ROOT / "tests" / "submissions" / "accepted"
TABLE = BUILD / "confusion.txt"


@dataclass(frozen=True)
class Row:
    """A mistake, or a right part, and what it was recognised as."""

    kind: str  # "mistake" or "right"
    name: str
    part: int
    expected: tuple[str, ...]
    named: tuple[str, ...]
    patterns: tuple[str, ...]

    @property
    def words(self) -> str:
        """What it was recognised as."""
        if self.named == self.expected:
            twin = self.kind == "mistake" and self.named != (self.name,)
            return (
                "itself" if self.kind == "mistake" and not twin else "its twin" if twin else "right"
            )
        return " + ".join(self.named) or "NOT RECOGNISED"


def run() -> int:
    """Prints a summary, and writes the whole table to a file. Returns 1 if a name is wrong or
    missing."""
    rows = table()
    TABLE.write_text("".join(f"{row.name:<48} part {row.part}  {row.words}\n" for row in rows))
    counts = Counter(row.words for row in rows)
    wrong = [row for row in rows if row.named != row.expected]
    known = sum(row.kind == "mistake" for row in rows)
    print(
        f"   {known} mistakes: {counts['itself']} recognised as themselves, {counts['its twin']} as "
        f"their twin; {len(rows) - known} right parts: {counts['right']} given no mistake "
        f"({TABLE.relative_to(ROOT)})"
    )
    for row in wrong:
        print(f"   {row.name} is taken for {row.words}")
    return int(bool(wrong))


def table() -> list[Row]:
    asked = [*_mistakes(), *_right_parts()]
    with tempfile.TemporaryDirectory() as name, ThreadPoolExecutor(os.cpu_count()) as pool:
        works = [Path(name) / str(i) for i in range(len(asked))]
        answers = pool.map(
            lambda job, work: known_mistakes.answers_of(job[1], job[2], work), asked, works
        )
        judged = recognised((job[2], got) for job, got in zip(asked, answers))
    return [
        Row(kind, folder.name, part.number, expected, *what)
        for (kind, folder, part, expected), what in zip(asked, judged)
    ]


def _mistakes() -> list[tuple[str, Path, Part, tuple[str, ...]]]:
    return [
        ("mistake", known_mistakes.GALLERY / m.name, m.part, (m.recognised_as,))
        for m in known_mistakes.gallery()
    ]


def _right_parts() -> list[tuple[str, Path, Part, tuple[str, ...]]]:
    folders = [folder for folder in sorted(ACCEPTED.iterdir()) if folder.is_dir()]
    taken = [(folder, submission.read(folder).parts) for folder in folders]
    return [
        ("right", folder, parts()[number - 1], ())
        for folder, numbers in taken
        for number in sorted(numbers)
    ]


def recognised(
    asked: Iterable[tuple[Part, Answers]],
) -> list[tuple[tuple[str, ...], tuple[str, ...]]]:
    """The mistakes and patterns that are recognised in each list of answers."""
    lines = [json.dumps({"part": part.number, "answers": answers}) for part, answers in asked]
    command = [str(BUILD / "recogniser"), str(FIXTURES / "public")]
    result = processes.run(command, known_mistakes.LIMITS, stdin="\n".join(lines).encode())
    if not result.ok:
        raise KitError(f"nothing could be recognised: {result.err.strip()}")
    judged = [json.loads(line) for line in result.out.splitlines()]
    return [(tuple(t["mistakes"]), tuple(t["patterns"])) for t in judged]
