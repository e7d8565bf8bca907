"""The page of a class: what it shows, as a person has read it in class_page/."""

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import golden
import pytest
import stand_in
from bounce_grader.classroom.grading.near_copies import Pair, Similar
from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.classroom.intake.student import Student
from bounce_grader.classroom.output import page
from bounce_grader.grading.report import report
from bounce_grader.formats.speed_chart import Curve, error_over_time
from bounce_grader.submission.submission import Submission

NOBODY = Similar((), 0)
DEGREES = {"name": "part1_degrees", "title": "theta is taken for degrees"}
TWICE = {"name": "part2_dt_squared", "title": "dt twice <in> V"}


def summary(name: str, ns: float = 300, mistakes: Sequence[Any] = (), **changes: Any) -> Summary:
    """Of a student who was timed, and makes these mistakes."""
    files = {"part2_lcp.cpp": f"// ns: {ns}".encode()}
    record = stand_in.record_of(Submission(name, files, {2: "part2_lcp.cpp"}, {})) | changes
    told = report(record)
    told["parts"][0]["mistakes"] = mistakes
    student = Student(name, name, Path(name), feedback=f"{name}.html")
    return Summary(student, "graded", "", "0", told)


@pytest.mark.golden
def test_the_page_is_what_a_person_has_read() -> None:
    """A missing answer has no error, however small those of the others are: only who has all points
    stands among right answers."""
    times = {"submission_ns": 1.0, "solution_ns": 1.0, "ratio": 1.0}
    odd = {"slow": times | {"ratio": 1e9, "largest_error": 0.0}, "untimed": {"largest_error": None}}
    odd |= {"far": {"largest_error": 1e300}, "exact": times | {"largest_error": 1e-13}}
    made = [summary(name, speed=speed) for name, speed in odd.items()]
    made += [summary("<b>"), summary("quick", 1e-300)]
    made += [summary("right", mistakes=[DEGREES], score=100)]
    made += [Summary(Student("x", "x", Path("x")), "failed", "the kit failed")]
    cases = {"caught": ["1B", "2H"]}
    made += [summary("lost", mistakes=[DEGREES, TWICE], score=70, examples=cases)]
    pairs = (Pair("far", "slow", 90), Pair("<b>", "lost", 95, (1, 2, 4)))
    near = Similar((*pairs, Pair("far", "lost", 91, (1, 2, 3, 4))), 40, more=1)
    text = page.render(made, near, ["a sentence"], "")
    text = re.sub(r"(?s)<style>.*?</style>", "<style>...</style>", text)
    numbers = ((1e-300, None), (1e300, 1e300), (1.0, 0.0))
    odd_curves = [Curve(numbers, kind, "<b>", ("10 ms",)) for kind in ("none", "solution")]
    curves = {"any_numbers.svg": error_over_time(odd_curves, "any numbers"), "page.html": text}
    expected = {name: re.sub(r">(?=<\w)", ">\n", text) for name, text in curves.items()}
    golden.compare(Path(__file__).parent / "class_page", expected)
    assert "None." in page.render([], NOBODY, [], "")
