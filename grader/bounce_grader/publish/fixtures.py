"""./kit fixtures: writes the cases and known mistakes' answers, or compares the committed ones."""

import argparse
import math
import re
import tempfile
from functools import partial
from pathlib import Path

from bounce_grader.common.files import write_whole
from bounce_grader.common.paths import FIXTURES
from bounce_grader.grading import known_mistakes
from bounce_grader.grading.examples import TABLE
from bounce_grader.grading.fixtures import DEFAULT, hidden_folder, PUBLIC, write
from bounce_grader.publish import wrong_programs

NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]\d+)?")  # of JSON
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
    """The files, as paths in fixtures/, that differ by even a byte or are only on one side."""
    sides = [(root, folder) for root in (made, FIXTURES) for folder in FOLDERS]
    names = {f"{at}/{file.name}" for root, at in sides for file in (root / at).glob("*.*")}
    return [name for name in sorted(names) if not _are_equal(made / name, FIXTURES / name)]


def _are_equal(made: Path, committed: Path) -> bool:
    """Answers of mistakes may differ by rounding: another machine's libm has other last digits."""
    if not (made.exists() and committed.exists()):
        return False
    texts = made.read_text("utf-8"), committed.read_text("utf-8")
    if made.parent.name != "mistakes":
        return texts[0] == texts[1]
    numbers = (map(float, NUMBER.findall(text)) for text in texts)
    alike = partial(math.isclose, rel_tol=1e-10, abs_tol=1e-10)
    return len({NUMBER.sub("0", text) for text in texts}) == 1 and all(map(alike, *numbers))
