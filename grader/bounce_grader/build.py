"""Compiles the parts of a submission one by one and links them with the runner, in a box."""

import hashlib
import os
import re
import shlex
import time
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from bounce_grader import processes
from bounce_grader.box import PROGRAMS, Box
from bounce_grader.errors import KitError
from bounce_grader.manifest import Part
from bounce_grader.paths import CACHE, CONTRACT, RUNNER, SOURCES
from bounce_grader.submission import Submission

COMPILE = processes.Limits(cpu_seconds=15, wall_seconds=120, memory=2 << 30, file_size=64 << 20)
LINK = processes.Limits(cpu_seconds=10, wall_seconds=60, memory=2 << 30, file_size=64 << 20)
LARGEST_OBJECT = 8 << 20
HELPERS_SECONDS = 30  # of CPU time, for all helpers of a submission
KEPT_IN_A_FOLDER = 64  # objects, in each of 256 folders
KEPT_BYTES = 16 << 20  # likewise
IN_USE = 3600  # seconds, in which every grading comes to its end
RUNNER_OBJECTS = ("runner", "channel", "crash", "solve_lcp", "render")
# First what is checked: of functions that are in several objects, the linker takes the first.
KIT_OBJECTS = ("prelude", *RUNNER_OBJECTS)

SANITIZERS = ("-fsanitize=address,undefined", "-fno-sanitize-recover=all")
CHECKED_LINK = (
    "-no-pie",
    "-static-libasan",
    "-static-libubsan",
    "-static-libstdc++",
    "-static-libgcc",
)

# For a compiler whose assembler can't write there by itself.
TO_STANDARD_OUTPUT = [
    *("/bin/sh", "-c"),
    'file=$(mktemp) && "$@" -o "$file" && cat "$file"; status=$?; rm -f "$file"; exit $status',
    "sh",
]


@dataclass(frozen=True)
class Built:
    """An object file or a runner; or one sentence that says why there is none."""

    path: Path | None
    problem: str = ""


@dataclass(frozen=True)
class Objects:
    parts: dict[int, Built]
    helpers: dict[str, Built]


def compile_all(
    submission: Submission, work: Path, box: Box, jobs: int, timed: bool = False
) -> Objects:
    """Every part and helper by itself, in folders of their own in the folder `work`. What is
    `timed` is built as a program is that somebody uses, without checks."""
    spent: list[float] = []  # by helpers, in seconds

    def helper(file: str) -> Built:
        if sum(spent) > HELPERS_SECONDS:
            return Built(None, f"{file} wasn't compiled: the helpers took {HELPERS_SECONDS} s")
        return _Compiling(file, submission, work, box, timed, spent).built()

    with ThreadPoolExecutor(jobs) as pool:
        parts = {
            number: pool.submit(_Compiling(file, submission, work, box, timed).built)
            for number, file in submission.parts.items()
        }
        helpers = {file: pool.submit(helper, file) for file in submission.helpers}
        return Objects(
            {n: built.result() for n, built in parts.items()},
            {f: built.result() for f, built in helpers.items()},
        )


@dataclass(frozen=True)
class _Compiling:
    """Of one file."""

    file: str
    submission: Submission
    work: Path
    box: Box
    timed: bool
    spent: list[float] = field(default_factory=list)  # CPU seconds, to add to

    def built(self) -> Built:
        """Compiles where the object doesn't exist yet. The compiler sees the files that name the
        object, and no other: first those that a look at the text says it needs, so that an object
        outlives changes elsewhere; and where it misses one, all."""
        needed, everything = _needed(self.file, self.submission), sorted(self.submission.files)
        if needed != everything:
            built = self._seeing(needed, more=True)
            if built.path or built.problem:
                return built
        return self._seeing(everything, more=False)

    def _seeing(self, names: list[str], more: bool) -> Built:
        """Neither an object nor a problem where a file is missed and `more` could be seen."""
        digest = _digest(self.file, names, self.submission, self.box, self.timed)
        if _is_kept(_cached(digest)):
            return Built(_cached(digest))
        folder = self.work / f"{SOURCES}-{digest[:16]}"
        self.submission.write_to(folder, names)
        self.box.give(folder)
        first = result = self._run(_clang(self.file, self.submission, self.timed), folder, ())
        if more and _misses_a_file(first):
            return Built(None)
        if not first.ok and not _ran_out_of_time(first):
            gcc = _gcc(self.file, self.submission, self.timed)
            result = self._run(gcc, folder, PROGRAMS)
        if result.ok and result.out:
            return Built(_store(result.out, _cached(digest)))
        return Built(None, compile_problem(first, self.file))

    def _run(self, command: list[str], folder: Path, programs: tuple[str, ...]) -> processes.Result:
        prefix = self.box.to_build(folder, [CONTRACT, RUNNER], programs)
        result = processes.run([*prefix, *command], COMPILE, cwd=folder, out_cap=LARGEST_OBJECT)
        self.spent.append(result.cpu_seconds)
        _require_a_compiler(result, COMPILE)
        return result


def _require_a_compiler(result: processes.Result, limits: processes.Limits) -> None:
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


def _misses_a_file(result: processes.Result) -> bool:
    """As the compilers and their assemblers say it."""
    says = r"not found|No such file|[Cc]ould not find|can't open"
    return not result.ok and re.search(says, result.err) is not None


def _source(file: str, submission: Submission) -> list[str]:
    includes = [f"-I{name}" for name in submission.include_folders]
    return [*includes, "-Dmain=submitted_main", "-x", "c++", "-c", file]


def _clang(file: str, submission: Submission, timed: bool) -> list[str]:
    flags, prelude = ("speed_flags", "speed") if timed else ("clang_flags", "prelude")
    clang = [compiler(), f"@{RUNNER / flags}.txt", "-include-pch", str(RUNNER / f"{prelude}.pch")]
    return [*clang, *_source(file, submission), "-o", "-"]


def _gcc(
    file: str, submission: Submission, timed: bool = False, flags: Iterable[str] = ()
) -> list[str]:
    """For what clang refuses: what a student's own compiler takes must count."""
    kind = "gcc_speed_flags" if timed else "gcc_flags"
    gcc = [*TO_STANDARD_OUTPUT, "/usr/bin/g++", f"@{RUNNER / kind}.txt", *flags]
    return [*gcc, "-include", str(RUNNER / "prelude.hpp"), *_source(file, submission)]


def _needed(file: str, submission: Submission) -> list[str]:
    """The file, all headers, and the sources that some file names, as in #include "helper.cpp"."""
    sources = {*submission.helpers, *submission.parts.values()}

    def is_named(name: str) -> bool:
        base = os.fsencode(Path(name).name)
        return any(base in text for text in submission.files.values())

    return sorted(n for n in submission.files if n == file or n not in sources or is_named(n))


def _digest(file: str, names: Iterable[str], submission: Submission, box: Box, timed: bool) -> str:
    """Names an object: the file, what can be included, and what it is built with, and where."""
    words = [file, box.kind, str(timed), *submission.include_folders]
    digest = hashlib.sha256(_toolchain_digest() + os.fsencode("\0".join(words)))
    for name in names:
        text = submission.files[name]
        digest.update(os.fsencode(f"\0{name}\0{len(text)}\0") + text)
    return digest.hexdigest()


@cache
def _toolchain_digest() -> bytes:
    """The flags, the precompiled headers and the kit's own objects, which runners are linked with."""
    if not (RUNNER / "prelude.pch").exists():
        raise KitError("the kit isn't built: run it as ./kit, which builds what is missing")
    digest = hashlib.sha256(str(RUNNER).encode())
    for path in sorted(RUNNER.iterdir()):
        digest.update(f"{path.name} {path.stat().st_mtime_ns}\0".encode())
    return digest.digest()


@cache
def compiler() -> str:
    return (RUNNER / "compiler.txt").read_text().strip()


def _cached(digest: str) -> Path:
    return CACHE / digest[:2] / digest[2:]


def _is_kept(object_file: Path) -> bool:
    """And stays so for as long as a grading takes."""
    try:
        os.utime(object_file)
    except FileNotFoundError:
        return False
    return True


def _store(data: bytes, path: Path) -> Path:
    """Written whole or not at all, so that gradings side by side can share it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    _forget_old(path.parent)
    temporary = path.with_suffix(f".{os.getpid()}.{id(data)}")
    temporary.write_bytes(data)
    temporary.chmod(0o644)  # whatever the umask: a box reads it as somebody else
    temporary.replace(path)
    return path


def _forget_old(folder: Path) -> None:
    """Keeps the newest objects, and those that a grading side by side may be about to link."""
    kept = bytes_kept = 0
    for file in sorted(folder.iterdir(), key=_last_used, reverse=True):
        with suppress(FileNotFoundError):  # where another grading was quicker
            kept, bytes_kept = kept + 1, bytes_kept + file.stat().st_size
            too_much = kept > KEPT_IN_A_FOLDER or bytes_kept > KEPT_BYTES
            if too_much and time.time() - _last_used(file) > IN_USE:
                file.unlink()


def _last_used(file: Path) -> float:
    try:
        return file.stat().st_mtime
    except FileNotFoundError:
        return 0.0


def link_together(objects: Objects, runner: Path, box: Box, timed: bool = False) -> Built:
    """One runner with all of the submission's own parts; where it is timed, without the prelude's
    code, which is checked and so slower than what the parts bring themselves."""
    kit = RUNNER_OBJECTS if timed else KIT_OBJECTS
    return _link([b.path for b in _all(objects)], [], runner, box, kit=kit)


def link_alone(part: Part, objects: Objects, runner: Path, box: Box) -> Built:
    """A runner with one part; what earlier parts it calls is asked of the judge.

    Helpers that another part's file defines are found in a second try, in which the given parts
    still come first.
    """
    own = [objects.parts[part.number].path, *(b.path for b in objects.helpers.values())]
    given = _given(part)
    alone = _link(own, given, runner, box)
    others = [b.path for number, b in objects.parts.items() if number != part.number and b.path]
    if alone.path or not others:
        return alone
    several = ("--allow-multiple-definition",)
    second = _link(own, [*given, *map(str, others)], runner, box, several)
    return second if second.path else alone


def checked_alone(part: Part, submission: Submission, work: Path, box: Box) -> Built:
    """A runner with one part, built with g++'s sanitizers, as link_alone would make it."""
    sources = work / SOURCES
    submission.write_to(sources)
    box.give(sources)
    objects: list[Path] = []
    for file in [submission.parts[part.number], *submission.helpers]:
        result = processes.run(
            [*box.to_build(sources, [CONTRACT, RUNNER]), *_gcc(file, submission, flags=SANITIZERS)],
            COMPILE,
            cwd=sources,
        )
        if not result.ok:
            return Built(None, compile_problem(result, file))
        objects.append(work / f"checked{part.number}-{len(objects)}.o")
        objects[-1].write_bytes(result.out)
        objects[-1].chmod(0o644)
    kit = [str(RUNNER / f"{name}.o") for name in (*RUNNER_OBJECTS, "sanitizers")]
    command = [*TO_STANDARD_OUTPUT, "/usr/bin/g++", *SANITIZERS, *CHECKED_LINK]
    command += [*kit, *map(str, objects), *_given(part)]
    result = processes.run(box.to_build(RUNNER, [RUNNER, *objects]) + command, LINK, cwd=RUNNER)
    if not result.ok:
        return Built(None, link_problem(result))
    runner = work / f"checked{part.number}"
    runner.write_bytes(result.out)
    runner.chmod(0o755)
    return Built(runner)


def _given(part: Part) -> list[str]:
    if not part.has_earlier_parts:
        return []
    return [str(RUNNER / f"given_part{n}.o") for n in range(1, part.number)]


def _all(objects: Objects) -> Iterable[Built]:
    return [*objects.parts.values(), *objects.helpers.values()]


def _link(
    own: Iterable[Path | None],
    more: list[str],
    runner: Path,
    box: Box,
    flags: tuple[str, ...] = (),
    kit: tuple[str, ...] = KIT_OBJECTS,
) -> Built:
    files = [str(path) for path in own if path]
    given = [str(RUNNER / f"{name}.o") for name in kit]
    command = _link_command([*flags, *given, *files, *more])
    visible = [Path(word) for word in files + more if word.startswith(str(CACHE))]
    prefix = box.to_build(RUNNER, visible, programs=())
    result = processes.run(prefix + command, LINK, cwd=RUNNER)
    _require_a_compiler(result, LINK)
    if result.ok and result.out:
        runner.write_bytes(result.out)
        runner.chmod(0o755)
        return Built(runner)
    return Built(None, link_problem(result))


def _link_command(words: list[str]) -> list[str]:
    """What clang would have the linker do with these words, written to standard output."""
    command = shlex.split((RUNNER / "link_command.txt").read_text())
    place = command.index("OBJECTS")
    return [*command[:place], *words, *command[place + 1 :]]


def _ran_out_of_time(result: processes.Result) -> bool:
    return result.too_long or result.code in (-9, -24, 128 + 9, 128 + 24)


def compile_problem(result: processes.Result, file: str) -> str:
    """The compiler's first error, in one line, with the submission's own file and line."""
    if result.flooded:
        return f"{file} makes an object of more than {LARGEST_OBJECT >> 20} MB"
    if _ran_out_of_time(result):
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


def link_problem(result: processes.Result) -> str:
    """What the linker misses, or has twice, in one line."""
    missing = _linker(r"undefined symbol: (.*)\n>>> referenced by (.+?):(\d+)", result)
    if missing:
        name, file, line = missing.groups()
        return f"{file}:{line} uses {name}, which no file that compiles defines"
    missing = _linker(r"undefined symbol: (.*)", result)
    if missing:
        return f"{missing.group(1)} is used, but no file that compiles defines it"
    twice = _linker(r"duplicate symbol: (.*)", result)
    if twice:
        return f"{twice.group(1)} is defined in two files"
    lines = result.err.strip().splitlines()
    return lines[0] if lines else "the parts could not be linked"


def _linker(says: str, result: processes.Result) -> re.Match[str] | None:
    """From the start of a line, so that long lines of a submission's own words are read once."""
    return re.search(rf"^ld\.lld: error: {says}", result.err, re.MULTILINE)
