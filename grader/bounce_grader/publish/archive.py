"""Writes zips whose bytes depend on nothing but what they hold."""

import stat
import zipfile
from collections.abc import Mapping
from pathlib import Path

from bounce_grader.common.errors import UsageError

TIME = (2000, 1, 1, 0, 0, 0)


def write(path: Path, held: Mapping[str, tuple[bytes, int]], compressed: bool) -> None:
    """Writes a zip, whole or not at all, of these contents and permissions by their path in it. One
    that isn't compressed has the same bytes with each version of zlib. Only its owner can read it
    until it is complete."""
    temporary = path.with_name(path.name + ".part")
    try:
        temporary.touch(mode=0o600)
        with zipfile.ZipFile(temporary, "w") as archive:
            for name, (data, mode) in held.items():
                entry = zipfile.ZipInfo(name, TIME)
                entry.create_system = 3  # Unix, so that permissions are kept
                entry.external_attr = (stat.S_IFREG | mode) << 16
                entry.compress_type = zipfile.ZIP_DEFLATED if compressed else zipfile.ZIP_STORED
                archive.writestr(entry, data)
        temporary.replace(path)
    except OSError as error:
        temporary.unlink(missing_ok=True)
        raise UsageError(f"{path} can't be written: {error.strerror}") from error
