"""The assignment as its first students wrote it: numpy, part by part, with Lemke's method.

Prints numpy's version. Then each line that comes is a simulation, as numbers,

    l m mu epsilon delta g_x g_y g_z  x y theta v_x v_y omega  dt STEPS SAMPLES TURNS

and is answered by a line: the CPU time of TURNS runs in ns, and the square at SAMPLES times, STEPS
steps apart: x y theta, each.
"""

import sys
import time

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class World:
    def __init__(self, numbers: list[float]) -> None:
        self.l, m, self.mu, self.epsilon, self.delta, *g = numbers[:8]
        M = np.diag([m, m, m * self.l**2 / 6])  # eq. (1)
        self.M_inv = np.linalg.inv(M)
        self.f_e = M @ np.array(g)  # eq. (2)
        self.dt = numbers[14]


def get_contacts(q: Array, world: World) -> tuple[Array, float]:
    """J and phi of the lowest corner, eqs. (3) to (6)."""
    c, s = np.cos(q[2]), np.sin(q[2])
    R = np.array([[c, -s], [s, c]])
    corners = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]]) * world.l / 2
    arms = (R @ corners.T).T
    r = arms[np.argmin(arms[:, 1])]
    J_t = np.array([1, 0, -r[1]])
    J_n = np.array([0, 1, r[0]])
    return np.column_stack([J_t, J_n]), float(q[1] + r[1])


def form_lcp(J: Array, v: Array, world: World) -> tuple[Array, Array]:
    """V and p, eqs. (7) to (10)."""
    J_t, J_n = J[:, 0], J[:, 1]
    J_hat = np.column_stack([J_n, -J_t, J_t])
    M_inv = world.M_inv
    V = np.zeros((4, 4))
    V[:3, :3] = J_hat.T @ M_inv @ J_hat * world.dt
    V[1:3, 3] = 1
    V[3, :3] = [world.mu, -1, -1]
    v_free = v + world.dt * M_inv @ world.f_e
    v_bounce = (1 + world.epsilon) * v + world.dt * M_inv @ world.f_e
    return V, np.array([J_n @ v_bounce, -J_t @ v_free, J_t @ v_free, 0])


def lemke(V: Array, p: Array) -> Array:
    """z with 0 <= V z + p, z >= 0, and one of each pair 0."""
    n = len(p)
    if np.all(p >= 0):
        return np.zeros(n)
    # columns: w, z, z_0, right side
    T = np.hstack([np.eye(n), -V, -np.ones((n, 1)), p.reshape(-1, 1)])
    basis = list(range(n))
    row = int(np.argmin(p))
    entering = 2 * n
    for _ in range(100):
        T[row] /= T[row, entering]
        for i in range(n):
            if i != row:
                T[i] -= T[i, entering] * T[row]
        leaving = basis[row]
        basis[row] = entering
        if leaving == 2 * n:
            break
        entering = leaving + n if leaving < n else leaving - n
        column = T[:, entering]
        if np.all(column <= 1e-12):
            break  # a ray
        with np.errstate(divide="ignore", invalid="ignore"):
            ratios = np.where(column > 1e-12, T[:, -1] / column, np.inf)
        least = np.flatnonzero(ratios <= ratios.min() + 1e-12)
        out = [i for i in least if basis[i] == 2 * n]
        row = int(out[0] if out else least[0])
    z = np.zeros(2 * n + 1)
    z[basis] = T[:, -1]
    return z[n : 2 * n]


def step(q: Array, v: Array, world: World) -> tuple[Array, Array]:
    """Eqs. (11) to (14)."""
    J, phi = get_contacts(q, world)
    f = world.f_e
    lift = np.zeros(3)
    if phi < world.delta:
        V, p = form_lcp(J, v, world)
        f_n, f_t1, f_t2, _ = lemke(V, p)
        f = f + J[:, 1] * f_n + J[:, 0] * (f_t2 - f_t1)
        lift[1] = world.delta
    v = v + world.dt * world.M_inv @ f
    return q + world.dt * v + lift, v


def simulate(numbers: list[float]) -> list[Array]:
    world = World(numbers)
    q, v = np.array(numbers[8:11]), np.array(numbers[11:14])
    steps, samples = int(numbers[15]), []
    for _ in range(int(numbers[16])):
        for _ in range(steps):
            q, v = step(q, v, world)
        samples.append(q)
    return samples


def answer(line: str) -> str:
    numbers = [float(word) for word in line.split()]
    start = time.process_time_ns()
    for _ in range(int(numbers[17])):
        samples = simulate(numbers)
    ns = time.process_time_ns() - start
    return " ".join([str(ns), *(repr(float(x)) for q in samples for x in q)])


def main() -> None:
    print(np.__version__, flush=True)
    for line in sys.stdin:
        print(answer(line), flush=True)


if __name__ == "__main__":
    main()
