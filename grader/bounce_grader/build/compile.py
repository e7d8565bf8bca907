"""Compiles the parts of a submission and its helpers (its other sources), in a box."""

import shutil
from pathlib import Path
from typing import NamedTuple

from bounce_grader.build import compiler, object_cache
from bounce_grader.build.errors import Built
from bounce_grader.common.parallel_map import parallel_map
from bounce_grader.common.paths import SOURCES
from bounce_grader.sandbox.box import PROGRAMS, Box
from bounce_grader.sandbox.budget import Budget, Overrun
from bounce_grader.submission.submission import Submission

HELPERS_SECONDS = 30  # of CPU time, for all helpers of a submission together
HELPERS_BYTES = 32 << 20  # of objects, likewise; one more may be under way


class Objects(NamedTuple):
    """The objects of a submission: of its parts by number, and of its helpers by file name."""

    parts: dict[int, Built]
    helpers: dict[str, Built]

    @property
    def all(self) -> list[Built]:
        return [*self.parts.values(), *self.helpers.values()]


def compile_all(
    submission: Submission, work: Path, box: Box, jobs: int, timed: bool = False
) -> Objects:
    """Compiles every part and then every helper by itself, in folders inside of the folder `work`.
    If `timed`, compiles as for normal use, without run-time checks."""
    named = object_cache.named_sources(submission)
    compiling = _Compiling(submission, named, work, box, timed)
    parts = parallel_map(compiling.built, submission.parts.values(), jobs)
    wall = box.budget.left()[1]
    limited = Budget(HELPERS_SECONDS, wall, part_of=box.budget, whose="the compiling of helpers")
    helping = compiling._replace(box=box._replace(budget=limited))
    sizes: list[int] = []

    def helper(file: str) -> Built:
        if sum(sizes) > HELPERS_BYTES:
            most = f"the helpers' objects take more than {HELPERS_BYTES >> 20} MB"
            return Built(None, f"{file} wasn't compiled: {most}")
        built = helping.built(file)
        sizes.append(built.path.stat().st_size if built.path else 0)
        return built

    helpers = submission.helpers
    return Objects(
        dict(zip(submission.parts, parts)),
        dict(zip(helpers, parallel_map(helper, helpers, jobs))),
    )


class _Compiling(NamedTuple):
    """What is the same for all files of a submission."""

    submission: Submission
    named: frozenset[str]  # the sources that some file may include
    work: Path
    box: Box
    timed: bool

    def built(self, file: str) -> Built:
        """Compiles a file, unless its object is in the cache; by g++ what clang rejects. The cache
        key covers every file that the compiler can see: no other source unless some file names it,
        so that the object stays valid when other parts change."""
        names = object_cache.needed(file, self.submission, self.named)
        name = object_cache.name_of(file, names, self.submission, self.box, self.timed)
        place = object_cache.place(name)
        if object_cache.is_there(place):
            return Built(place)
        folder, made = self.work / f"{SOURCES}-{name[:16]}", self.work / f"{name[:16]}.o"
        self.submission.write_to(folder, names)
        self.box.give(folder)
        try:
            clang = compiler.clang(file, self.submission, self.timed)
            first = result = compiler.run(clang, folder, self.box, made)
            if not first.ok and not compiler.ran_out_of_time(first) and not first.flooded:
                gcc = compiler.gcc(file, self.submission, self.box, self.timed)
                result = compiler.run(gcc, folder, self.box, made, PROGRAMS)
                compiler.require_gcc_ran(result)
            size = made.stat().st_size
            if not result.ok or not size:
                return compiler.compile_problem(first, file)
            if size > compiler.LARGEST_OBJECT:
                return compiler.too_large(file)
            return Built(object_cache.store(made.read_bytes(), place))
        except Overrun as overrun:
            return Built(None, f"{file} wasn't compiled: {overrun}")
        finally:
            # At once: those of all files together may not fit into the temporary folder.
            shutil.rmtree(folder)
            made.unlink(missing_ok=True)
