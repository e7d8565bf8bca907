"""What a person wrote down of a submission of the gallery, in its expected.json."""

import json
from pathlib import Path
from typing import Any

from bounce_grader.common.manifest import parts

Expected = dict[str, Any]


def expected(folder: Path) -> Expected:
    """With every lost check by its id; the file names a part for all of its checks. A
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
    """In the manifest's order; what the manifest doesn't have stays at the end."""
    known = [(f"part{part.number}", check.id) for part in parts() for check in part.checks]
    named = [check for part, check in known if part in lost or check in lost]
    return named + [name for name in lost if all(name not in words for words in known)]
