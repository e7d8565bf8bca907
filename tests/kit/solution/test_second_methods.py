"""The numbers of the study's tables, row by row, by programs that share nothing with those that
found them: second_methods.py for what steps and strikes, second_truth.f90 for what is exact."""

import csv
import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import second_methods as second
from bounce_grader.common.paths import FIXTURES, ROOT
from test_second_truth import second_truth

Row = dict[str, str]
pytestmark = pytest.mark.long
G, DEFAULTS = -9.81, {"l": 0.2, "mu": 0.3, "epsilon": 0.5, "g": [0, -9.81, 0]}
DELTA_SPEED = 0.1  # m/s: delta over dt where they are in proportion


def table(name: str, folder: str = "docs/studies") -> list[Row]:
    lines = (ROOT / folder / f"{name}.csv").read_text().splitlines()
    return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def stepped(rows: list[Row], scene: dict[str, Any], until: float, samples: int) -> list[Any]:
    """The scene with each row's step and delta, and the number of steps to a sample."""
    lanes = []
    for row in rows:
        per_sample = max(1, round(until / samples / float(row["setting"])))
        dt, method = until / samples / per_sample, row["method"]
        delta = {"assignment_delta_dt": DELTA_SPEED * dt, "assignment_delta_0": 0}
        lanes.append((scene | {"dt": dt, "delta": delta.get(method, 0.001)}, per_sample))
    return lanes


See = Callable[[Any, second.Squares], None]  # which of the lanes, and as they are


def follow(rows: list[Row], lanes: list[Any], samples: list[int], see: See) -> None:
    """Runs each row's method; see() at each sample of a row."""
    steps = np.array([per_sample for _, per_sample in lanes])
    total = steps * np.array(samples)
    names = [row["method"].replace("_delta_dt", "").replace("_delta_0", "") for row in rows]
    for method in second.METHODS:
        own = np.flatnonzero([name == method for name in names])

        def seen(step: int, places: Any, s: second.Squares, own: Any = own) -> None:
            now = step % steps[own[places]] == 0
            if now.any():
                see(own[places[now]], s.at(now))

        if own.size:
            second.run(method, second.squares([lanes[i][0] for i in own]), total[own], seen)


def agree(name: str, column: str, rows: list[Row], found: Any, rounding: float = 1e-12) -> None:
    """To the five digits that are written."""
    wrong = [
        (row, x)
        for row, x in zip(rows, found, strict=True)
        if not abs(float(row[column]) - x) <= 5.01e-5 * abs(x) + rounding
    ]
    assert not wrong, (name, column, len(wrong), len(rows), wrong[:5])


def by_step(rows: list[Row]) -> list[Row]:
    """Those of methods with steps; event-driven rows are another test's."""
    return [row for row in rows if row["method"] != "event_driven"]


# --- motion ---


def test_rest_and_drift() -> None:
    rows = by_step(table("rest_and_drift"))
    scene, most = DEFAULTS | {"q": [0, 0.1, 0], "v": [0, 0, 0]}, np.zeros((3, len(rows)))
    lanes, looks = [], [round(10 / float(row["setting"])) for row in rows]
    for row, n in zip(rows, looks):
        lanes += stepped([row], scene, 10, n)

    def see(at: Any, s: second.Squares) -> None:
        moves = s.z.imag - 0.1, 0.1 - s.z.imag, abs(s.z.real)
        most[:, at] = np.maximum(most[:, at], moves)

    follow(rows, lanes, looks, see)
    for column, found in zip(("height_m", "depth_m", "drift_m"), most):
        agree("rest_and_drift", column, rows, found)


def test_slopes() -> None:
    rows = [row for row in by_step(table("slope_and_energy")) if row["case"] == "slope"]
    lanes, exact, off = [], np.zeros(len(rows)), np.zeros(len(rows))
    for i, row in enumerate(rows):
        sine, cosine = math.sin(float(row["tilt_rad"])), math.cos(float(row["tilt_rad"]))
        scene = DEFAULTS | {"q": [0, 0.1, 0], "v": [0, 0, 0], "g": [-G * sine, G * cosine, 0]}
        lanes += stepped([row], scene, 0.5, 1)
        exact[i] = -G * max(0, sine - 0.3 * cosine) * 0.5**2 / 2

    def see(at: Any, s: second.Squares) -> None:
        off[at] = np.hypot(abs(s.z - 0.1j - exact[at]), s.l / math.sqrt(2) * s.theta)

    follow(rows, lanes, [1] * len(rows), see)
    agree("slope_and_energy", "off", rows, off)


def test_energy() -> None:
    """Starts that are 1e-15 rad apart are a millimetre apart after half of the time: a number is
    one of those that rounding may give."""
    starts = 8
    rows = [row for row in by_step(table("slope_and_energy")) if row["case"] == "energy"]
    scene = DEFAULTS | {"v": [0, 0, 5], "mu": 0, "epsilon": 1}
    many, lanes = [row for row in rows for _ in range(starts)], []
    for i, row in enumerate(many):
        lanes += stepped([row], scene | {"q": [0, 1, 0.3 + 1e-15 * (i % starts)]}, 10, 100)
    most = np.zeros(len(many))

    def energy(s: second.Squares) -> Any:
        return (abs(s.v) ** 2 + s.l**2 / 6 * s.omega**2) / 2 - G * s.z.imag

    before = energy(second.squares([lanes[0][0]]))

    def see(at: Any, s: second.Squares) -> None:
        r, _ = second.low_arms(s.l, s.theta)
        flies = (s.z.imag + r.imag).min(axis=0) > s.l / 100
        most[at] = np.maximum(most[at], abs(energy(s) / before - 1) * flies)

    follow(many, lanes, [100] * len(many), see)
    told = np.array([float(row["off"]) for row in rows])
    found = most.reshape(len(rows), starts)
    wrong = (told < found.min(axis=1) / 1.5) | (told > found.max(axis=1) * 1.5)
    assert not wrong.any(), [(rows[i], found[i]) for i in np.flatnonzero(wrong)]


def test_flat_landing() -> None:
    rows = by_step(table("flat_landing"))
    omega = np.zeros(len(rows))
    thetas = [float(row["theta_rad"]) for row in rows]
    start = DEFAULTS | {"v": [0, 0, 0], "dt": 1e-4, "delta": 0.001}
    lanes = [(start | {"q": [0, 0.3, theta]}, 2100) for theta in thetas]

    def see(at: Any, s: second.Squares) -> None:
        omega[at] = s.omega

    follow(rows, lanes, [1] * len(rows), see)
    agree("flat_landing", "omega_rad_s", rows, omega)


def test_depth() -> None:
    rows, heights, depth = table("depth"), 256, []
    for row in rows:
        speed, dt = float(row["speed_m_s"]), float(row["dt_s"])
        above = 0.2 / math.sqrt(2) + 0.001 + 1e-9 + speed * dt * np.arange(heights) / heights
        start = DEFAULTS | {"v": [0, -speed, 0], "dt": dt, "delta": 0.001}
        s = second.squares([start | {"q": [0, y, math.pi / 4]} for y in above])
        deepest = 0.0
        for _ in range(4):
            s = second.METHODS[row["method"]](s)
            low, _ = second.low_arms(s.l, s.theta)
            deepest = max(deepest, -(s.z.imag + low.imag).min())
        depth.append(deepest)
    agree("depth", "depth_m", rows, depth)


# --- contacts ---

ANGLES = np.radians(np.arange(46))[:, None]  # in which a square's corner can lean


def test_energy_gain() -> None:
    rows, v_t = table("energy_gain"), np.arange(-300, 301) / 100
    laws = {"newton": second.newton, "poisson": lambda k: second.routh(k, False)}
    laws["stronge"] = lambda k: second.routh(k, True)
    for law, impulse in laws.items():
        found = []
        for row in rows:
            k = second.leaning(ANGLES, v_t, float(row["mu"]), float(row["epsilon"]))
            found.append(k.gain(*impulse(k)).max())
        agree("energy_gain", law, rows, found)


def test_the_least_epsilon_that_gains() -> None:
    """By bisection, over the velocities at which an impact sticks best or just about."""
    rows = table("energy_gain")
    limits: dict[float, float] = {}
    for mu in {float(row["mu"]) for row in rows}:
        low, high = np.zeros(46), np.ones(46)
        for _ in range(50):
            middle = (low + high) / 2
            at_rest = second.leaning(ANGLES[:, 0], 0, mu, middle)
            a, b, c, u = at_rest.a, at_rest.b, at_rest.c, -(1 + middle)
            v_t = [-b / a, (b + mu * c) * u / (a + mu * b), (b - mu * c) * u / (a - mu * b)]
            k = second.leaning(ANGLES[:, 0], np.array(v_t), mu, middle)
            gains = k.gain(*second.newton(k)).max(axis=0) > 1e-15
            low, high = np.where(gains, low, middle), np.where(gains, middle, high)
        limits[mu] = high.min()
    agree("energy_gain", "limit_epsilon", rows, [limits[float(row["mu"])] for row in rows])


def test_solution_count() -> None:
    """The cases of a contact that hold, at most, over velocities of eight decades."""
    rows, found, stars = table("solution_count"), [], []
    decades = 10 ** (np.arange(1, 161) / 20 - 3)
    u_t = np.concatenate([-decades, [0], decades])
    for row in rows:
        # The digits that are written are too few to tell which side of mu* a pair is on.
        alpha = round(float(row["alpha_rad"]) * 60 / math.pi) * math.pi / 60
        mu, most = float(row["mu"]), 0
        for u_n in (-1, 1):
            k = second.leaning(np.full_like(u_t, alpha), u_t, mu, 0, u_n)
            G = np.array([[k.a[0], k.b[0]], [k.b[0], k.c[0]]])
            stick = -np.linalg.solve(G, [k.v_n, u_t])
            count = (stick[0] > 0) & (abs(stick[1]) <= mu * stick[0])
            count = count + np.full_like(u_t, u_n > 0, int)
            for way in (1, -1):
                slide = -u_n / (k.a - way * mu * k.b)
                count += (slide > 0) & (way * (u_t + (k.b - way * mu * k.c) * slide) > 0)
            most = max(most, int(count.max()))
        found.append(most)
        stars.append(k.a[0] / abs(k.b[0]))
    agree("solution_count", "most_solutions", rows, found)
    agree("solution_count", "mu_star", rows, stars)


def test_gauss_seidel() -> None:
    rows = table("gauss_seidel")
    stacks = [row for row in rows if row["problem"] == "mass_ratio"]
    counts, predicted = [], []
    for i in range(len(stacks)):
        R, count, change, p, q = 10 ** (i / 2 - 2), 0, 1.0, 0.0, 0.0
        while change > 1e-9:  # the impulse of the ground, and that between the squares
            before = p, q
            p = max(0, q + 0.0981)
            q = max(0, p / (1 + 1 / R))
            change, count = max(abs(p - before[0]), abs(q - before[1]) * (1 + 1 / R)), count + 1
        counts.append(count)
        predicted.append(1 + math.log(1e-9 / 0.0981) / math.log(R / (1 + R)))
    agree("gauss_seidel", "sweeps", stacks, counts)
    agree("gauss_seidel", "predicted_sweeps", stacks, predicted)
    rows = [row for row in rows if row["problem"] == "one_corner_mu"]
    random, contacts = second.uniform(1), []
    for _ in range(2000):
        u_t, u_n = random(-3, 3), -random(0.1, 1)
        contacts.append((random(-0.78, 0.78), u_n, u_t))
    alpha, u_n, u_t = np.tile(np.array(contacts).T, len(rows))
    mu = np.repeat([float(row["value"]) for row in rows], 2000)
    k = second.leaning(alpha, u_t, 0, 0)
    never = second.sweeps(np.array([k.a, k.b, k.c]), np.array([u_n, u_t]), mu, 10_000) == 10_000
    agree("gauss_seidel", "share_without_end", rows, never.reshape(len(rows), -1).mean(axis=1))


def test_examples() -> None:
    found = []
    s = second.squares(
        [DEFAULTS | {"q": [0, 0.104267, 0.043633], "v": [0.040023, -0.396829, 6.313089]}]
    )
    low, right = second.low_arms(s.l, s.theta)
    r, k = np.where(right, low[1], low[0])[0], 0.2**2 / 6
    v = second.corner_velocity(s, r)
    share = 1 + r.real**2 / k, -r.real * r.imag / k, 1 + r.imag**2 / k
    a, b, c = (np.array([x]) for x in share)
    corner = second.Corner(a, b, c, v.imag, v.real, 0.3, 0.9)
    before = abs(s.v) ** 2 + k * s.omega**2
    for p_n, p_t in (second.newton(corner), *(second.routh(corner, law) for law in (False, True))):
        after = second.pushed(s, r[None, None], p_n[None], p_t)
        found.append(((abs(after.v) ** 2 + k * after.omega**2) / before)[0])
    alpha = np.arange(1, 20_000) * math.pi / 40_000
    any_corner = second.leaning(alpha, 0, 0, 0)
    a, b, c = any_corner.a, any_corner.b, any_corner.c
    mu = a / abs(b)
    found += [np.sqrt(1 - b * b / (a * c)).min(), mu.min(), math.tan(alpha[mu.argmin()])]
    agree("examples", "value", table("examples")[:6], found)


# --- what is exact in time ---


def scene_of(name: str) -> dict[str, Any]:
    scene = json.loads((FIXTURES / "scenes" / f"{name}.json").read_text())
    return dict(scene["params"], q=scene["q"], v=scene["v"], until=scene["compare"]["until"])


def exact(folder: Path, asked: list[tuple[dict[str, Any], float]]) -> Any:
    """x, y, theta, v_x, v_y and omega of scenes at times."""
    lines = [
        [s["l"], s["mu"], s["epsilon"], *s["g"][:2], *s["q"], *s["v"], time] for s, time in asked
    ]
    return np.array(second_truth(folder, lines)).astype(float)


def apart(one: Any, other: Any, l: Any) -> Any:
    x, y, theta = (one - other).T
    return np.sqrt(x**2 + y**2 + l**2 / 2 * theta**2)


def test_event_driven_rows(tmp_path: Path) -> None:
    moves = [("rest_and_drift", name) for name in ("height_m", "depth_m", "drift_m")]
    for name, column in [*moves, ("slope_and_energy", "off")]:
        rows = [row for row in table(name) if row["method"] == "event_driven"]
        agree(name, column, rows, np.zeros(len(rows)), 1e-14)
    # Nearer to flat, both corners count as touching.
    rows = [row for row in table("flat_landing") if row["method"] == "event_driven"]
    rows = [row for row in rows if not 0 < abs(float(row["theta_rad"])) < 1e-12]
    start = DEFAULTS | {"v": [0, 0, 0]}
    asked = [(start | {"q": [0, 0.3, float(row["theta_rad"])]}, 0.21) for row in rows]
    agree("flat_landing", "omega_rad_s", rows, exact(tmp_path, asked)[:, 5])


FINEST = 0.99e-4  # s: ten times finer steps take ten times as long


def samples_for(until: float, dt: float) -> int:
    steps = max(1, round(until / dt))
    return min(range(20, 40), key=lambda n: abs(steps - n * round(steps / n)))


def test_speed_and_accuracy(tmp_path: Path) -> None:
    """The error from each scene's own start."""
    rows, lanes, counts, asked = [], [], [], []
    for row in by_step(table("speed_accuracy", "fixtures/study")):
        known = row["method"].replace("_delta_dt", "") in second.METHODS
        if not known or float(row["setting"]) < FINEST:
            continue
        scene = scene_of(row["scene"])
        exponent = round(-4 * math.log10(float(row["setting"]) / 0.01))
        counts.append(samples_for(scene["until"], 0.01 * 10 ** (-exponent / 4)))
        step = row | {"setting": str(0.01 * 10 ** (-exponent / 4))}
        lanes += stepped([step], scene, scene["until"], counts[-1])
        rows.append(row)
    pairs = sorted({(row["scene"], n) for row, n in zip(rows, counts)})
    for name, n in pairs:
        scene = scene_of(name)
        asked += [(scene, scene["until"] * (i + 1) / n) for i in range(n)]
    found, truths = exact(tmp_path, asked)[:, :3], {}
    for pair in pairs:
        truths[pair], found = found[: pair[1]], found[pair[1] :]
    taken, worst = np.zeros(len(rows), int), np.zeros(len(rows))

    def see(at: Any, s: second.Squares) -> None:
        there = [truths[rows[i]["scene"], counts[i]][taken[i]] for i in at]
        here = np.array([s.z.real, s.z.imag, s.theta]).T
        worst[at] = np.maximum(worst[at], apart(here, np.array(there), s.l))
        taken[at] += 1

    follow(rows, lanes, counts, see)
    agree("speed_accuracy", "own_error_m", rows, worst)


MODELS = {
    "one_normal": ("moreau_jean_1", False),
    "one_friction": ("moreau_jean_1", True),
    "two_normals": ("moreau_jean_2", False),
    "two_frictions": ("moreau_jean_2", True),
}


def test_least_model() -> None:
    """Each model by Moreau-Jean's steps of 1e-4 s instead of event by event; one that never ends has none."""
    rows = [row for row in table("least_model") if math.isfinite(float(row["error_m"]))]
    truth: dict[str, list[Any]] = {}
    for at in table("truth", "fixtures/study"):
        pose = [float(at[name]) for name in ("t_s", "x_m", "y_m", "theta_rad")]
        truth.setdefault(at["scene"], []).append(pose)
    stepping, lanes, error = [], [], np.zeros(len(rows))
    for i, row in enumerate(rows):
        scene, known = scene_of(row["scene"]), np.array(truth[row["scene"]])
        if row["model"] in MODELS:
            method, friction = MODELS[row["model"]]
            stepping.append((i, row | {"method": method, "setting": "1e-4"}, known))
            scene |= {} if friction else {"mu": 0}
            lanes += stepped([stepping[-1][1]], scene, scene["until"], len(known))
        else:
            t = known[:, :1] * (row["model"] == "ballistic")
            q = np.array(scene["q"]) + t * scene["v"] + t * t / 2 * scene["g"]
            error[i] = apart(q, known[:, 1:], scene["l"]).max()
    taken = np.zeros(len(lanes), int)

    def see(at: Any, s: second.Squares) -> None:
        for k, z, theta, l in zip(at, s.z, s.theta, s.l):
            i, _, known = stepping[k]
            off = np.array([[z.real, z.imag, theta]]) - known[taken[k], 1:]
            error[i] = max(error[i], apart(off, np.zeros((1, 3)), l)[0])
            taken[k] += 1

    follow([row for _, row, _ in stepping], lanes, [len(known) for *_, known in stepping], see)
    told = np.array([float(row["error_m"]) for row in rows])
    speed = [math.hypot(*scene_of(row["scene"])["v"][:2]) for row in rows]
    wrong = abs(told - error) > 0.02 * told + 2e-3 + 2e-4 * np.array(speed)  # two steps' way
    assert not wrong.any(), [(rows[i], error[i]) for i in np.flatnonzero(wrong)]


def test_measured_laws() -> None:
    """How far the laws are off from measured impacts, in the median."""
    hits = np.array([[*row.values()] for row in table("measured_impacts", "fixtures/study")], float)
    body = {row["quantity"]: row["value"] for row in table("measured_body", "fixtures/study")}
    _, x, y, v_x, v_y, omega, *after = hits.T
    k = float(body["gyration_squared"])
    share = 1 + x**2 / k, -x * y / k, 1 + y**2 / k
    rows = [row for row in table("measured_laws", "fixtures/study") if row["shape"] == "squares"]
    rows, found = rows[:4], []
    for row in rows:  # frictionless, sticking, newton and poisson
        mu = float(row["mu"] or (0 if row["law"] == "frictionless" else 1e9))
        corner = second.Corner(*share, v_y + x * omega, v_x - y * omega, mu, float(row["epsilon"]))
        p_n, p_t = second.routh(corner, False) if row["law"] == "poisson" else second.newton(corner)
        off = v_x + p_t - after[0], v_y + p_n - after[1]
        turn = omega + (x * p_n - y * p_t) / k - after[2]
        found.append(np.median(np.sqrt(off[0] ** 2 + off[1] ** 2 + k * turn**2)))
    agree("measured_laws", "median_m_s", rows, found, 1e-5)
