"""The same failed public case has the same words in ./check and in ./kit grade."""

from pathlib import Path

import pytest
from bounce_grader.common.manifest import parts
from bounce_grader.grading.grade import grade
from handed_in import submission_of
from handed_out import check, put, run, SUBMISSIONS

pytestmark = pytest.mark.xdist_group("student")
NAMES = [
    "mistakes/part1_highest_corner",
    "mistakes/part2_friction_directions_swapped",
    "mistakes/part3_moves_with_the_old_velocity",
    "broken/part1_not_a_number",
    "broken/part3_throws_not_done_yet",
    "mistakes/part4_initial_state_exchanged",
]


@pytest.mark.parametrize("name", NAMES)
def test_a_failed_case_is_told_alike(name: str, home: Path, tmp_path: Path) -> None:
    """Where the course's first wrong case is a public one. It has hidden cases as well, so that
    its numbers of cases are others."""
    record = grade(submission_of(SUBMISSIONS / name, tmp_path / "submission"))
    part = parts()[int(name.partition("/part")[2][0]) - 1]
    put(home, name)
    check(home)
    told = run(home, f"build/{part.stem}_test").stdout
    compared = 0
    for graded in record["parts"][part.number - 1]["checks"]:
        case = graded["message"].partition("the first: ")[2]
        if case and not graded["shown"]["hidden"]:
            assert case in told, told
            compared += 1
    assert compared
