"""The compilers' commands, and what they say, in a box."""

import re
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path

from bounce_grader import processes
from bounce_grader.box import Box
from bounce_grader.errors import KitError
from bounce_grader.paths import CONTRACT, RUNNER
from bounce_grader.submission import Submission

COMPILE = processes.Limits(cpu_seconds=15, wall_seconds=120, memory=2 << 30, file_size=64 << 20)
LARGEST_OBJECT = 8 << 20

# What solvers.hpp is for: it takes longer to read, and shorter than to make what is in it.
SOLVERS = re.compile(rb"MatrixXd|VectorXd|LLT|LDLT|L[Uu]\b|Q[Rr]\b|\b(?:llt|ldlt|lu)\b")

# For a compiler whose assembler can't write there by itself.
TO_STANDARD_OUTPUT = [
    *("/bin/sh", "-c"),
    'file=$(mktemp) && "$@" -o "$file" && cat "$file"; status=$?; rm -f "$file"; exit $status',
    "sh",
]


def run(
    command: list[str], folder: Path, box: Box, programs: Iterable[str] = ()
) -> processes.Result:
    """In the folder of a submission's sources. Raises KitError where the box or the machine has
    failed, and not the submission."""
    prefix = box.to_build(folder, [CONTRACT, RUNNER], programs)
    result = processes.run([*prefix, *command], COMPILE, cwd=folder, out_cap=LARGEST_OBJECT)
    require_a_compiler(result, COMPILE)
    return result


def require_a_compiler(result: processes.Result, limits: processes.Limits) -> None:
    """Raises KitError where the box or the machine has failed, and not the submission."""
    said = result.err.partition("\n")[0]
    if result.code in (1, 125) and re.match(r"(bwrap|enter): (?!.*:\d+:\d+: )", said):
        raise KitError(f"the compiler's box couldn't be made: {said}")
    if _was_killed(result) and result.cpu_seconds < limits.cpu_seconds:
        raise KitError("the compiler was killed from outside; is the machine short of memory?")


def _was_killed(result: processes.Result) -> bool:
    """It, or what g++ has started; not by processes.run."""
    says = r"^g\+\+: fatal error: Killed signal terminated program \w+$"
    told = re.search(says, result.err, re.MULTILINE)
    stopped = result.too_long or result.flooded
    return not stopped and (result.code in (-9, 128 + 9) or told is not None)


def misses_a_file(result: processes.Result) -> bool:
    """As the compilers and their assemblers say it."""
    says = r"not found|No such file|[Cc]ould not find|can't open"
    return not result.ok and re.search(says, result.err) is not None


def header_of(names: Iterable[str], submission: Submission) -> str:
    """The name of the precompiled header for a part that is made from these files."""
    rare = any(SOLVERS.search(submission.files[name]) for name in names)
    return "solvers" if rare else "prelude"


def clang(file: str, submission: Submission, header: str) -> list[str]:
    flags = "speed_flags" if header == "speed" else "clang_flags"
    command = [compiler(), f"@{RUNNER / flags}.txt", "-include-pch", str(RUNNER / f"{header}.pch")]
    return [*command, *_source(file, submission), "-o", "-"]


def clang_of_many(
    files: Sequence[str], submission: Submission, folder: Path, header: str
) -> list[str]:
    """One start of the compiler proper, which takes the files one after the other, each by itself,
    and writes their objects in a row; with the words that clang would give it for one file."""
    words = (RUNNER / "compile_command.txt").read_text().splitlines()
    command = [re.sub("=FOLDER$", lambda _: f"={folder}", word) for word in words]
    command[command.index("-include-pch") + 1] = str(RUNNER / f"{header}.pch")
    return [*command, *_includes(submission), *files]


def gcc(
    file: str, submission: Submission, timed: bool = False, flags: Iterable[str] = ()
) -> list[str]:
    """For what clang refuses: what a student's own compiler takes must count."""
    kind = "gcc_speed_flags" if timed else "gcc_flags"
    command = [*TO_STANDARD_OUTPUT, "/usr/bin/g++", f"@{RUNNER / kind}.txt", *flags]
    return [*command, "-include", str(RUNNER / "prelude.hpp"), *_source(file, submission)]


def _source(file: str, submission: Submission) -> list[str]:
    return [*_includes(submission), "-Dmain=submitted_main", "-x", "c++", "-c", file]


def _includes(submission: Submission) -> list[str]:
    return [f"-I{name}" for name in submission.include_folders]


@cache
def compiler() -> str:
    return (RUNNER / "compiler.txt").read_text().strip()


def ran_out_of_time(result: processes.Result) -> bool:
    return result.too_long or result.code in (-9, -24, 128 + 9, 128 + 24)


def compile_problem(result: processes.Result, file: str) -> str:
    """The compiler's first error, in one line, with the submission's own file and line."""
    if result.flooded:
        return f"{file} makes an object of more than {LARGEST_OBJECT >> 20} MB"
    if ran_out_of_time(result):
        return f"{file} took more than {COMPILE.cpu_seconds} s to compile"
    errors = re.findall(r"^(.+?:\d+:\d+): (?:fatal )?error: (.*)$", result.err, re.MULTILINE)
    if not errors:
        last = result.err.strip().splitlines()
        return f"{file}: {last[-1] if last else 'the compiler ended without a word'}"
    where, what = errors[0]
    said_by_eigen = re.search(r'"([A-Z_0-9]{8,})"$', what)
    if said_by_eigen:
        what = said_by_eigen.group(1).replace("_", " ").lower()
    if where.startswith("/"):
        instantiated = re.search(rf"^({re.escape(file)}:\d+):\d+: note: ", result.err, re.MULTILINE)
        asked = f", asked for at {instantiated.group(1)}" if instantiated else f" in {file}"
        return f"{what}{asked} ({Path(where).name})"
    return f"{where}: {what}"
