"""Links the objects of a submission with the runner, in a box."""

from collections.abc import Iterable
from pathlib import Path

from bounce_grader.build import compiler
from bounce_grader.build.compile import Compiled, HELPERS_BYTES
from bounce_grader.build.errors import Built, of_linker
from bounce_grader.common.manifest import Part, parts
from bounce_grader.common.paths import CACHE, RUNNER, SOURCES
from bounce_grader.sandbox.box import Box
from bounce_grader.sandbox.processes import Limits

LINK = Limits(cpu_seconds=10, wall_seconds=60, memory=2 << 30, file_size=64 << 20)
RUNNER_OBJECTS = ("runner", "channel", "crash", "solve_lcp", "render")
# The checked code comes first: of an inline function in several objects the linker takes the first.
KIT_OBJECTS = ("prelude", *RUNNER_OBJECTS)

# Without what AddressSanitizer finds, too, and what a file does that can't be opened in the box.
SANITIZERS = (
    "-fsanitize=address,undefined",
    "-fno-sanitize=alignment,null,object-size,vptr,nonnull-attribute,returns-nonnull-attribute",
    "-fno-sanitize-recover=all",
)
# Eigen allocates in another way for sanitizers, and the kit's objects free as without them.
ALLOCATES_ALIKE = "-DEIGEN_MALLOC_ALREADY_ALIGNED=1"
CHECKED_LINK = ("-no-pie", *(f"-static-lib{name}" for name in ("asan", "ubsan", "stdc++", "gcc")))


def link_together(compiled: Compiled) -> Path | None:
    """Links one runner with all of the submission's own parts; None if one is missing, or they
    don't link."""
    own = [built.path for built in (*compiled.parts.values(), *compiled.helpers)]
    is_whole = len(compiled.parts) == len(parts()) and all(own)
    name = "timed" if compiled.timed else "together"
    return _link(compiled, name, own).path if is_whole else None


def link_alone(part: Part, compiled: Compiled) -> Built:
    """Links a runner with one part; calls to earlier parts go to the judge, which answers them.

    If that fails, a second try adds the files of the other parts, which may define what this part
    needs. The given parts still come first, and duplicate definitions are allowed.
    """
    helpers = [built.path for built in compiled.helpers]
    own, name = [compiled.parts[part.number].path, *helpers, *_given(part)], f"alone{part.number}"
    alone = _link(compiled, name, own)
    others = [b.path for number, b in compiled.parts.items() if number != part.number and b.path]
    if alone.path or not (others or helpers):
        return alone
    second = _link(compiled, name, [*own, *others], "--allow-multiple-definition")
    return second if second.path else alone


def link_sanitized(part: Part, compiled: Compiled) -> Built:
    """Like link_alone, but compiles and links with g++'s sanitizers."""
    taken, work, box = compiled.taken, compiled.work, compiled.box
    sources = work / SOURCES
    taken.write_to(sources)
    box.give(sources)
    objects: list[Path] = []
    for file in [taken.parts[part.number], *taken.helpers]:
        objects.append(work / f"checked{part.number}-{len(objects)}.o")
        command = compiler.gcc(file, taken, box, flags=(*SANITIZERS, ALLOCATES_ALIKE))
        result = compiler.run(command, sources, box, objects[-1], by_gcc=True)
        if not result.ok:
            return compiler.compile_problem(result, file)
        if sum(path.stat().st_size for path in objects) > HELPERS_BYTES:
            return compiler.too_large(file)
    kit = [str(RUNNER / f"{name}.o") for name in (*RUNNER_OBJECTS, "sanitizers")]
    command = ["/usr/bin/g++", *SANITIZERS, *CHECKED_LINK, "-o", "OUTPUT"]
    command += [*kit, *map(str, [*objects, *_given(part)])]
    prefix = box.to_build(RUNNER, [RUNNER, *objects])
    return _linked(prefix + command, work / f"checked{part.number}", box)


def _given(part: Part) -> list[Path]:
    return [RUNNER / f"given_part{number}.o" for number in part.calls]


def _link(compiled: Compiled, name: str, files: Iterable[Path | None], *flags: str) -> Built:
    """Links these files with the kit's, by the linker command that clang would run. A runner that
    is timed goes without the prelude's code: its run-time checks make it slower than the parts'."""
    linked, box = [path for path in files if path], compiled.box
    kit = RUNNER_OBJECTS if compiled.timed else KIT_OBJECTS
    objects = [*flags, *(f"{RUNNER}/{name}.o" for name in kit), *map(str, linked)]
    command = (RUNNER / "link_command.txt").read_text().splitlines()
    place = command.index("OBJECTS")
    command[place : place + 1] = objects
    visible = [path for path in linked if path.is_relative_to(CACHE)]
    prefix = box.to_build(RUNNER, visible, programs=())
    return _linked(prefix + command, compiled.work / name, box)


def _linked(command: list[str], runner: Path, box: Box) -> Built:
    result = box.run(command, LINK, cwd=RUNNER, output=runner)
    compiler.require_compiler_ran(result)
    if not result.ok or not runner.stat().st_size:
        return of_linker(result.err)
    runner.chmod(0o755)
    return Built(runner)
