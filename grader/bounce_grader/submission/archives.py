"""Makes a zip of a tar, or an archive of 7-Zip, RAR and others, for zips.py to read: libarchive's
bsdtar does so in a box, from its standard input to its output, and nothing is written to disk.

It parses what strangers made, and an archive may even ask it for other files (mtree has a field for
that): so it runs in a box always, also for a submission that is trusted, and what it writes is read
as anybody's zip. Left out are hard links, pipes and devices, which a zip can't hold.
"""

from pathlib import Path

from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.escaping import printable_text
from bounce_grader.sandbox import box as boxes
from bounce_grader.sandbox.processes import Limits, Result
from bounce_grader.submission.entry import UnpackLimits

PROGRAMS = ("env", "bsdtar")
LOCALES = Path("/usr/lib/locale")
NOT_FOUND = 127  # the exit status of env
COMMAND = ("/usr/bin/env", "LC_ALL=C.UTF-8", "/usr/bin/bsdtar", "-cPf-", "--format=zip")
STORED = "--options=zip:compression=store"


def as_zip(path: Path, packed: bytes, left: UnpackLimits) -> bytes:
    """Raises UsageError if the archive can't be unpacked within the limits."""
    try:
        box = boxes.choose()
    except KitError as error:
        raise UsageError(f"{path} isn't opened here, but a zip would be: {error}") from error
    prefix = box.to_build(Path("/usr/include"), [LOCALES], PROGRAMS)  # where it finds no archive
    limits = Limits(max(1, int(left.seconds)), 60, memory=1 << 30, file_size=0, output=left.room)
    result = box.run([*prefix, *COMMAND, STORED, "@-"], limits, stdin=packed)
    if not result.boxed or result.code == NOT_FOUND:
        raise KitError(f"bsdtar could not be started: {result.err.strip()[:200] or 'it ended'}")
    left.seconds -= result.cpu_seconds
    left.take(path, left.room + 1 if result.flooded else len(result.out))
    if not result.ok or left.seconds < 0:
        raise UsageError(f"{path} can't be unpacked ({_why(result)}): make it anew, as a zip")
    return result.out


def _why(result: Result) -> str:
    if result.ok or result.too_long or result.killed:
        return "it takes too much time or space"
    reason = result.err.partition("\n")[0].removeprefix("bsdtar: ")
    reason = reason.removeprefix("Error reading archive -: ").replace("(null)", "a password?")
    return printable_text(reason or "libarchive's bsdtar crashed", 200)
