"""Lists and reads the files of a tar, or an archive of 7-Zip, RAR and others. libarchive's bsdtar
unpacks it in a box, as one plain tar to its standard output; so nothing of it is written to disk.

It parses what strangers made, and an archive may even ask it for other files (mtree has a field for
that): so it runs in a box always, also for a submission that is trusted, and its output is taken
for anybody's. Python's tarfile would follow headers that bsdtar doesn't write here, for minutes and
gigabytes (global ones, a sparse file's map); so the plain ones are walked by a loop.
"""

import tarfile
from collections.abc import Iterator
from pathlib import Path

from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.escaping import printable_text
from bounce_grader.sandbox import box as boxes
from bounce_grader.sandbox.processes import Limits, Result
from bounce_grader.submission.entry import MOST_ENTRIES, Entry, of_bytes, UnpackLimits
from bounce_grader.submission.entry import readable, too_many

PROGRAMS = ("env", "bsdtar")
LOCALES = Path("/usr/lib/locale")
NOT_FOUND = 127  # the exit status of env
# GNU's tar has names of any length, and no other header that changes what follows.
COMMAND = ("/usr/bin/env", "LC_ALL=C.UTF-8", "/usr/bin/bsdtar", "-cPf-", "--format=gnutar", "@-")
ENCODING = ("utf-8", "surrogateescape")
BLOCK = tarfile.BLOCKSIZE
LONG_NAME = tarfile.GNUTYPE_LONGNAME


def entries(path: Path, packed: bytes, left: UnpackLimits) -> Iterator[Entry]:
    """Raises UsageError if the archive can't be unpacked within the limits."""
    try:
        box = boxes.choose()
    except KitError as error:
        raise UsageError(f"{path} isn't opened here, but a zip would be: {error}") from error
    prefix = box.to_build(Path("/usr/include"), [LOCALES], PROGRAMS)  # where it finds no archive
    limits = Limits(max(1, int(left.seconds)), 60, memory=1 << 30, file_size=0, output=left.room)
    result = box.run([*prefix, *COMMAND], limits, stdin=packed)
    if not result.boxed or result.code == NOT_FOUND:
        raise KitError(f"bsdtar could not be started: {result.err.strip()[:200] or 'it ended'}")
    left.seconds -= result.cpu_seconds
    left.take(path, left.room + 1 if result.flooded else len(result.out))
    if not result.ok or left.seconds < 0:
        raise UsageError(f"{path} can't be unpacked ({_why(result)}): make it anew, as a zip")
    return _members(path, result.out)


def _why(result: Result) -> str:
    if result.ok or result.too_long or result.killed:
        return "it takes too much time or space"
    reason = result.err.partition("\n")[0].removeprefix("bsdtar: ")
    reason = reason.removeprefix("Error reading archive -: ").replace("(null)", "a password?")
    return printable_text(reason or "libarchive's bsdtar crashed", 200)


def _members(path: Path, data: bytes) -> Iterator[Entry]:
    at, seen, long_name = 0, 0, ""
    while data[at : at + BLOCK].strip(b"\0"):
        with readable(path):
            info = tarfile.TarInfo.frombuf(data[at : at + BLOCK], *ENCODING)
        own = data[at + BLOCK : at + BLOCK + max(0, info.size)]
        at += BLOCK + -(-len(own) // BLOCK) * BLOCK
        if info.type == LONG_NAME:
            long_name = own.rstrip(b"\0").decode(*ENCODING)
        elif info.type != tarfile.GNUTYPE_LONGLINK:
            seen += 1  # folders count, too
            if seen > MOST_ENTRIES:
                raise too_many(path)
            if not info.isdir():
                yield of_bytes(long_name or info.name, own, not info.isreg())
            long_name = ""
