"""Submissions by what is odd about them: files that a folder, a zip and a tar can hold, names that
only a zip can, and paths that are none of these."""

import json
import os
import subprocess
from pathlib import Path

import golden
from bounce_grader.common.paths import STUBS
from bounce_grader.submission import entry
from conftest import ROOT, write

Files = dict[str, bytes]

STEMS = ("part1_contacts", "part2_lcp", "part3_step", "part4_simulate")
PARTS: Files = {f"{stem}.cpp": b"// " + stem.encode() for stem in STEMS}
UNTOUCHED: Files = {name: (STUBS / name).read_bytes() for name in PARTS}


def inside(folder: str) -> Files:
    return {f"{folder}/{name}": text for name, text in PARTS.items()}


def written(files: dict[str, str]) -> Files:
    """Files as files.json has them, where * in a name stands for the four parts, or their stubs."""
    made: Files = {}
    for name, text in files.items():
        own = {name: text.encode()}
        if "*" in name:
            own = UNTOUCHED if text == "the stubs" else PARTS
        made |= {name.replace("*", part): data for part, data in own.items()}
    return made


TABLES = ROOT / "tests" / "kit" / "odd_submissions"
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


COMMANDS: dict[str, dict[str, str]] = golden.table(TABLES / "folders.toml")
# What is made in an empty folder, and which path is then read.
PATHS = {
    "nothing": ("true", "nowhere"),
    "a file alone": ("cp ../parts/* .", "part2_lcp.cpp"),
    "a pipe": ("mkfifo pipe", "pipe"),
    "/dev/zero": ("true", "/dev/zero"),
    "/dev/null": ("true", "/dev/null"),
    **{what: (command, ".") for what, command in COMMANDS["folders"].items()},
}


def bash(command: str, folder: Path) -> Path:
    folder.mkdir(exist_ok=True)
    subprocess.run(["bash", "-ec", command], cwd=folder, check=True)
    return folder


def deep(folder: Path) -> Path:
    """Deeper than a path can be long. shutil can't remove it, but rm can."""
    here = os.open(write(folder, PARTS), os.O_RDONLY)
    for _ in range(3000):
        os.mkdir("d", dir_fd=here)
        below = os.open("d", os.O_RDONLY, dir_fd=here)
        os.close(here)
        here = below
    os.close(here)
    return folder
