"""Nothing false is said of programs with known slips, in styles other than the gallery's.

`python -m slips` writes the tables of docs/grading.md.
"""

from collections.abc import Callable

import pytest
from bounce_grader.common.paths import ROOT
from slips.table import said, table

FEW = 15  # random pairs for each part and style


def test_nothing_false_is_said_of_a_slip_and_two_of_three_are_named() -> None:
    rows = said(FEW)
    assert not [(row.slips, row.style, row.false) for row in rows if row.false]
    single = [row for row in rows if len(row.slips) == 1]
    assert sum(row.is_named for row in single) >= 2 / 3 * len(single)


@pytest.mark.long
def test_the_documented_tables_are_those_of_the_programs(
    record_property: Callable[[str, object], None]
) -> None:
    rows = said()
    assert len(rows) >= 3000
    assert not [(row.slips, row.style, row.false) for row in rows if row.false]
    assert table(rows) in (ROOT / "docs" / "grading.md").read_text(encoding="utf-8")
    record_property("shown", table(rows))
