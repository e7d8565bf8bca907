"""Counts the outcomes of the changes by file, by kind, and by the reason why they lose nothing."""

import json
from collections import Counter
from collections.abc import Iterable
from functools import cache
from pathlib import Path

from mutation.changes import OPERATORS, Change
from mutation.trial import Outcome

REASONS = Path(__file__).parent / "equivalent.json"
COLUMNS = ("made", "compile", "lose points", "equivalent", "left")


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
    """As COLUMNS says."""
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


def row(name: str, outcomes: list[Outcome]) -> str:
    return f"| {name} | " + " | ".join(map(str, counts(outcomes))) + " |\n"


def tables(outcomes: list[Outcome]) -> str:
    """Those of docs/mutation.md: by file, by kind of change, and by reason."""
    files = dict.fromkeys(o.change.file for o in outcomes)
    lines = [_head("right program", *COLUMNS)]
    lines += [row(file, [o for o in outcomes if o.change.file == file]) for file in files]
    lines += [row("all", outcomes), "\n", _head("kind of change", *COLUMNS)]
    lines += [row(kind, [o for o in outcomes if o.change.operator == kind]) for kind in OPERATORS]
    return "".join([*lines, "\n", table_of_reasons()])


def table_of_reasons() -> str:
    count = Counter(reason for of_file in reasons().values() for reason in of_file.values())
    in_order = sorted(count.items(), key=lambda item: (-item[1], item[0]))
    rows = [f"| {reason} | {number} |\n" for reason, number in in_order]
    return _head("why it can't be told from the solution", "changes") + "".join(rows)


def _head(name: str, *columns: str) -> str:
    return f"| {name} | {' | '.join(columns)} |\n| --- |{' ---: |' * len(columns)}\n"
