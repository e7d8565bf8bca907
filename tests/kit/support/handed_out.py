"""The handout, as a student has it, and what a student does with it."""

import subprocess
import zipfile
from collections.abc import Mapping, Sequence
from pathlib import Path

from bounce_grader.publish import handout
from conftest import ROOT, SOLUTION

SUBMISSIONS = ROOT / "tests/submissions"
SYSTEM = {"PATH": "/usr/bin:/bin", "HOME": "/nonexistent", "LANG": "C.UTF-8", "TERM": "xterm"}
Done = subprocess.CompletedProcess[str]
Edits = Mapping[str, Sequence[Sequence[str]]]


def unzipped(folder: Path) -> Path:
    """Into the folder; gives the handout's own, which is in it."""
    handout.write(folder / "handout.zip")
    with zipfile.ZipFile(folder / "handout.zip") as archive:
        for entry in archive.infolist():
            path = Path(archive.extract(entry, folder))
            path.chmod(entry.external_attr >> 16 & 0o777)
    return folder / "bounce"


def run(home: Path, *command: str, **environment: str) -> Done:
    variables = SYSTEM | environment
    return subprocess.run(command, cwd=home, env=variables, capture_output=True, text=True)


def check(home: Path, *words: str, **environment: str) -> Done:
    return run(home, "./check", *words, **environment)


def put(home: Path, *laid: str, edits: Edits = {}, files: Mapping[str, str] = {}) -> None:
    """Fills src/ with the solution's parts, over which are laid those of a folder of
    tests/submissions with their helpers, or "stub 1". What is there already isn't built again."""
    texts = _texts(SOLUTION, "*.cpp")
    for name in laid:
        if name[:4] == "stub":
            texts |= _texts(ROOT / "student/src", f"part{name[-1]}_*.cpp")
        else:
            texts |= _texts(SUBMISSIONS / name, "**/[!.]*.[ch]*")
    for stem, changes in edits.items():
        text = texts[f"{stem}.cpp"].decode()
        for old, new in changes:
            assert old in text, f"{old} isn't in {stem}"
            text = text.replace(old, new, 1)
        texts[f"{stem}.cpp"] = text.encode()
    texts |= {name: text.encode() for name, text in files.items()}
    for name in _texts(home / "src", "**/*").keys() - texts.keys():
        (home / "src" / name).unlink()
    for name, data in texts.items():
        there = home / "src" / name
        if not there.exists() or there.read_bytes() != data:
            (home / "new").write_bytes(data)
            there.parent.mkdir(exist_ok=True)
            (home / "new").rename(there)  # at once: a watch sees one change


def _texts(folder: Path, pattern: str) -> dict[str, bytes]:
    """By their paths in the folder."""
    return {str(f.relative_to(folder)): f.read_bytes() for f in folder.glob(pattern) if f.is_file()}
