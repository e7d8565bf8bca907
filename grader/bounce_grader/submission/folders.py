"""Lists and reads the files of a folder. It follows no link, opens no pipe or device, and can't be
led elsewhere if the folder changes meanwhile."""

import os
import stat
from collections.abc import Iterator
from contextlib import AbstractContextManager, ExitStack
from itertools import islice
from pathlib import Path

from bounce_grader.common.escaping import printable_name
from bounce_grader.submission.entry import MOST_ENTRIES, Entry, readable, too_many

# Non-blocking: a pipe that replaced a file must not make us wait.
SAFELY = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC
DEEPEST = 100


def entries(path: Path, stack: ExitStack) -> Iterator[Entry]:
    """The entries, to be read while the stack is open. Raises UsageError if it can't list them."""
    with _readable(path):
        top = os.open(path, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
    stack.callback(os.close, top)
    folders: list[tuple[str, ...]] = [()]
    seen = 0
    while folders:
        folder = folders.pop()
        with _readable(path, folder):
            children = _children(top, folder)
        for child, status in children:
            seen += 1
            if seen > MOST_ENTRIES:
                raise too_many(path)
            inside = (*folder, child)
            if not stat.S_ISDIR(status.st_mode):
                yield _entry(path, top, inside, status)
            elif not child.startswith(".git") and len(inside) <= DEEPEST:
                folders.append(inside)


def _children(top: int, folder: tuple[str, ...]) -> list[tuple[str, os.stat_result]]:
    here = _open(top, folder)
    try:
        with os.scandir(here) as scan:
            some = islice(scan, MOST_ENTRIES + 1)
            return sorted((child.name, child.stat(follow_symlinks=False)) for child in some)
    finally:
        os.close(here)


def _entry(path: Path, top: int, inside: tuple[str, ...], status: os.stat_result) -> Entry:
    def read(limit: int) -> bytes:
        with _readable(path, inside), open(_open(top, inside), "rb") as stream:
            if not stat.S_ISREG(os.fstat(stream.fileno()).st_mode):
                raise FileNotFoundError(0, "it changed while it was read")
            return stream.read(limit)

    return Entry("/".join(inside), not stat.S_ISREG(status.st_mode), read)


def _open(top: int, inside: tuple[str, ...]) -> int:
    """Opens folder by folder, so that no folder on the path can have become a link."""
    here = os.dup(top)
    for part in inside:
        try:
            following = os.open(part, SAFELY, dir_fd=here)
        finally:
            os.close(here)
        here = following
    return here


def _readable(path: Path, inside: tuple[str, ...] = ()) -> AbstractContextManager[None]:
    return readable(printable_name("/".join((str(path), *inside))))
