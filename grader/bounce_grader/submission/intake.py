"""Lists the files of a submission, a folder or a zip, without trusting its names, sizes or
bytes."""

from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path

from bounce_grader.common.errors import UsageError
from bounce_grader.common.manifest import parts
from bounce_grader.submission import folders
from bounce_grader.submission.entry import Entry


@contextmanager
def opened(path: Path, zipped: bytes | None = None) -> Iterator[list[Entry]]:
    """All files, which can be read while this is open. `zipped` is a zip in memory; then `path` is
    only its name. Raises UsageError if they can't be listed."""
    with _opened(path, zipped) as entries:
        listed = list(entries)
        if not listed:
            raise UsageError(f"{path} is empty: it should hold {parts()[0].file} and so on")
        yield listed


def _opened(path: Path, zipped: bytes | None) -> AbstractContextManager[Iterator[Entry]]:
    if zipped is None and _is_folder(path):
        return folders.opened(path)
    from bounce_grader.submission import zips

    return zips.opened(path, zipped)


def _is_folder(path: Path) -> bool:
    try:
        if path.is_dir():
            return True
        if path.is_file():
            return False
        there = path.exists()
    except OSError as error:
        raise UsageError(f"{path} can't be read: {error.strerror}") from error
    if there:
        raise UsageError(f"{path} is neither a folder nor a zip")
    raise UsageError(f"there is no file or folder {path}")
