"""The class's page, the near-copies on it, and the progress messages."""

import re
import zipfile
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import stand_in
from bounce_grader.classroom.intake import students
from bounce_grader.classroom.intake.student import Class, Student, Unmatched
from bounce_grader.classroom.output import charts, page
from bounce_grader.classroom.output.charts import Point, Curve
from bounce_grader.classroom.work import near_copies, progress
from bounce_grader.classroom.work.near_copies import Pair, Similar
from bounce_grader.classroom.work.summary import of_result, Summary
from bounce_grader.classroom.work.task import task_of, Stamp
from bounce_grader.common.paths import STUBS
from bounce_grader.grading.known_mistakes import for_the_instructor
from bounce_grader.submission import submission
from conftest import ROOT, solution_files, write

NOBODY = Similar((), 0)


def summary(tmp_path: Path, name: str = "anna", **changes: Any) -> Summary:
    folder = write(tmp_path / name, {"part2_lcp.cpp": name.encode()})
    record = {**stand_in.record_of(submission.read(folder)), **changes}
    result = {"state": "graded", "message": "", "record": record}
    return of_result(Student(name, name, folder), "0" * 64, result)


def shown(*summaries: Summary) -> str:
    return page.render(Class("a folder"), summaries, NOBODY, [])


def test_every_graded_submission_has_a_mark(tmp_path: Path) -> None:
    speeds = [
        {"submission_ns": 1.0, "solution_ns": 1.0, "ratio": 1.0, "largest_error": 1e-13},
        {"submission_ns": 1.0, "solution_ns": 1.0, "ratio": 1e9, "largest_error": 0.0},
        {"largest_error": None},
        {"largest_error": 1e300},
    ]
    made = [summary(tmp_path, f"s{i}", speed=speed) for i, speed in enumerate(speeds)]
    text = shown(*made, Summary(Student("x", "x", tmp_path), "k", "failed", "the kit failed"))
    assert text.count("<title>s") == 4


def test_only_what_has_all_points_stands_among_right_answers(tmp_path: Path) -> None:
    """A missing answer has no error, however small the errors of the others are."""
    near = {"submission_ns": 1.0, "solution_ns": 1.0, "ratio": 1.0, "largest_error": 4.9e-13}
    full, lost = summary(tmp_path, "full", speed=near), summary(tmp_path, "lost", speed=near)
    full, lost = replace(full, score=100.0), replace(lost, score=70.0)
    heights = re.findall(r'<circle cx="[^"]*" cy="([^"]*)"[^>]*><title>(\w+)', shown(full, lost))
    at = {name: float(y) for y, name in heights}
    line = re.search(r'<path d="M90 ([\d.]+)h', shown(full, lost))
    assert line and at["lost"] < 56 < float(line[1]) < at["full"]


def test_pairs_that_stand_out_are_named_and_the_others_counted(tmp_path: Path) -> None:
    made = [summary(tmp_path, name) for name in "abcd"]
    pairs = (Pair("a", "b", 90), Pair("c", "d", 95, (1, 2, 4)), Pair("a", "d", 91, (1, 2, 3, 4)))
    text = page.render(Class("a folder"), made, Similar(pairs, 40, more=1), [])
    shares = re.findall(r"<td>([a-d])</td><td>([a-d])</td><td class=.n.>(.*?)</td>", text)
    assert shares == [
        ("a", "b", "90 %"),
        ("c", "d", "95 % of parts 1, 2 and 4"),
        ("a", "d", "91 % of all parts"),
    ]
    assert "And 1 more pair." in text
    assert "more pair" not in page.render(Class("a folder"), made, Similar(pairs, 40), [])


def test_a_page_about_a_thousand_stays_small(tmp_path: Path) -> None:
    one = replace(
        summary(tmp_path, "one"),
        mistakes={"part1_degrees": "theta is taken for degrees"},
        notes=("something that a person should look at, with a reason",),
        ratio=1.5,
        error=1e-3,
    )
    made = [
        replace(one, student=Student(f"4{i:05}", f"Surname {i}, First Middle", tmp_path))
        for i in range(1000)
    ]
    pairs = (Pair("400001", "400002", 90),) * near_copies.MOST
    text = page.render(Class("a folder"), made, Similar(pairs, 40), ["a sentence of fifty"] * 1000)
    assert len(text.encode()) < 1_500_000
    assert "<details><summary>Adjustments and the grade book: 1000" in text
    few = page.render(Class("a folder"), made[:3], NOBODY, ["a sentence"])
    assert "<details open><summary>Adjustments and the grade book: 1<" in few


def test_the_shapes_differ_without_colour() -> None:
    drawn = charts.scatter([Point(1, 1, kind, kind) for kind in ("full", "some", "none")], 1e-9)
    marks = re.findall(r"<(?:circle|path) [^>]*><title>(\w+)", drawn)
    assert marks == ["full", "some", "none"]
    assert drawn.count('fill="none" stroke="#111"><title>some') == 1
    assert set(re.findall(r"#[0-9a-f]{3,6}", drawn)) <= {"#111", "#444", "#999"}


def test_every_timed_submission_has_a_line_beside_the_solutions(tmp_path: Path) -> None:
    untimed = summary(tmp_path, "slow", speed={"largest_error": 1e-13})
    text = shown(summary(tmp_path, "anna"), summary(tmp_path, "<b>"), untimed)
    lines = re.findall(r'<path class="curve (\w+)[^"]*" d="M([^"]*)"><title>([^<]*)', text)
    assert [title.split(":")[0] for _, _, title in lines[:2]] == ["anna", "&lt;b&gt;"]
    assert [kind for kind, _, _ in lines[2:]] == ["solution", "least"]
    assert {places.count("L") for _, places, _ in lines} == {2}  # three time steps
    assert text.count(">10 ms<") == 1


def test_the_lines_differ_without_colour_and_a_thousand_fit_into_the_page() -> None:
    places = tuple((10.0**-k, 10.0**k) for k in range(7))
    kinds = ("full", "some", "none", "solution", "least")
    drawn = charts.error_against_time([Curve(places, kind, kind) for kind in kinds], 1e-3)
    shapes = dict(re.findall(r'<marker id="(\w+)"[^>]*>(<[^>]*>)', drawn))
    assert set(shapes) == set(kinds) and len(set(shapes.values())) == len(kinds)
    assert set(re.findall(r"#[0-9a-f]{3,6}\b", drawn)) <= {"#111", "#fff"}
    odd = Curve(((1e-300, None), (1e300, 1e300), (1.0, 0.0)), "none", "<b>")
    drawn = charts.error_against_time([odd], 1e-3)
    assert "nan" not in drawn and "<b>" not in drawn
    assert (
        len(charts.error_against_time([Curve(places, "full", "a student's name")] * 1000, 1e-3))
        < 300_000
    )


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


@pytest.mark.parametrize(
    "scores, counts",
    [([0, 9.9, 10, 99.9, 100], ["2", "1", "1", "1"]), ([], []), ([100] * 7, ["7"])],
)
def test_the_histogram_counts(scores: list[float], counts: list[str]) -> None:
    drawn = charts.histogram(scores, 100)
    assert re.findall(r">(\d+)</text>", drawn.replace(">100</text>", "")) == counts


def test_recognised_mistakes_are_counted_with_the_instructors_line(tmp_path: Path) -> None:
    """A mistake of one student alone is one line."""
    one = summary(tmp_path, "one")
    both = {"part1_degrees": "theta is taken for degrees", "part2_dt_squared": "dt twice <in> V"}
    some = [
        replace(one, mistakes=both),
        replace(one, mistakes={"part1_degrees": both["part1_degrees"]}),
    ]
    text = shown(*some, one).split("Known mistakes")[1].split("</section>")[0]
    (row,) = re.findall(
        r"<tr><td>(.*?)</td><td>(.*?)</td><td>(.*?)</td><td><details><summary>(.*?)</summary>"
        r"(.*?)</details></td></tr>",
        text,
    )
    assert (row[0], row[1], row[3], row[4]) == ("1", "theta is taken for degrees", "2", "one; one")
    words, heading = for_the_instructor("part1_degrees")
    said = f'{words} <details class="small"><summary>hint {heading}</summary>phi is the distance'
    assert words and row[2].startswith(said)
    assert re.findall("<li>(.*?)</li>", text) == ["Part 2. dt twice &lt;in&gt; V: one"]
    assert "<svg" not in text and "No known mistake" not in text


def test_without_a_known_mistake_the_checks_that_failed_are_counted(tmp_path: Path) -> None:
    assert "No known mistake was recognised" in shown(summary(tmp_path, "one"))


def test_who_needs_a_look_is_named_with_the_reason(tmp_path: Path) -> None:
    slow = summary(tmp_path, "slow")
    record = stand_in.record_of(submission.read(tmp_path / "slow"))
    record["parts"][2]["status"] = "timed_out"
    record["parts"][0]["remarks"] = ["part1_contacts.cpp:10: it uses a variable that is gone"]
    slow = summary(tmp_path, "slow", parts=record["parts"])
    boxless = summary(tmp_path, "boxless", box="none")
    failed = Summary(Student("x", "x", tmp_path), "k", "failed", "the kit failed: no compiler")
    text = shown(slow, boxless, summary(tmp_path, "also", box="none"), failed)
    before, looks = text.split("<h2>Needs a look")
    assert "<svg" not in before
    looks = looks.split("<h2>Points")[0]
    assert "boxless; also</td>" in looks
    assert "part 3: timed out" in looks and "graded with no box" in looks
    assert "part 1: part1_contacts.cpp:10: it uses a variable that is gone" in looks
    assert "the kit failed: no compiler" in looks


def test_nothing_graded_is_a_page_too(tmp_path: Path) -> None:
    assert "Nothing is graded yet." in shown()


def renamed(text: bytes) -> bytes:
    """Disguises a copy: other names, other comments, another layout."""
    for name in (b"corner", b"params", b"lowest", b"impulse", b"contact_"):
        text = re.sub(rb"\b" + name + rb"\b", b"my_" + name[::-1], text)
    return b"// my own work\n\n" + text.replace(b"\n", b"\n\n")


def test_a_renamed_copy_is_found_and_the_handout_is_no_copy(tmp_path: Path) -> None:
    """Two students who left the stubs unchanged share nothing of their own."""
    copies = {name: renamed(text) for name, text in solution_files().items()}
    stubs = {file.name: file.read_bytes() for file in STUBS.glob("*.cpp")}
    with zipfile.ZipFile(tmp_path / "x.zip", "w") as archive:
        for user, files in enumerate([solution_files(), copies, stubs, stubs], 1):
            for i, (name, text) in enumerate(files.items()):
                archive.writestr(f"doe{user}_{user}_{user}{i}_{name}", text)
    found = students.read(tmp_path / "x.zip").students
    stamp = Stamp("kit", "fixtures", "options")
    tasks = {s.id: task_of(s, stamp, tmp_path, False, False) for s in found}
    near = near_copies.find(tmp_path, found, tasks, trust=False)
    assert not near.problem
    assert [(pair.first, pair.second) for pair in near.pairs] == [("1", "2")]
    assert near.pairs[0].share >= 90
    assert near_copies.find(tmp_path, found, tasks, trust=False) == near
    assert len(near_copies.own_texts(found[2].path, found[2].uploads)[0].strip()) < 200


def test_copies_of_another_year_and_of_two_parts_are_found(tmp_path: Path) -> None:
    """One has handed in last year's; another has two parts of somebody's, and two of their own."""
    solved = solution_files()
    accepted = ROOT / "tests" / "submissions" / "accepted"
    other = {
        name: (accepted / folder / name).read_bytes()
        for folder, name in (
            ("corner_in_closed_form", "part1_contacts.cpp"),
            ("lcp_entry_by_entry", "part2_lcp.cpp"),
        )
    }
    last_year = write(tmp_path / "2025" / "old", {n: renamed(t) for n, t in solved.items()}).parent
    mixed = {**{name: renamed(text) for name, text in solved.items()}, **other}
    with zipfile.ZipFile(tmp_path / "x.zip", "w") as archive:
        for user, files in enumerate([solved, mixed], 1):
            for i, (name, text) in enumerate(files.items()):
                archive.writestr(f"doe{user}_{user}_{user}{i}_{name}", text)
    found = students.read(tmp_path / "x.zip").students
    stamp = Stamp("kit", "fixtures", "options")
    tasks = {s.id: task_of(s, stamp, tmp_path, False, False) for s in found}
    near = near_copies.find(tmp_path, found, tasks, trust=False, corpus=[last_year])
    assert not near.problem
    pairs = {(pair.first, pair.second): pair for pair in near.pairs}
    assert ("1", "2025/old") in pairs and {"1", "2"} <= {id for ids in pairs for id in ids}
    assert not any(p.first.startswith("2025") for p in near.pairs)


def test_progress_is_plain_lines_where_there_is_no_terminal(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(progress, "SECONDS_BETWEEN_LINES", 0.0)
    with progress.progress(2) as bar:
        bar.advance()
        bar.advance()
    lines = capsys.readouterr().err.splitlines()
    assert re.fullmatch(r"kit: 1 of 2 graded, \d+ a minute, 0 s left", lines[0])
    assert re.fullmatch(r"kit: 2 of 2 graded, \d+ a minute", lines[1])


SCROLLS_WITHOUT_KEYS = """
return [...document.querySelectorAll("*")]
  .filter(one => ["auto", "scroll"].includes(getComputedStyle(one).overflowX))
  .filter(one => one.scrollWidth > one.clientWidth)
  .filter(one => one.tabIndex < 0 && !one.querySelector("a, button, summary"))
  .map(one => one.outerHTML.slice(0, 80))
"""


@pytest.mark.parametrize("width", [390, 1280])
def test_all_of_the_page_can_be_reached_on_a_phone_and_by_keys(
    tmp_path: Path, driver: Any, width: int
) -> None:
    unread = Unmatched("dupontemile_1204649_text.html", "is text typed into Canvas")
    looks = summary(tmp_path, "x" * 60).with_note("a reason that is somewhat longer than others")
    submitted = Class("a folder", unmatched=[unread])
    text = page.render(submitted, [summary(tmp_path), looks], NOBODY, [])
    write(tmp_path, {"class.html": text.encode()})
    size = {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": width < 500}
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
    driver.get((tmp_path / "class.html").as_uri())
    assert driver.execute_script(SCROLLS_WITHOUT_KEYS) == []
    assert driver.execute_script("return document.documentElement.scrollWidth") <= width
    names = "[...document.querySelectorAll('.names td:first-child')].map(cell => cell.offsetWidth)"
    assert min(driver.execute_script(f"return {names}")) >= 150  # a name with its id
