"""What a student learns of their own program: the study of it, and the page that asks about it."""

import csv
import re
from pathlib import Path

import pytest
from bounce_grader.publish import handout_study
from conftest import ROOT
from test_check import MISTAKES, check, put

STUDIES = ROOT / "docs/studies"
EXPLORE = (ROOT / "student/explore.md").read_text()


def rows(table: str, **where: str) -> list[dict[str, str]]:
    lines = (STUDIES / f"{table}.csv").read_text().splitlines()
    read = csv.DictReader(line for line in lines if not line.startswith("#"))
    return [row for row in read if where.items() <= row.items()]


def only(table: str, column: str, **where: str) -> float:
    [row] = rows(table, **where)
    return float(row[column])


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


def sentences(page: Path) -> str:
    return "\n".join(re.findall(r"<figcaption>(.*?)</figcaption>", page.read_text(), re.S))


@pytest.mark.slow
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
    assert f"stays near {1000 * errors['1e-05']:.3g} mm" in said
    assert "by up to 2.82 mm up and down and 5.63 cm along the ground" in said
    assert "Some checks fail" not in page.read_text() and not re.search("https?:", page.read_text())

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


@pytest.mark.slow
@pytest.mark.xdist_group("student")
def test_says_why_nothing_was_studied(home: Path) -> None:
    put(home)
    part4 = home / "src/part4_simulate.cpp"
    part4.write_text(part4.read_text().replace("{", "{ int x = ;", 1))
    run = check(home, "--study")
    assert run.returncode == 3 and "the study needs all four parts to compile" in run.stderr
