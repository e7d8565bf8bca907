"""Draws a failed case: one step, or a trajectory."""

import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from bounce_grader.common.numbers import significant
from bounce_grader.formats.figures import circle, Drawing, INK, line, path, Place
from bounce_grader.formats.figures import svg, text, through

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


def of_case(shown: Shown) -> list[Figure]:
    """Draws a failed case. A trajectory gets one figure. A step gets one with the submission's
    answer, and another with the expected answer if that may be shown: the square before the step,
    with the velocity after it, and the force of the ground that follows from that velocity."""
    if "scene" in shown and "path" in shown:
        return [_trajectories(shown["scene"], shown["path"])]
    after = [q for q in shown["quantities"] if q["name"] == VELOCITY]
    if "scene" not in shown or not after:
        return []
    titles = {"yours": "got", "right": "expected"}
    sides = {title: _finite(after[0][key]) for title, key in titles.items() if key in after[0]}
    known = [v for v in sides.values() if v]
    largest = (  # m/s and N that are drawn at an arrow's full length
        max([1e-9, *(math.hypot(v[0], v[1]) for v in known)]),
        max([1e-9, *(math.hypot(*_force(shown["scene"], v)) for v in known)]),
    )
    return [_step(shown["scene"], title, v, largest) for title, v in sides.items()]


def corners(q: Sequence[float], l: float) -> list[Place]:
    """eq. (3)"""
    cos, sin = math.cos(q[2]), math.sin(q[2])
    arms = [(l / 2, l / 2), (-l / 2, l / 2), (-l / 2, -l / 2), (l / 2, -l / 2)]
    return [(q[0] + cos * x - sin * y, q[1] + sin * x + cos * y) for x, y in arms]


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


def _step(scene: Shown, whose: str, v: list[float] | None, largest: tuple[float, float]) -> Figure:
    width, height = STEP_SIZE
    scale, q = SIDE / scene["l"], scene["q"]

    def place(point: Sequence[float]) -> Place:
        return width / 2 + scale * (point[0] - q[0]), 95 - scale * (point[1] - q[1])

    square = corners(q, scene["l"])
    lowest = min(square, key=lambda corner: corner[1])
    ground = place((0, 0))[1]
    shapes = _ground(ground, width, f"{height - ground:.1f}") if ground < height else []
    shapes.append(_closed([place(corner) for corner in square]))
    touches = lowest[1] < scene["delta"]  # eq. (11)
    if touches:
        shapes.append(circle(place(lowest), 5, f'fill="{INK}"'))
    lines = ["not finite"]
    if v:
        shapes += _arrow(place(q), (v[0], v[1]), LONGEST / largest[0], "v\N{PRIME}")
        if v[2]:
            shapes.append(text(width - 46, 34, f"{'↺' if v[2] > 0 else '↻'} {OMEGA}"))
        x, y, omega = (significant(x, 4) for x in v)
        lines = [f"v\N{PRIME} = ({x}, {y}) m/s", f"{OMEGA} = {omega} rad/s"]
    if v and touches:
        force = _force(scene, v)
        shapes += _arrow(place(lowest), force, LONGEST / largest[1], "f", "5 3")
        x, y = (significant(x, 4) for x in force)
        lines.append(f"force of the ground f = ({x}, {y}) N")
    drawing = svg(shapes, width, height, f"One step, {whose}: {', '.join(lines)}")
    return Figure(drawing, lines, whose)


def _ground(y: float, width: int, height: str) -> list[str]:
    below = f'<rect x="0" y="{y:.1f}" width="{width}" height="{height}" class="ground"/>'
    return [below, line(0, y, width, y, width=2)]


def _closed(corners: list[Place], dash: str = "") -> str:
    return path([*corners, corners[0]], dash, 1.5)


def _arrow(start: Place, along: Place, scale: float, words: str, dash: str = "") -> list[str]:
    """An arrow with its label to its left, a little beyond its middle."""
    x, y = scale * along[0], -scale * along[1]
    length = math.hypot(x, y)
    if length < 2:
        return []
    tip = (start[0] + x, start[1] + y)
    beside = (start[0] + 0.6 * x + 13 * y / length, start[1] + 0.6 * y - 13 * x / length + 5)
    x, y = x / length, y / length
    base = (tip[0] - 9 * x, tip[1] - 9 * y)
    head = [tip, (base[0] - 4 * y, base[1] + 4 * x), (base[0] + 4 * y, base[1] - 4 * x)]
    filled = f'<path d="{through(head)}Z" fill="{INK}"/>'
    return [line(*start, *tip, dash, 2), filled, text(*beside, words, "middle")]


def _trajectories(scene: Shown, path: Shown) -> Figure:
    """The paths of the centre, and the squares at their ends."""
    got = {t: row for t, row in enumerate(path["got"]) if not any(isinstance(x, str) for x in row)}
    right = dict(zip(path.get("columns", []), path.get("expected", [])))
    at = _view([*right.values()] or [*got.values()] or [scene["q"]], scene["l"])
    shapes = _ground(at((0, 0))[1], PATH_SIZE[0], str(PATH_SIZE[1]))
    shapes += _path_of({t: at(q) for t, q in right.items()}, "", 5, "none")
    shapes += _path_of({t: at(q) for t, q in got.items()}, "5 4", 2.5, INK)
    last, first = max(right or got, default=0), path["first"]
    for known, dash in ((right, ""), (got, "5 4")):
        if last in known:
            shapes.append(
                _closed([at(corner) for corner in corners(known[last], scene["l"])], dash)
            )
    if first in (right or got):
        x, y = at((right or got)[first])
        shapes += [line(x + 6, y, x + 26, y), text(x + 30, y + 5, f"column {first}")]
    words = f"The path of the centre, and the square in column {last}"
    key = "rings, solid: right; dots, dashed: yours" if right else "dots, dashed: yours"
    drawing = svg(shapes, *PATH_SIZE, f"{words}; column {first} is wrong; {key}")
    return Figure(drawing, [f"{words} ({key})."])


def _view(configurations: list[list[float]], l: float) -> Callable[[Sequence[float]], Place]:
    """Maps the world to the picture, at a scale at which these configurations fit."""
    near = [q for q in configurations if math.hypot(q[0], q[1]) < 1e6] or [[0.0, 0.0, 0.0]]
    xs, ys = [q[0] for q in near], [0.0, *(q[1] for q in near)]
    width, height = max(xs) + 2 * l - min(xs), max(ys) + l - min(ys)
    room = (PATH_SIZE[0], PATH_SIZE[1] - 2 * ROOM)
    scale = min(room[0] / width, room[1] / height)
    left = min(xs) - l - (room[0] / scale - width) / 2

    def at(point: Sequence[float]) -> Place:
        x = scale * (point[0] - left)
        y = PATH_SIZE[1] - ROOM - scale * (point[1] - min(ys))
        return min(max(x, -FAR), FAR), min(max(y, -FAR), FAR)

    return at


def _path_of(places: dict[int, Place], dash: str, size: float, fill: str) -> list[str]:
    """Draws a mark at each column, or at every few; and a line through them if no column is
    missing."""
    columns = sorted(places)
    gapless = len(columns) > 1 and columns[-1] - columns[0] == len(columns) - 1
    out = [path([places[t] for t in columns], dash)] if gapless else []
    marks = columns[:: max(1, len(columns) // 20)]
    return out + [circle(places[t], size, f'fill="{fill}" stroke="{INK}"') for t in marks]
