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
    checks = {f"part{part.number}": [check.id for check in part.checks] for part in parts()}
    return data | {"lost": [id for lost in data.get("lost", []) for id in checks.get(lost, [lost])]}


def points(lost: list[str]) -> list[float]:
    """The points of each part without these checks."""
    return [sum(c.points for c in part.checks if c.id not in lost) for part in parts()]
