"""One unread file of a submission, how to read a source from it, and what its archives may take."""

import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import printable_name, printable_text

MOST_ENTRIES = 5000
LARGEST_SOURCE = 1024 * 1024
UNPACKED = 64 * 1024 * 1024  # bytes


class NotText(Exception):
    """A file can't be used as a source. The message continues a sentence that begins with its
    name."""


class Entry(NamedTuple):
    """A file in a submission's folder or archive."""

    name: str  # relative, with forward slashes, without "..", never empty
    link: bool  # a link, or anything else that is no regular file
    read: Callable[[int], bytes]  # at most so many bytes


def of_bytes(name: str, data: bytes, link: bool = False) -> Entry:
    return Entry(name, link, lambda limit: data[:limit])


class UnpackLimits:
    """What all archives of one submission may still take together."""

    room = UNPACKED  # for what is unpacked, and for archives inside of others
    seconds = 10.0  # of libarchive's CPU time

    def take(self, path: Path, size: int) -> None:
        """Raises UsageError if there is no room for so many bytes."""
        self.room -= size
        if self.room < 0:
            raise UsageError(
                f"{path} has more than {UNPACKED >> 20} MB unpacked, alone or with the other "
                "archives: submit the parts alone"
            )


def checked(path: Path, entries: Iterable[Entry]) -> Iterator[Entry]:
    """An archive's entries by names that lead nowhere else, each once. Raises UsageError."""
    names: set[str] = set()
    for entry in entries:
        name = _inside_name(path, entry.name)
        if name in names:
            raise UsageError(f"{path} holds two entries of the same name: make it anew")
        names.add(name)
        yield entry._replace(name=name)


def _inside_name(path: Path, claimed: str) -> str:
    name = PurePosixPath(claimed.replace("\\", "/"))
    if name.is_absolute() or ".." in name.parts or re.match("[A-Za-z]:(/|$)", str(name)):
        raise UsageError(
            f"{path} has an entry that points outside of it ('{printable_name(str(name))}')"
        )
    if not name.parts:
        raise UsageError(f"{path} has an entry without a name: make it anew and submit again")
    return str(name)


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
def readable(path: object) -> Iterator[None]:
    """Raises UsageError for whatever is raised within: a broken zip makes zipfile raise a dozen
    kinds."""
    try:
        yield
    except UsageError:
        raise
    except OSError as error:
        raise UsageError(f"{path} can't be read: {error.strerror or error}") from error
    except Exception as error:
        reason = printable_text(str(error) or type(error).__name__, 200)
        raise UsageError(f"{path} is broken ({reason}): make it anew and submit again") from error
