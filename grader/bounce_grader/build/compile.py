"""Compiles the parts of a submission and its helpers (its other sources) in a box; or takes their
objects from a cache, where each is stored under a hash of everything that it was made from."""

import hashlib
import os
import re
import shutil
import time
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from functools import cache, partial
from pathlib import Path

from bounce_grader.build import toolchain
from bounce_grader.build.errors import Built
from bounce_grader.build.toolchain import HELPERS_BYTES, Work
from bounce_grader.common.errors import KitError
from bounce_grader.common.files import digest, temporary_folder, write_whole
from bounce_grader.common.parallel_map import parallel_map
from bounce_grader.common.paths import BUILD, CACHE, RUNNER, SOURCES
from bounce_grader.sandbox.box import Box
from bounce_grader.sandbox.budget import Overrun
from bounce_grader.submission.submission import Submission

HELPERS_SECONDS = 30  # of CPU time, for all helpers of a submission together
INTERPRETER = b"\0.interp\0"  # among the names of an object's sections
# Change it to invalidate all objects.
FORMAT = "a file of its own from a process of its own, with its digest"
KEPT_BYTES = 16 << 20  # in each of the 256 folders
DIGEST = 32  # bytes
MADE = {".pch", ".gch", ".o", ".txt", ".hpp"}  # what submissions are built with
IN_USE = 3600  # seconds; every grading is over by then


@contextmanager
def compiled(taken: Submission, box: Box, jobs: int = 1) -> Iterator[Work]:
    """The work on a submission, in a temporary folder of its own."""
    with temporary_folder() as name:
        box.give(Path(name))
        yield compile_all(Work(taken, Path(name), box, jobs))


def compile_all(work: Work) -> Work:
    """Compiles every part and then every helper by itself, in folders inside of the work's."""
    taken, box, jobs = work.taken, work.box, work.jobs
    unnamed = _unnamed_sources(taken)
    parts = parallel_map(partial(_built, work, unnamed), taken.parts.values(), jobs)
    limited = box.budget.part(HELPERS_SECONDS, whose="the compiling of helpers")
    helping = work._replace(box=box._replace(budget=limited))
    sizes: list[int] = []

    def helper(file: str) -> Built:
        if sum(sizes) > HELPERS_BYTES:
            most = f"the helpers' objects take more than {HELPERS_BYTES >> 20} MB"
            return Built(None, f"{file} wasn't compiled: {most}")
        made = _built(helping, unnamed, file)
        sizes.append(made.path.stat().st_size if made.path else 0)
        return made

    helpers = parallel_map(helper, taken.helpers, jobs)
    return work._replace(parts=dict(zip(taken.parts, parts)), helpers=helpers)


def _unnamed_sources(taken: Submission) -> set[str]:
    """The sources whose name occurs in no file, so that none can include them. Empty if a file may
    put a name together from pieces."""
    text = b"\0".join(taken.files.values())
    if re.search(rb"##|%:%:|\\\r?\n", text):
        return set()
    sources = {*taken.helpers, *taken.parts.values()}
    return {name for name in sources if os.fsencode(Path(name).name) not in text}


def _built(work: Work, unnamed: set[str], file: str) -> Built:
    """Compiles a file, unless its object is in the cache; by g++ what clang rejects. The compiler
    sees, and the cache's key covers, no other source that is `unnamed`, so that the object stays
    valid when other parts change."""
    taken, box = work.taken, work.box
    names = sorted(taken.files.keys() - (unnamed - {file}))
    name = name_of(work, file, names)
    if there := stored(name):
        return Built(there)
    folder, made = work.folder / f"{SOURCES}-{name[:16]}", work.folder / f"{name[:16]}.o"
    taken.write_to(folder, names)
    box.give(folder)
    try:
        first = result = toolchain.run(toolchain.clang(work, file), folder, box, made)
        if not first.ok and not toolchain.ran_out_of_time(first) and not first.flooded:
            result = toolchain.run(toolchain.gcc(work, file), folder, box, made, by_gcc=True)
        size = made.stat().st_size
        if not result.ok or not size:
            return toolchain.compile_problem(first, file)
        if size > toolchain.LARGEST_OBJECT:
            return toolchain.too_large(file)
        data = made.read_bytes()
        if INTERPRETER in data:
            return Built(None, f"{file} names a program to start it with (a section .interp)")
        return Built(store(data, name))
    except Overrun as overrun:
        return Built(None, f"{file} wasn't compiled: {overrun}")
    finally:
        # At once: those of all files together may not fit into the temporary folder.
        shutil.rmtree(folder)
        made.unlink(missing_ok=True)


# --- the cache ---


def name_of(work: Work, file: str, names: Iterable[str]) -> str:
    """The cache key of an object: a hash of all that it is made from, the toolchain and FORMAT."""
    taken, kind = work.taken, work.box.kind
    made_from = [FORMAT, toolchain_digest(), file, kind, work.kind, taken.include_folders]
    texts = [(name, taken.files[name]) for name in names]
    return digest(made_from, texts)


@cache
def toolchain_digest() -> str:
    """A digest of the flags, the precompiled headers and the kit's own objects."""
    if not (RUNNER / "graded.pch").exists():
        raise KitError("the kit isn't built: run it as ./kit, which builds what is missing")
    if not os.access(BUILD, os.W_OK):
        whose = f"{BUILD} belongs to {BUILD.owner()}, who alone can grade with it"
        copy = "copy the kit to a folder of your own, and run it there"
        raise KitError(f"the kit's folder {whose}: {copy}")
    files = sorted(path for path in RUNNER.iterdir() if path.suffix in MADE)  # no running build's
    stamps = [(path.name, path.stat().st_mtime_ns) for path in files]
    return digest(str(RUNNER), stamps)


def place_of(name: str) -> Path:
    return CACHE / name[:2] / name[2:]


def stored(name: str) -> Path | None:
    """The object, if it is there and whole: a power loss may leave half of it. Marks it as used."""
    path = place_of(name)
    try:
        os.utime(path)
        data = path.read_bytes()
    except FileNotFoundError:
        return None
    return path if hashlib.sha256(data[:-DIGEST]).digest() == data[-DIGEST:] else None


def contents_of(stored: Path) -> bytes:
    """What was stored there."""
    return stored.read_bytes()[:-DIGEST]


def store(data: bytes, name: str) -> Path:
    """Writes an object for concurrent gradings to share. Its digest follows; linkers don't read
    that far."""
    path = place_of(name)
    forget_old(path.parent)
    whole = data + hashlib.sha256(data).digest()
    write_whole(path, whole, mode=0o644)  # a box reads it as another user
    return path


def forget_old(folder: Path) -> None:
    """Removes the objects that weren't used for longest, but none that a grading may be using."""
    kept = 0
    with suppress(FileNotFoundError):  # another grading removed one first
        used = [(file.stat().st_mtime, file.stat().st_size, file) for file in folder.iterdir()]
        for time_of_use, size, file in sorted(used, reverse=True):
            kept += size
            if kept > KEPT_BYTES and time.time() - time_of_use > IN_USE:
                file.unlink()
