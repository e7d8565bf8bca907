"""Compiles the parts of a submission and the sources beside them, in a box."""

from pathlib import Path
from typing import NamedTuple

from bounce_grader import compiler, kept, processes, together
from bounce_grader.box import PROGRAMS, Box
from bounce_grader.paths import SOURCES
from bounce_grader.side_by_side import each
from bounce_grader.submission import Submission

HELPERS_SECONDS = 30  # of CPU time, for all helpers of a submission


class Built(NamedTuple):
    """An object file or a runner; or one sentence that says why there is none."""

    path: Path | None
    problem: str = ""


class Objects(NamedTuple):
    parts: dict[int, Built]
    helpers: dict[str, Built]
    solvers: bool = True  # whether one may have been compiled against solvers.hpp


def compile_all(
    submission: Submission, work: Path, box: Box, jobs: int, timed: bool = False
) -> Objects:
    """Every part and helper by itself, in folders inside of the folder `work`. What is `timed` is
    built as a program is that somebody uses, without checks."""
    if not timed:
        together.compile_missing(submission, work, box, jobs)
    helpers, spent = submission.helpers, [0.0]  # by helpers, in seconds

    def compiled(file: str) -> Built:
        if file not in helpers:
            return _Compiling(file, submission, work, box, timed, []).built()
        if sum(spent) > HELPERS_SECONDS:
            return Built(None, f"{file} wasn't compiled: the helpers took {HELPERS_SECONDS} s")
        return _Compiling(file, submission, work, box, timed, spent).built()

    files = [*submission.parts.values(), *helpers]
    built = dict(zip(files, each(compiled, files, jobs)))
    return Objects(
        {number: built[file] for number, file in submission.parts.items()},
        {file: built[file] for file in helpers},
        compiler.header_of(submission.files, submission) == "solvers",
    )


class _Compiling(NamedTuple):
    """Of one file."""

    file: str
    submission: Submission
    work: Path
    box: Box
    timed: bool
    spent: list[float]  # CPU seconds, to add to

    def built(self) -> Built:
        """Compiles where the object doesn't exist yet. The compiler sees the files that name the
        object, and no other: first those that a look at the text says it needs, so that an object
        outlives changes elsewhere; and where it misses one, all."""
        needed, everything = kept.needed(self.file, self.submission), sorted(self.submission.files)
        if needed != everything:
            built = self._seeing(needed, more=True)
            if built.path or built.problem:
                return built
        return self._seeing(everything, more=False)

    def _seeing(self, names: list[str], more: bool) -> Built:
        """Neither an object nor a problem where a file is missed and `more` could be seen."""
        name = kept.name_of(self.file, names, self.submission, self.box, self.timed)
        place = kept.place(name)
        if kept.is_there(place):
            return Built(place)
        folder = self.work / f"{SOURCES}-{name[:16]}"
        self.submission.write_to(folder, names)
        self.box.give(folder)
        header = "speed" if self.timed else compiler.header_of(names, self.submission)
        first = result = self._run(compiler.clang(self.file, self.submission, header), folder, ())
        if more and compiler.misses_a_file(first):
            return Built(None)
        if not first.ok and not compiler.ran_out_of_time(first):
            gcc = compiler.gcc(self.file, self.submission, self.timed)
            result = self._run(gcc, folder, PROGRAMS)
        if result.ok and result.out:
            return Built(kept.store(result.out, place))
        return Built(None, compiler.compile_problem(first, self.file))

    def _run(self, command: list[str], folder: Path, programs: tuple[str, ...]) -> processes.Result:
        result = compiler.run(command, folder, self.box, programs)
        self.spent.append(result.cpu_seconds)
        return result
