"""Reads a service's download: a zip, or the folder that it was unpacked to."""

import os
import stat
import zipfile
import zlib
from functools import lru_cache
from pathlib import Path

from bounce_grader.common.errors import UsageError
from bounce_grader.submission.folders import SAFELY
from bounce_grader.submission.zips import name_of

FAILURES = (zipfile.BadZipFile, zlib.error, EOFError, OSError, ValueError, RuntimeError, KeyError)


def is_file(path: Path) -> bool:
    """Whether it is an ordinary file, and no link to one."""
    return os.path.isfile(path) and not os.path.islink(path)


def is_folder(path: Path) -> bool:
    return os.path.isdir(path) and not os.path.islink(path)


def of_macos(name: str) -> bool:
    """Whether macOS has added this file beside others: it is nobody's, and nothing is said of it."""
    return "__MACOSX" in name.split("/") or name.split("/")[-1].startswith((".DS_Store", "._"))


class Damaged(UsageError):
    """The whole download is damaged, which is no student's fault."""


class Archive:
    """Reads entries by name, at most `limit` bytes of each. Raises UsageError."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._zip: zipfile.ZipFile | None = None
        self._infos: dict[str, zipfile.ZipInfo] = {}  # by their names
        if not path.is_dir():
            try:
                self._zip = zipfile.ZipFile(path)
                infos = self._zip.infolist()
                self._infos = {name_of(info): info for info in infos if not info.is_dir()}
            except FAILURES as error:
                raise Damaged(f"{path} is broken ({error}): download it again") from error

    def names(self) -> list[str]:
        if self._zip:
            return [name for name in self._infos if not of_macos(name)]
        found = (file for file in self.path.rglob("*") if not is_folder(file))
        names = (str(file.relative_to(self.path)) for file in found)
        return sorted(name for name in names if not of_macos(name))

    def read(self, name: str, limit: int) -> bytes:
        try:
            if self._zip:
                with self._zip.open(self._infos[name]) as stream:
                    return stream.read(limit)
            if os.path.islink(self.path / name):
                raise ValueError("it is a link")
            with open(os.open(self.path / name, SAFELY), "rb") as file:
                if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
                    raise ValueError("it is no ordinary file")
                return file.read(limit)
        except FAILURES as error:
            if self._zip:
                raise Damaged(
                    f"{self.path} is damaged ({name}: {error}): download it again"
                ) from error
            raise UsageError(f"{name} can't be read from {self.path.name}: {error}") from error


def not_named(service: str) -> str:
    """Why an entry is no submission."""
    return f"isn't named as {service} names submissions"


def opened(path: Path) -> Archive:
    """Opens an archive, and caches it until the file changes: its list of entries may be long."""
    status = path.stat()
    return _opened(path, status.st_mtime_ns, status.st_ino)


@lru_cache(maxsize=2)
def _opened(path: Path, changed: int, inode: int) -> Archive:
    return Archive(path)
