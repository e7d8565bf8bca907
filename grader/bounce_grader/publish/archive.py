"""Chooses files, and writes them into zips."""

from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from bounce_grader.common.errors import UsageError
from bounce_grader.common.files import write_whole, zipped


def write(path: Path, held: Mapping[str, tuple[bytes, int]], compressed: bool) -> None:
    """Writes a zip, whole or not at all, that only its owner can read."""
    if not path.parent.is_dir():
        raise UsageError(f"{path} can't be written: there is no folder {path.parent}")
    try:
        write_whole(path, zipped(held, compressed), mode=0o600)
    except OSError as error:
        raise UsageError(f"{path} can't be written: {error.strerror}") from error


def files_in(folder: Path, is_skipped: Callable[[Path], bool]) -> Iterator[Path]:
    """The files below a folder, without links and what is skipped."""
    for path in folder.iterdir():
        if path.is_symlink() or is_skipped(path):
            continue
        if path.is_dir():
            yield from files_in(path, is_skipped)
        else:
            yield path
