"""The engines beside our methods: the page and its data hold, and each engine that is installed
does what its settings say."""

import itertools
import json
import math
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from bounce_grader.common.paths import FIXTURES, ROOT
from bounce_study import facts_peers, measurements, pages, peers, tables
from bounce_study.tables import Row, Table, Tables
from studies import committed, STUDIES

COLUMNS = re.compile(r"Table table\(\{([^}]*)\}")
GRAVITY = 9.81
Errors = dict[tuple[str, str], dict[float, float]]


@pytest.fixture(scope="module")
def known() -> Tables:
    return committed()


@pytest.fixture(scope="module")
def facts(known: Tables) -> pages.Facts:
    return pages.facts_of(pages.PEERS_PAGE, known)


# --- the page and the tables beside it ---


def _page_with(known: Tables, name: str, rows: list[Row]) -> str:
    return pages.render(pages.PEERS_PAGE, {**known, name: Table(name, {}, rows)})


def test_engines_that_are_not_installed_are_left_out(known: Tables) -> None:
    rows = known["peers_variants"].rows
    installed = [row for row in rows if not row["engine"].startswith(("ode", "dart"))]
    page = _page_with(
        {**known, "peers_lcp": Table("peers_lcp", {}, [])}, "peers_variants", installed
    )
    assert "ODE (dWorldStep) stays" not in page and "MuJoCo stays" in page
    assert "Siconos was not installed." in page


def test_a_scene_where_an_engine_is_ahead_is_named(known: Tables) -> None:
    rows = known["peers_ratios"].rows
    ahead = [{**row, "times": "0.9"} if row["scene"] == "spin" else row for row in rows]
    page = _page_with(known, "peers_ratios", ahead)
    assert "scenes, in spin; in the others some method of ours is faster." in page


def test_names_with_settings_stand_in_sentences() -> None:
    assert facts_peers.in_sentence("Chipmunk") == "Chipmunk"
    assert facts_peers.in_sentence("ODE, dWorldStep") == "ODE (dWorldStep)"


def test_peers_have_the_columns_of_speed_accuracy() -> None:
    source = (ROOT / "solution" / "study" / "speed_accuracy.cpp").read_text()
    table = COLUMNS.search(source)
    assert table
    columns = re.findall(r'"(\w+)"', table[1])
    for name in ("peers", "peers_beside"):
        header = list(tables.read(STUDIES / f"{name}.csv").rows[0])
        assert [column for column in header if "quartile" not in column] == [
            column for column in columns if "quartile" not in column
        ]


def test_every_engine_and_numpy_ran_every_scene(known: Tables) -> None:
    scenes = {file.stem for file in (FIXTURES / "scenes").glob("*.json")}
    names = {"chipmunk", "chipmunk_10", "box2d", "ode", "bullet", "mujoco", "dart", "siconos"}
    names |= {"simbody", "numpy"}
    runs = {(row["scene"], row["method"]) for row in known["peers"].rows}
    assert runs == {(scene, name) for scene in scenes for name in names}


def test_in_each_scene_a_method_of_ours_lies_left_of_and_below_every_engine(
    facts: pages.Facts,
) -> None:
    for lead in facts["leads"]:
        assert lead["lower_quartile"] > 1, lead
        ours, theirs, ours_finest, theirs_finest = lead["fastest"]
        assert ours and (theirs is None or ours.ns < theirs.ns), lead
        assert ours_finest and (theirs_finest is None or ours_finest.ns < theirs_finest.ns), lead


def test_a_contact_step_is_thirty_times_as_fast_as_the_fastest_engine(known: Tables) -> None:
    rows = known["peers_steps"].where(kind="contact")
    contact = {row["engine"]: float(row["ratio"]) for row in rows}
    assert contact.pop("numpy") >= 1500
    assert contact.pop("assignment_fast") == 1
    assert contact.pop("assignment") >= 2
    assert contact.pop("moreau_jean_2") >= 4
    assert min(contact.values()) >= 30


def test_a_step_of_ours_keeps_its_share_of_the_plain_one(known: Tables) -> None:
    """Contact, flight and LCP: 12, 3 and 6 where a plain contact step takes 24."""
    rows = known["peers_steps"].rows
    ns = {(row["engine"], row["kind"]): float(row["ns_per_step"]) for row in rows}
    plain = ns["assignment", "contact"]
    assert ns["assignment_fast", "contact"] <= plain * 12 / 24
    assert ns["assignment_fast", "flight"] <= plain * 3 / 24
    (closed,) = known["peers_lcp"].where(solver="closed form, given a, b and c")
    assert float(closed["ns_per_lcp"]) <= plain * 6 / 24


def test_numpy_is_the_assignments_scheme(known: Tables) -> None:
    plain = known["peers_beside"].where(method="assignment")
    scenes = {"free_flight", "oblique_bounce", "pointed_drop", "projectile", "spin"}
    theirs = [row for row in known["peers"].where(method="numpy") if row["scene"] in scenes]
    assert {row["scene"] for row in theirs} == scenes
    for row in theirs:
        dt, error = float(row["setting"]), float(row["error_m"])
        ours = {float(r["setting"]): r for r in plain if r["scene"] == row["scene"]}
        around = sorted(ours, key=lambda other: abs(math.log(other / dt)))[:2]
        if dt < 1.01 * max(ours):  # with errors as those of ours at the nearest steps
            near = [float(ours[other]["error_m"]) for other in around]
            assert 0.7 * min(near) <= error <= 1.4 * max(near), row


# --- engines that are installed ---


def scene(name: str, **changes: Any) -> dict[str, Any]:
    params = {"l": 0.5, "m": 2, "mu": 0.4, "epsilon": 0.8, "g": [0, -GRAVITY, 0]}
    params |= {"dt": 0.01, "delta": 0.001, "T": 2}
    return {
        "name": name,
        "title": name,
        "params": params | changes.pop("params", {}),
        "q": [0, 3, 0.3],
        "v": [1, 1, 2],
        "compare": {"quantity": "pose", "until": 0.5},
        "least_model": "ballistic",
        "why": "a test",
        **changes,
    }


SCENES = (
    scene("flight"),
    scene("tilted", params={"g": [2, -5, 0]}),
    scene("bounce", params={"mu": 0}, q=[0, 0.75, 0], v=[0, 0, 0]),
    scene("friction", q=[0, 0.25, 0], v=[3, 0, 0]),
    scene("heavy", params={"m": 20, "mu": 0.2}, q=[0, 0.25, 0], v=[-3, 0, 0]),
    scene("rest", q=[0, 0.25, 0], v=[0, 0, 0]),
)


@pytest.fixture(scope="module")
def errors(tmp_path_factory: pytest.TempPathFactory) -> Errors:
    """The errors over the step, by scene and engine, from the largest step to the smallest."""
    if not peers.PROGRAM.exists():
        pytest.skip("no engines are built here: run ./kit study --peers")
    folder = tmp_path_factory.mktemp("peers")
    for data in SCENES:
        (folder / f"{data['name']}.json").write_text(json.dumps(data))
    program = [str(peers.PROGRAM), str(folder), str(peers.STEPS), str(folder / "out"), "--quick"]
    subprocess.run(program, check=True, capture_output=True)
    by_engine: Errors = {}
    for row in tables.read(folder / "out" / "peers.csv").rows:
        own = by_engine.setdefault((row["scene"], row["method"]), {})
        own[float(row["setting"])] = float(row["error_m"])
    return by_engine


@pytest.mark.parametrize("name, g", [("flight", GRAVITY), ("tilted", math.hypot(2, 5))])
def test_free_flight_has_eulers_error(errors: Errors, name: str, g: float) -> None:
    """Either symplectic Euler is off the parabola by g t dt / 2, and by nothing else."""
    for engine in engines(errors):
        if engine == "siconos":  # its midpoints are exact
            assert max(errors[name, engine].values()) < 1e-9
            continue
        for dt, error in errors[name, engine].items():
            # Box2D computes with floats
            assert error == pytest.approx(g * 0.5 * dt / 2, rel=0.01, abs=2e-5), (engine, dt)


def test_restitution_and_friction_mean_the_same(errors: Errors) -> None:
    """A restitution that is off by 0.05, or friction by 0.02, would be 3 cm off or more."""
    for engine in engines(errors):
        soft = engine == "mujoco"
        assert finest(errors["bounce", engine]) < (0.05 if soft else 0.01), engine
        assert finest(errors["friction", engine]) < 0.004, engine
        assert finest(errors["heavy", engine]) < 0.004, engine


def test_what_rests_stays_asleep_or_not(errors: Errors) -> None:
    for engine in engines(errors):
        assert finest(errors["rest", engine]) < 0.001, engine


def test_all_but_the_soft_one_converge(errors: Errors) -> None:
    for engine in engines(errors):
        for data in SCENES[:-1]:
            own = errors[data["name"], engine]
            falls = finest(own) < own[max(own)] / 3 or finest(own) < 1e-9
            assert falls or engine == "mujoco", (engine, data["name"])


def finest(errors: dict[float, float]) -> float:
    return errors[min(errors)]


def engines(errors: Errors) -> list[str]:
    """The engines without numpy, which runs the assignment's scheme."""
    return sorted({engine for _, engine in errors} - {"numpy"})


def test_the_program_says_how_it_is_called(tmp_path: Path) -> None:
    if not peers.PROGRAM.exists():
        pytest.skip("no engines are built here: run ./kit study --peers")
    refusals: dict[str, list[Path]] = {
        "usage: bounce_peers": [tmp_path],
        "is no folder of scenes": [tmp_path / "none", peers.STEPS, tmp_path / "out"],
    }
    for message, arguments in refusals.items():
        done = subprocess.run([peers.PROGRAM, *arguments], capture_output=True, text=True)
        assert done.returncode == 2 and message in done.stderr


# --- the assignment in numpy ---


def test_numpy_falls_with_eulers_error() -> None:
    pytest.importorskip("numpy", reason="python3-numpy is not installed: run ./kit study --peers")
    t, dt = 0.5, 0.01
    line = f"0.5 2 0.4 0.8 0.001 0 {-GRAVITY} 0  0 3 0.3 1 1 2  {dt} 5 10 3\n"
    command = [sys.executable, str(peers.NUMPY)]
    done = subprocess.run(command, input=line * 2, capture_output=True, check=True, text=True)
    version, *answers = done.stdout.splitlines()
    assert re.match(r"\d+\.\d+", version) and len(answers) == 2
    for answer in answers:
        ns, *poses = map(float, answer.split())
        assert ns > 0 and len(poses) == 30
        x, y, theta = poses[-3:]
        assert (x, theta) == pytest.approx((t, 0.3 + 2 * t))
        assert y == pytest.approx(3 + t - GRAVITY * t * t / 2 - GRAVITY * t * dt / 2)


# --- how errors and ratios are taken ---


def test_the_page_tells_how_the_sweep_is_made(known: Tables) -> None:
    starts = (ROOT / "solution" / "study" / "starts.hpp").read_text()
    assert f"kStarts = {measurements.STARTS};" in starts
    close = {"engine.hpp": measurements.CLOSE, "numpy.cpp": measurements.CLOSE_OF_NUMPY}
    for file, dt in close.items():
        text = (ROOT / "solution" / "study" / "peers" / file).read_text()
        said = re.findall(r"(?:close_dt|kCloseDt) = ([\de-]+);", text)
        assert [float(number) for number in said] == [dt], file


def test_errors_over_the_step_are_no_saw_tooth(known: Tables) -> None:
    """Neighbouring steps below 20 ms are at most 1.15 apart (1.155 where a scene has 53 of them);
    of larger ones at most nine and eleven make up the time between two samples. Where a method
    converges, the error over the starts rises between them by less than half; that of one start
    may rise tenfold."""
    runs = measurements.read(known)
    assert measurements.step_ratio([run for run in runs if run.setting < 0.02]) < 1.155
    assert measurements.step_ratio(runs) < 11.01 / 9
    rises = []
    for scene in measurements.scenes(runs):
        line = measurements.of(runs, scene, "moreau_jean_2")
        line = sorted(line, key=lambda run: -run.setting)
        rises += [b.error / a.error for a, b in itertools.pairwise(line) if a.error > 1e-9]
    assert sorted(rises)[len(rises) * 9 // 10] < 1.5


def test_an_error_is_between_the_least_and_the_largest_of_its_starts(known: Tables) -> None:
    for name in ("speed_accuracy", "peers", "peers_beside"):
        for row in known[name].rows:
            least, error, largest = (
                float(row[column]) for column in ("least_error_m", "error_m", "largest_error_m")
            )
            assert least * 0.9999 <= error <= largest * 1.0001 or error < 1e-15, row


def test_ratios_are_to_ours_of_the_same_rounds(known: Tables) -> None:
    rows = known["peers"].rows + known["peers_beside"].rows
    known_runs = (measurements.run_of(row, True) for row in rows)
    runs = {(run.scene, run.method, run.setting): run for run in known_runs}
    for row in known["peers_ratios"].rows:
        times, lower, upper = (float(row[name]) for name in facts_peers.RATIO)
        assert lower <= times <= upper, row
        engine = runs[row["scene"], row["engine"], float(row["engine_dt_s"])]
        ours = runs[row["scene"], row["ours"], float(row["ours_setting"])]
        assert engine.error <= float(row["error_m"]) >= ours.error
        assert lower / 3 <= engine.ns / ours.ns <= 3 * upper, "the medians are of the same size"


def test_variants_are_swept_over_the_step(known: Tables) -> None:
    table = known["peers_variants"]
    for scene in table.distinct("scene"):
        for engine in table.distinct("engine"):
            assert len(facts_peers.variant_errors(known, scene, engine)) >= 3
