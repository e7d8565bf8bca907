"""Reads the entries of a folder or a zip, without trusting a name, a size or a byte of them."""

import stat
import zipfile
import zlib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from bounce_grader.errors import UsageError

MOST_ENTRIES = 5000
LARGEST_SOURCE = 1024 * 1024


class NotText(Exception):
    """Why a file can't be used as a source; the sentence goes on from its name."""


@dataclass(frozen=True)
class Entry:
    name: str  # relative, with forward slashes, without ".."
    size: int
    link: bool
    read: Callable[[int], bytes]  # at most so many bytes


def entries(path: Path) -> Iterator[Entry]:
    """All files of a submission. Raises UsageError where it can't be read."""
    if path.is_dir():
        found = _folder(path)
    elif not path.exists():
        raise UsageError(f"there is no file or folder {path}")
    elif zipfile.is_zipfile(path):
        found = _zip(path)
    elif path.suffix.lower() == ".zip":
        raise UsageError(f"{path} is broken, or no zip: make it anew and submit again")
    else:
        raise UsageError(f"{path} is neither a folder nor a zip")
    seen = 0
    for entry in found:
        seen += 1
        if seen > MOST_ENTRIES:
            raise UsageError(f"{path} holds more than {MOST_ENTRIES} files: submit the parts alone")
        yield entry
    if seen == 0:
        raise UsageError(f"{path} is empty: it should hold part1_contacts.cpp and so on")


def text_of(entry: Entry) -> bytes:
    """The source as UTF-8, or what the compiler takes as such. Raises NotText."""
    if entry.size > LARGEST_SOURCE:
        raise NotText(f"is {_size(entry.size)} large; a source file may have 1 MB")
    data = entry.read(LARGEST_SOURCE + 1)
    if len(data) > LARGEST_SOURCE:
        raise NotText("is larger than it says; a source file may have 1 MB")
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        data = data.decode("utf-16", "replace").encode()
    if b"\0" in data:
        raise NotText("isn't a text file: save it as UTF-8 and submit it again")
    return data


def _size(n: int) -> str:
    return f"{n / 1e9:.1f} GB" if n >= 1e9 else f"{n / 1e6:.1f} MB"


def _folder(path: Path) -> Iterator[Entry]:
    def walk(folder: Path) -> Iterator[Path]:
        for child in sorted(folder.iterdir()):
            if child.is_dir() and not child.is_symlink():
                yield from walk(child) if not child.name.startswith(".git") else ()
            else:
                yield child

    try:
        for file in walk(path):
            mode = file.lstat().st_mode
            yield Entry(
                name=file.relative_to(path).as_posix(),
                size=file.lstat().st_size,
                link=not stat.S_ISREG(mode),
                read=lambda most, file=file: _read_file(file, most),  # type: ignore[misc]
            )
    except PermissionError as error:
        raise UsageError(f"{error.filename} can't be read: {error.strerror}") from error


def _read_file(file: Path, most: int) -> bytes:
    with file.open("rb") as stream:
        return stream.read(most)


def _zip(path: Path) -> Iterator[Entry]:
    with _readable(path), zipfile.ZipFile(path) as archive:
        infos = [info for info in archive.infolist() if not info.is_dir()]
    names = [info.filename for info in infos]
    if len(set(names)) < len(names):
        raise UsageError(f"{path} holds two entries of the same name: make it anew")
    for info in infos:
        yield _zip_entry(path, info)


def _zip_entry(path: Path, info: zipfile.ZipInfo) -> Entry:
    name = PurePosixPath(info.filename.replace("\\", "/"))
    if name.is_absolute() or ".." in name.parts or ":" in info.filename.split("/")[0]:
        raise UsageError(f"{path} has an entry that points outside of it ({info.filename!r})")
    if info.flag_bits & 0x1:
        raise UsageError(f"{path} is encrypted: submit it without a password")

    def read(most: int) -> bytes:
        with _readable(path), zipfile.ZipFile(path) as archive, archive.open(info) as stream:
            return stream.read(most)

    return Entry(str(name), info.file_size, stat.S_ISLNK(info.external_attr >> 16), read)


@contextmanager
def _readable(path: Path) -> Iterator[None]:
    try:
        yield
    except (zipfile.BadZipFile, zlib.error, EOFError, OSError, ValueError, RuntimeError) as error:
        raise UsageError(f"{path} is broken ({error}): make it anew and submit again") from error
