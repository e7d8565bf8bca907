"""What a student learns of their own program: the study of it, what it makes of measured impacts,
and the page that asks about both."""

import csv
import json
import re
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from animation_page import DATA
from bounce_grader.publish import handout_measured, handout_study
from conftest import ROOT
from test_check import MISTAKES, UNDEFINED, check, put

STUDIES = ROOT / "docs/studies"
EXPLORE = (ROOT / "student/explore.md").read_text()


def rows(table: str, **where: str) -> list[dict[str, str]]:
    lines = (STUDIES / f"{table}.csv").read_text().splitlines()
    read = csv.DictReader(line for line in lines if not line.startswith("#"))
    return [row for row in read if where.items() <= row.items()]


def only(table: str, column: str, **where: str) -> float:
    [row] = rows(table, **where)
    return float(row[column])


def times_of_exact() -> Iterator[float]:
    """Divides the time of the exact simulation, to rounding, by the scheme's at 0.01 s."""
    for step in rows("speed_accuracy", method="assignment", setting="0.01"):
        to = rows("speed_accuracy", method="event_driven", scene=step["scene"], setting="1e-12")
        column = "ns_per_simulated_second"
        yield float(to[0][column]) / float(step[column])


def told() -> dict[str, float]:
    """The numbers that the page tells, by the words around them, and as the studies have them."""
    fixed = rows("speed_accuracy", scene="tumble", method="assignment")
    errors = {row["setting"]: 1000 * float(row["own_error_m"]) for row in fixed}
    scaled = only(
        "speed_accuracy",
        "own_error_m",
        scene="tumble",
        method="assignment_delta_dt",
        setting="1e-05",
    )
    newton = rows("energy_gain", law="newton")
    most = max(newton, key=lambda row: float(row["largest_gain"]))
    gaining = [float(row["epsilon"]) for row in newton if float(row["largest_gain"]) > 0]
    rest = rows("rest_and_drift", method="assignment", setting="0.01")[0]
    landing = rows("flat_landing", method="assignment", theta_rad="0")[0]
    depth = only(
        "depth", "depth_m", method="assignment", speed_m_s="60", dt_s="0.01", epsilon="0.5"
    )
    laws = {row["law"]: row for row in rows("measured_ladder", group="squares, one corner")}
    exact = sorted(times_of_exact())
    whole = sorted(float(r["times_as_fast_as_whole"]) for r in rows("chosen_model", model="asleep"))
    return {
        "dt = 0.001 s with {} mm": errors["0.001"],
        "at 1e-05 s it is {} mm": errors["1e-05"],
        "falls to {} mm at 1e-05 s": 1000 * scaled,
        "hovers by {} mm": 1000 * float(rest["height_m"]),
        "wanders by {} cm": 100 * float(rest["drift_m"]),
        "adds up to {} %": 100 * float(most["largest_gain"]),
        "energy, at mu = {}.": float(most["mu"]),
        "Below epsilon = {} no": min(gaining) - 0.0,
        "leaves with {} rad/s": abs(float(landing["omega_rad_s"])),
        "Up to v dt = {} cm": 100 * depth,
        "is {} times as fast in the median": whole[len(whole) // 2],
        "your `form_lcp` {} measured": float(laws["newton"]["impacts_judged"]),
        "is off by {} m/s": float(laws["frictionless"]["median_m_s"]),
        "always sticks by {} m/s": float(laws["sticking"]["median_m_s"]),
        "with the LCP by {} m/s": float(laws["newton"]["median_m_s"]),
        "takes {} times as long in the median": exact[len(exact) // 2],
        "and {} times where": exact[-1],
        "gets below {} m/s": float(laws["newton"]["floor_m_s"]),
    }


def test_the_page_tells_the_numbers_of_the_studies() -> None:
    for words, number in told().items():
        pattern = re.escape(words).replace(r"\{\}", r"(\d+(?:\.\d+)?)")
        [printed] = re.findall(pattern, EXPLORE)
        digits = len(printed.replace(".", "").lstrip("0"))
        assert float(f"{number:.{digits}g}") == pytest.approx(float(printed), rel=0.03), words


def test_asks_seven_questions_with_a_prediction_an_experiment_and_stages() -> None:
    questions = re.split(r"^## ", EXPLORE, flags=re.M)[1:]
    assert [q[0] for q in questions] == list("1234567")
    for question in questions:
        assert question.count("**Predict.**") == question.count("**Run.**") == 1
        assert question.count("<details>") == question.count("</details>") >= 2


def test_names_scenes_that_are_there() -> None:
    named = set(re.findall(r"--scene (\w+)", EXPLORE)) | {"pointed_drop", "tumble", "rest"}
    text = handout_study.text()
    scenes = re.findall(r"^scene (\w+) ", text, re.M)
    assert named <= set(scenes) == {f.stem for f in (ROOT / "fixtures/scenes").glob("*.json")}
    assert len(re.findall(r"^truth ", text, re.M)) == 20 * len(handout_study.STUDIED)
    assert len(re.findall(r"^other ", text, re.M)) == 3 * len(handout_study.STUDIED)


@pytest.mark.xdist_group("student")
def test_a_scene_lasts_as_long_with_another_step_unless_its_columns_are_told(home: Path) -> None:
    put(home)
    assert check(home).returncode == 0
    subprocess.run(["cmake", "--build", "build", "--target", "bounce"], cwd=home, check=True)

    def bounce(*words: str) -> subprocess.CompletedProcess[str]:
        command = ["./build/bounce", "--scene", "tumble", *words]
        return subprocess.run(command, cwd=home, capture_output=True, text=True, check=False)

    def columns(*words: str) -> int:
        assert bounce(*words).returncode == 0
        [data] = DATA.findall((home / "animation.html").read_text())
        return len(json.loads(data)["q"][0])

    assert columns() == columns("T=41") == columns("dt=0.001", "T=41") == 41
    assert columns("dt=0.001", "epsilon=1") == 401
    for word in ("dt=0", "l=-1", "T=0", "T=2.5", "dt=1e-9", "nu=1", "mu=x", "page.html"):
        refused = bounce(word)
        assert refused.returncode == 1 and refused.stdout == "", word
        assert refused.stderr.startswith("No animation was written: "), word


def sentences(page: Path) -> str:
    return "\n".join(re.findall(r"<figcaption>(.*?)</figcaption>", page.read_text(), re.S))


@pytest.mark.xdist_group("student")
def test_studies_the_students_own_parts(home: Path) -> None:
    page = home / "study.html"
    page.unlink(missing_ok=True)
    put(home)
    run = check(home, "--study")
    assert run.returncode == 0 and "The study is in study.html" in run.stdout, run.stderr
    said = sentences(page)
    assert "from dt = 0.001 s on a smaller step no longer helps: delta stays" in said
    errors = {
        r["setting"]: float(r["own_error_m"])
        for r in rows("speed_accuracy", scene="tumble", method="assignment")
    }
    assert f"ends at {1000 * errors['1e-05']:.3g} mm" in said
    assert "by up to 2.82 mm up and down and 5.63 cm along the ground" in said
    assert "Some checks fail" not in page.read_text() and not re.search("https?:", page.read_text())


@pytest.mark.xdist_group("student")
def test_no_page_of_a_program_that_gives_other_numbers_when_it_is_optimised(home: Path) -> None:
    page = home / "study.html"
    page.write_text("of an earlier program")
    put(home, UNDEFINED / "part2_view_of_the_inverse")
    run = check(home, "--study")
    assert run.returncode == 3 and not page.exists()
    assert "your program gives other numbers when it is optimised; usually `auto`" in run.stderr


@pytest.mark.long
@pytest.mark.xdist_group("student")
def test_a_study_tells_what_keeps_a_wrong_part_from_the_truth(home: Path) -> None:
    page = home / "study.html"
    put(home, MISTAKES / "part3_friction_sign")
    wrong = check(home, "--study")
    assert wrong.returncode == 1 and "Some checks fail" in page.read_text()
    assert "it isn't delta that keeps your program from the truth" in sentences(page)
    assert "most of it comes from somewhere else" in sentences(page)
    assert "it isn't the step that moves it" in sentences(page)

    part4 = home / "src/part4_simulate.cpp"
    part4.write_text((ROOT / "student/src/part4_simulate.cpp").read_text())
    check(home, "--study")
    assert "another number of columns" in sentences(page)


@pytest.mark.xdist_group("student")
def test_says_why_nothing_was_studied(home: Path) -> None:
    put(home)
    part4 = home / "src/part4_simulate.cpp"
    part4.write_text(part4.read_text().replace("{", "{ int x = ;", 1))
    run = check(home, "--study")
    assert run.returncode == 3 and "the study needs all four parts to compile" in run.stderr


def bars(page: Path) -> dict[str, str]:
    """What the page of measured impacts shows: the label of each bar, by its name."""
    svg = page.read_text().partition("<svg")[2].partition("</svg>")[0]
    texts = re.findall(r"<text[^>]*>(.*?)</text>", svg)
    return dict(zip(texts[::2], texts[1::2]))


def lines(text: str, kind: str) -> list[list[str]]:
    return [line.split() for line in text.splitlines() if line.startswith(kind + " ")]


def test_measured_impacts_are_those_of_the_study_under_their_licence() -> None:
    text = handout_measured.text()
    assert "# Copyright 2020 Dynamic Autonomy and Intelligent Robotics Lab" in text
    assert "OF THIS SOFTWARE, EVEN IF ADVISED OF THE POSSIBILITY OF SUCH DAMAGE." in text
    newton = rows("measured_ladder", group="squares, one corner", law="newton")[0]
    assert len(lines(text, "impact")) == int(newton["impacts_judged"])
    assert {len(impact) for impact in lines(text, "impact")} == {9}
    [[_, side, mu, epsilon]] = lines(text, "square")
    assert (mu, epsilon) == (newton["mu"], newton["epsilon"])
    gyration = only("measured_extraction", "value", quantity="r_g^2, m^2")
    assert float(side) ** 2 / 6 == pytest.approx(gyration, rel=1e-4)


def error_of_newton(impact: list[float], gyration: float, mu: float, epsilon: float) -> float:
    """The impact by the assignment's law: the corner leaves at epsilon times its speed, and
    sticks or slides."""
    r_x, r_y, *v = impact[:5]
    a, b, c = 1 + r_x**2 / gyration, -r_x * r_y / gyration, 1 + r_y**2 / gyration
    v_n, v_t = v[1] + r_x * v[2], v[0] - r_y * v[2]
    n = (b * v_t - c * (1 + epsilon) * v_n) / (a * c - b * b)
    t = -(v_t + b * n) / c
    if abs(t) > mu * n:
        slides = -1 if t < 0 else 1
        n = -(1 + epsilon) * v_n / (a + slides * mu * b)
        t = slides * mu * n
    after = [v[0] + t, v[1] + n, v[2] + (r_x * n - r_y * t) / gyration]
    x, y, omega = (p - m for p, m in zip(after, impact[5:]))
    return float((x * x + y * y + gyration * omega * omega) ** 0.5)


def test_the_assignments_line_is_its_law_over_the_table() -> None:
    text = handout_measured.text()
    [[_, *square]] = lines(text, "square")
    side, mu, epsilon = map(float, square)
    impacts = [[float(x) for x in impact[1:]] for impact in lines(text, "impact")]
    errors = sorted(error_of_newton(hit, side**2 / 6, mu, epsilon) for hit in impacts)
    line = only("measured_ladder", "median_m_s", group="squares, one corner", law="newton")
    assert errors[len(errors) // 2] == pytest.approx(line, rel=1e-3)


WRONG_ON_REAL = {
    "part2_restitution_left_out": "0.26 m/s",
    "part2_friction_directions_swapped": "0.28 m/s",
    "part2_mass_in_place_of_its_inverse": "11 m/s, beyond the chart",
}


@pytest.mark.xdist_group("student")
def test_asks_the_students_own_part_2_about_measured_impacts(home: Path) -> None:
    page = home / "real.html"
    page.unlink(missing_ok=True)
    put(home)
    run = check(home, "--real")
    assert run.returncode == 0 and "real impacts is in real.html" in run.stdout, run.stderr
    assert bars(page) == {
        "your form_lcp": "0.095 m/s",
        "the assignment's law, as the course solves it": "0.095 m/s",
        "a corner without friction": "0.15 m/s",
        "a corner that always sticks": "0.16 m/s",
        "the least that any push at the corner leaves": "0.0087 m/s",
    }
    assert "what is left is the error of the law, not of your program" in sentences(page)
    assert "Checks of part 2" not in page.read_text() and not re.search("https?:", page.read_text())


@pytest.mark.xdist_group("student")
@pytest.mark.parametrize("mistake", WRONG_ON_REAL)
@pytest.mark.usual(1)
def test_measured_impacts_tell_what_comes_from_the_program(home: Path, mistake: str) -> None:
    page = home / "real.html"
    put(home, MISTAKES / mistake)
    assert check(home, "2", "--real").returncode == 1
    assert bars(page)["your form_lcp"] == WRONG_ON_REAL[mistake]
    assert "what is more comes from your program" in sentences(page)
    assert "Checks of part 2 fail" in page.read_text()


@pytest.mark.long
@pytest.mark.xdist_group("student")
def test_measured_impacts_may_show_nothing_of_what_the_checks_find(home: Path) -> None:
    page = home / "real.html"
    put(home, MISTAKES / "part2_force_is_g")
    check(home, "2", "--real")
    assert "what the checks find doesn't show in an impact" in sentences(page)

    put(home, MISTAKES / "part2_last_column_left_zero")
    check(home, "2", "--real")
    assert bars(page)["your form_lcp"] == "no answer"
    assert "solve_lcp finds no solution to your V and p, so that there is no" in sentences(page)


@pytest.mark.long
@pytest.mark.xdist_group("student")
def test_measured_impacts_need_part_2_alone(home: Path) -> None:
    page = home / "real.html"
    put(home)
    part3 = home / "src/part3_step.cpp"
    part3.write_text(part3.read_text().replace("{", "{ int x = ;", 1))
    check(home, "--real")
    assert bars(page)["your form_lcp"] == "0.095 m/s"
    assert "Checks of part 2" not in page.read_text()

    part2 = home / "src/part2_lcp.cpp"
    part2.write_text(part2.read_text().replace("{", "{ int x = ;", 1))
    broken = check(home, "--real")
    assert broken.returncode == 3 and "--real needs part 2 to compile" in broken.stderr
    other = check(home, "3", "--real")
    assert other.returncode == 3 and "./check 2 --real" in other.stderr
