"""Which files make old results of a class be graded again, and which don't."""

from bounce_grader.classroom.grading import results
from conftest import ROOT

DECIDES = (
    "grader/judge/main.cpp",
    "grader/box/filter.cpp",
    "grader/diagnosis/tables.txt",
    "grader/words/ending.cpp",
    "grader/bounce_grader/grading/grade.py",
    "solution/exact/event_driven.hpp",
    "student/given/solve_lcp.cpp",
    "student/given/examples/judge.cpp",
    "tests/parts/part3_step_test.cpp",
    "fixtures/public/mistakes/part3_step.json",
    "fixtures/public/wrong_programs.txt",
    "fixtures/scenes/free_flight.json",
    "fixtures/default/hidden/part3_step.json",
)
DECIDES_NOTHING = (
    "student/given/check/report.cpp",
    "student/README.md",
    "grader/words/endings.txt",
    "tests/parts/linked/main.cpp",
    "grader/bounce_grader/formats/html.py",
    "docs/grading.md",
)


def test_a_result_depends_on_what_judges_it_and_on_nothing_of_the_handout() -> None:
    files = {str(file.relative_to(ROOT)) for kind in results.depends_on() for file in kind}
    assert [name for name in DECIDES if name not in files] == []
    assert [name for name in DECIDES_NOTHING if name in files] == []
