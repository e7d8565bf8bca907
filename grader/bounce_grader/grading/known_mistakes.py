"""The known mistakes: their descriptions in the gallery, and their answers to the public cases.

A folder of tests/submissions/mistakes/ holds a wrong file, expected.json and mistake.md:

    # Title

    One sentence for the student.

    - Equations: 4, 5
    - Hint: 1.2 The moment arm r
    - For the instructor: one line

This module builds the wrong files, and writes the descriptions and the files' answers to
fixtures/public/mistakes/*.json, by which the judge and a student's own build recognise mistakes.
The line for the instructor is left out there.
"""

import json
import os
import re
import tempfile
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from bounce_grader.build import linking
from bounce_grader.build.compile import compile_all
from bounce_grader.common.errors import KitError
from bounce_grader.common.files import write_whole
from bounce_grader.common.manifest import part_of, parts, Part
from bounce_grader.common.parallel_map import parallel_map
from bounce_grader.common.paths import JUDGE, REFERENCE_RUNNER, ROOT
from bounce_grader.grading.gallery import expected
from bounce_grader.grading.record import MISTAKE_FIELDS
from bounce_grader.sandbox import processes
from bounce_grader.sandbox.box import LARGEST_FILE, Box
from bounce_grader.submission import submission

GALLERY = ROOT / "tests" / "submissions" / "mistakes"
TRUSTED = Box("none")  # the gallery is the kit's own
LIMITS = processes.Limits(20, 120, memory=4 << 30, file_size=LARGEST_FILE, output=64 << 20)
DIGITS = 12  # significant ones
LAYOUT = re.compile(
    r"# (?P<title>.+)\n\n(?P<sentence>.+)\n\n- Equations: (?P<equations>\d+(?:, \d+)*)\n"
    r"- Hint: (?P<hint>.+)\n- For the instructor: (?P<instructor>.+)\n"
)

Answers = list[Any]  # for each question: a list of numbers, or the text of an exception


class Mistake(NamedTuple):
    """A known mistake, as its folder in the gallery describes it."""

    name: str
    title: str
    sentence: str
    equations: tuple[int, ...]
    hint: str
    instructor: str
    lost: tuple[str, ...]  # ids of checks
    recognised_as: str  # itself, or the mistake with the same answers

    @property
    def part(self) -> Part:
        return part_of(self.name)


def gallery() -> list[Mistake]:
    """All mistakes of the gallery. Raises KitError that says what is wrong, and where."""
    return [read(folder) for folder in sorted(GALLERY.iterdir()) if folder.is_dir()]


def read(folder: Path) -> Mistake:
    written, file = expected(folder), f"{folder.name}/mistake.md"
    match = LAYOUT.fullmatch((folder / "mistake.md").read_text("utf-8"))
    if not match:
        raise KitError(f"{file} isn't laid out as tests/submissions/README.md says")
    numbers = tuple(int(number) for number in match["equations"].split(", "))
    found: dict[str, Any] = match.groupdict() | {"name": folder.name, "equations": numbers}
    twin = written.get("recognised_as", folder.name)
    return Mistake(**found, lost=tuple(written["lost"]), recognised_as=twin)


# --- answers ---


def answers(part: Part, runner: Path, cases: Path) -> Answers:
    """A runner's answers to the cases of a part in a folder, and to the diagnostic questions that
    are made of them, with given earlier parts. Empty if it ends before it has answered them all.
    Raises KitError if the judge fails."""
    given = bool(part.calls)
    asked = {"answers": True, "part": part.number, "given": given, "fixtures": [str(cases)]}
    # There it may make files: it has no box.
    command = [str(JUDGE), json.dumps(asked), str(runner)]
    result = processes.run(command, LIMITS, cwd=runner.parent)
    if not result.ok:
        raise KitError(f"the judge could not ask part {part.number}: {result.err.strip()}")
    return list(json.loads(result.out))


def _all_answers(mistakes: list[Mistake], cases: Path) -> dict[str, Answers]:
    """The answers of each mistake's file alone, built for this."""
    with tempfile.TemporaryDirectory() as name:

        def asked(m: Mistake) -> Answers:
            work = Path(name) / m.name
            work.mkdir()
            objects = compile_all(submission.read(GALLERY / m.name), work, TRUSTED, 1)
            linked = linking.link_alone(m.part, objects, work / "runner", TRUSTED)
            if not linked.path:
                raise KitError(f"{m.name} can't be built: {linked.problem}")
            got = answers(m.part, linked.path, cases)
            if not got:
                raise KitError(
                    f"{m.name} ends before it has answered; such ones belong into broken/"
                )
            return got

        got = parallel_map(asked, mistakes, os.cpu_count() or 1)
    return {m.name: answers for m, answers in zip(mistakes, got)}


# --- the files ---


def write(public: Path) -> None:
    """Writes the folder mistakes beside the cases in a folder. Of mistakes with the same answers all
    but one have to name that one in "recognised_as": the judge would name none of them."""
    mistakes = gallery()
    got = _all_answers(mistakes, public)
    for part in parts():
        right = _rounded(answers(part, REFERENCE_RUNNER, public))
        write_whole(public / "mistakes" / f"{part.stem}.json", _file(part, right, mistakes, got))


def are_equal_up_to_rounding(a: Any, b: Any) -> bool:
    """Whether two JSON values are equal, up to the rounding of numbers."""
    if isinstance(a, dict) and isinstance(b, dict):
        return list(a) == list(b) and all(are_equal_up_to_rounding(a[key], b[key]) for key in a)
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(map(are_equal_up_to_rounding, a, b))
    if isinstance(a, float | int) and isinstance(b, float | int):
        return abs(a - b) <= 1e-10 * max(1.0, abs(a), abs(b))
    return bool(a == b)


def _file(part: Part, right: Answers, mistakes: list[Mistake], got: Mapping[str, Answers]) -> str:
    """The JSON text for a part, with one mistake on each line."""
    lines = [
        _line(
            {key: getattr(m, key) for key in MISTAKE_FIELDS}
            | {"checks": m.lost, "answers": _differences(right, _rounded(got[m.name]))}
        )
        for m in mistakes
        if m.part == part and m.recognised_as == m.name
    ]
    answers_line = ",\n".join(_line(answer) for answer in right)
    body = ",\n".join(lines)
    return f'{{"stem": "{part.stem}", "right": [\n{answers_line}],\n"mistakes": [\n{body}]}}\n'


def _line(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))


def _rounded(answers: Answers) -> Answers:
    return [
        answer if isinstance(answer, str) else [None if x is None else _shorter(x) for x in answer]
        for answer in answers
    ]


def _shorter(x: float) -> float:
    return float(f"{x:.{DIGITS}g}") if abs(x) > 1e-12 else 0.0


def _differences(right: Answers, mistaken: Answers) -> dict[str, Any]:
    """The wrong answers: {question: {entry: number}}, or {question: text of the exception}."""
    different: dict[str, Any] = {}
    for k, (expected, got) in enumerate(zip(right, mistaken)):
        wrong = got
        if not isinstance(got, str):
            wrong = {
                str(i): x
                for i, (e, x) in enumerate(zip(expected, got))
                if x is None or abs(x - e) > 1e-9 * max(1.0, abs(e), abs(x))
            }
        if wrong:
            different[str(k)] = wrong
    return different


@cache
def for_the_instructor(name: str) -> tuple[str, str]:
    """The line for the instructor, and the heading of the hint; empty if the gallery isn't
    there."""
    file = GALLERY / name / "mistake.md"
    match = LAYOUT.fullmatch(file.read_text(encoding="utf-8")) if file.exists() else None
    return (match["instructor"], match["hint"]) if match else ("", "")
