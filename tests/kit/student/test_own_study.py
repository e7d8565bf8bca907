"""What a student learns of their own program: the study of it, what it makes of measured impacts,
and the page that asks about both."""

import json
import re
from pathlib import Path
from typing import Any

import pytest
from animation_page import animation
from bounce_grader.publish import handout_data
from conftest import ROOT
from handed_out import check, put, run

of_home = pytest.mark.xdist_group("student")
EXPLORE = (ROOT / "student/explore.md").read_text()


# ---- the page that asks ----


def rows(table: str, **where: str) -> list[dict[str, str]]:
    read = handout_data.rows(f"{table}.csv")
    return [row for row in read if where.items() <= row.items()]


def test_names_scenes_that_are_there() -> None:
    named = set(re.findall(r"--scene (\w+)", EXPLORE)) | {"pointed_drop", "tumble", "rest"}
    scenes = {scene["name"]: scene for scene in json.loads(handout_data.study())}
    assert named <= set(scenes) == {f.stem for f in (ROOT / "fixtures/scenes").glob("*.json")}
    for name, scene in scenes.items():
        is_studied = name in handout_data.STUDIED
        assert [len(scene["truth"]), len(scene["others"])] == ([20, 3] if is_studied else [0, 0])


def test_measured_impacts_are_those_of_the_study_under_their_licence() -> None:
    measured = json.loads(handout_data.measured())
    licence = "\n".join(measured["licence"])
    assert "\nCopyright 2020 Dynamic Autonomy and Intelligent Robotics Lab" in licence
    assert "OF THIS SOFTWARE, EVEN IF ADVISED OF THE POSSIBILITY OF SUCH DAMAGE." in licence
    [newton] = rows("measured_laws", shape="squares", law="newton")
    assert len(measured["impacts"]) == int(newton["tested"])
    assert {len(x["r"] + x["before"] + x["after"]) for x in measured["impacts"]} == {8}
    fitted = [float(newton[name]) for name in ("mu", "epsilon")]
    assert [measured["mu"], measured["epsilon"]] == fitted
    [gyration] = rows("measured_body", quantity="gyration_squared")
    assert measured["l"] ** 2 / 6 == pytest.approx(float(gyration["value"]), rel=1e-4)


# ---- the program ----


@of_home
def test_draws_a_scene_as_long_with_another_step_or_the_worked_example(home: Path) -> None:
    put(home)
    check(home, "--help")  # prepares the build
    assert run(home, "cmake", "--build", "build", "--target", "bounce").returncode == 0
    for words, columns in {"": 41, "T=41": 41, "dt=0.001 T=41": 41, "dt=0.001": 401}.items():
        assert run(home, "build/bounce", "--scene", "tumble", *words.split()).returncode == 0
        page = home / f"{'_'.join(['tumble', *words.split()])}.html"  # one for each, to compare
        assert len(animation(page.read_text())["q"][0]) == columns, words
    for word in ("dt=0", "l=-1", "T=0", "T=2.5", "dt=1e-9", "nu=1", "mu=x", "page.html"):
        refused = run(home, "build/bounce", "--scene", "tumble", word)
        assert refused.returncode == 1 and refused.stdout == "", word
        assert refused.stderr.startswith("No animation was written: "), word
    many = ("tumble", "dt=0.001", "T=301")
    assert run(home, "build/bounce", "--many", *many).returncode == 0
    drawn_many = animation((home / f"many_{'_'.join(many)}.html").read_text())
    assert drawn_many["about"].startswith("T = 301, dt = 0.001 s")
    assert [drawn_many["dt"], len(drawn_many["q"][0])] == [0.002, 151]  # every second column
    printed = run(home, "build/bounce", "--worked").stdout
    readme = (ROOT / "student/README.md").read_text()
    [v] = re.findall(r"^v' = (\(.*\)) m/s", readme, re.M)
    [q] = re.findall(r"^q' = (\(.*\)) m, m, rad  ", readme, re.M)
    for number in (f"v' = {v} m/s", f"q' = {q} m", "0.0551012", "phi = 0.00041433 m"):
        assert number in printed, printed


def drawn(page: Path) -> Any:
    """What the page's script draws. It loads nothing."""
    text = page.read_text()
    assert not re.search("https?:(?!//www.w3.org/2000/svg)", text)
    [data] = re.findall(r"^const \w+ = (\{.*?\});$", text, re.M | re.S)
    return json.loads(data)


UM = "\N{MICRO SIGN}m"
# Found apart from the kit, in numpy: what flight, the time of impact, delta, and anything else make
# alone with dt = 0.01 s, and all together.
CAUSES = {
    "Tumble": [
        "1.76 cm, 29 %",
        "3.74 cm, 62 %",
        "4.84 mm, 8 %",
        f"less than 0.01 {UM}, 0 %",
        "3.35 cm",
    ],
    "Oblique bounce": [
        "2.17 cm, 12 %",
        "14.8 cm, 81 %",
        "1.3 cm, 7 %",
        f"0.013 {UM}, 0 %",
        "2.82 cm",
    ],
    "Slide to rest": ["0, 0 %", "0, 0 %", "3.86 cm, 57 %", "2.92 cm, 43 %", "2.41 cm"],
}
HELPS = "Next: shrink delta with dt; delta = 0.1 m/s dt makes it"
ACCURACY = {
    "tumble": "Tumble: 2.25 mm off at best, with dt = 0.001 s. A smaller step does not help: "
    f"with dt = 0.0001 s it is 4.29 mm, 92 % by delta. {HELPS} 24.6 {UM}, with dt = 1e-05 s.",
    "slide": "Slide to rest: 2.41 cm off at best, with dt = 0.01 s. A smaller step does not help: "
    f"with dt = 0.0001 s it is 3.33 cm, 99 % by delta. {HELPS} 0.983 mm, with dt = 1e-05 s.",
}


@of_home
@pytest.mark.long
def test_studies_the_students_own_parts(home: Path) -> None:
    page = home / "study.html"
    page.unlink(missing_ok=True)
    put(home)
    done = check(home, "--study")
    assert done.returncode == 0 and "What your program is worth, with charts" in done.stdout
    study = drawn(page)
    told = {chart["id"]: chart["sentence"] for chart in study["charts"]}
    for scene, sentence in ACCURACY.items():
        assert told[f"step-{scene}"] == sentence
    columns = {column["title"]: [text for text, _ in column["cells"]] for column in study["causes"]}
    assert columns == CAUSES
    for said in (*CAUSES["Tumble"][:3], CAUSES["Tumble"][4], "2.25 mm"):
        assert said.split(",")[0] in EXPLORE
    [steps] = [chart for chart in study["charts"] if chart["id"] == "step-tumble"]
    alone = {line["name"]: [y for _, y in line["points"]] for line in steps["lines"]}
    assert alone["delta alone"] == pytest.approx([4.836277e-3] * 8, rel=1e-6)  # at each dt
    flight = [3.2439e-2, 1.7629e-2, 9.0983e-3, 3.7558e-3, 1.8939e-3, 9.517e-4, 3.816e-4]
    assert alone["flight alone"][:7] == pytest.approx(flight, rel=1e-3)
    assert not study["wrong"]
    assert [trial["found"] for trial in study["trials"]] == [
        "from epsilon = 0.81 on some impacts gain energy, up to 56 %",
        "at 60 m/s it sinks in by 60 cm, 3 sides, with dt = 0.01 s",
        "it trembles, up to 2.8 mm above where it should lie, and wanders by 5.6 cm in ten seconds, "
        "with dt = 0.01 s",
        "on 10 degrees it creeps 12 cm in a second, with dt = 0.001 s",
        f"with delta = 1 {UM} it sinks in by 17 cm, and stays there, with dt = 0.01 s",
        "after 100 s it has 1.5 times the energy, with dt = 0.001 s",
    ]


@of_home
@pytest.mark.long
def test_a_study_tells_what_keeps_a_wrong_part_from_the_truth(home: Path) -> None:
    page = home / "study.html"
    put(home, "mistakes/part3_friction_sign")
    done = check(home, "--study")
    assert done.returncode == 1 and drawn(page)["wrong"]
    says = "anything else 55 %. Next, for the largest: mend what ./check names first."
    assert says in " ".join(done.stdout.split())
    put(home, "mistakes/part3_friction_sign", "stub 4")
    check(home, "--study")
    assert "another number of columns" in page.read_text()

    ends = "  return {J, q(1) + r.y()};"
    on_a_face = f"  if (q(2) == 0) J(2, 1) = 0.0 / q(2);\n{ends}"
    put(home, edits={"part1_contacts": [[ends, on_a_face]]})
    done = check(home, "--study")
    says = "part 1 returns NaN at y = 0.1 m and theta = 0 rad"
    assert done.returncode == 3 and f"No study was written: {says}." in done.stderr

    put(home, "undefined/part2_view_of_the_inverse")
    done = check(home, "--study")
    assert done.returncode == 3 and not page.exists()
    assert (
        "your program gives different numbers when it is optimised; the usual cause is `auto`"
        in done.stderr
    )


# ---- measured impacts ----


# By the mistake of part 2: the error, and how the sentence ends.
REAL = {
    "": ("0.0908 m/s", "What is left is the error of the law, not of your program."),
    "restitution_left_out": ("0.267 m/s", "comes from your program."),
    "friction_directions_swapped": ("0.273 m/s", "comes from your program."),
    "mass_in_place_of_its_inverse": ("10.7 m/s", "comes from your program."),
    "force_is_g": ("0.0908 m/s", "(the least that any push at the corner leaves)."),
    "last_column_left_zero": ("no answer", "finds no solution to your V and p."),
}


@of_home
@pytest.mark.parametrize(
    "mistake", ["", *(pytest.param(m, marks=pytest.mark.long) for m in REAL if m)]
)
def test_asks_the_students_own_part_2_alone_about_measured_impacts(
    home: Path, mistake: str
) -> None:
    error, sentence = REAL[mistake]
    page = home / "real.html"
    page.unlink(missing_ok=True)
    laid = [f"mistakes/part2_{mistake}"] if mistake else []
    put(home, *laid, edits={"part3_step": [["{", "{ int x = ;"]]})
    done = check(home, "2", "--real")
    assert done.returncode == bool(mistake) and "in real.html" in done.stdout
    real = drawn(page)
    assert {bar["name"]: bar["label"] for bar in real["bars"]} == {
        "your form_lcp": error,
        "the assignment's law, as the course solves it": "0.0908 m/s",
        "a corner without friction": "0.155 m/s",
        "a corner that always sticks": "0.150 m/s",
        "the least that any push at the corner leaves": "0.00905 m/s",
    }
    assert real["sentence"].endswith(sentence) and real["wrong"] == bool(mistake)
    assert real["sentence"] in " ".join(done.stdout.split())
    assert {len(impact["mine"]) for impact in real["impacts"]} == {3}
