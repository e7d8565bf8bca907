"""A cache of object files. Each is stored under a hash of everything that it was made from."""

import hashlib
import os
import re
import time
from collections.abc import Iterable
from contextlib import suppress
from functools import cache
from pathlib import Path

from bounce_grader.common.errors import KitError
from bounce_grader.common.paths import BUILD, CACHE, RUNNER
from bounce_grader.sandbox.box import Box
from bounce_grader.submission.submission import Submission

# Change it to invalidate all objects.
FORMAT = "a file of its own from a process of its own, with its digest"
KEPT_BYTES = 16 << 20  # in each of the 256 folders
DIGEST = 32  # bytes
MADE = {".pch", ".gch", ".o", ".txt", ".hpp"}  # what submissions are built with
IN_USE = 3600  # seconds; every grading is over by then


def named_sources(taken: Submission) -> frozenset[str]:
    """The sources that some file may include: whose names occur in one, as in #include "helper.cpp";
    all of them where a name may be put together of pieces or goes on in another line."""
    text = b"\0".join(taken.files.values())
    sources = frozenset([*taken.helpers, *taken.parts.values()])
    if re.search(rb"##|%:%:|\\\r?\n", text):
        return sources
    return frozenset(name for name in sources if os.fsencode(Path(name).name) in text)


def needed(file: str, taken: Submission, named: frozenset[str]) -> list[str]:
    """What is needed to compile a file: itself, all headers, and the named sources."""
    sources = {*taken.helpers, *taken.parts.values()} - named
    return sorted(n for n in taken.files if n == file or n not in sources)


def name_of(file: str, names: Iterable[str], taken: Submission, box: Box, timed: bool) -> str:
    """The cache key of an object: a hash of all that it is made from, the toolchain and FORMAT."""
    made_from = [FORMAT, toolchain_digest(), file, box.kind, timed, taken.include_folders]
    texts = [(name, taken.files[name]) for name in names]
    return hashlib.sha256(repr((made_from, texts)).encode()).hexdigest()


@cache
def toolchain_digest() -> bytes:
    """A digest of the flags, the precompiled headers and the kit's own objects."""
    if not (RUNNER / "prelude.pch").exists():
        raise KitError("the kit isn't built: run it as ./kit, which builds what is missing")
    if not os.access(BUILD, os.W_OK):
        raise KitError(
            f"the kit's folder {BUILD} belongs to {BUILD.owner()}, who alone can grade with it: "
            "copy the kit to a folder of your own, and run it there"
        )
    files = sorted(path for path in RUNNER.iterdir() if path.suffix in MADE)  # no running build's
    stamps = [(path.name, path.stat().st_mtime_ns) for path in files]
    return hashlib.sha256(repr((str(RUNNER), stamps)).encode()).digest()


def place(name: str) -> Path:
    return CACHE / name[:2] / name[2:]


def is_there(object_file: Path) -> bool:
    """Whether the object exists, and is what was stored: a machine that lost its power may have
    kept half of it. Marks it as used, so that it stays for this grading."""
    try:
        os.utime(object_file)
        data = object_file.read_bytes()
    except FileNotFoundError:
        return False
    return _digest(data[:-DIGEST]) == data[-DIGEST:]


def store(data: bytes, path: Path) -> Path:
    """Writes an object, whole or not at all, so that concurrent gradings can share it. Its digest
    follows it; no linker looks beyond an object's end."""
    path.parent.mkdir(parents=True, exist_ok=True)
    forget_old(path.parent)
    temporary = path.with_suffix(f".{os.getpid()}.{id(data)}")
    temporary.write_bytes(data + _digest(data))
    temporary.chmod(0o644)  # whatever the umask: a box reads it as another user
    temporary.replace(path)
    return path


def _digest(data: bytes) -> bytes:
    return hashlib.sha256(data).digest()


def forget_old(folder: Path) -> None:
    """Removes the objects that weren't used for longest, but none that a grading may be using."""
    kept = 0
    with suppress(FileNotFoundError):  # another grading removed one first
        used = [(file.stat().st_mtime, file.stat().st_size, file) for file in folder.iterdir()]
        for time_of_use, size, file in sorted(used, reverse=True):
            kept += size
            if kept > KEPT_BYTES and time.time() - time_of_use > IN_USE:
                file.unlink()
