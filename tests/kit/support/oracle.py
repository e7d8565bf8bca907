"""A second opinion on the fixtures: the four parts once more, at 50 digits.

Written from the handout's equations alone: nothing is shared with the C++ solution, and no LCP is
pivoted. A vector is a tuple of mpf, and a Jacobian is the pair of its columns (J_t, J_n).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Iterator

import mpmath

mp = mpmath.mp.clone()
mp.dps = 50
mpf = mp.mpf

Number = Any  # an mpf, which has no type hints
Vector = tuple[Number, ...]

MARGIN = mpf("1e-6")  # m: right programs may decide otherwise nearer to a tie than this
ROUNDING = mpf("1e-14")  # m: so near, corners are equally low
CONFIRMED = mpf("1e-12")  # of max(1, |exact|): rounding in double precision is far below
SAME = mpf("1e-30")  # of max(1, |v|): two solutions this close are one, at 50 digits

# These checks look at no step beyond the listed columns. The others of part 4 compare every
# column with the one before, so every step has to be decidable.
LISTED_COLUMNS_ONLY = {
    "part4.HasTColumns",
    "part4.StartsAtTheInitialState",
    "part4.StaysFiniteOnALongRun",
}

# What starts the steps of a case that says that they are decidable, and their number; None: T - 1.
CHAINS = {"part3_step": (("q", "v"), 8), "part4_simulate": (("q_0", "v_0"), None)}


class Undecidable(ValueError):
    """Right programs may differ on this question, so no answer may be asked for."""


def require(condition: bool, complaint: str) -> None:
    if not condition:
        raise Undecidable(complaint)


def exact(number: Any) -> Number:
    """The double nearest to a number of a fixture, without any further rounding."""
    return mpf(float(number))


def vector(numbers: Any) -> Vector:
    x, y, z = numbers
    return exact(x), exact(y), exact(z)


@dataclass(frozen=True)
class Parameters:
    l: Number  # m
    m: Number  # kg
    mu: Number
    epsilon: Number
    g: Vector  # m/s^2
    dt: Number  # s
    delta: Number  # m
    T: int  # columns

    @staticmethod
    def read(params: dict[str, Any]) -> Parameters:
        scalars = ("l", "m", "mu", "epsilon", "dt", "delta")
        numbers = {name: exact(params[name]) for name in scalars}
        return Parameters(g=vector(params["g"]), T=params["T"], **numbers)

    def inverse_inertia(self) -> Vector:
        """The diagonal of M^-1, eq. (1)."""
        return 1 / self.m, 1 / self.m, 6 / (self.m * self.l * self.l)


@dataclass(frozen=True)
class Contact:
    J: tuple[Vector, Vector]
    phi: Number  # m, height of the lowest corner
    gap: Number  # m, from there up to the second lowest corner
    second_J: tuple[Vector, Vector]


def dot(a: Vector, b: Vector) -> Number:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def plus(a: Vector, scale: Number, b: Vector) -> Vector:
    """a + scale b."""
    return tuple(x + scale * y for x, y in zip(a, b))


def product(a: Vector, b: Vector) -> Vector:
    """A diagonal matrix times a vector."""
    return tuple(x * y for x, y in zip(a, b))


def get_contacts(q: Vector, params: Parameters) -> Contact:
    # r = R(theta) s_k with s_k = (+-l/2, +-l/2), eqs. (3) and (5), phi = y + r_y, eq. (4),
    # J_t = (1, 0, -r_y), J_n = (0, 1, r_x), eq. (6).
    cos, sin, half = mp.cos(q[2]), mp.sin(q[2]), params.l / 2
    corners = [(i * half, j * half) for i in (-1, 1) for j in (-1, 1)]
    arms = [(cos * s_x - sin * s_y, sin * s_x + cos * s_y) for s_x, s_y in corners]
    lowest, second = sorted(arms, key=lambda r: r[1])[:2]
    J, second_J = (((mpf(1), mpf(0), -r[1]), (mpf(0), mpf(1), r[0])) for r in (lowest, second))
    return Contact(J, q[1] + lowest[1], second[1] - lowest[1], second_J)


def form_lcp(
    J: tuple[Vector, Vector], v: Vector, params: Parameters
) -> tuple[list[list[Number]], list[Number]]:
    # J_hat = [J_n, -J_t, J_t], eq. (7). V is J_hat^T M^-1 J_hat dt, bordered by the column
    # (0, 1, 1, 0) and the row (mu, -1, -1, 0), eq. (9). In p, M^-1 f_e = g, eqs. (10) and (2).
    J_t, J_n = J
    J_hat = (J_n, tuple(-x for x in J_t), J_t)
    weights = params.inverse_inertia()
    V = [[dot(a, product(weights, b)) * params.dt for b in J_hat] for a in J_hat]
    V = [row + [mpf(edge)] for row, edge in zip(V, (0, 1, 1))]
    V.append([params.mu, mpf(-1), mpf(-1), mpf(0)])
    bounced = plus(product((1 + params.epsilon,) * 3, v), params.dt, params.g)
    pulled = plus(v, params.dt, params.g)
    p = [dot(J_n, bounced), dot(J_hat[1], pulled), dot(J_t, pulled), mpf(0)]
    return V, p


def contact_forces(
    J: tuple[Vector, Vector], v: Vector, params: Parameters
) -> Iterator[tuple[Number, Number]]:
    """Every (f_n, f_t) that solves the LCP, eq. (8), where f_t = f_t2 - f_t1."""
    # With a = J_n^T M^-1 J_n, b = J_n^T M^-1 J_t and c = J_t^T M^-1 J_t, the LCP's rows say
    #   w_n = u_n + dt (a f_n + b f_t) >= 0   and = 0 where f_n > 0,
    #   s   = u_t + dt (b f_n + c f_t)        is the sliding velocity after the step,
    #   |f_t| <= mu f_n                       and f_t = -mu f_n sign(s) where s is not 0.
    J_t, J_n = J
    weights, dt, mu = params.inverse_inertia(), params.dt, params.mu
    a, c = dot(J_n, product(weights, J_n)), dot(J_t, product(weights, J_t))
    b = dot(J_n, product(weights, J_t))
    require(a > mu * abs(b), f"a = {mp.nstr(a)} is not above mu |b| = {mp.nstr(mu * abs(b))}")
    u_n = (1 + params.epsilon) * dot(J_n, v) + dt * dot(J_n, params.g)
    u_t = dot(J_t, v) + dt * dot(J_t, params.g)
    # Case 1: the corner goes, and nothing holds it.
    if u_n >= 0:
        yield mpf(0), mpf(0)
    # Case 2: it sticks, w_n = s = 0, inside the cone of friction.
    scale = dt * (a * c - b * b)
    f_n, f_t = (b * u_t - c * u_n) / scale, (b * u_n - a * u_t) / scale
    if f_n >= 0 and abs(f_t) <= mu * f_n:
        yield f_n, f_t
    # Cases 3 and 4: it slides to the right or to the left, on the cone's edge.
    for side in (1, -1):
        f_n = -u_n / (dt * (a - side * mu * b))
        f_t = -side * mu * f_n
        if f_n >= 0 and side * (u_t + dt * (b * f_n + c * f_t)) >= 0:
            yield f_n, f_t


def contact_velocity(J: tuple[Vector, Vector], v: Vector, params: Parameters) -> Vector:
    # v' = v + dt M^-1 (f_e + J_n f_n + J_t f_t), eq. (13). Solutions may share their velocity.
    J_t, J_n = J
    free = plus(v, params.dt, params.g)
    weights = params.inverse_inertia()
    velocities = []
    for f_n, f_t in contact_forces(J, v, params):
        force = product((f_n,) * 3, J_n)
        velocities.append(plus(free, params.dt, product(weights, plus(force, f_t, J_t))))
    require(bool(velocities), "the LCP has no solution")
    for other in velocities[1:]:
        same = all(abs(x - y) <= SAME * max(1, abs(x)) for x, y in zip(velocities[0], other))
        require(same, "the LCP has solutions with different velocities")
    return velocities[0]


def step(q: Vector, v: Vector, params: Parameters) -> tuple[Vector, Vector]:
    # Contact is phi < delta, eq. (11). v' is then that of eq. (13), else v + dt M^-1 f_e, eq. (12);
    # q' = q + dt v', lifted by delta in contact, eq. (14).
    contact = get_contacts(q, params)
    clearance = contact.phi - params.delta
    require(abs(clearance) > MARGIN, f"phi - delta is {mp.nstr(clearance, 5)} m")
    if clearance > 0:
        v_next = plus(v, params.dt, params.g)
        return plus(q, params.dt, v_next), v_next
    require(contact.gap > MARGIN, f"the second corner is {mp.nstr(contact.gap, 5)} m higher")
    v_next = contact_velocity(contact.J, v, params)
    x, y, theta = plus(q, params.dt, v_next)
    return (x, y + params.delta, theta), v_next


def simulate(
    q_0: Vector, v_0: Vector, params: Parameters, last: int | None = None
) -> list[tuple[Vector, Vector]]:
    """The states (q, v) of columns 0 to last, which is T - 1 unless told, eq. (15)."""
    columns = [(q_0, v_0)]
    for t in range(params.T - 1 if last is None else last):
        try:
            columns.append(step(*columns[-1], params))
        except Undecidable as problem:
            raise Undecidable(f"step from column {t}: {problem}") from None
    return columns


def leaves(tree: Any, name: str = "") -> dict[str, Any]:
    """The numbers of nested lists, tuples and objects, by names such as J[2][0]."""
    if not isinstance(tree, (dict, list, tuple)):
        return {name: tree}
    items = tree.items() if isinstance(tree, dict) else enumerate(tree)
    names = ((f"{name}[{key}]" if name else str(key), branch) for key, branch in items)
    return {leaf: x for name, branch in names for leaf, x in leaves(branch, name).items()}


def answer(stem: str, check: str, case: dict[str, Any]) -> dict[str, Any]:
    """The exact answer to a case, shaped as its expected one."""
    params, asked = Parameters.read(case["params"]), case["input"]
    if stem == "part2_lcp":
        J_t, J_n = zip(*asked["J"], strict=True)
        V, p = form_lcp((vector(J_t), vector(J_n)), vector(asked["v"]), params)
        return {"V": V, "p": p}
    if stem == "part4_simulate":
        columns = case["expected"].get("columns", [])
        last = max(columns, default=0) if check in LISTED_COLUMNS_ONLY else None
        states = simulate(vector(asked["q_0"]), vector(asked["v_0"]), params, last)
        listed = {name: [states[t][i] for t in columns] for i, name in enumerate("qv")}
        return {"columns": columns, **listed}
    q = vector(asked["q"])
    if stem == "part3_step":
        return dict(zip("qv", step(q, vector(asked["v"]), params)))
    contact = get_contacts(q, params)
    if "other_J" in case["expected"]:
        require(contact.gap < ROUNDING, "the corners aren't equally low")
        two = [contact.J, contact.second_J]
        if two[0][1][2] * exact(case["expected"]["J"][2][1]) < 0:  # either may be the first
            two.reverse()
        J, other_J = (list(zip(*J)) for J in two)
        return {"phi": contact.phi, "J": J, "other_J": other_J}
    require(contact.gap > MARGIN, f"the second corner is {mp.nstr(contact.gap, 5)} m higher")
    return {"phi": contact.phi, "J": list(zip(*contact.J))}


def differences(expected: dict[str, Any], truth: dict[str, Any]) -> Iterator[str]:
    expected_leaves, true_leaves = leaves(expected), leaves(truth)
    assert set(expected_leaves) == set(true_leaves), "it has too much or too little"
    for quantity, true in true_leaves.items():
        difference = abs(exact(expected_leaves[quantity]) - true)
        if not difference <= CONFIRMED * max(1, abs(true)):
            yield (
                f"{quantity}: expected {expected_leaves[quantity]!r}, "
                f"exact {mp.nstr(mpf(true), 20)}, difference {mp.nstr(difference, 3)}"
            )


def without_claims(stem: str, case: dict[str, Any]) -> dict[str, Any]:
    """The expected numbers. Raises Undecidable if steps that are called decidable aren't."""
    expected = dict(case["expected"])
    if expected.get("steps") == "decidable":
        del expected["steps"]
        names, last = CHAINS[stem]
        q, v = (vector(case["input"][name]) for name in names)
        simulate(q, v, Parameters.read(case["params"]), last)
    return expected


def complaints(stem: str, check: str, cases: list[dict[str, Any]]) -> list[str]:
    """What is wrong with a check's cases, one line a number or a case; empty when confirmed."""
    found = []
    for case in cases:
        try:
            problems = list(differences(without_claims(stem, case), answer(stem, check, case)))
        except Undecidable as problem:
            problems = [f"undecidable: {problem}"]
        found += [f"{check}, case {case.get('name')!r}, {problem}" for problem in problems]
    return found
