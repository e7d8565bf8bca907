"""The charts of the class's page and its size, on paper, on a phone and by keys."""

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import stand_in
from bounce_grader.classroom.intake.student import Class, Student, Unmatched
from bounce_grader.classroom.output import charts, page
from bounce_grader.classroom.output.charts import Curve, Point
from bounce_grader.classroom.work import near_copies
from bounce_grader.classroom.work.near_copies import Pair, Similar
from bounce_grader.classroom.work.summary import of_result, Summary
from bounce_grader.grading.known_mistakes import for_the_instructor
from bounce_grader.submission import submission
from conftest import write

NOBODY = Similar((), 0)
DEGREES = {"part1_degrees": "theta is taken for degrees"}


def summary(tmp_path: Path, name: str = "anna", **changes: Any) -> Summary:
    """Of a student who was timed."""
    folder = write(tmp_path / name, {"part2_lcp.cpp": b"// ns: 300"})
    record = {**stand_in.record_of(submission.read(folder)), **changes}
    result = {"state": "graded", "message": "", "record": record}
    return of_result(Student(name, name, folder), "0" * 64, result)


def shown(*summaries: Summary, near: Similar = NOBODY) -> str:
    return page.render(Class("a folder"), summaries, near, [])


def test_every_graded_submission_has_a_mark_and_a_line_if_it_was_timed(tmp_path: Path) -> None:
    """What takes long, or has no finite error, too."""
    times = {"submission_ns": 1.0, "solution_ns": 1.0, "ratio": 1.0}
    speeds = [times | {"ratio": 1e9, "largest_error": 0.0}, {"largest_error": None}]
    speeds += [{"largest_error": 1e300}, times | {"largest_error": 1e-13}]
    made = [summary(tmp_path, f"s{i}", speed=speed) for i, speed in enumerate(speeds)]
    failed = Summary(Student("x", "x", tmp_path), "k", "failed")
    text = shown(*made, summary(tmp_path, "<b>"), failed)
    assert text.count("<title>s") == 4
    lines = re.findall(r'<path class="curve (\w+)[^"]*" d="M[^"]*"><title>([^<:]*)', text)
    assert [kind for kind, _ in lines] == ["some", "solution", "least"]
    assert lines[0][1] == "&lt;b&gt;"
    text = text[text.index("Speed against accuracy, one line") :]
    one = re.search(r'<text x="([\d.]+)"[^>]*>1</text>', text)  # the solution's time at dt = 1 ms
    last = re.search(r'class="curve solution[^"]*" d="[^"]*L(\d+) \d+"', text)
    assert one and last and float(last[1]) == pytest.approx(float(one[1]), abs=1)


def test_only_what_has_all_points_stands_among_right_answers(tmp_path: Path) -> None:
    """A missing answer has no error, however small those of the others are."""
    full = replace(summary(tmp_path, "full"), score=100.0, error=4.9e-13)
    lost = replace(summary(tmp_path, "lost"), score=70.0, error=4.9e-13)
    text = shown(full, lost)
    heights = re.findall(r'<circle cx="[^"]*" cy="([^"]*)"[^>]*><title>(\w+)', text)
    at = {name: float(y) for y, name in heights}
    line = re.search(r'<path d="M90 ([\d.]+)h', text)
    assert line and at["lost"] < 56 < float(line[1]) < at["full"]


def test_marks_and_lines_differ_without_colour() -> None:
    kinds = ("full", "some", "none", "solution", "least")
    drawn = charts.scatter([Point(1, 1, kind, kind) for kind in kinds[:3]], 1e-9)
    marks = re.findall(r"<((?:circle|path) [^>]*)><title>", str(drawn))
    assert len({re.sub(r' (c?[xyr]|d)="[^"]*"', "", mark) for mark in marks}) == 3
    places = tuple((10.0**-k, 10.0**k) for k in range(7))
    odd = Curve(((1e-300, None), (1e300, 1e300), (1.0, 0.0)), "none", "<b>")
    lines = charts.error_against_time([*(Curve(places, kind, kind) for kind in kinds), odd], 1e-3)
    assert "nan" not in lines and "<b>" not in lines
    shapes = dict(re.findall(r'<marker id="(\w+)"[^>]*>(<[^>]*>)', lines))
    assert set(shapes) == set(kinds) and len(set(shapes.values())) == len(kinds)
    assert set(re.findall(r"#[0-9a-f]{3,6}\b", drawn + lines)) <= {"#111", "#444", "#999", "#fff"}


def test_labels_of_a_curve_lie_apart_and_within_the_frame() -> None:
    """Three steps whose places nearly coincide, at the right edge and at the top."""
    places = ((1e5, 1e2), (0.99e5, 0.9e2), (0.98e5, 0.95e2))
    steps = ("10 ms", "3 ms", "1 ms")
    drawn = charts.error_against_time([Curve(places, "solution", "x", steps)], 1e-3)
    found = re.findall(r'<text x="([\d.]+)" y="([\d.]+)"[^>]*>(?:10|3|1) ms<', drawn)
    at = [(float(x), float(y)) for x, y in found]
    assert len(at) == 3
    assert all(90 < x < charts.WIDTH - 40 - 40 and 20 < y - 10 for x, y in at)
    for i, (x, y) in enumerate(at):
        assert all(abs(y - v) >= charts.LINE or abs(x - u) > 44 for u, v in at[:i])


def test_the_histogram_counts() -> None:
    drawn = charts.histogram([0, 9.9, 10, 99.9, *[100] * 7], 100)
    counts = re.findall(r">(\d+)</text>", drawn.replace(">100</text>", ""))
    assert counts == ["2", "1", "1", "7"]


def test_known_mistakes_are_counted_with_the_instructors_line(tmp_path: Path) -> None:
    """A mistake of one student alone is one line; without any, the failed checks are counted."""
    one = summary(tmp_path, "one")
    both = {**DEGREES, "part2_dt_squared": "dt twice <in> V"}
    text = shown(replace(one, mistakes=both), replace(one, mistakes=DEGREES), one)
    words, heading = for_the_instructor("part1_degrees")
    line = f'{words} <details class="small"><summary>hint {heading}</summary>phi is the distance'
    assert f"<td>1</td><td>{DEGREES['part1_degrees']}</td><td>{line}" in text
    assert "<summary>2</summary>one; one</details>" in text
    assert "<li>Part 2. dt twice &lt;in&gt; V: one" in text
    assert "No known mistake was recognised" in shown(one) and "Nothing is graded" in shown()


def test_pairs_that_stand_out_are_named_and_the_others_counted(tmp_path: Path) -> None:
    pairs = (Pair("a", "b", 90), Pair("c", "d", 95, (1, 2, 4)), Pair("a", "d", 91, (1, 2, 3, 4)))
    text = shown(*(summary(tmp_path, n) for n in "abcd"), near=Similar(pairs, 40, more=1))
    shares = re.findall(r"<td>[a-d]</td><td>[a-d]</td><td class=.n.>(.*?)</td>", text)
    assert shares == ["90 %", "95 % of parts 1, 2 and 4", "91 % of all parts"]
    assert "And 1 more pair." in text


def test_a_page_about_a_thousand_stays_small_and_needs_nothing_else(tmp_path: Path) -> None:
    looks = ("something that a person should look at, with a reason",)
    one = replace(summary(tmp_path, "one"), mistakes=DEGREES, notes=looks)
    people = [Student(f"4{i:05}", f"Surname {i}, First Middle", tmp_path) for i in range(1000)]
    made = [replace(one, student=student) for student in people]
    pairs = Similar((Pair("400001", "400002", 90),) * near_copies.MOST, 40)
    text = page.render(Class("a folder"), made, pairs, ["a sentence of fifty"] * 1000)
    assert len(text.encode()) < 2_000_000
    assert "<details><summary>Adjustments and the grade book: 1000" in text
    assert "http" not in text.replace("http-equiv", "")
    assert text.count("<circle cx=") == 1000 and text.count('<path class="curve ') == 1002


SCROLLS_WITHOUT_KEYS = """
return [...document.querySelectorAll("*")]
  .filter(one => ["auto", "scroll"].includes(getComputedStyle(one).overflowX))
  .filter(one => one.scrollWidth > one.clientWidth)
  .filter(one => one.tabIndex < 0 && !one.querySelector("a, button, summary"))
  .map(one => one.outerHTML.slice(0, 80))
"""
NAMES = "return [...document.querySelectorAll('.names td:first-child')].map(one => one.offsetWidth)"


def test_all_of_the_page_can_be_reached_on_a_phone_and_by_keys(tmp_path: Path, driver: Any) -> None:
    unread = Unmatched("dupontemile_1204649_text.html", "is text typed into Canvas")
    looks = summary(tmp_path, "x" * 60).with_note("a reason that is somewhat longer than others")
    submitted = Class("a folder", unmatched=[unread])
    text = page.render(submitted, [summary(tmp_path), looks], NOBODY, [])
    write(tmp_path, {"class.html": text.encode()})
    for width in (390, 1280):
        size = {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": width < 500}
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
        driver.get((tmp_path / "class.html").as_uri())
        assert driver.execute_script(SCROLLS_WITHOUT_KEYS) == []
        assert driver.execute_script("return document.documentElement.scrollWidth") <= width
        assert min(driver.execute_script(NAMES)) >= 150  # a name with its id
