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
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from bounce_grader.assignment.hints import headings
from bounce_grader.build import linking
from bounce_grader.build.compile import compile_all
from bounce_grader.common.errors import KitError
from bounce_grader.common.files import write_whole
from bounce_grader.common.manifest import part_of, parts, Part
from bounce_grader.common.parallel_map import parallel_map
from bounce_grader.common.paths import FIXTURES, JUDGE, REFERENCE_RUNNER, ROOT
from bounce_grader.grading.gallery import expected
from bounce_grader.sandbox import processes
from bounce_grader.sandbox.box import LARGEST_FILE, Box
from bounce_grader.submission import submission

GALLERY = ROOT / "tests" / "submissions" / "mistakes"
KNOWN = FIXTURES / "public" / "mistakes"
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
    """All mistakes of the gallery. Raises KitError that says what is missing, and where."""
    return [read(folder) for folder in sorted(GALLERY.iterdir()) if folder.is_dir()]


def read(folder: Path) -> Mistake:
    words = _text(folder / "mistake.md", "its title, a sentence, equations, hint and a line")
    _text(folder / "expected.json", "the checks that it loses")
    written = expected(folder)
    match = LAYOUT.fullmatch(words)
    if not match:
        raise KitError(
            f"{folder.name}/mistake.md isn't laid out as tests/submissions/README.md says"
        )
    if not re.match(r"part\d+_", folder.name):
        raise KitError(f"{folder.name}: the name must begin with its part, as in part2_without_dt")
    if match["hint"] not in headings().values():
        raise KitError(
            f"{folder.name}/mistake.md names a hint that isn't a heading in student/hints"
        )
    numbers = tuple(int(number) for number in match["equations"].split(", "))
    if not set(numbers) <= _equations():
        raise KitError(f"{folder.name}/mistake.md names an equation that student/README.md hasn't")
    return Mistake(
        folder.name,
        match["title"],
        match["sentence"],
        numbers,
        match["hint"],
        match["instructor"],
        tuple(written["lost"]),
        written.get("recognised_as", folder.name),
    )


def _text(file: Path, what: str) -> str:
    if not file.exists():
        raise KitError(f"{file.parent.name} lacks {file.name}: write {what}")
    return file.read_text(encoding="utf-8")


@cache
def _equations() -> set[int]:
    handout = (ROOT / "student" / "README.md").read_text(encoding="utf-8")
    return {int(number) for number in re.findall(r"\((\d+)\)$", handout, re.MULTILINE)}


# --- answers ---


def answers(part: Part, runner: Path) -> Answers:
    """A runner's answers to the public cases of a part, with given earlier parts. Empty if it ends
    before it has answered them all. Raises KitError if the judge fails."""
    fixtures = [str(FIXTURES / "public")]
    asked = {"answers": True, "part": part.number, "given": bool(part.calls), "fixtures": fixtures}
    # There it may make files: it has no box.
    command = [str(JUDGE), json.dumps(asked), str(runner)]
    result = processes.run(command, LIMITS, cwd=runner.parent)
    if not result.ok:
        raise KitError(f"the judge could not ask part {part.number}: {result.err.strip()}")
    return list(json.loads(result.out))


def runner_of(folder: Path, part: Part, work: Path) -> Path:
    """Builds a runner with a folder's file for this part alone."""
    taken = submission.read(folder)
    work.mkdir(parents=True, exist_ok=True)
    objects = compile_all(taken, work, TRUSTED, 1)
    linked = linking.link_alone(part, objects, work / "runner", TRUSTED)
    if not linked.path:
        raise KitError(f"{folder.name} can't be built: {linked.problem}")
    return linked.path


def answers_of(folder: Path, part: Part, work: Path) -> Answers:
    got = answers(part, runner_of(folder, part, work))
    if not got:
        raise KitError(f"{folder.name} ends before it has answered; such ones belong into broken/")
    return got


def right_answers(part: Part) -> Answers:
    return answers(part, REFERENCE_RUNNER)


def _all_answers(mistakes: list[Mistake]) -> dict[str, Answers]:
    with tempfile.TemporaryDirectory() as name:

        def asked(m: Mistake) -> Answers:
            return answers_of(GALLERY / m.name, m.part, Path(name) / m.name)

        got = parallel_map(asked, mistakes, os.cpu_count() or 1)
    return {m.name: answers for m, answers in zip(mistakes, got)}


# --- the files ---


def texts() -> dict[str, str]:
    """The files of fixtures/public/mistakes, as name -> text. Raises KitError if the gallery is
    incomplete, or if two mistakes have the same answers and neither names the other in
    "recognised_as"."""
    mistakes = gallery()
    got = _all_answers(mistakes)
    _check_twins(mistakes, got)
    return {f"{part.stem}.json": _file(part, mistakes, got) for part in parts()}


def write(folder: Path = KNOWN) -> None:
    """Writes the files. One that differs only by rounding stays as it is: the libm of another
    machine gives other last digits."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in texts().items():
        file = folder / name
        if not _is_fresh(file, text):
            write_whole(file, text)


def differing(folder: Path = KNOWN) -> list[str]:
    """The names of the files that don't match the gallery."""
    fresh = texts()
    names = {file.name for file in folder.glob("*")} | set(fresh)
    return sorted(name for name in names if not _is_fresh(folder / name, fresh.get(name)))


def _is_fresh(file: Path, text: str | None) -> bool:
    if text is None or not file.exists():
        return False
    return are_equal_up_to_rounding(json.loads(file.read_text()), json.loads(text))


def are_equal_up_to_rounding(a: Any, b: Any) -> bool:
    """Whether two JSON values are equal, up to the rounding of numbers."""
    if isinstance(a, dict) and isinstance(b, dict):
        return list(a) == list(b) and all(are_equal_up_to_rounding(a[key], b[key]) for key in a)
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and all(map(are_equal_up_to_rounding, a, b))
    if isinstance(a, float | int) and isinstance(b, float | int):
        return abs(a - b) <= 1e-10 * max(1.0, abs(a), abs(b))
    return bool(a == b)


def _file(part: Part, mistakes: list[Mistake], got: Mapping[str, Answers]) -> str:
    """The JSON text for a part, with one mistake on each line."""
    right = _rounded(right_answers(part))
    lines = [
        _line(_entry(m, _differences(right, _rounded(got[m.name]))))
        for m in mistakes
        if m.part == part and m.recognised_as == m.name
    ]
    answers_line = ",\n".join(_line(answer) for answer in right)
    body = ",\n".join(lines)
    return f'{{"stem": "{part.stem}", "right": [\n{answers_line}],\n"mistakes": [\n{body}]}}\n'


def _line(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))


def _entry(mistake: Mistake, differences: dict[str, Any]) -> dict[str, Any]:
    return {
        "name": mistake.name,
        "title": mistake.title,
        "sentence": mistake.sentence,
        "equations": mistake.equations,
        "hint": mistake.hint,
        "checks": mistake.lost,
        "answers": differences,
    }


def _rounded(answers: Answers) -> Answers:
    return [
        answer if isinstance(answer, str) else [None if x is None else _shorter(x) for x in answer]
        for answer in answers
    ]


def _shorter(x: float) -> float:
    return float(f"{x:.{DIGITS}g}") if abs(x) > 1e-12 else 0.0


def _differences(right: Answers, mistaken: Answers) -> dict[str, Any]:
    """The wrong answers: {question: {entry: number}}, or {question: text of the exception}."""
    return {str(k): what for k, what in _differing_answers(right, mistaken)}


def _differing_answers(right: Answers, mistaken: Answers) -> Iterator[tuple[int, Any]]:
    for k, (expected, got) in enumerate(zip(right, mistaken)):
        if isinstance(got, str):
            yield k, got
            continue
        entries = {
            str(i): x
            for i, (e, x) in enumerate(zip(expected, got))
            if x is None or abs(x - e) > 1e-9 * max(1.0, abs(e), abs(x))
        }
        if entries:
            yield k, entries


# --- twins ---


def _check_twins(mistakes: list[Mistake], got: Mapping[str, Answers]) -> None:
    by_name = {m.name: m for m in mistakes}
    for m in mistakes:
        twin = by_name.get(m.recognised_as)
        if twin is None or twin.recognised_as != twin.name:
            raise KitError(f"{m.name} is recognised_as {m.recognised_as}, which isn't by itself")
        if not are_equal_up_to_rounding(got[m.name], got[twin.name]):
            raise KitError(f"{m.name} is recognised_as {twin.name}, but answers otherwise")
    alone = [m for m in mistakes if m.recognised_as == m.name]
    for i, m in enumerate(alone):
        for other in alone[i + 1 :]:
            if m.part == other.part and are_equal_up_to_rounding(got[m.name], got[other.name]):
                raise KitError(
                    f"{m.name} and {other.name} answer the same to every public case: give one "
                    f'"recognised_as" in its expected.json, and the other words true of both'
                )


# --- for reports ---


@cache
def known() -> dict[str, dict[str, Any]]:
    """What students are told about each mistake, and the checks that it costs, by its name."""
    match = {}
    for part in parts():
        file = KNOWN / f"{part.stem}.json"
        for entry in json.loads(file.read_text(encoding="utf-8"))["mistakes"]:
            match[entry["name"]] = {key: entry[key] for key in entry if key != "answers"}
    return match


@cache
def for_the_instructor(name: str) -> tuple[str, str]:
    """The line for the instructor, and the heading of the hint; empty if the gallery isn't
    there."""
    file = GALLERY / name / "mistake.md"
    match = LAYOUT.fullmatch(file.read_text(encoding="utf-8")) if file.exists() else None
    return (match["instructor"], match["hint"]) if match else ("", "")
