"""Folders of what has to come out: compared with what does, or written anew by ./kit test --accept
for a person to read in the diff."""

import os
import shutil
from pathlib import Path


def compare(expected: Path, got: dict[str, str]) -> None:
    """Compares texts, by their file's name, with the files of a folder. Raises AssertionError if
    one differs, is missing, or is one too many."""
    if os.environ.get("BOUNCE_ACCEPT"):
        shutil.rmtree(expected, ignore_errors=True)
        for name, text in got.items():
            path = expected / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8", newline="")
        return
    files = (path for path in sorted(expected.rglob("*")) if path.is_file())
    written = {str(path.relative_to(expected)): path.read_bytes().decode("utf-8") for path in files}
    for name in sorted(written.keys() | got.keys()):
        says = "if that is right, run ./kit test --accept, and read the diff"
        assert got.get(name) == written.get(name), f"{expected / name} differs: {says}"
