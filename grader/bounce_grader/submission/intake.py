"""Lists the files of a submission, a folder or an archive, without trusting its names, sizes or
bytes."""

from collections.abc import Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager
from pathlib import Path

from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import printable_name
from bounce_grader.common.manifest import parts
from bounce_grader.submission import archives, folders
from bounce_grader.submission.archives import is_archive, CLOSED, SEVEN, START, TARS
from bounce_grader.submission.entry import MOST_ENTRIES, Entry
from bounce_grader.submission.unpack_limits import UnpackLimits

MOST_INNER = 3  # archives inside of a submission that are opened
LARGEST_INNER = 32 * 1024 * 1024  # bytes of each


@contextmanager
def opened(
    path: Path, zipped: bytes | None = None, left: UnpackLimits | None = None
) -> Iterator[list[Entry]]:
    """All files, which can be read while this is open. `zipped` is an archive in memory; then
    `path` is only its name. `left` is for all archives of the submission, if there are others.
    Raises UsageError if they can't be listed."""
    left = left or UnpackLimits()
    with ExitStack() as stack:
        listed = list(stack.enter_context(_opened(path, zipped, left)))
        listed = _with_inner(path, listed, stack, left)
        if not listed:
            raise UsageError(f"{path} is empty: it should hold {parts()[0].file} and so on")
        yield listed


def _opened(
    path: Path, zipped: bytes | None, left: UnpackLimits
) -> AbstractContextManager[Iterator[Entry]]:
    if zipped is None and _is_folder(path):
        return folders.opened(path)
    from bounce_grader.submission import sevens, tars, zips

    start = _bytes(path, START) if zipped is None else zipped[:START]
    kind = archives.kind(path.name, start)
    if kind in CLOSED:
        raise UsageError(f"{path} {archives.closed(kind)}")
    if kind in TARS or kind == SEVEN:
        data = _whole(path) if zipped is None else zipped
        return (sevens if kind == SEVEN else tars).opened(path, data, left)
    return zips.opened(path, zipped)


def _bytes(path: Path, limit: int) -> bytes:
    try:
        with path.open("rb") as file:
            return file.read(limit)
    except OSError as error:
        raise UsageError(f"{path} can't be read: {error.strerror}") from error


def _whole(path: Path) -> bytes:
    data = _bytes(path, LARGEST_INNER + 1)
    if len(data) > LARGEST_INNER:
        raise UsageError(f"{path} is larger than {LARGEST_INNER >> 20} MB: submit the parts alone")
    return data


def _with_inner(
    path: Path, listed: list[Entry], stack: ExitStack, left: UnpackLimits
) -> list[Entry]:
    """Opens archives inside, one level deep, if no part is there beside them."""
    stems = [part.stem for part in parts()]
    if any(stem in entry.name.lower() for entry in listed for stem in stems):
        return listed
    inner = [e for e in listed if is_archive(e.name) and not (e.link or "__MACOSX" in e.name)]
    found = [entry for entry in listed if entry not in inner[:MOST_INNER]]
    for archive in inner[:MOST_INNER]:
        name = Path(printable_name(archive.name))
        data = archive.read(LARGEST_INNER + 1)
        if len(data) > LARGEST_INNER:
            raise UsageError(f"{path} holds {printable_name(archive.name)}, which is too large")
        left.take(name, len(data))
        entries = stack.enter_context(_opened(name, data, left))
        found += [entry._replace(name=f"{archive.name}/{entry.name}") for entry in entries]
        if len(found) > MOST_ENTRIES:
            raise UsageError(f"{path} holds more than {MOST_ENTRIES} files: submit the parts alone")
    return found


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
    raise UsageError(f"there is no file or folder {printable_name(str(path))}")
