"""More random cases of the exact simulation than the usual run of its tests looks at."""

import os
import subprocess

import pytest
from bounce_grader.common.paths import BUILD


@pytest.mark.long
@pytest.mark.parametrize("tests", ["exact.*", "simulate_to.Keeps*:simulate_scene.*RandomDrops"])
def test_many_random_cases_hold(tests: str) -> None:
    done = subprocess.run(
        [BUILD / "study_test", f"--gtest_filter={tests}"],
        env={**os.environ, "BOUNCE_RANDOM_CASES": "20000"},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout[-4000:]
