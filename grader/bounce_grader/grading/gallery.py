"""Reads expected.json, in which a person wrote what a submission of the gallery should get."""

import json
from pathlib import Path
from typing import Any

from bounce_grader.common.manifest import parts

Expected = dict[str, Any]


def expected(folder: Path, reduced: bool = False) -> Expected:
    """The content of expected.json, with parts in "lost" replaced by the ids of their checks; in
    the reduced box, the entries under "reduced" replace the others. A submission that loses nothing
    needs no file."""
    file = folder / "expected.json"
    data: Expected = json.loads(file.read_text()) if file.exists() else {}
    if reduced:
        data |= data["reduced"]
    return data | {"lost": _checks(data.get("lost", []))}


def points(lost: list[str]) -> list[float]:
    """The points of each part without these checks."""
    return [sum(c.points for c in part.checks if c.id not in lost) for part in parts()]


def _checks(lost: list[str]) -> list[str]:
    """The ids of these checks and parts' checks, in the manifest's order; unknown names come
    last."""
    known = [(f"part{part.number}", check.id) for part in parts() for check in part.checks]
    named = [check for part, check in known if part in lost or check in lost]
    return named + [name for name in lost if all(name not in words for words in known)]
