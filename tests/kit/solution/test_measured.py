"""Measured impacts and drops: what is put in synthetic figures is found again, and figures that
can't be used are refused in a sentence."""

import gzip
import json
from pathlib import Path

import numpy as np
import pytest

from bounce_grader.cli import main
from bounce_grader.common.errors import UsageError
from bounce_grader.common.paths import FIXTURES
from bounce_study import measured_part
from bounce_study.tables import number
from measured import body as bodies
from measured import flights, impacts, ladder, laws, rows, sorting, study
from measured.body import Body, Impacts
from measured.impacts import Air
from measured.ladder import Grids, Group
from measured.rows import Array, INTERVAL, Trial
from studies import committed

MEASURED = FIXTURES / "measured"
NOISE = np.array([2e-5, 4e-5, 8e-4])
AIR = Air(9.81, 0.4, NOISE)
BODY = Body(0.05, 0.03, -3e-4, -4e-4, 0.004, 0.002, 0.0, 4.2e-4)


def random_impacts(count: int, seed: int) -> Impacts:
    """Impacts of one corner of BODY, each a trial, whose velocity after is not known yet."""
    random = np.random.default_rng(seed)
    theta = random.uniform(0.2, np.pi / 4, count) * random.choice([-1, 1], count)
    all_arms = bodies.arms(theta - BODY.turn, BODY)
    lowest = all_arms[:, :, 1].argmin(axis=1)
    n = np.arange(count)
    corner = all_arms[n, lowest]
    other = np.where(
        (all_arms[n, (lowest + 1) % 4, 1] < all_arms[n, (lowest + 3) % 4, 1])[:, None],
        all_arms[n, (lowest + 1) % 4],
        all_arms[n, (lowest + 3) % 4],
    )
    before = np.stack(
        [random.normal(0, 0.6, count), np.zeros(count), random.normal(0, 8, count)], axis=1
    )
    before[:, 1] = -random.uniform(0.3, 2, count) - corner[:, 0] * before[:, 2]
    pose = np.stack([np.zeros(count), np.zeros(count), theta], axis=1)
    gyration_squared = np.full(count, BODY.gyration_squared)
    return Impacts(n, pose, before, before.copy(), corner, other, gyration_squared)


def obeying(law: laws.Law, hits: Impacts, setting: Array) -> Impacts:
    return Impacts(
        *(
            laws.after(law, hits, setting) if name == "after" else getattr(hits, name)
            for name in Impacts.__dataclass_fields__
        )
    )


def named(name: str) -> laws.Law:
    return next(law for law in laws.LADDER if law.name == name)


def flight(t: Array, pose: Array, velocity: Array) -> Array:
    """Poses at times t after (or before) a pose, in AIR."""
    s = AIR.warped(t)
    path = pose + np.outer(s, velocity)
    path[:, 1] += AIR.fallen(t)
    return path


def trial_of(name: int, at: float, pose: Array, before: Array, after: Array) -> Trial:
    """Rows without noise around one impact, which comes `at` of a row after row 12."""
    k = np.arange(25)
    t = (k - 12 - at) * INTERVAL
    q = np.where((t < 0)[:, None], flight(t, pose, before), flight(t, pose, after))
    return Trial(name, k, q)


def synthetic(count: int) -> tuple[list[Trial], Impacts]:
    """Drops of BODY by Newton's law, mu 0.2 and epsilon 0.5, in the frame of the rows."""
    hits = obeying(named("newton"), random_impacts(count, 3), np.array([0.2, 0.5, 0.0]))
    random = np.random.default_rng(4)
    trials = []
    for i in range(count):
        x = random.uniform(-0.3, 0.3)
        y = BODY.ground + BODY.slope * (x + hits.corner[i, 0]) - hits.corner[i, 1]
        theta = hits.pose[i, 2]
        arm = np.array([BODY.centre_x, BODY.centre_y])
        turn = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
        off = turn @ arm
        pose = np.array([x - off[0], y - off[1], theta - BODY.turn])
        moved = [
            v - np.array([-v[2] * off[1], v[2] * off[0], 0])
            for v in (hits.before[i], hits.after[i])
        ]
        trials.append(trial_of(i, random.uniform(0.05, 0.95), pose, *moved))
    return trials, hits


# --- extraction ---


def test_an_impact_without_noise_is_found_to_rounding() -> None:
    trials, hits = synthetic(120)
    found = impacts.find(trials, AIR)
    assert len(found.events) > 100
    for event in found.events:
        _, before = bodies.centred(event.pose[None], event.before[None], BODY)
        _, after = bodies.centred(event.pose[None], event.after[None], BODY)
        assert event.residual < 1e-3
        assert np.abs(before[0] - hits.before[event.trial]) == pytest.approx(0, abs=2e-3)
        assert np.abs(after[0] - hits.after[event.trial]) == pytest.approx(0, abs=2e-3)


def test_the_body_is_found_from_its_impacts() -> None:
    found = impacts.find(synthetic(120)[0], AIR)
    body = bodies.fit_geometry(found.events)
    assert body.side == pytest.approx(BODY.side, rel=1e-3)
    assert body.turn == pytest.approx(BODY.turn, abs=1e-3)
    assert body.ground == pytest.approx(BODY.ground, abs=5e-5)
    assert body.slope == pytest.approx(BODY.slope, abs=5e-4)
    assert body.gyration_squared == pytest.approx(BODY.gyration_squared, rel=2e-3)
    ordered = sorting.sort(found, body)
    assert len(ordered.one) + len(ordered.two) + sum(ordered.left_out.values()) == 120


def test_gravity_and_drag_are_found_from_flight() -> None:
    random = np.random.default_rng(5)
    trials = []
    for i in range(40):
        velocity = np.array([random.normal(), random.uniform(-2, 2), random.normal(0, 9)])
        k = np.arange(12)
        q = flight(k * INTERVAL, np.array([0, 0.5, 0.1]), velocity)
        trials.append(Trial(i, k, q + random.normal(size=q.shape) * NOISE / 100))
    measured = flights.measure(trials)
    drags = {drag.name: drag for drag in flights.drags(measured)}
    assert drags["linear"].g == pytest.approx(AIR.g, rel=2e-3)
    assert drags["linear"].drag == pytest.approx(AIR.drag, rel=2e-2)
    assert drags["linear"].left < drags["none"].left / 3
    for i in (0, 2):
        assert flights.linear_drag(measured, i) == pytest.approx(AIR.drag, rel=5e-2)


# --- laws ---


def test_newtons_law_reverses_the_normal_velocity_within_the_cone() -> None:
    hits = random_impacts(200, 6)
    mu, epsilon = 0.3, 0.6
    after = laws.after(named("newton"), hits, np.array([mu, epsilon, 0.0]))
    done = obeying(named("newton"), hits, np.array([mu, epsilon, 0.0]))
    v_n = after[:, 1] + hits.corner[:, 0] * after[:, 2]
    v_t = after[:, 0] - hits.corner[:, 1] * after[:, 2]
    impulse = after - hits.before
    assert v_n == pytest.approx(-epsilon * hits.approach())
    sticks = np.abs(v_t) < 1e-9
    assert sticks.any() and not sticks.all()
    assert np.all(np.abs(impulse[:, 0]) <= mu * impulse[:, 1] + 1e-12)
    assert impulse[~sticks, 0] == pytest.approx(-mu * impulse[~sticks, 1] * np.sign(v_t[~sticks]))
    assert bodies.floor(done) == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("law", [law.name for law in laws.LADDER if law.name != "newton"])
def test_laws_act_at_their_corners_alone(law: str) -> None:
    hits = random_impacts(100, 7)
    if named(law).corners == 2:  # which take both corners to be equally low
        hits.other[:, 1] = hits.corner[:, 1]
    done = obeying(named(law), hits, np.array([0.3, 0.5, 1.0]))
    floor = bodies.floor_of_side if named(law).corners == 2 else bodies.floor
    assert floor(done) == pytest.approx(0, abs=1e-9)


def test_a_compliant_corner_without_coupling_rebounds_with_epsilon() -> None:
    hits = random_impacts(20, 8)
    hits.corner[:, 0] = 0
    hits.before[:] = [0, -1, 0]
    after = laws.after(named("compliant"), hits, np.array([0.3, 0.5, 1.0]))
    assert after[:, 1] == pytest.approx(0.5, abs=0.02)


def group(hits: Impacts) -> Group:
    return Group("synthetic", (hits,), (bodies.floor(hits),), laws.ONE_CORNER[:-1])


@pytest.mark.parametrize("law", ["frictionless", "newton", "poisson_normal", "routh_stronge"])
def test_the_law_that_was_put_in_is_the_least(law: str) -> None:
    setting = np.array([0.2 if law != "frictionless" else 0.0, 0.5, 0.0])
    hits = obeying(named(law), random_impacts(160, 9), setting)
    verdict = ladder.judge(group(hits), 50, Grids())
    rung = next(rung for rung in verdict.rungs if rung.law.name == law)
    assert rung.setting == pytest.approx(setting, abs=1e-9)
    assert rung.median < 1e-6
    assert verdict.least == law


def test_under_noise_the_interval_holds_what_was_put_in() -> None:
    hits = obeying(named("newton"), random_impacts(300, 10), np.array([0.21, 0.47, 0.0]))
    hits.after[:] += np.random.default_rng(11).normal(size=(300, 3)) * [0.02, 0.02, 1.0]
    verdict = ladder.judge(group(hits), 100, Grids())
    rung = next(rung for rung in verdict.rungs if rung.law.name == "newton")
    assert rung.low[0] <= 0.21 <= rung.high[0] and rung.low[1] <= 0.47 <= rung.high[1]
    assert rung.interval[0] <= rung.median <= rung.interval[1]
    assert verdict.floor < rung.median


def test_trials_and_not_impacts_are_halved() -> None:
    trial = np.array([7, 7, 3, 9, 9, 9, 12])
    half = ladder.halves(trial)
    assert half.fit.tolist() == [False, False, True, True, True, True, False]
    assert not (half.fit & half.judge).any() and (half.fit | half.judge).all()


# --- the command ---


def some_squares(folder: Path, trials: int) -> Path:
    """The first drops, as plain text, and with other row counts."""
    lines = gzip.decompress((MEASURED / "squares.csv.gz").read_bytes()).decode().splitlines()
    names = list(dict.fromkeys(line.split(",")[0] for line in lines[1:]))[:trials]
    kept = [line for line in lines[1:] if line.split(",")[0] in set(names)]
    short = [line for line in kept if int(line.split(",")[0]) % 7 or int(line.split(",")[1]) < 170]
    file = folder / "squares.csv"
    file.write_text("\n".join([lines[0], *short]) + "\n")
    return file


def some_ellipses(folder: Path, count: int) -> Path:
    lines = (MEASURED / "ellipses.csv").read_text().splitlines()
    file = folder / "ellipses.csv.gz"
    file.write_bytes(gzip.compress("\n".join(lines[: count + 1]).encode()))
    return file


def test_the_command_answers_for_other_figures(tmp_path: Path) -> None:
    squares, oval = some_squares(tmp_path, 60), some_ellipses(tmp_path, 80)
    answers = []
    for name in ("one.json", "two.json"):
        command = ["study", "measured", "--quick", "--squares", str(squares)]
        command += ["--ellipses", str(oval), "--json", str(tmp_path / name)]
        assert main(command) == 0
        answers.append((tmp_path / name).read_bytes())
    assert answers[0] == answers[1], "the same figures give the same bytes"
    shapes = json.loads(answers[0])["shapes"]
    assert set(shapes) == {study.ONE, study.TWO, study.ALL, study.OVAL, study.BOTH}
    for shape in shapes.values():
        assert shape["impacts_fitted"] > 0 < shape["impacts_judged"]
        assert shape["least_model"] in shape["laws"] and shape["best"] in shape["laws"]
        least, best = (shape["laws"][shape[name]] for name in ("least_model", "best"))
        assert best["median_error"] <= least["median_error"]
        for law in shape["laws"].values():
            low, high = law["interval"]
            assert 0 <= low <= high
            for name, value in law["parameters"].items():
                low, high = law["parameter_intervals"][name]
                assert low <= value <= high
    newton = shapes[study.ONE]["laws"]["newton"]
    assert newton["median_error"] > shapes[study.ONE]["floor"]["median_error"]
    assert sorted(file.name for file in tmp_path.iterdir()) == [
        "ellipses.csv.gz",
        "one.json",
        "squares.csv",
        "two.json",
    ]


def test_the_tables_are_those_that_the_pages_need() -> None:
    assert measured_part.TABLES == study.TABLES


HEADER = "trial,k,x,y,theta\n"
BAD_SQUARES = {
    "has no column theta": "trial,k,x,y\n1,0,0,0\n",
    "line 3: y is 'high', no number": HEADER + "1,0,0,1,0\n1,1,0,high,0\n",
    "line 2: theta is missing": HEADER + "1,0,0,1\n",
    "line 2: y is nan": HEADER + "1,0,0,nan,0\n",
    "has no rows": HEADER,
    "has no column trial": "",
    "trial 1 has a row twice": HEADER + "1,0,0,1,0\n1,0,0,1,0\n",
    "k has to be whole numbers": HEADER + "1,0.5,0,1,0\n",
    "it takes four": HEADER + "1,0,0,1,0\n1,1,0,1,0\n",
    "it takes 30 to find gravity": HEADER + "".join(f"{i},0,0,1,0\n" for i in range(9)),
}


@pytest.mark.parametrize("sentence", BAD_SQUARES)
def test_figures_that_cannot_be_used_are_refused_in_a_sentence(
    sentence: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "squares.csv"
    file.write_text(BAD_SQUARES[sentence])
    assert main(["study", "measured", "--squares", str(file)]) == 2
    message = capsys.readouterr().err
    assert sentence in message and message.count("\n") == 1


def test_too_few_impacts_are_refused(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="clear impacts of one corner"):
        study.run(some_squares(tmp_path, 12), MEASURED / "ellipses.csv", quick=True)
    with pytest.raises(UsageError, match="ellipses have no flag"):
        study.run(MEASURED / "squares.csv.gz", some_ellipses(tmp_path, 4), quick=True)


def test_a_file_that_is_not_there_or_cut_short_is_named(tmp_path: Path) -> None:
    cut = tmp_path / "cut.csv.gz"
    cut.write_bytes((MEASURED / "squares.csv.gz").read_bytes()[:5000])
    for file in (tmp_path / "none.csv", cut):
        with pytest.raises(UsageError, match=f"{file.name} can't be read"):
            rows.trials(file)


def test_options_of_the_measured_part_are_for_it_alone(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["study", "depth", "--squares", "x.csv"]) == 2
    assert "are for ./kit study measured" in capsys.readouterr().err


def test_in_the_fitted_bodys_metric_its_own_error_stays() -> None:
    """And it differs from the published body's error in that body's metric, by r_g."""
    known = committed()
    in_metric = known["measured_findings"].where(about="metric")
    errors = {row["hypothesis"]: number(row, "second_half") for row in in_metric}
    own = {row["group"]: row for row in known["measured_bodies"].where(law="newton")}
    assert set(errors) == set(own)
    assert errors["fitted"] == pytest.approx(number(own["fitted"], "median_m_s"), rel=1e-3)
    published = number(own["as published"], "median_m_s")
    assert errors["fitted"] < errors["as published"] < published
