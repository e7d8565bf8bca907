"""One unread file of a submission, and how to read a source from it."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import printable_text

MOST_ENTRIES = 5000
LARGEST_SOURCE = 1024 * 1024


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
def readable(path: object) -> Iterator[None]:
    """Raises UsageError for whatever is raised within, as zipfile's dozen kinds of error."""
    try:
        yield
    except UsageError:
        raise
    except OSError as error:
        raise UsageError(f"{path} can't be read: {error.strerror or error}") from error
    except Exception as error:
        reason = printable_text(str(error) or type(error).__name__, 200)
        raise UsageError(f"{path} is broken ({reason}): make it anew and submit again") from error
