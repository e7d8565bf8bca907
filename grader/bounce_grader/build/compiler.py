"""Runs the compilers in a box, and tells whose fault it is if one makes no object."""

from collections.abc import Iterable
from pathlib import Path

from bounce_grader.build.errors import Built, of_compiler
from bounce_grader.common.errors import KitError
from bounce_grader.common.escaping import printable_text, terminal
from bounce_grader.common.paths import CONTRACT, RUNNER
from bounce_grader.sandbox.box import Box, PROGRAMS
from bounce_grader.sandbox.processes import Limits, Result
from bounce_grader.submission.submission import Submission

COMPILE = Limits(15, 120, memory=2 << 30, file_size=64 << 20)
LARGE = 640 << 20  # bytes of a compiler's memory; for an honest part it takes up to 470 MB
LARGEST_OBJECT = 8 << 20
MAIN = b"_Z14submitted_main"  # in an object whose source defines main, by its name for the linker


def run(command: list[str], folder: Path, box: Box, made: Path, by_gcc: bool = False) -> Result:
    """Runs a compiler in the folder of a submission's sources; it writes the object to the file
    `made`. Raises KitError if the box or the machine failed, and not the submission."""
    prefix = box.to_build(folder, [CONTRACT, RUNNER], PROGRAMS if by_gcc else ())
    result = box.run([*prefix, *command], COMPILE, cwd=folder, output=made)
    require_compiler_ran(result)
    # A program that g++ starts and that fails once it has begun gives g++ another exit status.
    if by_gcc and result.code in (1, 125):
        raise KitError("g++ couldn't start its compiler; is the machine short of processes?")
    return result


def require_compiler_ran(result: Result) -> None:
    """Raises KitError if the box or the machine kept the compiler from running. This is decided by
    what the box reports on a descriptor that no compiler has, and by signals and times; never by
    text, because a submission can make a compiler print any text."""
    if not result.boxed:
        why = terminal(printable_text(result.err.strip().partition("\n")[0], 200))
        raise KitError(f"a box couldn't be made: {why or 'it ended'}")
    if _killed_early(result) and result.peak < LARGE:
        raise KitError("the compiler was killed from outside; is the machine short of memory?")
    if result.too_long and result.cpu_seconds < result.cpu_limit / 2:
        raise KitError("a compiler hardly ran: the machine was too busy, or it was stopped")


def _killed_early(result: Result) -> bool:
    """Whether it was killed well before its limit of CPU time. The system enforces that limit in
    ticks but reports times in nanoseconds, so a process at its limit can seem to be below it."""
    return result.killed and result.cpu_seconds < 0.7 * result.cpu_limit


def clang(file: str, taken: Submission, timed: bool = False) -> list[str]:
    flags, header = ("speed_flags", "speed") if timed else ("clang_flags", "prelude")
    command = [compiler(), f"@{RUNNER / flags}.txt", "-include-pch", str(RUNNER / f"{header}.pch")]
    return [*command, *_source(file, taken)]


def gcc(
    file: str, taken: Submission, box: Box, timed: bool = False, flags: Iterable[str] = ()
) -> list[str]:
    """Used for what clang rejects: code that a student's own compiler accepts must count. If a
    signal ends a program that g++ starts, the exit status tells which."""
    kind = "gcc_speed_flags" if timed else "gcc_flags"
    command = ["/usr/bin/g++", "-wrapper", f"{box.enter},step", "-pass-exit-codes"]
    command += [f"@{RUNNER / kind}.txt", *flags, "-include", str(RUNNER / "prelude.hpp")]
    return [*command, *_source(file, taken)]


def _source(file: str, taken: Submission) -> list[str]:
    folders = [f"-I{name}" for name in taken.include_folders]
    return [*folders, "-Dmain=submitted_main", "-x", "c++", "-c", file, "-o", "OUTPUT"]


def compiler() -> str:
    return (RUNNER / "compiler.txt").read_text().strip()


def ran_out_of_time(result: Result) -> bool:
    return result.too_long or result.code in (-9, -24, 128 + 9, 128 + 24)


def too_large(file: str) -> Built:
    return Built(None, f"{file} makes an object of more than {LARGEST_OBJECT >> 20} MB")


def compile_problem(result: Result, file: str) -> Built:
    """Why a compiler made no object of the file."""
    if _killed_early(result):
        return Built(None, f"{file} takes more memory to compile than there is")
    if ran_out_of_time(result):
        return Built(None, f"{file} took more than {COMPILE.cpu_seconds} s to compile")
    if result.code in (-25, 128 + 25):
        return too_large(file)
    if result.flooded:
        words = "makes the compiler print without end: look for lines of assembler in it"
        return Built(None, f"{file} {words}")
    return of_compiler(result.err, file)
