"""Submissions by what is odd about them: files that a folder, a zip and a tar can hold, names that
only a zip can, and paths that are none of these."""

import json
import os
import subprocess
from collections.abc import Callable
from pathlib import Path

from bounce_grader.submission import entry
from conftest import ROOT, write
from handed_in import zip_of

Files = dict[str, bytes]
Make = Callable[[Path], Path]  # makes a submission in an empty folder, and returns its path

STEMS = ("part1_contacts", "part2_lcp", "part3_step", "part4_simulate")
PARTS: Files = {f"{stem}.cpp": b"// " + stem.encode() for stem in STEMS}


def inside(folder: str, files: Files = PARTS) -> Files:
    return {f"{folder}/{name}": text for name, text in files.items()}


def written(files: dict[str, str]) -> Files:
    """Files as files.json has them, where * in a name stands for the four parts."""
    made: Files = {}
    for name, text in files.items():
        own = {name: text.encode()} if "*" not in name else PARTS
        made |= {name.replace("*", part): data for part, data in own.items()}
    return made


TABLES = ROOT / "tests" / "kit" / "submission"
FILES = {k: written(files) for k, files in json.loads((TABLES / "files.json").read_text()).items()}
FILES |= {
    "UTF-16, and no text": {"part1_contacts.cpp": "// Höhe\nint x;\n".encode("utf-16")}
    | {"part2_lcp.cpp": b"int\0x;"},
    "a large helper": PARTS | {"table.hpp": b" " * (2 << 20), "notes.txt": b""},
    "5001 files": {f"{i}.txt": b"" for i in range(entry.MOST_ENTRIES + 1)},
    "20 MB of sources": dict.fromkeys([f"{i}.cpp" for i in range(20)], b" " * entry.LARGEST_SOURCE),
    "5000 sources that are no text": {f"{i}.cpp": b"\0" * 99 for i in range(entry.MOST_ENTRIES)},
}

# Each could mislead a compiler or a reader.
MISLEADING = ["-o.cpp", "@options.cpp", "a\nb.hpp", "\x1b[2J.cpp", "a\u202eppc.hpp"]
MISLEADING += [f"{'a' * 300}.cpp", "a/" * 200 + "a.cpp"]


def no_utf8(folder: Path) -> Path:
    (write(folder, PARTS) / os.fsdecode(b"L\xf6sung.hpp")).write_bytes(b"")
    return folder


def huge(folder: Path) -> Path:
    with (write(folder, PARTS) / "part2_lcp.cpp").open("wb") as stream:
        stream.truncate(1_000_000_000)
    return folder


def links_and_pipes(folder: Path) -> Path:
    (write(folder, PARTS) / "helper.cpp").symlink_to("/etc/passwd")
    (folder / "folder").symlink_to("/etc")
    os.mkfifo(folder / "pipe.cpp")
    return folder


def pipe(folder: Path) -> Path:
    os.mkfifo(folder / "pipe")
    return folder / "pipe"


def folders(folder: Path) -> Path:
    for i in range(entry.MOST_ENTRIES + 1):
        (folder / f"{i}").mkdir()
    return folder


def deep(folder: Path) -> Path:
    """Deeper than a path can be long."""
    here = os.open(write(folder, PARTS), os.O_RDONLY)
    for _ in range(3000):
        os.mkdir("d", dir_fd=here)
        below = os.open("d", os.O_RDONLY, dir_fd=here)
        os.close(here)
        here = below
    os.close(here)
    return folder


def remove(folder: Path) -> None:
    """Removes also what is deeper than shutil can."""
    subprocess.run(["rm", "-rf", folder], check=True)


def no_zip(folder: Path) -> Path:
    return write(folder, {"part1_contacts.cpp": b"int x;"}) / "part1_contacts.cpp"


FOLDERS: dict[str, Make] = {
    "an empty folder": lambda folder: folder,
    "a name that is no UTF-8": no_utf8,
    "a part of 1 GB": huge,
    "links and a pipe": links_and_pipes,
    "5001 folders": folders,
    "3000 folders deep": deep,
    "nothing": lambda folder: folder / "nowhere",
    "a file alone": no_zip,
    "a pipe": pipe,
    "/dev/zero": lambda _: Path("/dev/zero"),
    "/dev/null": lambda _: Path("/dev/null"),
    "misleading names": lambda folder: zip_of(
        folder / "x.zip", PARTS | dict.fromkeys(MISLEADING, b"int x;")
    ),
}
