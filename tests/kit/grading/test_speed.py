"""Speed against accuracy: what the stopwatch measures, and which tricks can't deceive it. No test
compares times: ./kit bench does."""

import json
import re
from pathlib import Path
from typing import Any

import golden
import pytest
from bounce_grader import formats
from bounce_grader.common import escaping
from bounce_grader.common.errors import KitError
from bounce_grader.formats import html, terminal
from bounce_grader.grading import speed
from bounce_grader.grading.grade import grade, Options
from bounce_grader.grading.report import Report, report
from bounce_grader.grading.speed import Point
from conftest import ROOT, solution_files, write

HEAD = "#include <bounce/part4_simulate.hpp>\n#include <map>\n#include <tuple>\n"
SIGNATURE = "Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params)"
HONEST = solution_files()["part4_simulate.cpp"].decode().replace(" simulate(", " honest(")
RIGHT = "const Trajectory right = honest(q_0, v_0, params);"
WORDS = {
    "ZEROS": "return {Eigen::Matrix3Xd::Zero(3, params.T), Eigen::Matrix3Xd::Zero(3, params.T)};",
    "OFTEN": "params.dt < 0.0035 && std::abs(params.delta - 0.1 * params.dt) < 1e-12",
    "ROUND": "std::round(1e4 * v_0(0)) == 1e4 * v_0(0) && std::round(1e4 * v_0(1)) == 1e4 * v_0(1)",
}
TIMINGS = Path(__file__).parent / "timings.toml"
ACCEPTED = ROOT / "tests" / "submissions" / "accepted"


def part4(row: dict[str, Any]) -> bytes:
    body = f"{row.get('before', '')} {RIGHT} {row.get('after', 'return right;')}"
    if "alone" in row:
        body = row["alone"]
    for word, code in WORDS.items():
        body = body.replace(word, code)
    return f"{HEAD}{HONEST}\nnamespace bounce {{ {SIGNATURE} {{ {body} }} }}\n".encode()


def timed(folder: Path, changes: dict[str, bytes]) -> Report:
    return report(grade(write(folder, {**solution_files(), **changes}), Options(speed=True)))


@pytest.mark.parametrize("row", golden.rows(TIMINGS, "timing"))
def test_who_is_not_right_everywhere_has_no_times(tmp_path: Path, row: dict[str, Any]) -> None:
    record = timed(tmp_path / "x", {"part4_simulate.cpp": part4(row)})
    found, printed = record["speed"], str(terminal.lines(record))
    if row["speed"] == "cut":
        assert re.match(r"at dt = [0-9.e-]+ s: ", found["cut"]) and row["says"] in found["cut"]
        assert len(speed.curve(found, "solution")) == len(found["dt"])
        assert len(speed.curve(found, "submission")) < len(found["dt"])
        assert record["score"] == grade(tmp_path / "x")["score"]
        assert "<b>" not in html.render(record) and "It was cut" in printed
        return
    assert set(found) == {"otherwise", "largest_error"}
    said = found["otherwise"]
    assert said.startswith(f"{speed.WRONG}: at dt = ") and said[1:] in printed
    if record["score"] == record["max_score"]:
        for format in set(formats.NAMES) - {"junit"}:
            text = formats.render(format, record)
            assert said[1:40] in text.replace(escaping.ZERO_WIDTH_SPACE, ""), format


def test_the_solution_is_as_exact_as_itself_each_time(tmp_path: Path) -> None:
    twice = part4({"before": "const Trajectory first = honest(q_0, v_0, params);"})
    found = timed(tmp_path / "a", {})["speed"]
    again = timed(tmp_path / "b", {"part4_simulate.cpp": twice})["speed"]
    assert len(found["scenes"]) == 6 and found["cut"] == "" and 0 < found["largest_error"] < 1e-9
    assert found["ratio"] == found["submission_ns"] / found["solution_ns"] > 0
    errors = [point.error or 1.0 for point in speed.curve(found, "submission")]
    for one in (found, again):
        for whose in ("submission", "solution"):
            assert [point.error for point in speed.curve(one, whose)] == errors
    assert errors[-1] < errors[0] / 20 and errors[-1] < speed.FINE
    for scene in found["scenes"]:
        assert scene["least"][-1]["error"] <= scene["least"][0]["error"] + 1e-14  # rounding


@pytest.mark.long
@pytest.mark.parametrize("name", golden.table(TIMINGS)["accepted"])
def test_who_rounds_otherwise_is_right(tmp_path: Path, name: str) -> None:
    files = {f.relative_to(ACCEPTED / name).as_posix(): f for f in (ACCEPTED / name).rglob("*.?pp")}
    found = timed(tmp_path, {file: path.read_bytes() for file, path in files.items()})["speed"]
    assert found.get("cut") == "" and "otherwise" not in found


def test_a_start_that_can_be_known_by_heart_counts_for_no_time(tmp_path: Path) -> None:
    """Elsewhere it does its work many times over."""
    slow = part4(
        {"before": "for (int i = 0; i < ((ROUND) ? 0 : 30); ++i) honest(q_0, v_0, params);"}
    )
    assert timed(tmp_path, {"part4_simulate.cpp": slow})["speed"]["ratio"] > 5


@pytest.mark.parametrize("name", ["part2_lcp.cpp", "part4_simulate.cpp"])
def test_parts_that_do_not_run_together_are_not_timed(tmp_path: Path, name: str) -> None:
    record = timed(tmp_path, {name: b"#error no\n"})
    assert set(record["speed"]) == {"largest_error"}
    assert "Speed: not measured (the parts don't run together)" in str(terminal.lines(record))


def test_the_largest_error_tells_no_expected_number(tmp_path: Path) -> None:
    """Of a part 1 that is off by a million, in hidden cases alone or everywhere."""
    public = json.loads((ROOT / "fixtures" / "public" / "part1_contacts.json").read_text())
    cases = [case for cases in public["checks"].values() for case in cases]
    hidden = " && ".join(f"q(0) != {case['input']['q'][0]!r}" for case in cases)
    for condition, most in ((hidden, 1e-9), ("true", 1e6)):
        part1 = solution_files()["part1_contacts.cpp"].decode()
        part1 = part1.replace("q(1) + r.y()", f"({condition} ? 1e6 : q(1) + r.y())")
        record = timed(tmp_path / str(most), {"part1_contacts.cpp": part1.encode()})
        assert record["parts"][0]["score"] < record["parts"][0]["max_score"]
        error = record["speed"]["largest_error"]
        assert error <= most and error == float(f"{error:.1e}")


# --- what is said of curves ---

DTS = (1e-2, 1e-3, 1e-4)


def found(times: float = 1.0, error: float | None = None) -> dict[str, Any]:
    """One scene: errors that fall with dt, or are this one."""
    solution = [{"dt": dt, "ns": 200 / dt, "error": 5 * dt} for dt in DTS]
    mine = [{**p, "ns": times * p["ns"], "error": error or p["error"]} for p in solution]
    least = [{"dt": 1e-2, "ns": 1e3, "error": 0.01}, {"dt": 1e-3, "ns": 1e4, "error": 5e-4}]
    scene = {"scene": "s", "title": "S", "seconds": 0.5}
    scene |= dict(zip(speed.CURVES, (mine, solution, least)))
    return {"dt": list(DTS), "scenes": [scene], "cut": None}


def read(measured: dict[str, Any]) -> dict[str, Any]:
    return speed.read(json.dumps(measured).encode())


def test_no_ratio_is_told_of_what_nothing_could_compute() -> None:
    assert ["ratio" in read(found(times)) for times in (0.2, 0.01, 0.0001)] == [True, False, False]


def test_a_scene_that_was_cut_ends_the_curve_of_all_and_no_error_is_infinite() -> None:
    made = found(error=1e200)
    assert speed.curve(read(made), "submission")[0] == Point(1e-2, 2e4, None)
    made["scenes"].append({**made["scenes"][0], "submission": made["scenes"][0]["submission"][:2]})
    assert len(speed.curve(read(made), "submission")) == 2


@pytest.mark.parametrize("answer", golden.table(TIMINGS)["no_answer"], ids=lambda text: text[:40])
def test_what_is_no_answer_is_the_kits_failure(answer: str) -> None:
    with pytest.raises(KitError):
        speed.read(answer.encode())
