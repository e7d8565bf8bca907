"""Counts the outcomes of the changes by part and kind."""

import json
from collections.abc import Iterable
from functools import cache
from pathlib import Path

from mutation.changes import OPERATORS, Change
from mutation.trial import Outcome

REASONS = Path(__file__).parent / "equivalent.json"
COLUMNS = ("made", "compiled", "noticed", "alike", "left", "left by public cases alone")


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


def survivors(outcomes: Iterable[Outcome]) -> list[Change]:
    """The changes that compile and cost nothing."""
    return [outcome.change for outcome in outcomes if not outcome.is_noticed]


def by_operator(outcomes: list[Outcome], told_apart: set[str]) -> str:
    """A row for each file and a column for each kind of change: how many cost points, of those that
    compile and that the solution isn't like. What costs nothing is like it unless it is among
    `told_apart`, the names of those that random questions tell from it."""
    compiled = [o for o in outcomes if o.compiles and (o.lost or str(o.change) in told_apart)]
    kinds = [k for k in OPERATORS if any(o.change.operator == k for o in compiled)]
    lines = ["| | made | compile | " + " | ".join(kinds) + " | all |"]
    lines.append("| --- |" + " ---: |" * (len(kinds) + 3))
    for file in [*dict.fromkeys(o.change.file for o in outcomes), ""]:
        made = [o for o in outcomes if file in ("", o.change.file)]
        rows = [[o for o in compiled if o in made and k in ("", o.change.operator)] for k in kinds]
        shares = [_share(row) for row in [*rows, [o for row in rows for o in row]]]
        numbers = [len(made), sum(o.compiles for o in made)]
        lines.append(f"| {file or 'all'} | {' | '.join([*map(str, numbers), *shares])} |")
    return "\n".join(lines)


def _share(outcomes: list[Outcome]) -> str:
    return f"{sum(bool(o.lost) for o in outcomes)}/{len(outcomes)}" if outcomes else ""


def counts(outcomes: list[Outcome]) -> tuple[int, ...]:
    compiled = [o for o in outcomes if o.compiles]
    different = [o for o in compiled if not is_alike(o.change)]
    return (
        len(outcomes),
        len(compiled),
        sum(bool(o.lost) for o in compiled),
        len(compiled) - len(different),
        sum(not o.lost for o in different),
        sum(not o.lost_in_public for o in different),
    )


def table(outcomes: list[Outcome]) -> str:
    """A row for each kind of change of each file, and for each file."""
    lines = [f"{'':32}" + "".join(f"{column:>{_width(column)}}" for column in COLUMNS)]
    for file in dict.fromkeys(o.change.file for o in outcomes):
        of_file = [o for o in outcomes if o.change.file == file]
        for kind in dict.fromkeys(o.change.operator for o in of_file):
            rows = [o for o in of_file if o.change.operator == kind]
            lines.append(_row(f"{file}: {kind}", counts(rows)))
        lines.append(_row(file, counts(of_file)))
    return "\n".join([*lines, _row("all", counts(outcomes))])


def _row(name: str, numbers: Iterable[int]) -> str:
    return f"{name:32}" + "".join(f"{n:>{_width(c)}}" for n, c in zip(numbers, COLUMNS))


def _width(column: str) -> int:
    return max(10, len(column) + 2)
