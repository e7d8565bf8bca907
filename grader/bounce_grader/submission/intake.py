"""Lists the files of a submission, a folder or an archive, without trusting its names, sizes or
bytes."""

import io
import re
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import BinaryIO

from bounce_grader.common.errors import UsageError
from bounce_grader.common.escaping import printable_name
from bounce_grader.common.manifest import parts
from bounce_grader.submission import folders
from bounce_grader.submission.entry import checked, readable, too_many
from bounce_grader.submission.entry import MOST_ENTRIES, Entry, UnpackLimits

BY_LIBARCHIVE = (".tar.gz", ".tgz", ".tar.bz2", ".tar.xz", ".tar.zst", ".tar", ".7z", ".rar")
ENDINGS = (".zip", *BY_LIBARCHIVE)
# How those begin, whatever their names: 7-Zip, RAR, what gzip, bzip2, xz and zstd pack, and a tar.
MAGIC = re.compile(
    rb"7z\xbc\xaf\x27\x1c|Rar!\x1a\x07|\x1f\x8b|BZh|\xfd7zXZ|\x28\xb5\x2f\xfd|(?s:.{257})ustar"
)
MOST_INNER = 3  # archives inside of a submission that are opened
LARGEST_PACKED = 32 * 1024 * 1024  # bytes of an archive inside, or one that libarchive unpacks
NOT_USED = "is no C++ source and no zip"  # after the name of an upload


def is_archive(name: str) -> bool:
    return name.lower().endswith(ENDINGS)


def archive_stem(name: str) -> str:
    """The name without the archive's ending: hw from hw.tar.gz."""
    return next((name[: -len(e)] for e in ENDINGS if name.lower().endswith(e)), name)


@contextmanager
def opened(
    path: Path, packed: bytes | None = None, left: UnpackLimits | None = None
) -> Iterator[list[Entry]]:
    """All files, which can be read while this is open. `packed` is an archive in memory; then
    `path` is only its name. `left` is for all archives of the submission, if there are others.
    Raises UsageError if they can't be listed."""
    left = left or UnpackLimits()
    with ExitStack() as stack:
        if packed is None and _is_folder(path):
            listed, empty = list(folders.entries(path, stack)), "empty"
        else:
            with readable(path):
                stream = path.open("rb") if packed is None else io.BytesIO(packed)
            unpacked = _unpacked(path, stack.enter_context(stream), left)
            listed, empty = list(unpacked), "empty or damaged"
        listed = _with_inner(path, listed, left)
        if not listed:
            raise UsageError(f"{path} is {empty}: it should hold {parts()[0].file} and so on")
        yield listed


def _unpacked(path: Path, stream: BinaryIO, left: UnpackLimits) -> Iterator[Entry]:
    from bounce_grader.submission import archives, zips  # no folder needs them

    with readable(path):
        start = stream.read(512)
        stream.seek(0)
    named = path.name.lower().endswith(BY_LIBARCHIVE) and not start.startswith(b"PK")
    if named or MAGIC.match(start):
        with readable(path):
            packed = _packed(path, stream.read)
        stream = io.BytesIO(archives.as_zip(path, packed, left))
    return checked(path, zips.entries(path, stream))


def _packed(path: Path, read: Callable[[int], bytes]) -> bytes:
    packed = read(LARGEST_PACKED + 1)
    if len(packed) > LARGEST_PACKED:
        raise UsageError(f"{path} is larger than {LARGEST_PACKED >> 20} MB: submit the parts alone")
    return packed


def _with_inner(path: Path, listed: list[Entry], left: UnpackLimits) -> list[Entry]:
    """Opens archives inside, one level deep, if no part is there beside them."""
    stems = [part.stem for part in parts()]
    if any(stem in entry.name.lower() for entry in listed for stem in stems):
        return listed
    inner = [e for e in listed if is_archive(e.name) and not (e.link or "__MACOSX" in e.name)]
    found = [entry for entry in listed if entry not in inner[:MOST_INNER]]
    for archive in inner[:MOST_INNER]:
        name = Path(printable_name(archive.name))
        packed = _packed(name, archive.read)
        left.take(name, len(packed))
        entries = _unpacked(name, io.BytesIO(packed), left)
        found += [entry._replace(name=f"{archive.name}/{entry.name}") for entry in entries]
        if len(found) > MOST_ENTRIES:
            raise too_many(path)
    return found


def _is_folder(path: Path) -> bool:
    with readable(path):
        if not path.exists():
            raise UsageError(f"there is no file or folder {printable_name(str(path))}")
        if not (path.is_dir() or path.is_file()):
            raise UsageError(f"{path} is neither a folder nor a zip")
        return path.is_dir()
