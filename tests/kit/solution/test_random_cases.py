"""Random cases of the exact simulation, more of them than the usual run of its tests looks at."""

import os
import subprocess

import pytest

from bounce_grader.common.paths import BUILD


@pytest.mark.long
@pytest.mark.parametrize(
    ("tests", "cases"),
    [
        ("every_scale.EndsAndSinks*:every_scale.IsTheSame*:every_scale.RocksToRest*", 100_000),
        ("every_scale.AgreesWithMoreauJean*", 100_000),  # a tenth of them
        ("simulate_to.KeepsItsBound*", 20_000),  # half of them
    ],
)
def test_many_random_cases_hold(tests: str, cases: int) -> None:
    done = subprocess.run(
        [BUILD / "study_test", f"--gtest_filter={tests}"],
        env={**os.environ, "BOUNCE_RANDOM_CASES": str(cases)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-4000:]
