"""One unread file of a submission, and how to read a source from it."""

import re
from collections.abc import Callable
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import printable_name

MOST_ENTRIES = 5000
LARGEST_SOURCE = 1024 * 1024


class NotText(Exception):
    """A file can't be used as a source. The message continues a sentence that begins with its
    name."""


class Entry(NamedTuple):
    """A file or folder in a submission's folder or archive."""

    name: str  # relative, with forward slashes, without "..", never empty
    size: int  # claimed, not checked; only for messages
    link: bool  # a link, or anything else that is no regular file
    read: Callable[[int], bytes]  # at most so many bytes


def inside_name(path: Path, claimed: str) -> str:
    """The name of an archive's entry, with forward slashes. Raises UsageError if it points outside
    of the archive."""
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
        known = entry.size > LARGEST_SOURCE
        size = f"{_size(entry.size)} large" if known else "larger than it says"
        raise NotText(f"is {size}; a source file may have 1 MB")
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        data = data.decode("utf-16", "replace").encode()
    if b"\0" in data:
        raise NotText("isn't a text file: save it as UTF-8 and submit it again")
    return data


def _size(n: int) -> str:
    return f"{n / 1e9:.1f} GB" if n >= 1e9 else f"{n / 1e6:.1f} MB"
