"""Writes files atomically, and removes temporary ones that a killed process left."""

import os
import shutil
import tempfile
import time
from pathlib import Path

from bounce_grader.common.paths import WORK_FOLDER

CLASS_FOLDER = "bounce-class-"  # prefix of the temporary folders of ./kit class
BOX_FOLDER = "bounce-box-"  # prefix of those of a reduced box, as in grader/box/enter.cpp
ABANDONED = 3600.0  # seconds after which a temporary file counts as abandoned


def write_whole(path: Path, data: str | bytes, durable: bool = False) -> None:
    """Writes a file whole or not at all, by renaming a temporary one. If `durable`, the file also
    survives a power loss. If it raises OSError, the old file stays. A device or a pipe is written
    to directly."""
    if path.exists() and not path.is_file() and not path.is_dir():
        path.write_bytes(data.encode() if isinstance(data, str) else data)
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f".{fitting(path.name, 100)}.{os.getpid()}.part")
    try:
        with temporary.open("wb") as stream:
            stream.write(data.encode() if isinstance(data, str) else data)
            if durable:
                stream.flush()
                os.fsync(stream.fileno())
        temporary.replace(path)
    except OSError:
        temporary.unlink(missing_ok=True)
        raise
    if durable:
        _flush_folder(path.parent)


def _flush_folder(folder: Path) -> None:
    handle = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


def fitting(name: str, most: int = 200) -> str:
    """Cuts a name to at most so many bytes; a file system allows 255."""
    cut = os.fsencode(name)[:most]
    return name if cut == os.fsencode(name) else cut.decode(errors="ignore")


def remove_abandoned(folder: Path) -> None:
    """Removes what killed writers and gradings left behind. Other gradings may be running, and may
    remove their own files at the same time."""
    for part in folder.rglob(".*.part"):
        if _abandoned(part):
            part.unlink(missing_ok=True)
    for left in Path(tempfile.gettempdir()).glob("bounce-*"):
        if left.name.startswith((WORK_FOLDER, CLASS_FOLDER, BOX_FOLDER)) and _abandoned(left):
            shutil.rmtree(left, ignore_errors=True)


def _abandoned(path: Path) -> bool:
    try:
        return time.time() - path.stat().st_mtime > ABANDONED
    except OSError:
        return False
