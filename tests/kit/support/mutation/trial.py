"""Judges changed parts as the grader judges a submission: the solution with one file changed.

Compiler, runner, judge and box are the grader's. The part is judged with its own earlier parts and,
if it doesn't get full points, with given ones; the better result counts. The other parts aren't
judged: earlier ones don't call it, and later ones get full points with it given. Whole gradings of
some changes confirm this.
"""

import json
import os
from collections.abc import Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from bounce_grader.build import linking
from bounce_grader.build.compile import compile_all, Built, Objects
from bounce_grader.common.errors import KitError
from bounce_grader.common.files import temporary_folder
from bounce_grader.common.manifest import parts, Part
from bounce_grader.common.paths import BUILD, ROOT, WORK_FOLDER
from bounce_grader.grading import fixtures, judging
from bounce_grader.grading.judging import Judged
from bounce_grader.sandbox import box as boxes, processes
from bounce_grader.sandbox.box import Box
from bounce_grader.submission.submission import read

from mutation.batch import Batch, compiled
from mutation.changes import Change, changes

ALIKE = BUILD / "alike"
SOLUTION = ROOT / "solution" / "src"
AT_ONCE = 200  # changes in one object
GALLERY = ROOT / "tests" / "submissions" / "accepted"
STYLES = ("dynamic_matrices_and_lu", "vectors_and_algorithms")


@dataclass(frozen=True)
class Outcome:
    """The checks that a change loses. One that doesn't compile loses its whole part."""

    change: Change
    compiles: bool
    lost: tuple[str, ...] = ()

    @property
    def is_noticed(self) -> bool:
        return not self.compiles or bool(self.lost)


class Choosing(Box):
    """Tells the runner which change to make."""

    number: int

    @staticmethod
    def of(box: Box, number: int) -> "Choosing":
        chosen = Choosing(box.kind)
        chosen.number = number
        return chosen

    def to_run(self, program: Path) -> list[str]:
        return [*super().to_run(program), str(self.number)]


@dataclass(frozen=True)
class Runners:
    """The runners of a batch: one with all parts, and one with the changed part and given parts."""

    part: Part
    together: Path
    alone: Path


@cache
def all_changes() -> tuple[Change, ...]:
    files = (SOLUTION / part.file for part in parts())
    return tuple(change for file in files for change in changes(file.name, file.read_text()))


def files_of_styles() -> tuple[str, ...]:
    """The parts of right programs in other styles, as their folder and name; those whose signature
    stands in one line of the namespace, as the changes need it."""
    found = (path for style in STYLES for path in sorted((GALLERY / style).glob("part*.cpp")))
    fit = (path for path in found if "using namespace bounce" not in path.read_text())
    return tuple(f"{path.parent.name}/{path.name}" for path in fit)


def changes_of_style(file: str) -> tuple[Change, ...]:
    return tuple(changes(file, (GALLERY / file).read_text()))


def changes_of(file: str) -> tuple[Change, ...]:
    """Of a file of the solution, or of another style, as its folder and name."""
    if "/" in file:
        return changes_of_style(file)
    return tuple(change for change in all_changes() if change.file == file)


def part_of(change: Change) -> Part:
    return next(part for part in parts() if part.file == Path(change.file).name)


def outcomes(chosen: Iterable[Change]) -> list[Outcome]:
    """What each of these changes of one part costs."""
    wanted = list(chosen)
    groups = -(-len(wanted) // AT_ONCE)  # each of all kinds, so that some of it compiles
    found = {o.change: o for k in range(groups) for o in _outcomes(wanted[k::groups])}
    return [found[change] for change in wanted]


def _outcomes(wanted: list[Change]) -> list[Outcome]:
    hidden = fixtures.hidden_folder()
    with _built(wanted) as (batch, runners):
        numbers = {change.name: number for number, change in enumerate(batch.changes)}

        def outcome(change: Change) -> Outcome:
            if change.name not in numbers:
                return Outcome(change, compiles=False)
            box = Choosing.of(_box(), numbers[change.name])
            return Outcome(change, True, _lost(runners, hidden, box))

        with ThreadPoolExecutor(os.cpu_count()) as pool:
            return list(pool.map(outcome, wanted))


def differing(chosen: Iterable[Change], count: int) -> dict[str, int]:
    """How many of `count` random questions each of these changes of one part answers otherwise than
    the solution does."""
    with _built(list(chosen)) as (batch, runners):
        found = {}
        for number, change in enumerate(batch.changes):
            asked = ["--part", str(runners.part.number), "--count", str(count)]
            run = Choosing.of(_box(), number).to_run(runners.together)
            result = processes.run([str(ALIKE), *asked, "--", *run], judging.WAIT)
            if not result.ok:
                raise KitError(f"alike failed: {result.err.strip()}")
            found[change.name] = int(json.loads(result.out)["differing"])
        return found


def _lost(runners: Runners, folder: Path, box: Box) -> tuple[str, ...]:
    """The checks that fail, in the better of both ways of judging."""
    part = runners.part
    own = judging.judge(part, runners.together, False, folder, box)
    if own.score(part) == part.points or not part.calls:
        return _failed(own)
    given = judging.judge(part, runners.alone, True, folder, box)
    return _failed(max(given, own, key=lambda judged: judged.score(part)))


def _failed(judged: Judged) -> tuple[str, ...]:
    return tuple(sorted(id for id, verdict in judged.verdicts.items() if not verdict.passed))


@cache
def _box() -> Box:
    return boxes.choose()


@cache
def _solution() -> dict[int, Built]:
    """The objects of the unchanged parts."""
    taken, box = read(SOLUTION), _box()
    with temporary_folder(WORK_FOLDER) as name:
        box.give(Path(name))
        return compile_all(taken, Path(name), box, 1).parts


@contextmanager
def _built(wanted: list[Change]) -> Iterator[tuple[Batch, Runners]]:
    part, box = part_of(wanted[0]), _box()
    batch = compiled(wanted, box)
    objects = Objects({**_solution(), part.number: Built(batch.object)}, {})
    with temporary_folder(WORK_FOLDER) as name:
        work = Path(name)
        linked = [
            linking.link_together(objects, work / "together", box),
            linking.link_alone(part, objects, work / "alone", box),
        ]
        box.give(work)
        for runner in linked:
            if not runner.path:
                raise KitError(f"the changes of {part.file} can't be linked: {runner.problem}")
        yield batch, Runners(part, work / "together", work / "alone")
