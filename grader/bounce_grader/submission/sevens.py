"""Lists and reads the files of a 7-Zip archive. Debian's 7zip or p7zip unpacks it in a box, to its
standard output, one file after the other; so nothing of it is written to disk."""

import re
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import NamedTuple

from bounce_grader.common.errors import UsageError
from bounce_grader.common.files import temporary_folder
from bounce_grader.common.paths import WORK_FOLDER
from bounce_grader.sandbox import box as boxes
from bounce_grader.sandbox.processes import Limits, Result
from bounce_grader.submission.entry import MOST_ENTRIES, Entry, inside_name
from bounce_grader.submission.unpack_limits import LARGEST, UnpackLimits

# The programs themselves: what Debian has in /usr/bin may be a script, and a box has no shell.
PROGRAMS = (
    "/usr/bin/7zz",
    *(f"/usr/lib/{p}/{n}" for p in ("7zip", "p7zip") for n in ("7zr", "7za")),
)
LIMITS = Limits(cpu_seconds=10, wall_seconds=60, memory=1 << 30, file_size=0, output=LARGEST)
OPTIONS = ("-t7z", "-p", "-mmt=1", "-bd", "-sccUTF-8")  # no password, thread, progress


class _Listed(NamedTuple):
    name: str
    size: int
    crc: str  # hexadecimal; empty for an empty file
    link: bool


@contextmanager
def opened(path: Path, packed: bytes, left: UnpackLimits) -> Iterator[Iterator[Entry]]:
    """The entries of the archive. Raises UsageError if they can't be listed and read."""
    program = _program(path)
    with temporary_folder(WORK_FOLDER) as folder:
        (folder / "archive.7z").write_bytes(packed)
        listed = list(_listed(path, _run(path, folder, left, program, "l", "-slt", "-ba")))
        left.take(path, sum(one.size for one in listed))
        data = _run(path, folder, left, program, "x", "-so") if listed else b""
    yield _entries(path, listed, data)


def _program(path: Path) -> str:
    for program in PROGRAMS:
        if Path(program).is_file():
            return program
    raise UsageError(
        f"{path} is a 7-Zip archive, which isn't opened here: submit a zip (or, on the machine that "
        "grades, apt-get install 7zip)"
    )


def _run(
    path: Path, folder: Path, left: UnpackLimits, program: str, command: str, *options: str
) -> bytes:
    box = boxes.choose()
    box.give(folder)
    prefix = box.to_build(folder, [Path(program)], programs=())
    words = [program, command, *OPTIONS, *options, "archive.7z"]
    limits = LIMITS._replace(cpu_seconds=max(1, int(left.seconds)))
    result = box.run([*prefix, *words], limits, cwd=folder)
    left.seconds -= result.cpu_seconds
    if not result.ok or left.seconds < 0:
        raise UsageError(f"{path} is broken ({_why(result)}): make it anew, as a zip")
    return result.out


def _why(result: Result) -> str:
    if result.ok or result.too_long or result.flooded or result.killed:
        return "it takes too much time or space to unpack"
    password = re.search("password|encrypted", result.err, re.IGNORECASE)
    return "it has a password" if password else "7-Zip can't unpack it"


def _listed(path: Path, text: bytes) -> Iterator[_Listed]:
    blocks = text.split(b"\n\n", MOST_ENTRIES + 1)
    if len(blocks) > MOST_ENTRIES + 1:  # folders count, too
        raise UsageError(f"{path} holds more than {MOST_ENTRIES} files: submit the parts alone")
    for block in blocks:
        lines = block.decode("utf-8", "replace").split("\n")
        fields = dict(line.partition(" = ")[::2] for line in lines)
        attributes = fields.get("Attributes", "")
        if "Path" in fields and not attributes.startswith("D"):
            size = int(fields.get("Size") or 0)
            link = " l" in attributes
            yield _Listed(fields["Path"], size, fields.get("CRC", ""), link)


def _entries(path: Path, listed: list[_Listed], data: bytes) -> Iterator[Entry]:
    names: set[str] = set()
    whole, at = memoryview(data), 0  # a copy of each rest would take minutes
    for one in listed:
        own = whole[at : at + one.size]
        at += one.size
        if one.size and one.crc != f"{zlib.crc32(own):08X}":
            raise UsageError(f"{path} is broken (a checksum differs): make it anew, as a zip")
        name = inside_name(path, one.name)
        if name in names:
            raise UsageError(f"{path} holds two entries of the same name: make it anew")
        names.add(name)
        yield Entry(name, one.size, one.link, partial(_first, own))


def _first(data: memoryview, limit: int) -> bytes:
    return bytes(data[:limit])
