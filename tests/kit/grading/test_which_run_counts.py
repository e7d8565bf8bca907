"""Which of two runs of a part counts: the table of docs/grading.md, row by row. For ./check,
tests/kit/check compares it with ./kit grade."""

import itertools

import pytest
from bounce_grader.common.manifest import parts
from bounce_grader.grading.judging import Judged, Verdict, which_counts
from conftest import ROOT

PART = parts()[2]
IDS = [check.id for check in PART.checks]
# How many checks each run may pass where the table says so; None: it didn't run.
OWN: dict[str, list[int | None]] = {
    "ran, with no fewer points": [3, 4],
    "ran, with fewer points, or can't be linked": [1, 2, None],
    "not tried, as a called part lost some (not in `./check`)": [None],
}
GIVEN: dict[str, list[int | None]] = {
    "ran, or wasn't needed": [3, None],
    "ran": [3],
    "ran, with full marks": [len(IDS)],
}
TEXT = (ROOT / "docs" / "grading.md").read_text("utf-8")
ROWS = [
    [cell.strip() for cell in line.strip("|").split("|")]
    for line in TEXT.partition("| --- | --- | --- |\n")[2].partition("\n\n")[0].split("\n")
]


def run(name: str, passed: int | None) -> Judged | None:
    if passed is None:
        return None
    checks = (Verdict(number < passed, "graded") for number in range(len(IDS)))
    return Judged(dict(zip(IDS, checks)), None, name)


@pytest.mark.parametrize("own, given, counts", ROWS[:3])
def test_each_row_of_the_table_holds(own: str, given: str, counts: str) -> None:
    for mine, theirs in itertools.product(OWN[own], GIVEN[given]):
        chosen = which_counts(PART, run("own", mine), run("given", theirs))
        assert chosen.graded_with == counts.partition(":")[0]


def test_the_table_has_no_other_row_for_the_course() -> None:
    others = [row for row in ROWS[3:] if "alone)" not in row[1]]
    assert [row[2].partition(":")[0] for row in others] == ["none"]
