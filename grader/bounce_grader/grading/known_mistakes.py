"""The known mistakes: their descriptions in the gallery, and their answers to the public cases.

A folder of tests/submissions/mistakes/ holds a wrong file, expected.json and mistake.md, as
tests/submissions/README.md says. This module builds the wrong files, and writes the descriptions
and the files' answers to fixtures/public/mistakes/*.json, by which the judge and a student's own
build recognise mistakes. The line for the instructor is left out there.
"""

import json
import math
import os
import re
from pathlib import Path
from typing import Any, NamedTuple

from bounce_grader.build.compile import compiled
from bounce_grader.build.toolchain import link_alone
from bounce_grader.common.errors import KitError
from bounce_grader.common.files import write_whole
from bounce_grader.common.manifest import part_of, parts, Part
from bounce_grader.common.parallel_map import parallel_map
from bounce_grader.common.paths import JUDGE, REFERENCE_RUNNER, ROOT
from bounce_grader.common.progress import Progress
from bounce_grader.grading.record import MISTAKE_FIELDS
from bounce_grader.sandbox import processes
from bounce_grader.sandbox import box as boxes
from bounce_grader.sandbox.box import LARGEST_FILE
from bounce_grader.submission import submission

GALLERY = ROOT / "tests" / "submissions" / "mistakes"
ANY_BOX = (*boxes.FULL_OR_REDUCED, "none")  # the gallery is the kit's own; as gradings compile it
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


def expected(folder: Path) -> dict[str, Any]:
    """The content of expected.json, in which a person wrote what a submission of the gallery should
    get. One that loses nothing needs no file."""
    file = folder / "expected.json"
    data: dict[str, Any] = json.loads(file.read_text()) if file.exists() else {}
    return data | {"lost": check_ids(data.get("lost", []))}


def check_ids(lost: list[str]) -> list[str]:
    """The ids of what is lost: of all its checks where that is a part."""
    checks = {f"part{part.number}": [check.id for check in part.checks] for part in parts()}
    return [id for name in lost for id in checks.get(name, [name])]


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


def _of_mistake(mistake: Mistake, cases: Path) -> Answers:
    """The answers of a mistake's file alone, which is built for this."""
    with compiled(submission.read(GALLERY / mistake.name), boxes.choose(ANY_BOX)) as work:
        linked = link_alone(mistake.part, work)
        if not linked.path:
            raise KitError(f"{mistake.name} can't be built: {linked.problem}")
        if got := answers(mistake.part, linked.path, cases):
            return got
    raise KitError(f"{mistake.name} ends before it has answered; such ones belong into broken/")


# --- the files ---


def write(public: Path) -> None:
    """Writes the folder mistakes beside the cases in a folder. Of mistakes with the same answers all
    but one have to name that one in "recognised_as": the judge would name none of them."""
    mistakes = gallery()
    progress = Progress(len(mistakes), "mistakes built and asked")

    def ask(mistake: Mistake) -> Answers:
        return progress.after(_of_mistake(mistake, public))

    got = parallel_map(ask, mistakes, os.cpu_count() or 1)
    for part in parts():
        right = _rounded(answers(part, REFERENCE_RUNNER, public))
        told = [
            {key: getattr(m, key) for key in MISTAKE_FIELDS}
            | {"checks": m.lost, "answers": _differences(right, _rounded(mistaken))}
            for m, mistaken in zip(mistakes, got)
            if m.part == part and m.recognised_as == m.name
        ]
        known = {"stem": part.stem, "right": right, "mistakes": told}
        text = json.dumps(known, ensure_ascii=False, separators=(",", ":"))
        lines = re.sub(r'(?<=[\[,])(?=\[|{"name")', "\n", text)  # one for each answer and mistake
        write_whole(public / "mistakes" / f"{part.stem}.json", lines + "\n")


def _rounded(answers: Answers) -> Answers:
    def shorter(x: float | None) -> float | None:
        return None if x is None else float(f"{x:.{DIGITS}g}") if abs(x) > 1e-12 else 0.0

    return [a if isinstance(a, str) else list(map(shorter, a)) for a in answers]


def _differences(right: Answers, mistaken: Answers) -> dict[str, Any]:
    """The wrong answers: {question: {entry: number}}, or {question: text of the exception}."""
    different: dict[str, Any] = {}
    for k, (expected, got) in enumerate(zip(right, mistaken)):
        wrong = got
        if not isinstance(got, str):
            wrong = {
                str(i): x
                for i, (e, x) in enumerate(zip(expected, got))
                if x is None or not math.isclose(x, e, rel_tol=1e-9, abs_tol=1e-9)
            }
        if wrong:
            different[str(k)] = wrong
    return different


def for_the_instructor(name: str) -> tuple[str, str]:
    """The line for the instructor, and the hint's heading; empty where there is no gallery."""
    if not (GALLERY / name).exists():
        return "", ""
    known = read(GALLERY / name)
    return known.instructor, known.hint
