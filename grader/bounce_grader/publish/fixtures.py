"""./kit fixtures: writes the cases and the answers of known mistakes, or compares them with the
committed ones."""

import tempfile
from pathlib import Path

from bounce_grader.grading import known_mistakes
from bounce_grader.grading.fixtures import DEFAULT, PUBLIC, hidden_folder, write


def write_all() -> None:
    write("public", PUBLIC)
    write("hidden", DEFAULT)
    hidden_folder()
    known_mistakes.write()


def differing() -> list[str]:
    """The committed files that differ, by even a byte, from what the solution writes; as paths in
    fixtures/."""
    public = [f"public/{name}" for name in _differing("public", PUBLIC)]
    return public + [f"default/hidden/{name}" for name in _differing("hidden", DEFAULT)]


def _differing(kind: str, folder: Path) -> list[str]:
    with tempfile.TemporaryDirectory() as temporary:
        fresh = Path(temporary)
        write(kind, fresh)
        names = {f.name for where in (fresh, folder) for f in where.glob("*.json")}
        return sorted(n for n in names if _bytes(fresh / n) != _bytes(folder / n))


def check() -> int:
    """Names the committed files that differ from what the solution writes, and those of known
    mistakes that don't match the gallery. Returns the exit status."""
    mistakes = [f"public/mistakes/{name}" for name in known_mistakes.differing()]
    names = [*differing(), *mistakes]
    for name in names:
        print(f"fixtures/{name} isn't what the kit writes: run ./kit fixtures")
    return int(bool(names))


def _bytes(file: Path) -> bytes | None:
    return file.read_bytes() if file.exists() else None
