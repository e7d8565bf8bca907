"""The unread files of a submission: what is known of one, how to read a source from it, and how to
list a folder's. No link is followed and no pipe or device opened, and nobody who changes the folder
meanwhile can lead the reader elsewhere."""

import os
import stat
from collections.abc import Callable, Iterator
from contextlib import contextmanager, ExitStack
from itertools import islice
from pathlib import Path
from typing import NamedTuple

from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import printable_name, printable_text

SOURCES = {".cpp", ".cc", ".cxx"}
HEADERS = {".hpp", ".h", ".hh", ".hxx", ".ipp", ".inl"}
MOST_ENTRIES = 5000
LARGEST_SOURCE = 1024 * 1024
# Non-blocking: a pipe that replaced a file must not make us wait.
SAFELY = os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC
DEEPEST = 100


class NotText(Exception):
    """A file can't be used as a source. The message continues a sentence after its name."""


class Entry(NamedTuple):
    """A file in a submission's folder or archive."""

    name: str  # relative, with forward slashes, without "..", never empty
    link: bool  # a link, or anything else that is no regular file
    read: Callable[[int], bytes]  # at most so many bytes


def of_bytes(name: str, data: bytes) -> Entry:
    return Entry(name, False, lambda limit: data[:limit])


def text_of(entry: Entry) -> bytes:
    """The source's bytes, converted from UTF-16 if need be. Raises NotText."""
    data = entry.read(LARGEST_SOURCE + 1)
    if len(data) > LARGEST_SOURCE:
        raise NotText("is larger than 1 MB, the most that a source file may have")
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        data = data.decode("utf-16", "replace").encode()
    if b"\0" in data:
        raise NotText("isn't a text file: save it as UTF-8 and submit it again")
    return data


def too_many(path: Path) -> UsageError:
    return UsageError(f"{path} holds more than {MOST_ENTRIES} files: submit the parts alone")


@contextmanager
def readable(path: Path) -> Iterator[None]:
    """Raises UsageError for whatever is raised within, as zipfile's dozen kinds of error."""
    try:
        yield
    except UsageError:
        raise
    except OSError as error:
        shown = printable_name(str(path))
        raise UsageError(f"{shown} can't be read: {error.strerror or error}") from error
    except Exception as error:
        reason = printable_text(str(error) or type(error).__name__, 200)
        raise UsageError(f"{path} is broken ({reason}): make it anew and submit again") from error


# --- a folder ---


def of_folder(path: Path, stack: ExitStack) -> Iterator[Entry]:
    """The entries, to be read while the stack is open. Raises UsageError if it can't list them."""
    with readable(path):
        top = os.open(path, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
    stack.callback(os.close, top)
    folders: list[tuple[str, ...]] = [()]
    seen = 0
    while folders:
        folder = folders.pop()
        with readable(path.joinpath(*folder)):
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
        with readable(path.joinpath(*inside)), open(_open(top, inside), "rb") as stream:
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
