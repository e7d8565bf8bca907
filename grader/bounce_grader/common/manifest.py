"""The parts and their checks, from grader/parts.json: the one place where points stand."""

import json
from functools import cache
from typing import NamedTuple

from bounce_grader.common.paths import ROOT


class Check(NamedTuple):
    id: str
    title: str
    points: float


class Part(NamedTuple):
    number: int
    stem: str
    title: str
    function: str
    points: float
    checks: tuple[Check, ...]

    @property
    def file(self) -> str:
        return f"{self.stem}.cpp"

    @property
    def has_earlier_parts(self) -> bool:
        """Parts 3 and 4 call earlier ones, which can be given to them."""
        return self.number >= 3


@cache
def parts() -> tuple[Part, ...]:
    manifest = json.loads((ROOT / "grader" / "parts.json").read_text())
    return tuple(
        Part(
            number=part["part"],
            stem=part["stem"],
            title=part["title"],
            function=part["function"],
            points=part["points"],
            checks=tuple(Check(**check) for check in part["checks"]),
        )
        for part in manifest["parts"]
    )
