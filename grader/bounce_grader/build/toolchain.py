"""Runs the compilers and the linker in a box, and tells whose fault it is if one makes nothing."""

import time
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Literal, NamedTuple

from bounce_grader.build.errors import Built, of_compiler, of_linker
from bounce_grader.common.errors import KitError
from bounce_grader.common.escaping import printable_text, terminal
from bounce_grader.common.manifest import Part, parts
from bounce_grader.common.paths import CACHE, CONTRACT, RUNNER
from bounce_grader.sandbox.box import Box, PROGRAMS
from bounce_grader.sandbox.processes import Limits, Result
from bounce_grader.submission.submission import Submission

COMPILE = Limits(15, 120, memory=2 << 30, file_size=64 << 20)
LARGE = 640 << 20  # bytes of a compiler's memory; for an honest part it takes up to 470 MB
LARGEST_OBJECT = 8 << 20
PAUSES = (0, 1, 3)  # s, before each try to start g++; a program with too many threads lives 0.1 s
HELPERS_BYTES = 32 << 20  # of all helpers of a submission together; one more may be under way
MAIN = b"_Z14submitted_main"  # in an object whose source defines main, by its name for the linker
LINK = Limits(cpu_seconds=10, wall_seconds=60, memory=2 << 30, file_size=64 << 20)
RUNNER_OBJECTS = ("runner", "channel", "crash", "solve_lcp")

# What a submission is built for: as graded, to be timed, or with sanitizers. Each has its flags, its
# precompiled header, and the objects that are linked with the runner's. The checked code comes first:
# of an inline function in several objects the linker takes the first. A runner that is timed goes
# without the prelude's code, whose run-time checks make it slower than the parts'.
Kind = Literal["graded", "speed", "sanitized"]
KIT_OBJECTS = {
    "graded": ("prelude", *RUNNER_OBJECTS),
    "speed": RUNNER_OBJECTS,
    "sanitized": ("sanitized", *RUNNER_OBJECTS, "sanitizers"),
}


class Work(NamedTuple):
    """A submission that is built in a folder and run in a box; with its objects, once there are."""

    taken: Submission
    folder: Path
    box: Box
    jobs: int = 1  # at the same time
    kind: Kind = "graded"
    parts: Mapping[int, Built] = {}  # by number
    helpers: Sequence[Built] = ()


# --- compilers ---


def run(command: list[str], folder: Path, box: Box, made: Path, by_gcc: bool = False) -> Result:
    """Runs a compiler in the folder of the sources; it writes the object to the file `made`. Raises
    KitError if the box or the machine failed."""
    prefix = box.to_build(folder, [CONTRACT, RUNNER], PROGRAMS if by_gcc else ())
    for pause in PAUSES:
        time.sleep(pause)
        result = box.run([*prefix, *command], COMPILE, cwd=folder, output=made)
        require_compiler_ran(result)
        # A program that g++ starts and that fails once it has begun gives g++ another exit status;
        # 127 is that of `enter` where there is no such program.
        if not by_gcc or result.code not in (1, 125, 127):
            return result
    raise KitError("g++ couldn't start its compiler; is the machine short of processes?")


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


def clang(work: Work, file: str) -> list[str]:
    flags, header = f"@{RUNNER / work.kind}_flags.txt", f"{RUNNER / work.kind}.pch"
    return [compiler(), flags, "-include-pch", header, *_source(work, file)]


def gcc(work: Work, file: str) -> list[str]:
    """Used for what clang rejects: code that a student's own compiler accepts must count. If a
    signal ends a program that g++ starts, the exit status tells which."""
    command = ["/usr/bin/g++", "-wrapper", f"{work.box.enter},step", "-pass-exit-codes"]
    command += [f"@{RUNNER}/gcc_{work.kind}_flags.txt", "-include", f"{RUNNER}/prelude.hpp"]
    return [*command, *_source(work, file)]


def _source(work: Work, file: str) -> list[str]:
    folders = [f"-I{name}" for name in work.taken.include_folders]
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


# --- the linker ---


def link_together(work: Work) -> Path | None:
    """Links one runner from all parts; None if one is missing or they don't link."""
    own = [built.path for built in (*work.parts.values(), *work.helpers)]
    is_whole = len(work.parts) == len(parts()) and all(own)
    return _link(work, f"{work.kind}-together", own).path if is_whole else None


def link_alone(part: Part, work: Work) -> Built:
    """Links a runner with one part; calls to earlier parts go to the judge, which answers them.

    If that fails, a second try adds the files of the other parts, which may define what this part
    needs. The given parts still come first, and duplicate definitions are allowed.
    """
    helpers, name = [built.path for built in work.helpers], f"{work.kind}-alone{part.number}"
    given = [RUNNER / f"given_part{number}.o" for number in part.calls]
    own = [work.parts[part.number].path, *helpers, *given]
    alone = _link(work, name, own)
    others = [b.path for number, b in work.parts.items() if number != part.number and b.path]
    if alone.path or not (others or helpers):
        return alone
    second = _link(work, name, [*own, *others], "--allow-multiple-definition")
    return second if second.path else alone


def _link(work: Work, name: str, files: Iterable[Path | None], *flags: str) -> Built:
    """Links these files with the kit's, by the linker command that clang would run."""
    linked, box = [path for path in files if path], work.box
    kit = [f"{RUNNER}/{name}.o" for name in KIT_OBJECTS[work.kind]]
    objects = [*flags, *kit, *map(str, linked)]
    of = "sanitized_" if work.kind == "sanitized" else ""
    command = (RUNNER / f"{of}link_command.txt").read_text().splitlines()
    place = command.index("OBJECTS")
    command[place : place + 1] = objects
    visible = [path for path in linked if path.is_relative_to(CACHE)]
    runner = work.folder / name
    result = box.run(box.to_build(RUNNER, visible, ()) + command, LINK, cwd=RUNNER, output=runner)
    require_compiler_ran(result)
    if not result.ok or not runner.stat().st_size:
        return of_linker(result.err)
    runner.chmod(0o755)
    return Built(runner)
