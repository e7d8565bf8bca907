"""Counts the outcomes of the changes, and knows why some lose nothing."""

import json
from collections.abc import Iterable
from functools import cache
from pathlib import Path

from mutation.changes import Change
from mutation.trial import Outcome

REASONS = Path(__file__).parent / "equivalent.json"


@cache
def reasons() -> dict[str, dict[str, str]]:
    """For each file and change, the reason why it can't be told from the solution."""
    return json.loads(REASONS.read_text())


def is_alike(change: Change) -> bool:
    """Whether it is known to answer as the solution does."""
    return change.name in reasons().get(change.file, {})


def described(outcome: Outcome) -> str:
    if not outcome.compiles:
        return f"{outcome.change}: doesn't compile"
    return f"{outcome.change}: loses {', '.join(outcome.lost) or 'nothing'}"


def faults(outcomes: Iterable[Outcome]) -> list[str]:
    """The faults: changes that cost nothing, and changes listed as equivalent that cost
    something."""
    return [described(o) for o in outcomes if o.is_noticed == is_alike(o.change)]


def counts(outcomes: list[Outcome]) -> tuple[int, ...]:
    """Those made, that compile, that lose points, that can't be told from the program, and that
    are left."""
    compiled = [o for o in outcomes if o.compiles]
    alike = [o for o in compiled if is_alike(o.change)]
    left = [o for o in compiled if not o.lost and not is_alike(o.change)]
    return (
        len(outcomes),
        len(compiled),
        sum(bool(o.lost) for o in compiled),
        len(alike),
        len(left),
    )


def summary(name: str, outcomes: list[Outcome]) -> str:
    made, compiled, lost, alike, left = counts(outcomes)
    return (
        f"{name}: {made} small changes, {compiled} compile, {lost} lose points, "
        f"{alike} can't be told from it, {left} left without explanation"
    )
