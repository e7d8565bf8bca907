"""./kit fixtures: writes the cases and the answers of known mistakes, or compares them with the
committed ones."""

import argparse
import json
import tempfile
from pathlib import Path

from bounce_grader.common.files import write_whole
from bounce_grader.common.paths import FIXTURES
from bounce_grader.grading import known_mistakes
from bounce_grader.grading.examples import TABLE
from bounce_grader.grading.fixtures import DEFAULT, hidden_folder, PUBLIC, write
from bounce_grader.publish import wrong_programs

FOLDERS = [str(folder.relative_to(FIXTURES)) for folder in (PUBLIC, DEFAULT, PUBLIC / "mistakes")]


def run(options: argparse.Namespace) -> int:
    with tempfile.TemporaryDirectory() as name:
        made = Path(name)
        write_cases(made)
        known_mistakes.write(made / FOLDERS[0])
        names = differing(made)
        if options.check:
            for differs in names:
                print(f"fixtures/{differs} isn't what the kit writes: run ./kit fixtures")
            return int(bool(names))
        for differs in names:
            (FIXTURES / differs).unlink(missing_ok=True)
            if (made / differs).exists():
                write_whole(FIXTURES / differs, (made / differs).read_bytes())
    hidden_folder()
    return 0


def write_cases(to: Path) -> None:
    """Writes the cases into a folder, with the same names as in fixtures/."""
    write("public", to / FOLDERS[0])
    write("hidden", to / FOLDERS[1])
    (to / FOLDERS[0] / TABLE.name).write_text(wrong_programs.table(), "utf-8")


def differing(made: Path) -> list[str]:
    """The committed files that differ, by even a byte, from those made, or are there alone; as paths
    in fixtures/."""
    names = {
        f"{folder}/{file.name}"
        for folder in FOLDERS
        for root in (made, FIXTURES)
        for file in (root / folder).glob("*.*")
    }
    return [name for name in sorted(names) if not _are_equal(made / name, FIXTURES / name)]


def _are_equal(made: Path, committed: Path) -> bool:
    """Answers of mistakes may differ by rounding: the libm of another machine gives other last
    digits."""
    if not (made.exists() and committed.exists()):
        return False
    texts = made.read_text("utf-8"), committed.read_text("utf-8")
    if made.parent.name == "mistakes":
        return known_mistakes.are_equal_up_to_rounding(*map(json.loads, texts))
    return texts[0] == texts[1]
