"""The study's stepping methods and laws of impact a second time, from the assignment's equations:
nothing is shared with solution/. Vectors are complex numbers, x + i y; every array has one place for
each of many squares, which step side by side; and a contact is solved by trying its cases.

Impulses are divided by the mass: m falls out of every motion."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from itertools import product
from typing import Any

import numpy as np

Array = Any  # of numpy, which a dozen operations below would have to name each time


@dataclass(frozen=True)
class Squares:
    """n of them: each field has n numbers, g and z are complex."""

    l: Array
    mu: Array
    epsilon: Array
    g: Array
    dt: Array
    delta: Array
    z: Array  # the centre, m
    theta: Array
    v: Array  # m/s
    omega: Array

    def at(self, places: Array) -> Squares:
        return Squares(*(values[places] for values in vars(self).values()))

    def moved(self, time: Array, v: Array, omega: Array) -> Squares:
        z, theta = self.z + time * v, self.theta + time * omega
        return replace(self, z=z, theta=theta, v=v, omega=omega)


def squares(rows: list[dict[str, Any]]) -> Squares:
    """Of rows with the fields of the assignment; m is not needed."""
    of = {name: np.array([row[name] for row in rows], float) for name in ("l", "mu", "epsilon")}
    q, v, g = (np.array([row[name] for row in rows], float) for name in ("q", "v", "g"))
    dt, delta = (np.array([row.get(name, 0) for row in rows], float) for name in ("dt", "delta"))
    pairs = (pair[:, 0] + 1j * pair[:, 1] for pair in (g, q, v))
    g, z, speed = pairs
    return Squares(**of, g=g, dt=dt, delta=delta, z=z, theta=q[:, 2], v=speed, omega=v[:, 2])


def low_arms(l: Array, theta: Array) -> tuple[Array, Array]:
    """From the centre to the two lower corners, left and right: 2 x n; and whether right is lower.
    theta is a number of quarter turns and a rest, whose sign tells it."""
    rest = theta - np.round(theta / (np.pi / 2)) * (np.pi / 2)
    turned = l / 2 * np.exp(1j * rest)
    return np.array([-(1 + 1j) * turned, (1 - 1j) * turned]), rest < 0


def corner_velocity(s: Squares, r: Array) -> Array:
    return s.v + 1j * s.omega * r


def one_corner(share: Any, u_n: Array, u_t: Array, mu: Array) -> tuple[Array, Array]:
    """By trying: it is free, sticks, or slides to the side where it then goes on sliding. share is a,
    b and c: what an impulse does to its corner's velocity."""
    a, b, c = share
    D = a * c - b * b
    p_n, p_t = (b * u_t - c * u_n) / D, (b * u_n - a * u_t) / D
    sticks = (p_n >= 0) & (abs(p_t) <= mu * p_n)
    for way in (1, -1):
        slides = -u_n / (a - way * mu * b)
        here = ~sticks & (way * (u_t + (b - way * mu * c) * slides) > 0)
        p_n, p_t = np.where(here, slides, p_n), np.where(here, -way * mu * slides, p_t)
    return p_n * (u_n < 0), p_t * (u_n < 0)


@cache
def cases(corners: int) -> tuple[Array, Array]:
    """Which corners are pressed, and where they slide: 0 if they stick."""
    pushing = [case for case in product(*[(0, 1)] * corners, (0, 1, -1)) if any(case[:-1])]
    table = np.array(pushing)
    return table[:, None, :-1] == 1, table[:, -1:]


def impulses(k: Array, mu: Array, r: Array, u_n: Array, u_t: Array) -> tuple[Array, Array]:
    """Normal impulses of c corners and their common friction, with Coulomb's law between impulses
    and the velocities after: c x n and n. Of two corners each is pressed or free, and both stick or
    slide to one side: each case is a linear system, and the case counts whose inequalities hold best.
    """
    c, n = u_n.shape
    x, y = r.real, r.imag.mean(axis=0)
    if c == 1:
        share = 1 + x[0] ** 2 / k, -x[0] * y / k, 1 + y * y / k
        p_n, p_t = one_corner(share, u_n[0], u_t, mu)
        return p_n[None], p_t
    G = np.empty((n, c + 1, c + 1))
    for i, j in product(range(c), repeat=2):
        G[:, i, j] = 1 + x[i] * x[j] / k
    G[:, :c, c] = G[:, c, :c] = (-x * y / k).T
    G[:, c, c] = 1 + y * y / k
    u = np.vstack([u_n, u_t]).T
    pressed, way = cases(c)
    stops = np.concatenate([pressed, way[:, None] == 0], axis=2)  # the rows with no velocity after
    other = np.tile(np.eye(c + 1), (len(way), n, 1, 1))
    other[..., c, :c] = (way * mu)[..., None]
    M = np.where(stops[..., None], G, other)
    p = np.linalg.solve(M, np.where(stops, -u, 0)[..., None])[..., 0]
    w = np.einsum("nij,knj->kni", G, p) + u
    holds = np.where(way == 0, mu * p[..., :c].sum(axis=2) - abs(p[..., c]), way * w[..., c])
    lack = np.maximum(-np.minimum(p[..., :c], w[..., :c]).min(axis=2), -holds)
    best = p[lack.argmin(axis=0), np.arange(n)]
    best[np.maximum(0, -u_n).max(axis=0) <= lack.min(axis=0)] = 0
    return best[:, :c].T, best[:, c]


def pushed(s: Squares, r: Array, p_n: Array, p_t: Array) -> Squares:
    y = r.imag.mean(axis=0)
    turn = ((r.real * p_n).sum(axis=0) - y * p_t) * 6 / s.l**2
    return replace(s, v=s.v + p_t + 1j * p_n.sum(axis=0), omega=s.omega + turn)


def struck(s: Squares, r: Array, approaching_alone: bool) -> Squares:
    """After a step's impulses at the arms r, before gravity. Restitution counts where a corner
    approaches; in the assignment's eq. (10), always."""
    v, pull = corner_velocity(s, r), s.dt * s.g
    u_n = v.imag + s.epsilon * (np.minimum(v.imag, 0) if approaching_alone else v.imag) + pull.imag
    u_t = s.v.real - r.imag.mean(axis=0) * s.omega + pull.real
    return pushed(s, r, *impulses(s.l**2 / 6, s.mu, r, u_n, u_t))


def put(s: Squares, places: Array, part: Squares) -> Squares:
    v, omega = s.v.copy(), s.omega.copy()
    v[places], omega[places] = part.v, part.omega
    return replace(s, v=v, omega=omega)


def assignment(s: Squares) -> Squares:
    low, right = low_arms(s.l, s.theta)
    r = np.where(right, low[1], low[0])
    touches = s.z.imag + r.imag < s.delta
    if touches.any():
        s = put(s, touches, struck(s.at(touches), r[None, touches], False))
    s = s.moved(s.dt, s.v + s.dt * s.g, s.omega)
    return replace(s, z=s.z + 1j * s.delta * touches)


def moreau_jean(corners: int) -> Callable[[Squares], Squares]:
    """Of two corners, the second counts if it is no farther up than sticking could lift it."""

    def step(s: Squares) -> Squares:
        s = s.moved(s.dt / 2, s.v, s.omega)
        low, right = low_arms(s.l, s.theta)
        heights = s.z.imag + low.imag
        lower = heights.min(axis=0)
        reach = s.l / np.sqrt(2) * (s.dt * s.omega) ** 2 + abs(s.dt**2 * s.g.imag)
        both = (lower <= 0) & (heights.max(axis=0) <= reach) & (corners == 2)
        for places, count in ((both, 2), ((lower <= 0) & ~both, 1)):
            if places.any():
                r = low if count == 2 else np.where(right, low[1], low[0])[None]
                s = put(s, places, struck(s.at(places), r[:, places], True))
        return s.moved(s.dt / 2, s.v + s.dt * s.g, s.omega)

    return step


@cache
def damping_ratio(epsilon: float) -> float:
    """zeta of a damper whose spring does not pull, for this restitution: by bisection."""
    target, low, high = -np.log(max(epsilon, np.exp(-2))) / 2, 1e-9, np.pi / 2
    for _ in range(60):
        beta = (low + high) / 2
        low, high = (beta, high) if beta / np.tan(beta) > target else (low, beta)
    return float(np.cos(low))


def penalty(s: Squares) -> Squares:
    """A spring and a damper at each corner below the ground; pi is half an oscillation, which takes
    sqrt(dt 0.25 s)."""
    r = np.array([[1 + 1j], [-1 + 1j], [-1 - 1j], [1 - 1j]]) * s.l / 2 * np.exp(1j * s.theta)
    depth, v, k = -(s.z.imag + r.imag), corner_velocity(s, r), s.l**2 / 6
    below = depth > 0
    a = below.sum(axis=0) + r.real * (r.real * below).sum(axis=0) / k
    zeta = np.array([damping_ratio(epsilon) for epsilon in s.epsilon])
    frequency = np.pi / np.sqrt(0.25 * s.dt)
    force = frequency**2 * depth - 2 * zeta * frequency / np.sqrt(np.maximum(a, 1)) * v.imag
    p_n = s.dt * np.maximum(0, force) * below
    p_t = np.clip(-v.real / 4, -s.mu * p_n, s.mu * p_n)
    omega = s.omega + ((r.real * p_n).sum(axis=0) - (r.imag * p_t).sum(axis=0)) / k
    return s.moved(s.dt, s.v + (p_t + 1j * p_n).sum(axis=0) + s.dt * s.g, omega)


METHODS: dict[str, Callable[[Squares], Squares]] = {
    "assignment": assignment,
    "moreau_jean_1": moreau_jean(1),
    "moreau_jean_2": moreau_jean(2),
    "penalty": penalty,
}


def run(method: str, s: Squares, steps: Array, see: Callable[[int, Array, Squares], None]) -> None:
    """Takes each square through its number of steps; see(step, places, squares) after each."""
    left, step = np.arange(len(steps)), 0
    while True:
        going = steps[left] > step
        if not going.all():
            left, s = left[going], s.at(going)
        if not left.size:
            return
        s, step = METHODS[method](s), step + 1
        see(step, left, s)


# --- laws of impact, of a rectangle's corner that leans alpha from below its centre, 1 m away ---


@dataclass(frozen=True)
class Corner:
    """G's entries, and the corner's velocity before."""

    a: Array
    b: Array
    c: Array
    v_n: Array
    v_t: Array
    mu: float
    epsilon: Array

    def gain(self, p_n: Array, p_t: Array) -> Array:
        """Of energy, as a share of what an impulse at the corner can change."""
        w_n, w_t = (
            2 * self.v_n + self.a * p_n + self.b * p_t,
            2 * self.v_t + self.b * p_n + self.c * p_t,
        )
        v_n, v_t, D = self.v_n, self.v_t, self.a * self.c - self.b**2
        all_of_it = (self.c * v_n**2 - 2 * self.b * v_n * v_t + self.a * v_t**2) / D
        return (p_n * w_n + p_t * w_t) / all_of_it


def leaning(alpha: Array, v_t: Array, mu: float, epsilon: Array, v_n: float = -1) -> Corner:
    x, y = np.sin(alpha), -np.cos(alpha)
    return Corner(1 + 3 * x * x, -3 * x * y, 1 + 3 * y * y, v_n + 0 * x, v_t, mu, epsilon)


def newton(k: Corner) -> tuple[Array, Array]:
    return one_corner((k.a, k.b, k.c), (1 + k.epsilon) * k.v_n, k.v_t, k.mu)


def routh(k: Corner, energetic: bool) -> tuple[Array, Array]:
    """Poisson's law, or Stronge's: the corner slides until it stops at P = stop, and then sticks if
    it can. Compression ends where v_n = 0; the work is the integral of v_n over P."""
    after = np.where(abs(k.b) <= k.mu * k.c, -k.b / k.c, -np.sign(k.b) * k.mu)  # dp_t/dP
    first = np.where(k.v_t == 0, after, -np.sign(k.v_t) * k.mu)
    brakes = (k.b + k.c * first) * k.v_t < 0
    stop = np.where(brakes, -k.v_t / np.where(brakes, k.b + k.c * first, 1), 1e9)  # or never
    n_1, n_2 = k.a + k.b * first, k.a + k.b * after  # dv_n/dP until the stop, and then
    at_stop = k.v_n + n_1 * stop
    early = at_stop >= 0  # compression ends before
    compressed = np.where(early, -k.v_n / n_1, stop - at_stop / n_2)
    late_work = ((k.v_n + at_stop) * stop + at_stop * (compressed - stop)) / 2
    give = -(k.epsilon**2) * np.where(early, k.v_n * compressed / 2, late_work)
    rest = np.where(early, stop - compressed, 0)
    speed = n_1 * rest  # v_n at the stop
    more = np.sqrt(speed**2 + 2 * n_2 * np.maximum(give - speed * rest / 2, 0)) - speed
    stronge = np.where(give <= speed * rest / 2, np.sqrt(2 * give / n_1), rest + more / n_2)
    end = compressed + (stronge if energetic else k.epsilon * compressed)
    return end, first * np.minimum(end, stop) + after * np.maximum(end - stop, 0)


def sweeps(G: Array, u: Array, mu: Array, most: int, tolerance: float = 1e-9) -> Array:
    """The sweeps of projected Gauss-Seidel for n contacts of one corner: most where it never ends.
    G is its a, b, c, and u its u_n and u_t, 3 x n and 2 x n."""
    (a, b, c), count, left = G, np.full(u.shape[1], most), np.arange(u.shape[1])
    p_n = p_t = np.zeros(u.shape[1])
    for sweep in range(1, most + 1):
        n = np.maximum(0, p_n - (a * p_n + b * p_t + u[0]) / a)
        t = np.clip(p_t - (b * n + c * p_t + u[1]) / c, -mu * n, mu * n)
        going = np.maximum(abs(n - p_n) * a, abs(t - p_t) * c) > tolerance
        count[left[~going]] = sweep
        left, p_n, p_t, u, mu = left[going], n[going], t[going], u[:, going], mu[going]
        a, b, c = a[going], b[going], c[going]
        if not left.size:
            break
    return count


def uniform(seed: int) -> Callable[[float, float], float]:
    """Numbers of the 64-bit Mersenne Twister (Nishimura 2000), which the study's scenes come from."""
    mask, state = 2**64 - 1, [seed]
    for i in range(1, 312):
        state.append((6364136223846793005 * (state[-1] ^ (state[-1] >> 62)) + i) & mask)

    def next_number(low: float, high: float) -> float:
        x = (state[0] & ~(2**31 - 1)) | (state[1] & (2**31 - 1))
        state.append(state[156] ^ (x >> 1) ^ (0xB5026F5AA96619E9 if x & 1 else 0))
        del state[0]
        x = state[-1]
        x ^= (x >> 29) & 0x5555555555555555
        x ^= (x << 17) & 0x71D67FFFEDA60000
        x ^= (x << 37) & 0xFFF7EEE000000000
        x ^= x >> 43
        return low + (high - low) * (x >> 11) * 2.0**-53

    return next_number
