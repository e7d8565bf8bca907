"""Runs clang-tidy on our C++, as far as it is built here. It takes several seconds per file, mostly
for headers of Eigen and the standard library, so only a long run checks every file."""

import hashlib
import json
import os
import re
import subprocess
import sys
from pathlib import Path

from bounce_grader.common.files import write_whole
from bounce_grader.common.paths import BUILD, ROOT

FOLDERS = ("solution", "grader/judge")
HEADERS = ("solution", "grader", "student", "tests")
MOST = 2  # files of a usual run
CLEAN = BUILD / "tidied.json"  # {file: digest} of what was found clean


def run(all_files: bool) -> int:
    """Checks the files that aren't known to be clean: all of them, or in a usual run those that
    changed last."""
    folder, built = _commands()
    digests = {file: digest for file, digest in _digests().items() if str(ROOT / file) in built}
    clean = json.loads(CLEAN.read_text()) if CLEAN.exists() else {}
    waiting = [file for file in _latest_first(digests) if clean.get(file) != digests[file]]
    chosen = waiting if all_files else waiting[:MOST]
    if not chosen:
        return 0
    unknown = "-extra-arg=-Wno-unknown-warning-option"  # g++'s own, in the build's flags
    command = [sys.executable, "/usr/bin/run-clang-tidy", "-quiet", "-p", str(folder), unknown]
    command += ["-j", str(os.cpu_count() or 1), *(f"^{ROOT / file}$" for file in chosen)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode:
        print(done.stdout, done.stderr, sep="\n", flush=True)
        return done.returncode
    write_whole(CLEAN, json.dumps(clean | {file: digests[file] for file in chosen}))
    if len(chosen) < len(waiting):
        print(f"   the {len(chosen)} files that changed last; --long looks at {len(waiting)}")
    return 0


def _commands() -> tuple[Path, set[str]]:
    """Writes the build's command for each source by itself: without precompiled headers, which only
    g++ can read, and without unity builds, which include several sources. Returns the folder, and
    the sources that are built here; those of a physics engine that isn't installed are missing."""
    entries = json.loads((BUILD / "compile_commands.json").read_text())
    folder = BUILD / "tidy"
    folder.mkdir(exist_ok=True)
    alone = [command for entry in entries for command in _standalone(entry)]
    write_whole(folder / "compile_commands.json", json.dumps(alone))
    return folder, {entry["file"] for entry in alone}


def _standalone(entry: dict[str, str]) -> list[dict[str, str]]:
    command = re.sub(r"-include \S+/cmake_pch\.hxx", "", entry["command"])
    together = Path(entry["file"])
    files = [entry["file"]]
    if together.parent.name == "Unity":
        files = re.findall(r'#include "(.*)"', together.read_text())
    return [
        {**entry, "file": file, "command": command.replace(entry["file"], file)} for file in files
    ]


def _digests() -> dict[str, str]:
    """A digest for each file, of its text, all of our headers, and clang-tidy's configuration."""
    shared = hashlib.sha256((ROOT / ".clang-tidy").read_bytes())
    for header in sorted(h for folder in HEADERS for h in (ROOT / folder).rglob("*.hpp")):
        shared.update(header.read_bytes())
    sources = [f for folder in FOLDERS for f in sorted((ROOT / folder).rglob("*.cpp"))]
    return {str(f.relative_to(ROOT)): _digest_of(shared.hexdigest(), f) for f in sources}


def _digest_of(shared: str, file: Path) -> str:
    return hashlib.sha256(shared.encode() + file.read_bytes()).hexdigest()


def _latest_first(files: dict[str, str]) -> list[str]:
    """Sorts the files by their last change in git's history, if there is one. Uncommitted changes
    come first."""
    log = ["git", "log", "--name-only", "--format=", "-n", "200", "--", *FOLDERS]
    changed = [*_lines(["git", "diff", "--name-only", "HEAD"]), *_lines(log), *files]
    return [file for file in dict.fromkeys(changed) if file in files]


def _lines(command: list[str]) -> list[str]:
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    return done.stdout.splitlines()
