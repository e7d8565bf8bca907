"""./kit fixtures: writes the cases and the answers of known mistakes, or compares them with the
committed ones."""

import tempfile
from pathlib import Path

from bounce_grader.grading import known_mistakes
from bounce_grader.grading.fixtures import PUBLIC, hidden_folder, write


def write_all() -> None:
    write("public", PUBLIC)
    hidden_folder()
    known_mistakes.write()


def differing() -> list[str]:
    """The names of the committed files that differ, by even a byte, from what the solution
    writes."""
    with tempfile.TemporaryDirectory() as name:
        fresh = Path(name)
        write("public", fresh)
        names = {f.name for folder in (fresh, PUBLIC) for f in folder.glob("*.json")}
        return sorted(n for n in names if _bytes(fresh / n) != _bytes(PUBLIC / n))


def all_differing() -> list[str]:
    """These, and the files of known mistakes that don't match the gallery."""
    return [*differing(), *(f"mistakes/{name}" for name in known_mistakes.differing())]


def _bytes(file: Path) -> bytes | None:
    return file.read_bytes() if file.exists() else None
