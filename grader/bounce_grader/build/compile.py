"""Compiles the parts of a submission and its helpers (its other sources), in a box."""

import shutil
from functools import partial
from pathlib import Path
from typing import NamedTuple

from bounce_grader.build import compiler, object_cache
from bounce_grader.build.errors import Built
from bounce_grader.common.parallel_map import parallel_map
from bounce_grader.common.paths import SOURCES
from bounce_grader.sandbox.box import Box
from bounce_grader.sandbox.budget import Overrun
from bounce_grader.submission.submission import Submission

HELPERS_SECONDS = 30  # of CPU time, for all helpers of a submission together
HELPERS_BYTES = 32 << 20  # of objects, likewise; one more may be under way


class Objects(NamedTuple):
    """The objects of a submission: of its parts by number, and of its helpers."""

    parts: dict[int, Built]
    helpers: list[Built]

    @property
    def all(self) -> list[Built]:
        return [*self.parts.values(), *self.helpers]


def compile_all(taken: Submission, work: Path, box: Box, jobs: int, timed: bool = False) -> Objects:
    """Compiles every part and then every helper by itself, in folders inside of the folder `work`.
    If `timed`, compiles as for normal use, without run-time checks."""
    named = object_cache.named_sources(taken)
    built = partial(_built, taken, named, work, timed)
    parts = parallel_map(partial(built, box), taken.parts.values(), jobs)
    limited = box.budget.part(HELPERS_SECONDS, whose="the compiling of helpers")
    helping = box._replace(budget=limited)
    sizes: list[int] = []

    def helper(file: str) -> Built:
        if sum(sizes) > HELPERS_BYTES:
            most = f"the helpers' objects take more than {HELPERS_BYTES >> 20} MB"
            return Built(None, f"{file} wasn't compiled: {most}")
        made = built(helping, file)
        sizes.append(made.path.stat().st_size if made.path else 0)
        return made

    helpers = parallel_map(helper, taken.helpers, jobs)
    return Objects(dict(zip(taken.parts, parts)), helpers)


def _built(
    taken: Submission, named: frozenset[str], work: Path, timed: bool, box: Box, file: str
) -> Built:
    """Compiles a file, unless its object is in the cache; by g++ what clang rejects. The cache
    key covers every file that the compiler can see: no other source unless it is `named` by some
    file, so that the object stays valid when other parts change."""
    names = object_cache.needed(file, taken, named)
    name = object_cache.name_of(file, names, taken, box, timed)
    place = object_cache.place(name)
    if object_cache.is_there(place):
        return Built(place)
    folder, made = work / f"{SOURCES}-{name[:16]}", work / f"{name[:16]}.o"
    taken.write_to(folder, names)
    box.give(folder)
    try:
        clang = compiler.clang(file, taken, timed)
        first = result = compiler.run(clang, folder, box, made)
        if not first.ok and not compiler.ran_out_of_time(first) and not first.flooded:
            gcc = compiler.gcc(file, taken, box, timed)
            result = compiler.run(gcc, folder, box, made, by_gcc=True)
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
