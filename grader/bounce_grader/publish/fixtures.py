"""./kit fixtures: writes the cases and the answers of known mistakes, or compares them with the
committed ones."""

import argparse
import tempfile
from pathlib import Path

from bounce_grader.common.files import write_whole
from bounce_grader.grading import known_mistakes
from bounce_grader.grading.examples import TABLE
from bounce_grader.grading.fixtures import DEFAULT, PUBLIC, hidden_folder, write
from bounce_grader.publish import wrong_programs


def run(options: argparse.Namespace) -> int:
    return _check() if options.check else _write_all()


def _write_all() -> int:
    write("public", PUBLIC)
    write("hidden", DEFAULT)
    hidden_folder()
    known_mistakes.write()
    write_whole(TABLE, wrong_programs.table())
    return 0


def differing() -> list[str]:
    """The committed files that differ, by even a byte, from what the solution writes; as paths in
    fixtures/."""
    sets = (("public", PUBLIC, "public"), ("hidden", DEFAULT, "default/hidden"))
    return [f"{place}/{name}" for kind, folder, place in sets for name in _differing(kind, folder)]


def _differing(kind: str, folder: Path) -> list[str]:
    with tempfile.TemporaryDirectory() as temporary:
        write(kind, Path(temporary))
        fresh, committed = (
            {file.name: file.read_bytes() for file in where.glob("*.json")}
            for where in (Path(temporary), folder)
        )
        names = sorted(fresh.keys() | committed.keys())
        return [name for name in names if fresh.get(name) != committed.get(name)]


def _check() -> int:
    """Names the committed files that differ from what the solution writes, and those of known
    mistakes that don't match the gallery. Returns the exit status."""
    mistakes = [f"public/mistakes/{name}" for name in sorted(known_mistakes.stale())]
    names = [*differing(), *mistakes]
    if TABLE.read_text("utf-8") != wrong_programs.table():
        names.append(f"public/{TABLE.name}")
    for name in names:
        print(f"fixtures/{name} isn't what the kit writes: run ./kit fixtures")
    return int(bool(names))
