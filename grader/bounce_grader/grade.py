"""From a submission to its score record."""

import os
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from bounce_grader import box as boxes
from bounce_grader import build, fixtures, judging, record, submission
from bounce_grader.box import Box
from bounce_grader.errors import KitError
from bounce_grader.judging import Judged
from bounce_grader.manifest import Part, parts
from bounce_grader.record import Record
from bounce_grader.submission import Submission


@dataclass(frozen=True)
class Options:
    trust: bool = False  # grade without a box where none can be had
    speed: bool = False
    jobs: int = 0  # 0: one a core


def grade(path: Path, options: Options = Options()) -> Record:
    """Raises UsageError where the submission can't be read, KitError where the kit fails."""
    start = time.monotonic()
    taken = submission.read(path)
    box = boxes.choose(options.trust)
    hidden = fixtures.hidden_folder()
    jobs = options.jobs or os.cpu_count() or 1
    with tempfile.TemporaryDirectory(prefix="bounce-") as name:
        folder = Path(name)
        taken.write_to(folder)
        objects = build.compile_all(taken, folder, box, jobs)
    together = _link_together(taken, objects, box)
    compiled = time.monotonic()
    with ThreadPoolExecutor(jobs) as pool:
        grading = _Grading(taken, objects, together, hidden, box)
        records = list(pool.map(grading.part, parts()))
    if not any(r["score"] for r in records) and boxes.choose(options.trust) != box:
        raise KitError("the box stopped working while it was in use")
    speed = _speed(grading, box) if options.speed else None
    end = time.monotonic()
    return record.whole(
        taken,
        records,
        box.kind,
        {"compile": compiled - start, "run": end - compiled, "total": end - start},
        record.digest_of([fixtures.PUBLIC, hidden]),
        speed,
    )


def _link_together(taken: Submission, objects: build.Objects, box: Box) -> build.Built:
    if any(part.number not in objects.parts for part in parts()):
        return build.Built(None, "not all parts were submitted")
    broken = [b for b in [*objects.parts.values(), *objects.helpers.values()] if not b.path]
    return broken[0] if broken else build.link_together(objects, box)


class _Grading:
    """Judges the parts: with the submission's own earlier parts, and with given ones."""

    def __init__(
        self,
        taken: Submission,
        objects: build.Objects,
        together: build.Built,
        hidden: Path,
        box: Box,
    ) -> None:
        self.taken, self.objects, self.together = taken, objects, together
        self.hidden, self.box = hidden, box
        self.judged: dict[int, Judged] = {}

    def part(self, part: Part) -> Record:
        problem = self._problem(part)
        if problem:
            return record.failed_part(part, *problem)
        tries: list[Judged] = []
        if self.together.path:
            tries.append(self._judge(part, self.together.path, given=False))
        if not tries or self._could_be_better(part, tries[0]):
            alone = build.link_alone(part, self.objects, self.box)
            if alone.path:
                tries.append(self._judge(part, alone.path, given=part.has_earlier_parts))
            elif not tries:
                return record.failed_part(part, "does_not_compile", self._why(part, alone))
        # The later one, with the earlier parts given, where both score the same.
        best = max(reversed(tries), key=lambda judged: judged.score(part))
        self.judged[part.number] = best
        return record.part_record(part, best)

    def _problem(self, part: Part) -> tuple[str, str] | None:
        if part.number in self.taken.refused:
            return "does_not_compile", self.taken.refused[part.number]
        if part.number not in self.objects.parts:
            return "not_submitted", f"{part.file} isn't among the files submitted"
        built = self.objects.parts[part.number]
        return None if built.path else ("does_not_compile", built.problem)

    def _could_be_better(self, part: Part, own: Judged) -> bool:
        """Alone, a part is free of what the other files do before main, and of earlier parts."""
        if own.score(part) == part.points:
            return False
        return part.has_earlier_parts or own.status != "graded"

    def _why(self, part: Part, alone: build.Built) -> str:
        """A helper that doesn't compile is the reason behind what is missing."""
        broken = [built.problem for built in self.objects.helpers.values() if not built.path]
        return "; ".join([alone.problem, *broken])

    def _judge(self, part: Part, runner: Path, given: bool) -> Judged:
        return judging.judge(part, runner, given, self.hidden, self.box)


def _speed(grading: _Grading, box: Box) -> Record:
    """What a step costs beside the solution, and the largest error over all checks."""
    errors = [judged.largest_error for judged in grading.judged.values()]
    runner = grading.together.path
    times = judging.speed(runner, box) if runner else None
    known = [error for error in errors if error is not None]
    complete = len(known) == len(parts())
    return {**(times or {}), "largest_error": max(known) if complete else None}
