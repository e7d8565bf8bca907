"""Writes files atomically, and removes temporary ones that a killed process left."""

import hashlib
import io
import json
import os
import shutil
import stat
import tempfile
import time
import zipfile
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from bounce_grader.common.errors import UsageError
from bounce_grader.common.paths import BUILD, WORK_FOLDER

BOX_FOLDER = "bounce-box-"  # prefix of those of a reduced box, as in grader/box/enter.cpp
ABANDONED = 3600.0  # s, after which a temporary file counts as that; a grading takes two minutes


def digest(*fields: Any) -> str:
    """A digest of texts, bytes, numbers, and lists and tuples of them. `repr` keeps fields
    apart."""
    return hashlib.sha256(repr(fields).encode()).hexdigest()


def write_whole(path: Path, data: str | bytes, durable: bool = False, mode: int = 0) -> None:
    """Writes a file whole or not at all, by renaming a temporary one. If `durable`, the file also
    survives a power loss; a `mode` counts whatever the umask. If it raises OSError, the old file
    stays. To a device it just writes."""
    content = data.encode() if isinstance(data, str) else data
    if path.exists() and not path.is_file() and not path.is_dir():
        path.write_bytes(content)
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    # A name that nobody can foresee, to put a link there.
    temporary = path.with_name(f".{fitting(path.name, 100)}.{os.urandom(8).hex()}.part")
    try:
        made = os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_EXCL, mode or 0o666)
        with open(made, "wb") as stream:
            if mode:
                os.fchmod(made, mode)
            stream.write(content)
            if durable:
                stream.flush()
                os.fsync(stream.fileno())
        temporary.replace(path)
    except BaseException:  # also when this process is to end
        temporary.unlink(missing_ok=True)
        raise
    if durable:
        handle = os.open(path.parent, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def require_folder(path: Path) -> None:
    """Raises UsageError if there is no folder for this file."""
    if not path.parent.is_dir():
        raise UsageError(f"{path} can't be written: there is no folder {path.parent}")


def write_asked(path: Path, data: str | bytes, mode: int = 0) -> None:
    """Writes a file that the command line names. Raises UsageError if that can't be done."""
    require_folder(path)
    try:
        write_whole(path, data, mode=mode)
    except OSError as error:
        raise UsageError(f"{path} can't be written: {error.strerror}") from error


def zipped(held: Mapping[str, tuple[bytes, int]], compressed: bool) -> bytes:
    """A zip of these contents and permissions, by path. Without compression its bytes are the same
    with each version of zlib."""
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as archive:
        for name, (content, mode) in held.items():
            entry = zipfile.ZipInfo(name)
            entry.create_system = 3  # Unix, so that permissions are kept
            entry.external_attr = (stat.S_IFREG | mode) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED if compressed else zipfile.ZIP_STORED
            archive.writestr(entry, content)
    return data.getvalue()


def read_object(path: Path) -> dict[str, Any]:
    """The JSON object of objects of an earlier run; {} if there is none. Raises UsageError."""
    try:
        data = json.loads(path.read_text("utf-8"))
        if all(isinstance(value, dict) for value in data.values()):
            return dict(data)
    except FileNotFoundError:
        return {}
    except (OSError, ValueError, AttributeError):
        pass
    then = "then points that an earlier run has filled in count as a person's, and stay"
    raise UsageError(f"{path} is broken: put a copy of it back, or remove it; {then}")


def fitting(name: str, limit: int = 200) -> str:
    """Cuts a name to so many bytes; a file system allows 255. Digits tell two long names apart."""
    whole = os.fsencode(name)
    if len(whole) <= limit:
        return name
    digits = hashlib.sha256(whole).hexdigest()[:8]
    return f"{whole[: limit - 9].decode(errors='ignore')}-{digits}"


def temporary_folder() -> tempfile.TemporaryDirectory[str]:
    """The folder of a grading, which other users can't enter."""
    place = _temporary_place()
    return tempfile.TemporaryDirectory(prefix=WORK_FOLDER, dir=place, ignore_cleanup_errors=True)


def _temporary_place() -> Path:
    """Where programs may run: not in a /tmp that is mounted noexec."""
    usual = tempfile.gettempdir()
    return BUILD if os.statvfs(usual).f_flag & os.ST_NOEXEC else Path(usual)


def remove_abandoned(folder: Path | None = None) -> None:
    """Removes temporary files of killed gradings, and of killed writers in a folder. Other gradings
    may be running and do the same."""
    boxes = Path(tempfile.gettempdir()).glob(f"{BOX_FOLDER}*")
    found = [*_temporary_place().glob(f"{WORK_FOLDER}*"), *boxes]
    for left in [*found, *(folder.rglob(".*.part") if folder else [])]:
        with suppress(OSError):
            if time.time() - left.lstat().st_mtime <= ABANDONED:
                continue
            if left.is_dir():
                shutil.rmtree(left, ignore_errors=True)
            else:
                left.unlink()
