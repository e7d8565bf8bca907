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
        if path.is_dir():
            files = (file for file in path.rglob("*") if not is_folder(file))
            names = sorted(str(file.relative_to(path)) for file in files)
        else:
            try:
                self._zip = zipfile.ZipFile(path)
                infos = self._zip.infolist()
            except FAILURES as error:
                raise Damaged(f"{path} is broken ({error}): download it again") from error
            self._infos = {name_of(info): info for info in infos if not info.is_dir()}
            names = list(self._infos)
        self.names = [name for name in names if not of_macos(name)]

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
            if not self._zip:
                raise UsageError(f"{name} can't be read from {self.path.name}: {error}") from error
            damaged = f"{self.path} is damaged ({name}: {error})"
            raise Damaged(f"{damaged}: download it again") from error


def opened(path: Path) -> Archive:
    """Opens an archive, and caches it until the file changes: its list of entries may be long."""
    status = path.stat()
    return _opened(path, status.st_mtime_ns, status.st_ino)


@lru_cache(maxsize=2)
def _opened(path: Path, changed: int, inode: int) -> Archive:
    return Archive(path)
