"""The objects of earlier gradings, each under a name that says all that it was made from."""

import hashlib
import os
import time
from collections.abc import Iterable, Iterator
from contextlib import suppress
from functools import cache
from pathlib import Path

from bounce_grader.common.errors import KitError
from bounce_grader.common.paths import BUILD, CACHE, RUNNER
from bounce_grader.sandbox.box import Box
from bounce_grader.submission.submission import Submission

FORMAT = "a file of its own from a process of its own"  # another one makes another name
KEPT_IN_A_FOLDER = 64  # objects, in each of 256 folders
KEPT_BYTES = 16 << 20  # likewise
IN_USE = 3600  # seconds, in which every grading comes to its end


def named_sources(submission: Submission) -> frozenset[str]:
    """The sources that some file names, as in #include "helper.cpp"."""
    text = b"\0".join(submission.files.values())
    sources = {*submission.helpers, *submission.parts.values()}
    return frozenset(name for name in sources if os.fsencode(Path(name).name) in text)


def needed(file: str, submission: Submission, named: frozenset[str]) -> list[str]:
    """The file, all headers, and the sources that some file names."""
    sources = {*submission.helpers, *submission.parts.values()} - named
    return sorted(n for n in submission.files if n == file or n not in sources)


def name_of(file: str, names: Iterable[str], submission: Submission, box: Box, timed: bool) -> str:
    """Names an object: the file, what can be included, and what it is built with, and where, and
    how it is taken from its compiler."""
    words = [FORMAT, file, box.kind, str(timed), *submission.include_folders]
    hasher = hashlib.sha256(toolchain_digest() + os.fsencode("\0".join(words)))
    for name in names:
        text = submission.files[name]
        hasher.update(os.fsencode(f"\0{name}\0{len(text)}\0") + text)
    return hasher.hexdigest()


@cache
def toolchain_digest() -> bytes:
    """The flags, the precompiled headers and the kit's own objects, which runners are linked with."""
    if not (RUNNER / "prelude.pch").exists():
        raise KitError("the kit isn't built: run it as ./kit, which builds what is missing")
    if not os.access(BUILD, os.W_OK):
        raise KitError(
            f"the kit's folder {BUILD} belongs to {BUILD.owner()}, who alone can grade with it: "
            "copy the kit to a folder of your own, and run it there"
        )
    hasher = hashlib.sha256(str(RUNNER).encode())
    for path in sorted(RUNNER.iterdir()):
        hasher.update(f"{path.name} {path.stat().st_mtime_ns}\0".encode())
    return hasher.digest()


def place(name: str) -> Path:
    return CACHE / name[:2] / name[2:]


def is_there(object_file: Path) -> bool:
    """And stays so for as long as a grading takes."""
    try:
        os.utime(object_file)
    except FileNotFoundError:
        return False
    return True


def store(data: bytes, path: Path) -> Path:
    """Written whole or not at all, so that gradings side by side can share it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    forget_old(path.parent)
    temporary = path.with_suffix(f".{os.getpid()}.{id(data)}")
    temporary.write_bytes(data)
    temporary.chmod(0o644)  # whatever the umask: a box reads it as somebody else
    temporary.replace(path)
    return path


def forget_old(folder: Path) -> None:
    """Keeps the newest objects, and those that a grading side by side may be about to link."""
    kept = bytes_kept = 0
    for _, size, file in sorted(_used(folder), reverse=True):
        kept, bytes_kept = kept + 1, bytes_kept + size
        if kept > KEPT_IN_A_FOLDER or bytes_kept > KEPT_BYTES:
            with suppress(FileNotFoundError):  # where another grading was quicker
                if time.time() - os.stat(file).st_mtime > IN_USE:
                    os.unlink(file)


def _used(folder: Path) -> Iterator[tuple[float, int, str]]:
    """When each object was last used, and its size."""
    with os.scandir(folder) as entries:
        for entry in entries:
            with suppress(FileNotFoundError):
                status = entry.stat()
                yield status.st_mtime, status.st_size, entry.path
