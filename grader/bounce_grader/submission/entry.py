"""One file of a submission, still unread, and how a source is read from it."""

from collections.abc import Callable
from typing import NamedTuple

MOST_ENTRIES = 5000
LARGEST_SOURCE = 1024 * 1024


class NotText(Exception):
    """Why a file can't be used as a source; the sentence goes on from its name."""


class Entry(NamedTuple):
    name: str  # relative, with forward slashes, without "..", never empty
    size: int  # as it says: good for words alone
    link: bool  # or anything else that is no ordinary file
    read: Callable[[int], bytes]  # at most so many bytes


def text_of(entry: Entry) -> bytes:
    """The source as UTF-8, or what the compiler takes as such. Raises NotText."""
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
