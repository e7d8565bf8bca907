"""Grades a submission, and makes its score record."""

import os
import time
from contextlib import suppress
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

from bounce_grader.build.compile import compile_all, compiled
from bounce_grader.build.toolchain import link_alone, link_together, MAIN, Work
from bounce_grader.common.errors import KitError
from bounce_grader.common.escaping import first_few, printable_name
from bounce_grader.common.files import remove_abandoned
from bounce_grader.common.manifest import parts, Part
from bounce_grader.common.numbers import scientific
from bounce_grader.common.parallel_map import parallel_map
from bounce_grader.common.paths import STUBS
from bounce_grader.grading import examples, fixtures, judging, record
from bounce_grader.grading.judging import fact
from bounce_grader.grading.record import Record
from bounce_grader.sandbox import box as boxes
from bounce_grader.sandbox.box import Box
from bounce_grader.sandbox.budget import Budget, Overrun
from bounce_grader.submission import submission
from bounce_grader.submission.submission import Place, Submission


class Options(NamedTuple):
    """How a submission is graded."""

    boxes: tuple[str, ...] = boxes.FULL_OR_REDUCED  # the acceptable kinds, best first
    speed: bool = False
    sanitize: bool = False  # run parts with all points with sanitizers, for remarks
    public: bool = False  # on the public cases alone, as ./check does
    jobs: int = 0  # 0: one per core, and no more than parts
    within: Budget | None = None  # the grading's budget; None: a new one from its start on


def grade(given: Path | Submission, options: Options = Options()) -> Record:
    """Grades a submission, or a folder or zip that holds one. Raises UsageError if it can't be
    read, KitError if the kit fails. The record is for the course alone, as it has the answers of
    hidden cases; report.py makes what others get."""
    start = time.monotonic()
    within = options.within or Budget()
    taken = given if isinstance(given, Submission) else submission.read(given)
    box = boxes.choose(options.boxes)._replace(budget=within)
    hidden = None if options.public else fixtures.hidden_folder()
    remove_abandoned()
    jobs = options.jobs or min(os.cpu_count() or 1, len(parts()))
    with compiled(taken, box, jobs) as work:
        grading = _Grading(work, hidden)
        built = time.monotonic()
        grading.judge_together()
        grading.judge_alone()
        records = [grading.record_of(part) for part in parts()]
        if not any(r["score"] for r in records):
            _require_working_kit(Box(box.kind))
        speed = _speed(grading) if options.speed else None
        cases, case_records = examples.judged(taken.cases, box)
        if options.sanitize and any(r["score"] == r["max_score"] for r in records):
            _ = grading.checked  # once, before the parts go on side by side
            records = parallel_map(grading.with_remarks, records, jobs)
    end = time.monotonic()
    seconds = {"compile": built - start, "run": end - built, "total": end - start}
    return record.whole(
        taken,
        [*records, *case_records],
        box=box.kind,
        seconds={phase: round(value, 3) for phase, value in seconds.items()},
        fixtures_sha256=record.digest_of([fixtures.PUBLIC, *([hidden] if hidden else [])]),
        speed=speed,
        examples=cases,
    )


class _Grading:
    """Judges the parts. First all parts linked together; then, if a part could score better, this
    part alone, with the given earlier parts. The better score counts."""

    def __init__(self, work: Work, hidden: Path | None) -> None:
        self.work, self.hidden = work, hidden
        self.together: Path | None = None  # the runner with all parts, if they link
        self.own: dict[Part, judging.Judged] = {}
        self.never_called_given: set[Part] = set()  # that is, the part before, which they could
        self.results: dict[Part, judging.Judged | Record] = {}  # a record: nothing could be run

    @cached_property
    def checked(self) -> Work:
        """The submission, built with sanitizers."""
        return judging.sanitized(self.work)

    def judge_together(self) -> None:
        """Judges the parts in the runner that holds them all. Parts that call no other come first:
        where one of them lost points, its callers are tried with given parts first."""
        with suppress(Overrun):
            self.together = link_together(self.work)
            for calling in (False, True):
                lost = any(j.score(part) < part.points for part, j in self.own.items())
                if not self.together or lost:
                    return
                now = [part for part in parts() if bool(part.calls) == calling]
                parallel_map(self._judge_own, now, self.work.jobs)

    def _judge_own(self, part: Part) -> judging.Judged:
        assert self.together
        self.own[part] = judging.judge(part, "together", self.work, self.together, self.hidden)
        return self.own[part]

    def judge_alone(self) -> None:
        """Judges each part alone that could score better, and takes the better result. One after
        the other: side by side, the given answers of a later part could reach an earlier one, by
        whatever two programs notice of each other, as how busy the machine is."""
        for part in parts():
            self.results[part] = self._problem(part) or self._better(part)

    def _better(self, part: Part) -> judging.Judged | Record:
        given: judging.Judged | None = None
        try:
            if self._could_be_better(part):
                alone = link_alone(part, self.work)
                if alone.path:
                    given = judging.judge(part, "alone", self.work, alone.path, self.hidden)
                    if part.calls and given.graded_with == "own":
                        self.never_called_given.add(part)
                if self._could_be_better_together(part, given):
                    self._judge_own(part)
                if not given and part not in self.own:
                    # With the errors of helpers, which may be the reason.
                    broken = [b.problem for b in self.work.helpers if not b.path]
                    return self._not_built(part, "; ".join([alone.problem, *broken]), alone.place)
        except Overrun as overrun:
            if not given and part not in self.own:
                return record.failed_part(part, "timed_out", fact("no_time", str(overrun)))
        return judging.which_counts(part, self.own.get(part), given)

    def record_of(self, part: Part) -> Record:
        """The record of a part, once all are judged: explaining a crash takes what time is left."""
        best = self.results[part]
        if not isinstance(best, judging.Judged):
            return best
        if best.status == "crashed":
            best = judging.with_cause(part, best, lambda: self.checked, self.hidden)
        graded = record.part_record(part, best)
        graded["notes"] = self._shared_with_a_wrong_part(part, best)
        path = self.work.parts[part.number].path
        if not (path and MAIN in path.read_bytes()):
            return graded
        return record.with_remark(graded, fact("defines_main", part.file), None)

    def _shared_with_a_wrong_part(self, part: Part, best: judging.Judged) -> list[judging.Facts]:
        """For a part that lost points by its own code: what an earlier part that lost some shares
        with it, which costs points twice."""
        if best.graded_with == "given" or best.score(part) == part.points:
            return []
        for earlier in parts()[: part.number - 1]:
            result = self.results[earlier]
            lost = isinstance(result, judging.Judged) and result.score(earlier) < earlier.points
            if not lost:
                continue
            if shared := self.work.taken.shared(earlier.number, part.number):
                files = first_few(list(map(printable_name, shared)))
                return [fact("shared", str(earlier.number), str(part.number), files)]
            if part in self.never_called_given and earlier.number == part.number - 1:
                return [fact("calls_no_given", earlier.function, str(earlier.number))]
        return []

    def with_remarks(self, graded: Record) -> Record:
        """The record of a part; if it has all points, with what the sanitizers find in it."""
        if graded["score"] < graded["max_score"]:
            return graded
        found = judging.remark(parts()[graded["part"] - 1], self.checked)
        return record.with_remark(graded, *found) if found else graded

    def _could_be_better(self, part: Part) -> bool:
        """Whether the part might score more when it is linked alone, where neither earlier parts
        nor static initializers of other files can harm it. If another part answered in the same
        runner, a static initializer can't be why this part hung."""
        own = self.own.get(part)
        if not own or own.score(part) == part.points:
            return not own
        others_answered = any(other.status == "graded" for other in self.own.values())
        return bool(part.calls) or own.status != "timed_out" or not others_answered

    def _could_be_better_together(self, part: Part, given: judging.Judged | None) -> bool:
        """Whether the part wasn't judged so, and might score more there: if an earlier part hangs,
        its callers would hang, too."""
        has_all = given is not None and given.score(part) == part.points
        hangs = any(own.status == "timed_out" for own in self.own.values())
        return bool(self.together) and part not in self.own and not has_all and not hangs

    def _problem(self, part: Part) -> Record | None:
        """The record of a part of which there is nothing to run."""
        taken = self.work.taken
        if part.number in taken.refused:
            why = fact("refused", taken.refused[part.number])
            return record.failed_part(part, "does_not_compile", why)
        if part.number not in taken.parts:
            why = fact("not_submitted", part.file, taken.instead_of(part))
            return record.failed_part(part, "not_submitted", why)
        file = taken.parts[part.number]
        words = taken.files[file].split()
        if not words:
            return record.failed_part(part, "does_not_compile", fact("empty", file))
        if submission.is_stub(part, taken.files[file]):
            return record.failed_part(part, "graded", fact("stub", part.file))
        built = self.work.parts[part.number]
        return None if built.path else self._not_built(part, built.problem, built.place)

    def _not_built(self, part: Part, why: str, place: Place | None) -> Record:
        if place:  # as "./helper.hpp", or as whatever the submission made a compiler write
            place = place._replace(file=os.path.normpath(place.file))
        known = place if place and place.file in self.work.taken.files else None
        return record.failed_part(part, "does_not_compile", fact("not_built", why), known)


def _require_working_kit(box: Box) -> None:
    """Called if a submission scores 0: raises KitError unless a stub compiles and runs, so that a
    broken kit isn't taken for a bad submission."""
    with compiled(submission.read(STUBS), box) as work:
        stub = work.parts[1]
        linked = link_alone(parts()[0], work) if stub.path else stub
        if not linked.path:
            raise KitError(f"a stub can't be built: {linked.problem}")
    if problem := boxes.problem_of(box):
        raise KitError(f"the box stopped working while it was in use: {problem}")


def _speed(grading: _Grading) -> Record:
    """Times the submission beside the solution, if its parts link together and the grading has time
    left; and adds the largest error over all public cases."""
    from bounce_grader.grading import speed

    results = grading.results.values()
    errors = [judged.largest_error for judged in results if isinstance(judged, judging.Judged)]
    known = [error for error in errors if error is not None]
    largest = float(scientific(max(known))) if len(known) == len(parts()) else None
    measured: Record = {"largest_error": largest}
    with suppress(Overrun):
        if grading.together:
            work = compile_all(grading.work._replace(kind="speed"))
            if timed := link_together(work):
                measured |= speed.measure(timed, work.box) or {}
    return measured
