"""./check --json and ./kit grade --public --json write the same parts, field for field."""

import json
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import golden
import pytest
from bounce_grader.grading import judging
from bounce_grader.grading.grade import grade, Options
from bounce_grader.grading.known_mistakes import expected
from bounce_grader.grading.report import report
from handed_in import submission_of
from handed_out import check, put, SUBMISSIONS

pytestmark = pytest.mark.xdist_group("student")
HERE = Path(__file__).parent
DIFFERENCES = golden.table(HERE / "differences.toml")["difference"]
ALL = [
    str(folder.relative_to(SUBMISSIONS))
    for kind in ("accepted", "mistakes", "broken", "rarely_wrong", "undefined")
    for folder in sorted((SUBMISSIONS / kind).iterdir())
    # ./check runs nothing where one of the four files is missing.
    if [*folder.glob("part*.cpp")] and not expected(folder).get("alone")
]
SOON = {
    "accepted/helper_that_calls_the_earlier_parts",
    "mistakes/part1_highest_corner",
    "mistakes/part2_friction_directions_swapped",
    "mistakes/part3_moves_with_the_old_velocity",
    "mistakes/part4_initial_state_exchanged",
    "broken/part1_not_a_number",
    "broken/part3_throws_not_done_yet",
    "broken/part2_aborts",
    "broken/part3_empty_file",
    "rarely_wrong/part3_two_step_scheme",
}
NAMES = [pytest.param(name, marks=[] if name in SOON else pytest.mark.long) for name in ALL]


@pytest.mark.parametrize("name", NAMES)
def test_both_write_the_same_parts(
    name: str, home: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Apart from what sanitizers add to a crash in the course, and in ./check --sanitize."""
    monkeypatch.setattr(judging, "with_cause", lambda part, judged, *_: judged)
    submission = submission_of(SUBMISSIONS / name, tmp_path / "submission")
    course = report(grade(submission, Options(public=True)))["parts"]
    put(home, name)
    done = check(home, "--json", str(tmp_path / "record.json"))
    assert (tmp_path / "record.json").exists(), done.stderr
    own = json.loads((tmp_path / "record.json").read_text())["parts"]
    left = [line for line in _differences("", course, own) if not _is_known(name, line)]
    assert left == []


def _differences(path: str, one: Any, other: Any) -> Iterator[str]:
    """A line for each field that differs: its path, and both values. Files are named alike."""
    if isinstance(one, dict) and isinstance(other, dict):
        for key in sorted({*one, *other}):
            yield from _differences(f"{path}.{key}", one.get(key), other.get(key))
    elif isinstance(one, list) and isinstance(other, list) and len(one) == len(other):
        for number, pair in enumerate(zip(one, other)):
            yield from _differences(f"{path}[{number}]", *pair)
    elif not _says_the_same(one, other):
        yield f"{path}: {one!r} | {other!r}"


def _says_the_same(one: Any, other: Any) -> bool:
    """Recorded answers have 13 digits."""
    if isinstance(one, float) and isinstance(other, float):
        return math.isclose(one, other, rel_tol=1e-11, abs_tol=1e-12)
    return str(one) == str(other).replace("src/", "")


def _is_known(name: str, line: str) -> bool:
    return any(
        name.startswith(tuple(row["in"])) and any(field in line for field in row["fields"])
        for row in DIFFERENCES
    )
