"""A flat collection of files: Canvas's zip, or the folder that it was unpacked to."""

import zipfile
import zlib
from functools import lru_cache
from pathlib import Path

from bounce_grader.errors import UsageError

FAILURES = (zipfile.BadZipFile, zlib.error, EOFError, OSError, ValueError, RuntimeError, KeyError)


class Damaged(UsageError):
    """The download itself is: that is no student's fault."""


class Archive:
    """Reads entries by name; at most so many bytes of each. Raises UsageError."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._zip: zipfile.ZipFile | None = None
        if not path.is_dir():
            try:
                self._zip = zipfile.ZipFile(path)
            except FAILURES as error:
                raise Damaged(f"{path} is broken ({error}): download it again") from error

    def names(self) -> list[str]:
        if self._zip:
            return [info.filename for info in self._zip.infolist() if not info.is_dir()]
        return sorted(child.name for child in self.path.iterdir() if not child.is_dir())

    def size(self, name: str) -> int:
        if self._zip:
            return self._zip.getinfo(name).file_size
        return (self.path / name).lstat().st_size

    def read(self, name: str, most: int) -> bytes:
        try:
            if self._zip:
                with self._zip.open(name) as stream:
                    return stream.read(most)
            if (self.path / name).is_symlink():
                raise ValueError("it is a link")
            with (self.path / name).open("rb") as file:
                return file.read(most)
        except FAILURES as error:
            if self._zip:
                raise Damaged(
                    f"{self.path} is damaged ({name}: {error}): download it again"
                ) from error
            raise UsageError(f"{name} can't be read from {self.path.name}: {error}") from error


def opened(path: Path) -> Archive:
    """Kept open, for as long as it stays the same: its list of entries may be long."""
    status = path.stat()
    return _opened(path, status.st_mtime_ns, status.st_ino)


@lru_cache(maxsize=2)
def _opened(path: Path, changed: int, inode: int) -> Archive:
    return Archive(path)
