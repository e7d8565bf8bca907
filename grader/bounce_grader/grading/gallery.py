"""What a person wrote down of a submission of the gallery, in its expected.json."""

import json
from pathlib import Path
from typing import Any

from bounce_grader.common.manifest import parts

Expected = dict[str, Any]


def expected(folder: Path) -> Expected:
    """With every lost check by its id; the file names a part for all of its checks. A right
    submission that loses nothing needs no file."""
    file = folder / "expected.json"
    words: Expected = json.loads(file.read_text()) if file.exists() else {}
    return words | {"lost": _checks(words.get("lost", []))}


def in_reduced_box(words: Expected) -> Expected:
    """The same submission, with what is written down of the reduced box in place of the rest."""
    other = dict(words["reduced"])
    if "lost" in other:
        other["lost"] = _checks(other["lost"])
    return words | other


def points(lost: list[str]) -> list[float]:
    """What is left of each part's points without these checks."""
    return [sum(c.points for c in part.checks if c.id not in lost) for part in parts()]


def _checks(lost: list[str]) -> list[str]:
    whole = {f"part{part.number}": [check.id for check in part.checks] for part in parts()}
    return [check for name in lost for check in whole.get(name, [name])]
