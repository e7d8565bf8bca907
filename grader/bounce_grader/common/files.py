"""Writing files whole or not at all, and on the disk before they have their name."""

import os
import shutil
import tempfile
import time
from pathlib import Path

from bounce_grader.common.paths import WORK_FOLDER

CLASS_FOLDER = "bounce-class-"  # the prefix of a temporary one
BOX_FOLDER = "bounce-box-"  # likewise, of a reduced box, as in grader/box/enter.cpp
ABANDONED = 3600.0  # seconds after which nobody is writing a file any more


def write_whole(path: Path, data: str | bytes, durable: bool = False) -> None:
    """Under a temporary name first; `durable` survives a loss of power as well. Raises OSError,
    and then leaves what was there. A device or a pipe is written to, and never replaced."""
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
    """The beginning of a name, in so many bytes; a file system takes 255."""
    cut = os.fsencode(name)[:most]
    return name if cut == os.fsencode(name) else cut.decode(errors="ignore")


def remove_abandoned(folder: Path) -> None:
    """Takes away what writers and gradings that were killed have left; others may be at work beside
    this, and what they take away themselves is gone."""
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
