"""Speed against accuracy: what the stopwatch measures, and which tricks can't deceive it.

No test compares times, so that they hold on a busy machine, too: ./kit bench does.
"""

import json
import math
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest
from bounce_grader import formats
from bounce_grader.common import chart_style, escaping
from bounce_grader.common.errors import KitError
from bounce_grader.formats import html, speed_chart, terminal
from bounce_grader.grading import speed
from bounce_grader.grading.grade import grade, Options
from bounce_grader.grading.speed import Point
from bounce_grader.publish import handout_study
from conftest import ROOT, solution_files, write

SIMULATE = solution_files()["part4_simulate.cpp"].decode()
HEAD = "#include <bounce/part4_simulate.hpp>\n#include <map>\n#include <tuple>\n"
SIGNATURE = "Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params)"
ACCEPTED = ROOT / "tests" / "submissions" / "accepted"
ONE_CORNER = ["free_flight", "oblique_bounce", "pointed_drop", "projectile", "spin", "tumble"]


def around(before: str, after: str = "return right;") -> bytes:
    """The solution's simulate, renamed `honest`, and a simulate that modifies its result."""
    honest = SIMULATE.replace(" simulate(", " honest(")
    body = f"{before} const Trajectory right = honest(q_0, v_0, params); {after}"
    return f"{HEAD}{honest}\nnamespace bounce {{ {SIGNATURE} {{ {body} }} }}\n".encode()


def alone(body: str) -> bytes:
    return f"{HEAD}namespace bounce {{ {SIGNATURE} {{ {body} }} }}\n".encode()


def graded(tmp_path: Path, part4: bytes | None = None) -> dict[str, Any]:
    changes = {} if part4 is None else {"part4_simulate.cpp": part4}
    folder = write(tmp_path / "submission", {**solution_files(), **changes})
    return grade(folder, Options(speed=True))


def timed(tmp_path: Path, part4: bytes | None = None) -> dict[str, Any]:
    found: dict[str, Any] = graded(tmp_path, part4)["speed"]
    return found


def worst(found: dict[str, Any]) -> list[float | None]:
    return [point.error for point in speed.curve(found, "submission")]


# ---- what is measured ----


def test_the_solution_is_as_exact_and_as_fast_as_itself(tmp_path: Path) -> None:
    found = timed(tmp_path)
    assert [scene["scene"] for scene in found["scenes"]] == ONE_CORNER
    assert found["cut"] == "" and 0 < found["largest_error"] < 1e-9
    for scene in found["scenes"]:
        assert [p["error"] for p in scene["submission"]] == [p["error"] for p in scene["solution"]]
        assert [p["dt"] for p in scene["submission"]] == pytest.approx(found["dt"], rel=0.3)


def test_the_error_falls_with_the_step_and_is_the_same_each_time(tmp_path: Path) -> None:
    first, second = timed(tmp_path / "a"), timed(tmp_path / "b")
    assert worst(first) == worst(second)
    errors = [error or math.inf for error in worst(first)]
    assert errors[-1] < errors[0] / 20 and errors[-1] < speed.FINE
    for scene in first["scenes"]:
        assert scene["least"][-1]["error"] <= scene["least"][0]["error"] + 1e-14  # rounding


def test_who_does_everything_twice_is_as_exact(tmp_path: Path) -> None:
    found = timed(tmp_path, around("const Trajectory first = honest(q_0, v_0, params);"))
    assert worst(found) == [p.error for p in speed.curve(found, "solution")]


# ---- what can't be pretended ----

ZEROS = "return {Eigen::Matrix3Xd::Zero(3, params.T), Eigen::Matrix3Xd::Zero(3, params.T)};"
# Two columns of three are the one before: a third of the work.
BUILT_FOR_SPEED = {
    "zeros": f"#ifdef NDEBUG\n{ZEROS}\n#endif\n",
    "zeros at small steps": f"#ifdef NDEBUG\nif (params.dt < 2e-4) {ZEROS}\n#endif\n",
    "zeros after the first questions": f"""#ifdef NDEBUG
        static int asked = 0; if (++asked > 40) {ZEROS}\n#endif\n""",
    "another step": "#ifdef NDEBUG\nParameters other = params; other.mu *= 1 + 1e-6;\n"
    "return honest(q_0, v_0, other);\n#endif\n",
}


@pytest.mark.parametrize("name", BUILT_FOR_SPEED)
@pytest.mark.usual(1)
def test_what_answers_otherwise_built_for_speed_has_no_curve(tmp_path: Path, name: str) -> None:
    record = graded(tmp_path, around(f"\n{BUILT_FOR_SPEED[name]}"))
    assert record["score"] == record["max_score"]
    assert set(record["speed"]) == {"otherwise", "largest_error"}
    assert record["speed"]["otherwise"].startswith(f"{speed.OTHERWISE}: at dt = ")
    for format in set(formats.NAMES) - {"junit", "classroom50"}:
        text = formats.render(format, record, tmp_path)
        assert speed.OTHERWISE[1:] in text.replace(escaping.ZERO_WIDTH_SPACE, ""), format
    assert f"B{speed.OTHERWISE[1:]}" in str(terminal.lines(record))
    [board] = json.loads(formats.render("gradescope", record, tmp_path))["leaderboard"][:-1]
    assert board["name"] == "Points"


@pytest.mark.parametrize(
    "name",
    ["own_lcp_solver_by_enumeration", "contact_by_cases", "c_arrays_and_loops"]
    + ["jacobian_by_complex_step", "corner_in_closed_form", "dynamic_matrices_and_lu"],
)
@pytest.mark.usual(1)
def test_who_rounds_otherwise_is_right(tmp_path: Path, name: str) -> None:
    files = {f.relative_to(ACCEPTED / name).as_posix(): f for f in (ACCEPTED / name).rglob("*.?pp")}
    changes = {file: path.read_bytes() for file, path in files.items()}
    folder = write(tmp_path, {**solution_files(), **changes})
    found = grade(folder, Options(speed=True))["speed"]
    assert found.get("cut") == "" and "otherwise" not in found


MOVED = "r.q.colwise() += q_0 - Vector3(r.q.col(0)); r.v.colwise() += v_0 - Vector3(r.v.col(0));"
EVERY_THIRD = "for (int i = 1; i < params.T; ++i) if (i % 3) mine.q.col(i) = mine.q.col(i - 1);"
ROUND = "std::round(1e4 * v_0(0)) == 1e4 * v_0(0) && std::round(1e4 * v_0(1)) == 1e4 * v_0(1)"
OFTEN = "params.dt < 0.0035 && std::abs(params.delta - 0.1 * params.dt) < 1e-12"  # only when timed
KEPT = f"""static std::map<int, Trajectory> known;
    if (auto k = known.find(params.T); k != known.end() && k->second.q(1, 0) == q_0(1))
    {{ Trajectory r = k->second; {MOVED} return r; }}"""
FLOATING = """Trajectory r = right;
    for (int i = 1; i < params.T; ++i) if (r.v(1, i) > r.v(1, i - 1) + 1e-3) {
      for (; i < params.T; ++i) {
        r.q.col(i) << 0, params.l / 2 + params.delta, 0;
        r.v.col(i).setZero();
      }
    }
    return r;"""
WRONG = {
    "an empty loop": alone(ZEROS),
    "wrong at steps that no check asks for": around(f"if (params.dt < 2e-4) {ZEROS}"),
    "columns left out": around("", f"Trajectory mine = right; {EVERY_THIRD} return mine;"),
    "kept from before, and moved to the start": around(KEPT, "return known[params.T] = right;"),
    "wrong from another start than the scene's": around(f"if ({OFTEN} && !({ROUND})) {ZEROS}"),
    # Without friction, too; a state at delta itself is reached by a step alone.
    "floating where rounding decides": around(
        "", f"if (!({OFTEN}) || params.mu != 0 || {ROUND}) return right; {FLOATING}"
    ),
    "no number": around(
        "", "Trajectory r = right; r.q.col(r.q.cols() - 1).setConstant(NAN); return r;"
    ),
}


@pytest.mark.parametrize("name", WRONG)
@pytest.mark.usual(2)
def test_what_is_wrong_somewhere_has_no_times(tmp_path: Path, name: str) -> None:
    record = graded(tmp_path, WRONG[name])
    assert set(record["speed"]) == {"otherwise", "largest_error"}
    said = record["speed"]["otherwise"]
    assert said.startswith((f"{speed.WRONG}: at dt = ", f"{speed.OTHERWISE}: at dt = "))
    assert said[1:] in str(terminal.lines(record))


def test_a_program_that_does_not_compile_is_not_compiled_to_be_timed(tmp_path: Path) -> None:
    files = {**solution_files(), "part2_lcp.cpp": b"#error no\n"}
    record = grade(write(tmp_path, files), Options(speed=True))
    assert set(record["speed"]) == {"largest_error"}


CONTACTS = solution_files()["part1_contacts.cpp"].decode()


def far_away_where(condition: str) -> bytes:
    """Part 1, with a height that is a million where the condition holds."""
    honest = CONTACTS.replace(" get_contacts(", " honest(")
    return f"""{honest}
    namespace bounce {{ Contact get_contacts(const Vector3& q, const Parameters& params) {{
    Contact contact = honest(q, params); if ({condition}) contact.phi = 1e6; return contact; }} }}
    """.encode()


def test_the_largest_error_tells_no_expected_number(tmp_path: Path) -> None:
    checks = json.loads((ROOT / "fixtures" / "public" / "part1_contacts.json").read_text())[
        "checks"
    ]
    public = [case for cases in checks.values() for case in cases]
    hidden = " && ".join(f"q(0) != {case['input']['q'][0]!r}" for case in public)
    for condition, most in ((hidden, 1e-9), ("true", 1e6)):
        changes = {"part1_contacts.cpp": far_away_where(condition)}
        folder = write(tmp_path / str(most), {**solution_files(), **changes})
        record = grade(folder, Options(speed=True))
        assert record["parts"][0]["score"] < record["parts"][0]["max_score"]
        error = record["speed"]["largest_error"]
        assert error <= most and error == float(f"{error:.1e}")


# ---- limits ----


CUT = {
    "slow": (
        around("volatile double x = 1; for (int i = 0; i < 10000 * params.T; ++i) x = x + 1;"),
        "",
    ),
    "empty": (alone("return {};"), "3x0"),
    "short": (
        around("", "return {right.q.leftCols(std::max(1, params.T - 1)), right.v};"),
        "both should be 3x",
    ),
    "crashes": (around("if (params.T > 5000) __builtin_trap();"), "crashed"),
    "throws": (around('if (params.dt < 1e-3) throw std::runtime_error("<b>too small");'), "threw"),
    "hangs": (around('while (params.T > 5000) asm volatile("");'), "CPU time"),
}


@pytest.mark.parametrize("name", CUT)
@pytest.mark.usual(2)
def test_who_goes_too_far_is_cut_and_loses_nothing_by_it(tmp_path: Path, name: str) -> None:
    part4, reason = CUT[name]
    record = graded(tmp_path, part4)
    found = record["speed"]
    assert re.match(r"at dt = [0-9.e-]+ s: ", found["cut"]), found
    assert reason in found["cut"]
    assert len(speed.curve(found, "solution")) == len(found["dt"])
    assert len(speed.curve(found, "submission")) < len(found["dt"])
    assert record["score"] == grade(tmp_path / "submission")["score"]
    assert "<b>" not in html.render(record)
    assert any("It was cut" in line for _, line in terminal.lines(record))


def test_parts_that_do_not_run_together_are_not_timed(tmp_path: Path) -> None:
    record = graded(tmp_path, b"no C++")
    assert record["speed"] == {"largest_error": None}
    assert "Speed: not measured (the parts don't run together)" in str(terminal.lines(record))
    assert "Speed against accuracy" not in formats.render("html", record, tmp_path)


# ---- what is said ----


def found(*curves: Sequence[tuple[float, float, float | None]], cut: str = "") -> dict[str, Any]:
    points = [[{"dt": d, "ns": n, "error": e} for d, n, e in curve] for curve in curves]
    scene = {"scene": "s", "title": "S", "seconds": 0.5, **dict(zip(speed.CURVES, points))}
    return {"dt": [1e-2, 1e-3, 1e-4], "scenes": [scene], "cut": cut, "ratio": 3.0}


RIGHT = [(1e-2, 2e4, 0.05), (1e-3, 2e5, 5e-3), (1e-4, 2e6, 5e-4)]
LEAST = [(1e-2, 1e3, 0.01), (1e-3, 1e4, 5e-4)]


def test_the_sentence_says_when_a_millimetre_is_reached_and_what_that_costs() -> None:
    mine = [(dt, 3 * ns, error) for dt, ns, error in RIGHT]
    said = speed.sentences(found(mine, RIGHT, LEAST))
    assert said == [
        "Your program is within 1 mm of the exact motion from dt = 100 \N{MICRO SIGN}s on, and then takes "
        "6 ms for a second of motion, 3 times the solution's time; no more model than each step "
        "needs does that in 10 \N{MICRO SIGN}s."
    ]


def test_the_sentence_says_when_it_never_is() -> None:
    stuck = [(dt, ns, 0.02) for dt, ns, _ in RIGHT]
    assert speed.sentences(found(stuck, RIGHT, LEAST, cut="at dt = 1e-05 s: x")) == [
        "Your program doesn't get within 1 mm: at dt = 100 \N{MICRO SIGN}s it is still off by 20 mm; "
        "the solution does at dt = 100 \N{MICRO SIGN}s.",
        "It was cut at dt = 1e-05 s: x.",
    ]


@pytest.mark.parametrize("times, told", [(0.2, True), (0.01, False), (0.0001, False)])
def test_no_ratio_is_told_of_what_nothing_could_compute(times: float, told: bool) -> None:
    mine = [(dt, times * ns, error) for dt, ns, error in RIGHT]
    answer = {k: v for k, v in found(mine, RIGHT, LEAST).items() if k != "ratio"}
    assert ("ratio" in speed.read(json.dumps(answer).encode())) == told


def test_a_scene_that_was_cut_ends_the_curve_of_all() -> None:
    made = found(RIGHT, RIGHT, LEAST)
    made["scenes"].append({**made["scenes"][0], "seconds": 1.5})
    made["scenes"][1]["submission"] = made["scenes"][1]["submission"][:2]
    curve = speed.curve(made, "submission")
    assert curve == [Point(1e-2, 2e4, 0.05), Point(1e-3, 2e5, 5e-3)]


@pytest.mark.parametrize(
    "spoil",
    [b"{}", b"[]", b"x", b'{"dt":[NaN],"scenes":[],"cut":""}', b'{"dt":[0],"scenes":[],"cut":""}']
    + [b'{"dt":[],"scenes":[],"cut":1}', b'{"wrong":1}']
    + [b'{"otherwise":1}']
    + [b'{"dt":[],"scenes":[{}],"cut":""}', b'{"dt":[],"scenes":[],"cut":1}']
    + [b'{"dt":[1e200],"scenes":[],"cut":""}', b'{"dt":[1%s],"scenes":[],"cut":""}' % (b"0" * 400)],
)
def test_what_is_no_answer_is_the_kits_failure(spoil: bytes) -> None:
    with pytest.raises(KitError):
        speed.read(spoil)


def test_an_error_beyond_all_bounds_is_none() -> None:
    point = {"dt": 0.1, "ns": 1.0, "error": 1e200}
    curves = {curve: [point] for curve in speed.CURVES}
    scene = {"scene": "drop", "title": "Drop", "seconds": 1.0, **curves}
    found = speed.read(json.dumps({"dt": [0.1], "scenes": [scene], "cut": ""}).encode())
    assert speed.curve(found, "submission") == [Point(0.1, 1.0, None)]


def test_the_charts_words_are_those_that_a_student_reads() -> None:
    drawn = speed_chart.of_all(found(RIGHT, RIGHT, LEAST))
    words = chart_style.WORDS
    assert set(words) == {"ErrorOverTime", "Time", "Error", "Yours", "Assignment"}
    for word in words.values():
        assert escaping.html(word) in drawn
    program = (chart_style.CHARTS / "main.cpp").read_text()
    assert all(f"k{name}" in program for name in words if name != "Assignment")
    assert f" {words['Assignment']}\n" in handout_study.text()


def test_the_chart_is_told_apart_without_colour() -> None:
    measured = found(RIGHT, RIGHT, LEAST)
    drawn = speed_chart.of_all(measured) + speed_chart.of_scene(measured["scenes"][0])
    styles = set(re.findall(r'class="curve ([^"]*)"', drawn))
    assert styles == set(chart_style.CLASSES.values()) and len(styles) == 3
    dashes = dict(re.findall(r"\.curve\.(k\d) {[^}]*stroke-dasharray: (.*?);", chart_style.STYLE))
    assert len({dashes[style.split()[-1]] for style in styles}) == 3
    assert not re.findall(r"#[0-9a-f]{3,6}\b", drawn)
    assert drawn.count("<title>yours, dt = 10 ms: 50 mm in 20") == 2  # whole, and its one scene
    json.dumps(found(RIGHT, RIGHT, LEAST))
