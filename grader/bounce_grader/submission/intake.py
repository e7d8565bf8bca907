"""Lists the files of a submission, a folder or an archive, without trusting its names, sizes or
bytes.

A zip is read in memory, and what isn't asked for isn't unpacked. Of a tar, or an archive of 7-Zip,
RAR and others, libarchive's bsdtar makes a zip, from its standard input to its output. It parses
what strangers made, and an archive may even ask it for other files (mtree has a field for that): so
it runs in a box always, also for a submission that is trusted, and what it writes is read as
anybody's zip. Left out are hard links, pipes and devices, which a zip can't hold.
"""

import io
import re
import stat
import zipfile
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, ExitStack, suppress
from pathlib import Path, PurePosixPath
from typing import BinaryIO, cast

from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.escaping import printable_name, printable_text
from bounce_grader.common.manifest import parts
from bounce_grader.sandbox import box as boxes
from bounce_grader.sandbox.processes import Limits, Result
from bounce_grader.submission.entry import Entry, HEADERS, MOST_ENTRIES, of_folder
from bounce_grader.submission.entry import readable, SOURCES, too_many

BY_LIBARCHIVE = (".tar.gz", ".tgz", ".tar.bz2", ".tar.xz", ".tar.zst", ".tar", ".7z", ".rar")
ENDINGS = (".zip", *BY_LIBARCHIVE)
# How those begin, whatever their names: 7-Zip, RAR, what gzip, bzip2, xz and zstd pack, and a tar.
MAGIC = re.compile(
    rb"7z\xbc\xaf\x27\x1c|Rar!\x1a\x07|\x1f\x8b|BZh|\xfd7zXZ|\x28\xb5\x2f\xfd|(?s:.{257})ustar"
)
MOST_INNER = 3  # archives inside of a submission that are opened
LARGEST_PACKED = 32 * 1024 * 1024  # bytes of an archive inside, or one that libarchive unpacks
UNPACKED = 64 * 1024 * 1024  # bytes
NOT_USED = "is neither a C++ source nor a zip"  # after the name of an upload
# For zipfile:
ENCRYPTED = 0x1
UTF_8 = 0x800
LARGEST_DIRECTORY = 2 * 1024 * 1024  # of a table of contents, or a single read
METHODS = {zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED}  # others may need gigabytes
# For bsdtar:
PROGRAMS = ("env", "bsdtar")
LOCALES = Path("/usr/lib/locale")
NOT_FOUND = 127  # the exit status of env
COMMAND = ("/usr/bin/env", "LC_ALL=C.UTF-8", "/usr/bin/bsdtar", "-cPf-", "--format=zip")
STORED = "--options=zip:compression=store"


class UnpackLimits:
    """What all archives of one submission may still take together."""

    room = UNPACKED  # for what is unpacked, and for archives inside of others
    seconds = 10.0  # of libarchive's CPU time

    def take(self, path: Path, size: int) -> None:
        """Raises UsageError if there is no room for so many bytes."""
        self.room -= size
        if self.room < 0:
            much = f"has more than {UNPACKED >> 20} MB unpacked, alone or with the other archives"
            raise UsageError(f"{path} {much}: submit the parts alone")


def is_archive(name: str) -> bool:
    return archive_stem(name) != name


def archive_stem(name: str) -> str:
    """hw for hw.tar.gz, and for hw.tar-1.gz, as Canvas names one that is handed in again."""
    plain = re.sub(r"(\.tar)-\d+(\.\w+)$", r"\1\2", name, flags=re.I)
    return next((plain[: -len(e)] for e in ENDINGS if plain.lower().endswith(e)), name)


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
            listed, empty = list(of_folder(path, stack)), "empty"
        else:
            with readable(path):
                stream = path.open("rb") if packed is None else io.BytesIO(packed)
            unpacked = _unpacked(path, stack.enter_context(stream), left)
            listed, empty = list(unpacked), "empty or damaged"
        listed = _with_inner(path, listed, left)
        if not listed:
            raise UsageError(f"{path} is {empty}: it should hold {parts()[0].file} and so on")
        yield listed


def _is_folder(path: Path) -> bool:
    with readable(path):
        if not path.exists():
            raise UsageError(f"there is no file or folder {printable_name(str(path))}")
        if not (path.is_dir() or path.is_file()):
            raise UsageError(f"{path} is neither a folder nor a zip")
        return path.is_dir()


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


def _unpacked(path: Path, stream: BinaryIO, left: UnpackLimits) -> Iterator[Entry]:
    with readable(path):
        start = stream.read(512)
        stream.seek(0)
    named = is_archive(path.name) and path.suffix.lower() != ".zip" and not start.startswith(b"PK")
    if named or MAGIC.match(start):
        with readable(path):
            packed = _packed(path, stream.read)
        stream = io.BytesIO(_as_zip(path, packed, left))
    return checked(path, _of_zip(path, stream))


def _packed(path: Path, read: Callable[[int], bytes]) -> bytes:
    packed = read(LARGEST_PACKED + 1)
    if len(packed) > LARGEST_PACKED:
        raise UsageError(f"{path} is larger than {LARGEST_PACKED >> 20} MB: submit the parts alone")
    return packed


def checked(path: Path, entries: Iterable[Entry]) -> Iterator[Entry]:
    """An archive's entries under safe names, each once: of those that aren't sources, the first."""
    names: set[str] = set()
    for entry in entries:
        name = _inside_name(path, entry.name)
        if name in names:
            used = PurePosixPath(name).suffix.lower() in SOURCES | HEADERS | {".txt"}
            if used or is_archive(name):
                raise UsageError(f"{path} holds {printable_name(name)} twice: make it anew")
            continue
        names.add(name)
        yield entry._replace(name=name)


def _inside_name(path: Path, claimed: str) -> str:
    name = PurePosixPath(claimed.replace("\\", "/"))
    if name.is_absolute() or ".." in name.parts or re.match("[A-Za-z]:(/|$)", str(name)):
        shown = printable_name(str(name))
        raise UsageError(f"{path} has an entry that points outside of it ('{shown}')")
    if not name.parts:
        raise UsageError(f"{path} has an entry without a name: make it anew and submit again")
    return str(name)


# --- a zip ---


def _of_zip(path: Path, stream: BinaryIO) -> Iterator[Entry]:
    """The entries, to be read while the stream is open. Raises UsageError if it can't list them."""
    with readable(path):
        bounded = _Bounded(cast(io.RawIOBase, stream))
        bounded.path = path
        if not zipfile.is_zipfile(bounded):
            if not isinstance(stream, io.BytesIO) and path.suffix.lower() != ".zip":
                raise UsageError(f"{path} is neither a folder nor a zip")
            raise UsageError(f"{path} is broken, or no zip: make it anew and submit again")
        archive = zipfile.ZipFile(bounded)
    infos = archive.infolist()
    if len(infos) > MOST_ENTRIES:  # folders count, too
        raise too_many(path)
    # Entries that share their bytes would be unpacked from them again and again.
    if sum(info.compress_size for info in infos) > archive.start_dir:
        raise UsageError(f"{path} is broken (its entries overlap): make it anew and submit again")
    for info in infos:
        if not info.filename.endswith(("/", "\\")):
            yield _entry(path, archive, info)


class _Bounded(io.BufferedReader):
    """Limits one read: zipfile reads a table of contents whole, of the size that the zip claims."""

    path: Path

    def read(self, size: int | None = -1) -> bytes:
        if size is not None and size > LARGEST_DIRECTORY:
            raise too_many(self.path)
        return super().read(size)


def name_in_zip(info: zipfile.ZipInfo) -> str:
    """An entry's name. Canvas and macOS write UTF-8 unmarked, which zipfile reads as code page
    437."""
    with suppress(UnicodeError):
        if not info.flag_bits & UTF_8:
            return info.filename.encode("cp437").decode("utf-8")
    return info.filename


def _entry(path: Path, archive: zipfile.ZipFile, info: zipfile.ZipInfo) -> Entry:
    if info.flag_bits & ENCRYPTED:
        raise UsageError(f"{path} is encrypted: submit it without a password")

    def read(limit: int) -> bytes:
        if info.compress_type not in METHODS:
            raise UsageError(f"{path} is compressed in an unusual way: make it anew, as plain zip")
        with readable(path), archive.open(info) as stream:
            return stream.read(limit)

    kind = stat.S_IFMT(info.external_attr >> 16)  # 0 if the zip wasn't made on Unix
    return Entry(name_in_zip(info), kind not in (0, stat.S_IFREG), read)


# --- other archives ---


def _as_zip(path: Path, packed: bytes, left: UnpackLimits) -> bytes:
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
