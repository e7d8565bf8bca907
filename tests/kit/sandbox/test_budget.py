"""The budget of a whole grading, and what happens to the remaining parts."""

import resource
from pathlib import Path
from typing import Any

import hostile
import pytest
from bounce_grader.common.errors import KitError
from bounce_grader.common.manifest import parts
from bounce_grader.grading import judging
from bounce_grader.grading.grade import grade as grade_path, Options
from bounce_grader.grading.report import report
from bounce_grader.sandbox import processes
from bounce_grader.sandbox.box import Box
from bounce_grader.sandbox.budget import Budget, Overrun
from conftest import Grade, Patch, points, SOLUTION, write


def _cpu_seconds_of_children() -> float:
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def test_time_that_the_machine_takes_costs_nobody_points() -> None:
    """As while a class is stopped by Ctrl-Z, or on a machine with far too much to do. The first
    number is of CPU time, the second of time on the clock."""
    with pytest.raises(KitError, match="too busy, or it was stopped"):
        Budget(100, 0).require_time()
    with pytest.raises(KitError, match="had 0 s of CPU time"):
        grade_path(SOLUTION, Options(within=Budget(60, 0)))


def test_points_earned_stay_when_the_time_is_up(grade: Grade, monkeypatch: Patch) -> None:
    judge = judging.judge

    def no_time_for_part_three(part: Any, *others: Any, **more: Any) -> judging.Judged:
        if part.number == 3:
            raise Overrun("the grading as a whole had taken its 120 s")
        return judge(part, *others, **more)

    monkeypatch.setattr(judging, "judge", no_time_for_part_three)
    record = grade({})
    assert points(record) == [30, 30, 0, 10]
    assert record["parts"][2]["status"] == "timed_out"
    assert "had taken its 120 s" in record["parts"][2]["message"]


FLOODS = "(void)!write(4, junk, sizeof junk); for (;;) pause();"


@pytest.mark.parametrize("end", ["abort();", FLOODS])
def test_the_judge_keeps_to_what_is_left(end: str, tmp_path: Path) -> None:
    """Even if each answer takes half of a runner's limit, and each new runner starts from 0; and
    whether a runner ends by itself, or is ended for writing what is no answer."""
    works = "#include <ctime>\n#include <cstdlib>\n#include <unistd.h>\nstatic char junk[4096];\n"
    works += "static void attack() { while (clock() < CLOCKS_PER_SEC / 2) {} " + end + " }"
    write(tmp_path, {part.file: hostile.part(part.number, works) for part in parts()})
    before = _cpu_seconds_of_children()
    record = grade_path(tmp_path, Options(within=Budget(4, 120)))
    assert record["score"] == 0
    assert "whole" in report(record)["parts"][3]["message"], record["parts"][3]
    assert _cpu_seconds_of_children() - before < 20  # and not the 60 that the runners could take


def test_what_a_killed_program_left_behind_counts() -> None:
    """The system counts the time of a child for a parent that waits for it; here that is killed."""
    box = Box("none", budget=Budget(60, 60))
    command = ["/bin/sh", "-c", "sh -c 'while :; do :; done' & wait"]
    before = box.budget.left()[0]
    assert box.run(command, processes.Limits(30, 2, memory=None, file_size=0)).too_long
    assert before - box.budget.left()[0] > 0.5
