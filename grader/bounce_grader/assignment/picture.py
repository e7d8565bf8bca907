"""Draws small pictures of a failed case: one step, or a trajectory. Position, labels and dashes
tell the right answer from the submission's; colour doesn't."""

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

from bounce_grader.common import svg
from bounce_grader.common.numbers import significant
from bounce_grader.common.svg import Drawing, Place

VELOCITY = "v after the step"
STEP_SIZE, SIDE = (250, 190), 92  # px: a picture of a step, and the square in it
LONGEST = 70  # px, of an arrow
PATH_SIZE, ROOM = (480, 300), 24
FAR = 5000.0  # px: points further out are moved to this distance
OMEGA = "\N{GREEK SMALL LETTER OMEGA}\N{PRIME}"
Shown = dict[str, Any]  # a failed case in numbers, as grading/words.py gives it


class Figure(NamedTuple):
    """A drawing with its caption."""

    drawing: Drawing
    lines: list[str]  # lines of the caption
    title: str = ""


def figures_of(shown: Shown) -> list[Figure]:
    """Draws a failed case. A trajectory gets one figure. A step gets one with the submission's
    answer, and another with the expected answer if that may be shown."""
    if "scene" not in shown:
        return []
    if "path" in shown:
        return [_trajectories(shown["scene"], shown["path"])]
    after = [q for q in shown["quantities"] if q["name"] == VELOCITY]
    return _steps(shown["scene"], after[0]) if after else []


def corners(q: Sequence[float], l: float) -> list[Place]:
    """eq. (3)"""
    cos, sin = math.cos(q[2]), math.sin(q[2])
    arms = [(l / 2, l / 2), (-l / 2, l / 2), (-l / 2, -l / 2), (l / 2, -l / 2)]
    return [(q[0] + cos * x - sin * y, q[1] + sin * x + cos * y) for x, y in arms]


# --- one step ---


def _steps(scene: Shown, velocity: Shown) -> list[Figure]:
    """The square before the step, with the velocity after the step, and the force of the ground
    that follows from that velocity."""
    sides = [("yours", _finite(velocity["got"]))]
    if "expected" in velocity:
        sides.append(("right", _finite(velocity["expected"])))
    known = [v for _, v in sides if v]
    longest = _Longest(
        max([1e-9, *(math.hypot(v[0], v[1]) for v in known)]),
        max([1e-9, *(abs(v[2]) for v in known)]),
        max([1e-9, *(math.hypot(*_force(scene, v)) for v in known)]),
    )
    return [_step(scene, title, v, longest) for title, v in sides]


class _Longest(NamedTuple):
    """The velocity, turning and force that are drawn at the full length of an arrow."""

    speed: float  # m/s
    turning: float  # rad/s
    force: float  # N


def _finite(rows: list[list[float | str]]) -> list[float] | None:
    """v as three numbers; None unless all three are finite."""
    numbers = [row[0] for row in rows]
    if len(numbers) != 3 or any(isinstance(x, str) or abs(x) > 1e100 for x in numbers):
        return None
    return [float(x) for x in numbers]


def _force(scene: Shown, v: list[float]) -> Place:
    """M (v' - v) / dt - f_e, in N; a component within rounding of 0 is 0."""
    m, dt, g = scene["m"], scene["dt"], scene["g"]
    change = [m * ((v[i] - scene["v"][i]) / dt - g[i]) for i in range(2)]
    least = 1e-9 * m * (abs(v[0]) + abs(v[1]) + math.hypot(*g[:2]) * dt) / dt
    f_x, f_y = (x if abs(x) > least else 0.0 for x in change)
    return f_x, f_y


def _step(scene: Shown, title: str, v: list[float] | None, longest: _Longest) -> Figure:
    width, height = STEP_SIZE
    scale = SIDE / scene["l"]
    q = scene["q"]

    def place(point: Sequence[float]) -> Place:
        return width / 2 + scale * (point[0] - q[0]), 95 - scale * (point[1] - q[1])

    square = corners(q, scene["l"])
    lowest = min(square, key=lambda corner: corner[1])
    ground = place((0, 0))[1]
    shapes = _ground(ground, width, f"{height - ground:.1f}") if ground < height else []
    shapes.append(_closed([place(corner) for corner in square]))
    touches = lowest[1] < scene["delta"]  # eq. (11)
    if touches:
        x, y = place(lowest)
        shapes.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="5" fill="{svg.INK}"/>')
    lines = ["not finite"]
    if v:
        shapes += _arrow(place(q), (v[0], v[1]), LONGEST / longest.speed, "v\N{PRIME}")
        shapes += _turning((width - 36, 34), v[2] / longest.turning)
        speed = f"v\N{PRIME} = ({_four_digits(v[0])}, {_four_digits(v[1])}) m/s"
        lines = [speed, f"{OMEGA} = {_four_digits(v[2])} rad/s"]
    if v and touches:
        force = _force(scene, v)
        shapes += _arrow(place(lowest), force, LONGEST / longest.force, "f", "5 3")
        pair = f"({_four_digits(force[0])}, {_four_digits(force[1])})"
        lines.append(f"force of the ground f = {pair} N")
    drawing = svg.svg(shapes, width, height, f"One step, {title}: {', '.join(lines)}")
    return Figure(drawing, lines, title)


def _four_digits(x: float) -> str:
    return significant(x, 4)


def _ground(y: float, width: int, height: str) -> list[str]:
    below = f'<rect x="0" y="{y:.1f}" width="{width}" height="{height}" class="ground"/>'
    return [below, svg.line(0, y, width, y, width=2)]


def _closed(corners: list[Place], dash: str = "") -> str:
    return svg.path([*corners, corners[0]], dash, 1.5)


def _arrow(start: Place, along: Place, scale: float, words: str, dash: str = "") -> list[str]:
    """An arrow with its label to its left, a little beyond its middle."""
    x, y = scale * along[0], -scale * along[1]
    length = math.hypot(x, y)
    if length < 2:
        return []
    tip = (start[0] + x, start[1] + y)
    beside = (start[0] + 0.6 * x + 13 * y / length, start[1] + 0.6 * y - 13 * x / length + 5)
    out = [svg.line(*start, *tip, dash, 2), _head(tip, x / length, y / length)]
    return [*out, svg.text(*beside, words, "middle")]


def _head(tip: Place, x: float, y: float) -> str:
    """The head of an arrow in the direction (x, y)."""
    base = (tip[0] - 9 * x, tip[1] - 9 * y)
    triangle = [tip, (base[0] - 4 * y, base[1] + 4 * x), (base[0] + 4 * y, base[1] - 4 * x)]
    return f'<path d="{svg.through(triangle)}Z" fill="{svg.INK}"/>'


def _turning(centre: Place, share: float) -> list[str]:
    """An arc that starts at the top, counter-clockwise if omega is positive. It spans at most three
    quarters of a turn, and is always long enough for its head."""
    if share == 0:
        return []
    share = math.copysign(max(abs(share), 0.15), share)
    radius, end = 20, -1.5 * math.pi * share - math.pi / 2
    tip = (centre[0] + radius * math.cos(end), centre[1] + radius * math.sin(end))
    large, sweep = int(abs(share) > 2 / 3), int(share < 0)
    arc = f"M{centre[0]:.1f} {centre[1] - radius:.1f}A{radius} {radius} 0 {large} {sweep} "
    drawn = f'<path d="{arc}{tip[0]:.1f} {tip[1]:.1f}" fill="none" stroke="{svg.INK}"/>'
    ahead = math.copysign(1, -share)
    head = _head(tip, -ahead * math.sin(end), ahead * math.cos(end))
    return [drawn, head, svg.text(centre[0], centre[1] + 5, OMEGA, "middle")]


# --- a trajectory ---


def _trajectories(scene: Shown, path: Shown) -> Figure:
    """The paths of the centre, and the squares at their ends."""
    got = {t: row for t, row in enumerate(path["got"]) if not any(isinstance(x, str) for x in row)}
    right = dict(zip(path.get("columns", []), path.get("expected", [])))
    view = _View([*right.values()] or [*got.values()] or [scene["q"]], scene["l"])
    shapes = _ground(view.ground, PATH_SIZE[0], str(PATH_SIZE[1]))
    shapes += _draw_path(view, right, "", hollow=True) + _draw_path(view, got, "5 4", hollow=False)
    last = max(right or got, default=0)
    for known, dash in ((right, ""), (got, "5 4")):
        if last in known:
            square = [view.at(corner) for corner in corners(known[last], scene["l"])]
            shapes.append(_closed(square, dash))
    first = path["first"]
    if first in (right or got):
        x, y = view.at((right or got)[first])
        shapes += [svg.line(x + 6, y, x + 26, y), svg.text(x + 30, y + 5, f"column {first}")]
    words = f"The path of the centre, and the square in column {last}"
    key = "rings, solid: right; dots, dashed: yours" if right else "dots, dashed: yours"
    label = f"{words}; column {first} is wrong; {key}"
    return Figure(svg.svg(shapes, *PATH_SIZE, label), [f"{words} ({key})."])


class _View:
    """Maps the world to the picture, at a scale at which these configurations fit."""

    def __init__(self, configurations: list[list[float]], l: float) -> None:
        near = [q for q in configurations if math.hypot(q[0], q[1]) < 1e6] or [[0.0, 0.0, 0.0]]
        xs, ys = [q[0] for q in near], [0.0, *(q[1] for q in near)]
        self.left, self.bottom = min(xs) - l, min(ys)
        width, height = max(xs) + l - self.left, max(ys) + l - self.bottom
        room_x, room_y = PATH_SIZE[0], PATH_SIZE[1] - 2 * ROOM
        self.scale = min(room_x / width, room_y / height)
        self.left -= (room_x / self.scale - width) / 2
        self.ground = self.at((0, 0))[1]

    def at(self, point: Sequence[float]) -> Place:
        x = self.scale * (point[0] - self.left)
        y = PATH_SIZE[1] - ROOM - self.scale * (point[1] - self.bottom)
        return min(max(x, -FAR), FAR), min(max(y, -FAR), FAR)


def _draw_path(view: _View, known: dict[int, list[float]], dash: str, hollow: bool) -> list[str]:
    """Draws a mark at each column, or at every few; and a line through them if no column is
    missing."""
    places = {t: view.at(q) for t, q in known.items()}
    columns = sorted(places)
    gapless = len(columns) > 1 and columns[-1] - columns[0] == len(columns) - 1
    out = [svg.path([places[t] for t in columns], dash)] if gapless else []
    every = max(1, len(columns) // 20)
    for x, y in (places[t] for t in columns[::every]):
        size, fill = (5, "none") if hollow else (2.5, svg.INK)
        place = f'cx="{x:.1f}" cy="{y:.1f}"'
        out.append(f'<circle {place} r="{size}" fill="{fill}" stroke="{svg.INK}"/>')
    return out
