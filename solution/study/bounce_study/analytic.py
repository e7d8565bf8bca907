"""Checks the truth against closed forms, and against flights between impacts of single corners in
forty digits. Nothing here is shared with the program that is checked."""

import json
import math
from collections.abc import Callable
from dataclasses import dataclass
from decimal import Decimal, localcontext
from typing import Any

from bounce_grader.common.paths import FIXTURES
from bounce_study.tables import number, Tables

DIGITS = 40
HALVINGS = 110
SAMPLING = 1e-4  # s: between samples, which are enough to find the contacts of these scenes

Pose = tuple[Decimal, Decimal, Decimal]
Motion = list[Decimal]  # x, y, theta, v_x, v_y, omega


@dataclass(frozen=True)
class Check:
    scene: str
    how: str
    error: float  # m


@dataclass(frozen=True)
class Scene:
    start: Motion
    l: Decimal
    mu: Decimal
    epsilon: Decimal
    g: Decimal  # downwards

    @property
    def half(self) -> Decimal:
        return self.l / 2


Solution = Callable[[Scene, list[Decimal]], list[Pose]]  # the poses at these times


def checks(tables: Tables) -> list[Check]:
    """Checks each scene whose motion is known by other means."""
    with localcontext() as context:
        context.prec = DIGITS
        return [Check(name, how, _error(name, solve, tables)) for name, how, solve in SOLUTIONS]


def _error(name: str, solve: Solution, tables: Tables) -> float:
    """Gives the largest distance, measured as by distance() in solution/exact/scene.cpp."""
    data = json.loads((FIXTURES / "scenes" / f"{name}.json").read_text(encoding="utf-8"))
    rows = tables["truth"].where(scene=name)
    scene, until = _scene(data), Decimal(data["compare"]["until"])
    times = [until * (i + 1) / len(rows) for i in range(len(rows))]
    arm = data["params"]["l"] / math.sqrt(2)
    worst = 0.0
    for row, (x, y, theta) in zip(rows, solve(scene, times)):
        truth = [Decimal(number(row, column)) for column in ("x_m", "y_m", "theta_rad")]
        dx, dy, turn = (float(a - b) for a, b in zip(truth, (x, y, theta)))
        worst = max(worst, math.hypot(dx, dy, arm * turn))
    return worst


def _scene(data: dict[str, Any]) -> Scene:
    params = data["params"]
    return Scene(
        start=[Decimal(x) for x in (*data["q"], *data["v"])],
        l=Decimal(params["l"]),
        mu=Decimal(params["mu"]),
        epsilon=Decimal(params["epsilon"]),
        g=-Decimal(params["g"][1]),
    )


# --- closed forms ---


def _parabola(scene: Scene, times: list[Decimal]) -> list[Pose]:
    return [_pose(_fly(scene, scene.start, t)) for t in times]


def _slide(scene: Scene, times: list[Decimal]) -> list[Pose]:
    """Friction brakes the square at mu g until nothing moves."""
    x, y, theta, v = scene.start[:4]
    rate = scene.mu * scene.g
    end = v / rate if rate else Decimal(0)
    return [(x + v * s - rate * s * s / 2, y, theta) for s in (min(t, end) for t in times)]


def _bounces(scene: Scene, times: list[Decimal]) -> list[Pose]:
    """A drop without tilt or speed: each bounce lasts epsilon times as long as the one before."""
    x, y, theta = scene.start[:3]
    ground = -_lowest(scene, [x, Decimal(0), theta, *scene.start[3:]])
    return [(x, ground + _height(scene, y - ground, t), theta) for t in times]


def _height(scene: Scene, drop: Decimal, t: Decimal) -> Decimal:
    fall = (2 * drop / scene.g).sqrt()
    if t >= fall * (1 + scene.epsilon) / (1 - scene.epsilon):
        return Decimal(0)
    if t < fall:
        return drop - scene.g * t * t / 2
    t -= fall
    speed = scene.epsilon * scene.g * fall
    while t >= 2 * speed / scene.g:
        t -= 2 * speed / scene.g
        speed *= scene.epsilon
    return speed * t - scene.g * t * t / 2


# --- impacts of single corners ---


def _impacts(scene: Scene, times: list[Decimal]) -> list[Pose]:
    poses: list[Pose] = []
    motion, now = scene.start, Decimal(0)
    while len(poses) < len(times):
        lands = now + _contact(scene, motion, times[-1] - now)
        poses += [_pose(_fly(scene, motion, t - now)) for t in times if now <= t < lands]
        if lands <= times[-1]:
            motion, now = _after_impact(scene, _fly(scene, motion, lands - now)), lands
    return poses


def _contact(scene: Scene, motion: Motion, within: Decimal) -> Decimal:
    """Finds when the lowest corner lands, by sampling, then by halving; gives a time past `within`
    where it doesn't land."""
    steps = 1
    while _is_in_the_air(scene, motion, steps * SAMPLING):
        steps += 1
        if (steps - 1) * SAMPLING > within:
            return within + 1
    high = steps * Decimal(SAMPLING)
    low = high - Decimal(SAMPLING)
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        above = _lowest(scene, _fly(scene, motion, middle)) > 0
        low, high = (middle, high) if above else (low, middle)
    return high


def _is_in_the_air(scene: Scene, motion: Motion, t: float) -> bool:
    """Computes in double precision, which is enough for a sample."""
    _, y, theta, _, v_y, omega = map(float, motion)
    angle = theta + omega * t
    reach = float(scene.half) * (abs(math.cos(angle)) + abs(math.sin(angle)))
    return y + v_y * t - float(scene.g) * t * t / 2 > reach


def _after_impact(scene: Scene, motion: Motion) -> Motion:
    """Applies Newton's restitution and Coulomb's friction: the corner sticks or slides."""
    x, y, theta, v_x, v_y, omega = motion
    r_x, r_y = min(_arms(scene, theta), key=lambda arm: arm[1])
    gyration_squared = scene.l**2 / 6
    a, b, c = (
        1 + r_x**2 / gyration_squared,
        -r_x * r_y / gyration_squared,
        1 + r_y**2 / gyration_squared,
    )
    u_n, u_t = v_y + r_x * omega, v_x - r_y * omega
    target = -(1 + scene.epsilon) * u_n
    p_n = (c * target + b * u_t) / (a * c - b * b)
    p_t = (-u_t - b * p_n) / c
    if abs(p_t) > scene.mu * p_n:
        p_n, p_t = next(
            (n, -sign * scene.mu * n)
            for sign in (1, -1)
            for n in [target / (a - sign * scene.mu * b)]
            if sign * (u_t + b * n - sign * scene.mu * c * n) >= 0
        )
    return [x, y, theta, v_x + p_t, v_y + p_n, omega + (r_x * p_n - r_y * p_t) / gyration_squared]


def _fly(scene: Scene, motion: Motion, t: Decimal) -> Motion:
    x, y, theta, v_x, v_y, omega = motion
    fallen = scene.g * t * t / 2
    return [x + v_x * t, y + v_y * t - fallen, theta + omega * t, v_x, v_y - scene.g * t, omega]


def _pose(motion: Motion) -> Pose:
    return motion[0], motion[1], motion[2]


def _lowest(scene: Scene, motion: Motion) -> Decimal:
    return motion[1] + min(y for _, y in _arms(scene, motion[2]))


def _arms(scene: Scene, theta: Decimal) -> list[tuple[Decimal, Decimal]]:
    c, s = _sum_of(theta, 0), _sum_of(theta, 1)
    p, q = scene.half * (c + s), scene.half * (c - s)
    return [(q, p), (-p, q), (-q, -p), (p, -q)]


def _sum_of(x: Decimal, power: int) -> Decimal:
    """Sums the series of the cosine, which begins with power 0, or of the sine, with 1."""
    term = x ** power if power else Decimal(1)
    total = term
    while abs(term) > Decimal(10) ** -(DIGITS + 2):
        term *= -x * x / ((power + 1) * (power + 2))
        power += 2
        total += term
    return total


SOLUTIONS: tuple[tuple[str, str, Solution], ...] = (
    ("rest", "nothing moves", _slide),
    ("free_flight", "a parabola", _parabola),
    ("slide", "braked at μ g", _slide),
    ("flat_drop", "bounces, a geometric series", _bounces),
    ("zeno", "bounces, a geometric series, and its end", _bounces),
    ("pointed_drop", "bounces, a geometric series, and balance", _bounces),
    ("oblique_bounce", "flights and impacts of corners, in forty digits", _impacts),
    ("projectile", "flights and impacts of corners, in forty digits", _impacts),
    ("spin", "flights and impacts of corners, in forty digits", _impacts),
    ("tumble", "flights and impacts of corners, in forty digits", _impacts),
)
