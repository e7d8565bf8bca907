"""Compiles the parts of a submission and its helpers (its other sources), in a box."""

import shutil
from pathlib import Path
from typing import NamedTuple

from bounce_grader.build import compiler, object_cache
from bounce_grader.common.parallel_map import parallel_map
from bounce_grader.common.paths import SOURCES
from bounce_grader.sandbox import processes
from bounce_grader.sandbox.box import PROGRAMS, Box
from bounce_grader.sandbox.budget import Overrun, Shares
from bounce_grader.submission.submission import Submission

HELPERS_SECONDS = 30  # of CPU time, for all helpers of a submission together
HELPERS_BYTES = 32 << 20  # of objects, likewise, refused ones too; one more may be under way


class Built(NamedTuple):
    """An object file or a runner; or one sentence that says why there is none."""

    path: Path | None
    problem: str = ""


class Objects(NamedTuple):
    """The objects of a submission: of its parts by number, and of its helpers by file name."""

    parts: dict[int, Built]
    helpers: dict[str, Built]


def compile_all(
    submission: Submission, work: Path, box: Box, jobs: int, timed: bool = False
) -> Objects:
    """Compiles every part and helper by itself, in folders inside of the folder `work`. If `timed`,
    compiles as for normal use, without run-time checks."""
    helpers, spent = submission.helpers, _Spent()
    named = object_cache.named_sources(submission)

    def compiled(file: str) -> Built:
        own = spent if file in helpers else _Spent()
        if own.left() < 0:
            return Built(None, f"{file} wasn't compiled: the helpers took {HELPERS_SECONDS} s")
        if own.bytes > HELPERS_BYTES:
            most = f"{HELPERS_BYTES >> 20} MB"
            return Built(
                None, f"{file} wasn't compiled: the helpers' objects take more than {most}"
            )
        try:
            built = _Compiling(file, submission, named, work, box, timed, own).built()
        except Overrun as overrun:
            return Built(None, f"{file} wasn't compiled: {overrun}")
        return built

    files = [*submission.parts.values(), *helpers]
    built = dict(zip(files, parallel_map(compiled, files, jobs)))
    return Objects(
        {number: built[file] for number, file in submission.parts.items()},
        {file: built[file] for file in helpers},
    )


class _Spent:
    """CPU seconds of compilers, which may be at work side by side, and bytes of their objects."""

    def __init__(self) -> None:
        self.seconds = 0.0
        self.bytes = 0
        self.shares = Shares(self.left)

    def left(self) -> float:
        return HELPERS_SECONDS - self.seconds


class _Compiling(NamedTuple):
    """Compiles one file."""

    file: str
    submission: Submission
    named: frozenset[str]  # the sources whose names occur in some file
    work: Path
    box: Box
    timed: bool
    spent: _Spent  # by all helpers together, or by this part

    def built(self) -> Built:
        """Compiles the file, unless its object is in the cache. The cache key covers every file
        that the compiler can see. So at first it sees only the files that the text seems to need,
        and the object stays valid when others change. If the compiler misses one, it sees all."""
        needed = object_cache.needed(self.file, self.submission, self.named)
        everything = sorted(self.submission.files)
        if needed != everything:
            built = self._seeing(needed, more=True)
            if built.path or built.problem:
                return built
        return self._seeing(everything, more=False)

    def _seeing(self, names: list[str], more: bool) -> Built:
        """Compiles with only these files visible. Returns neither an object nor a problem if the
        compiler missed a file and there are `more` files that it could see."""
        name = object_cache.name_of(self.file, names, self.submission, self.box, self.timed)
        place = object_cache.place(name)
        if object_cache.is_there(place):
            self.spent.bytes += place.stat().st_size
            return Built(place)
        folder = self.work / f"{SOURCES}-{name[:16]}"
        made = self.work / f"{name[:16]}.o"
        self.submission.write_to(folder, names)
        self.box.give(folder)
        try:
            return self._made(more, folder, made, place)
        finally:
            # At once: those of all files together may not fit into the temporary folder.
            shutil.rmtree(folder)
            made.unlink(missing_ok=True)

    def _made(self, more: bool, folder: Path, made: Path, place: Path) -> Built:
        clang = compiler.clang(self.file, self.submission, self.timed)
        first = result = self._run(clang, folder, made, ())
        if more and compiler.misses_a_file(first):
            return Built(None)
        if not first.ok and not compiler.ran_out_of_time(first) and not first.flooded:
            gcc = compiler.gcc(self.file, self.submission, self.box, self.timed)
            result = self._run(gcc, folder, made, PROGRAMS)
            compiler.require_gcc_ran(result)
        size = made.stat().st_size
        self.spent.bytes += size
        if not result.ok or not size:
            return Built(None, compiler.compile_problem(first, self.file))
        if size > compiler.LARGEST_OBJECT:
            return Built(None, compiler.too_large(self.file))
        return Built(object_cache.store(made.read_bytes(), place))

    def _run(
        self, command: list[str], folder: Path, made: Path, programs: tuple[str, ...]
    ) -> processes.Result:
        with self.spent.shares.take(compiler.COMPILE.cpu_seconds) as seconds:
            limits = compiler.COMPILE._replace(cpu_seconds=seconds)
            result = compiler.run(command, folder, self.box, made, programs, limits)
            self.spent.seconds += result.cpu_seconds
        return result
