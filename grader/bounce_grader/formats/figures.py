"""Figures of pages, as SVG: shapes, logarithmic axes, a failed case, and speed against accuracy.

They use the colour of the surrounding text, so they work on paper, in the dark and in grey. What
tells curves and answers apart is their place, labels, marks and dashes, never colour alone.
"""

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any, NamedTuple

from bounce_grader.common.escaping import html
from bounce_grader.common.numbers import metres, seconds, significant
from bounce_grader.common.paths import HANDOUT
from bounce_grader.grading import speed
from bounce_grader.grading.speed import Measured, Point

INK = "currentColor"
BOLD = ' style="font-weight:bold"'  # an attribute for text()
Place = tuple[float, float]  # px, to the right and down


class Drawing(str):
    """Finished SVG, which a template inserts without escaping."""

    def __html__(self) -> str:
        return self


# The words and colours of charts of error over time are those of the handout's own charts.
_CHARTS = HANDOUT / "given" / "study"
WORDS = dict(line.split(": ") for line in (_CHARTS / "words.txt").read_text("utf-8").splitlines())
STYLE = Drawing((_CHARTS / "chart.css").read_text("utf-8"))
ON_PAPER = Drawing(STYLE.partition("@media")[0])  # also for pages that invert themselves
# The curve's class by what it shows; delta is in proportion to dt, as in the handout's second line.
CLASSES = {"submission": "own k1", "solution": "k2", "least": "k4"}
NAMES = {
    "submission": WORDS["Yours"],
    "solution": WORDS["Assignment"],
    "least": "no more model than each step needs",
}

# --- shapes ---


def svg(shapes: Iterable[str], width: float, height: float, label: str) -> Drawing:
    size = f"0 0 {width:.0f} {height:.0f}"
    start = f'<svg viewBox="{size}" role="img" aria-label="{html(label)}">'
    return Drawing(f"{start}{''.join(shapes)}</svg>")


def rect(x: float, y: float, w: float, h: float, fill: str, stroke: str = "none") -> str:
    size = f'width="{max(w, 0):.1f}" height="{max(h, 0):.1f}"'
    return f'<rect x="{x:.1f}" y="{y:.1f}" {size} fill="{fill}" stroke="{stroke}"/>'


def text(x: float, y: float, words: str, anchor: str = "start", attributes: str = "") -> str:
    start = f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{attributes}>'
    return f"{start}{html(words)}</text>"


def line(x1: float, y1: float, x2: float, y2: float, dash: str = "", width: float = 1) -> str:
    return path([(x1, y1), (x2, y2)], dash, width)


def path(places: Iterable[Place], dash: str = "", width: float = 1) -> str:
    dashed = f' stroke-dasharray="{dash}"' if dash else ""
    thick = f' stroke-width="{width:g}"' if width != 1 else ""
    return f'<path d="{through(places)}" fill="none" stroke="{INK}"{dashed}{thick}/>'


def through(places: Iterable[Place], decimals: int = 1) -> str:
    """The straight lines from place to place, as a path's "d"."""
    return "M" + "L".join(f"{x:.{decimals}f} {y:.{decimals}f}" for x, y in places)


def cross(x: float, y: float, arm: int) -> str:
    """Two diagonals, as a path's "d"."""
    return f"M{x - arm:.1f} {y - arm:.1f}l{2 * arm} {2 * arm}m0-{2 * arm}l-{2 * arm} {2 * arm}"


def circle(place: Place, r: float, rest: str) -> str:
    return f'<circle cx="{place[0]:.1f}" cy="{place[1]:.1f}" r="{r:g}" {rest}>'


def title(words: str) -> str:
    """The tooltip that a browser shows for a shape."""
    return f"<title>{html(words)}</title>"


# --- logarithmic axes ---


def decades(values: Iterable[float], low: float, high: float) -> tuple[int, int]:
    """The exponents of the powers of ten around the values; values are clamped to low and high
    first."""
    logs = [math.log10(min(max(value, low), high)) for value in values] or [0.0]
    first, last = math.floor(min(logs)), math.ceil(max(logs))
    return first, max(last, first + 1)


class Axes(NamedTuple):
    """Logarithmic axes for error over time: the exponents at the ends of the axes, and the frame in
    px."""

    x: tuple[int, int]
    y: tuple[int, int]
    left: float
    top: float
    width: float
    height: float

    @property
    def bottom(self) -> float:
        return self.top + self.height

    def at(self, x: float, y: float | None) -> Place:
        """The position of a point in px. A point outside goes to the edge, and to the top if y is
        None."""
        across, up = _share(x, self.x), _share(math.inf if y is None else y, self.y)
        return self.left + self.width * across, self.bottom - self.height * up

    def ticks(
        self,
        x_label: Callable[[float], str],
        y_label: Callable[[float], str],
        gap: int = 9,
    ) -> list[str]:
        """Ticks at all powers of ten."""
        out = []
        for decade in range(self.x[0], self.x[1] + 1):
            x, bottom = self.at(10.0**decade, 0)
            out += [line(x, bottom, x, bottom + 5)]
            out += [text(x, bottom + 20, x_label(10.0**decade), "middle")]
        for decade in range(self.y[0], self.y[1] + 1):
            left, y = self.at(0, 10.0**decade)
            out += [line(left - 5, y, left, y)]
            out += [text(left - gap, y + 5, y_label(10.0**decade), "end")]
        return out

    def names(self, time: str, error: str, gap: int = 44) -> list[str]:
        x_name = text(self.left + self.width / 2, self.bottom + gap, time, "middle")
        middle = self.top + self.height / 2
        upward = f' transform="rotate(-90 {16:.1f} {middle:.1f})"'
        return [x_name, text(16, middle, error, "middle", upward)]


def _share(value: float, decades: tuple[int, int]) -> float:
    """0 at the lower end of an axis, 1 at the upper one."""
    low, high = decades
    log = math.log10(value) if value > 0 else low
    return (min(max(log, low), high) - low) / (high - low)


# --- speed against accuracy ---

CHART, LEFT, RIGHT, TOP, BOTTOM = (480, 430), 80, 28, 96, 52  # px, and around the axes
LABEL = 45  # px: the width of a step's label
LARGEST, LEAST = 1e2, 1e-9  # m: errors beyond are drawn at the edge
Curves = dict[str, list[Point]]


def of_all(measured: Measured) -> Drawing:
    """The chart for all scenes together, with time steps written at the submission's points."""
    curves = {whose: speed.curve(measured, whose) for whose in speed.CURVES}
    words = f"{WORDS['ErrorOverTime']}: the worst of {len(measured['scenes'])} scenes"
    return _chart(curves, words, labelled=True)


def of_scene(scene: Measured) -> Drawing:
    curves = {
        whose: [Point(p["dt"], p["ns"], p["error"]) for p in scene[whose]] for whose in speed.CURVES
    }
    return _chart(curves, scene["title"], labelled=False)


def _chart(curves: Curves, label: str, labelled: bool) -> Drawing:
    """Error over the CPU time for a second of motion."""
    points = [point for curve in curves.values() for point in curve]
    width, height = CHART
    axes = Axes(
        decades((p.ns for p in points), 1, 1e12),
        decades((LARGEST if p.error is None else p.error for p in points), LEAST, LARGEST),
        *(LEFT, TOP, width - LEFT - RIGHT, height - TOP - BOTTOM),
    )
    shapes = [text(width / 2, 16, label, "middle", BOLD)]
    shapes += [rect(axes.left, axes.top, axes.width, axes.height, "none", INK)]
    shapes += axes.ticks(seconds, metres, gap=8)
    if axes.y[0] < -3 < axes.y[1]:
        _, y = axes.at(1, speed.FINE)
        shapes.append(line(LEFT, y, width - RIGHT, y, "2 3"))
    shapes += axes.names(WORDS["Time"], WORDS["Error"], gap=BOTTOM - 10)
    for row, whose in enumerate(filter(curves.__getitem__, speed.CURVES)):
        y = 38 + 20 * row
        shapes += [_curve(whose, [(LEFT, y), (LEFT + 32, y)]), _mark(whose, (LEFT + 16, y))]
        shapes += [text(LEFT + 38, y + 5, NAMES[whose])]
    for whose in filter(curves.__getitem__, reversed(speed.CURVES)):
        places = [axes.at(point.ns, point.error) for point in curves[whose]]
        shapes.append(_curve(whose, places))
        for point, place in zip(curves[whose], places):
            error = "not finite" if point.error is None else metres(point.error)
            words = f"{NAMES[whose]}, {speed.step(point)}: {error} in {seconds(point.ns)}"
            shapes.append(_mark(whose, place, title(words)))
    if labelled:
        shapes += _steps_of(curves["submission"], axes)
    return svg(shapes, width, height, label)


def _curve(whose: str, places: Sequence[Place]) -> str:
    return f'<path class="curve {CLASSES[whose]}" d="{through(places)}"/>'


def _steps_of(points: Sequence[Point], axes: Axes) -> list[str]:
    """The labels of the time steps: the first one below its point, out of the way of the second;
    none where it would cover the one before."""
    out, last = [], 0.0
    for i, point in enumerate(points):
        x, y = axes.at(point.ns, point.error)
        if i == 0:
            out.append(text(x, y + 24, speed.step(point), "middle"))
        elif x - last < LABEL:
            continue
        elif x > CHART[0] - RIGHT - 50:
            out.append(text(x - 9, y + 16, seconds(1e9 * point.dt), "end"))
        else:
            out.append(text(x + 6, y - 8, seconds(1e9 * point.dt)))
        last = x if i else last
    return out


def _mark(whose: str, place: Place, words: str = "") -> str:
    """The mark of a curve: a disc, a square or a cross."""
    x, y = place
    kind = f'class="{CLASSES[whose]}"'
    if whose == "submission":
        return circle(place, 2.5, f'stroke-width="5" fill="none" {kind}') + f"{words}</circle>"
    if whose == "solution":
        return (
            f'<rect x="{x - 4.5:.1f}" y="{y - 4.5:.1f}" width="9" height="9" '
            f'stroke-width="1.5" class="hollow {CLASSES[whose]}">{words}</rect>'
        )
    return f'<path d="{cross(x, y, 5)}" stroke-width="1.5" {kind}>{words}</path>'


# --- a failed case: one step, or a trajectory ---

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
    largest = (  # m/s, rad/s and N that are drawn at an arrow's full length
        max([1e-9, *(math.hypot(v[0], v[1]) for v in known)]),
        max([1e-9, *(abs(v[2]) for v in known)]),
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


def _step(
    scene: Shown, whose: str, v: list[float] | None, largest: tuple[float, float, float]
) -> Figure:
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
        shapes.append(circle(place(lowest), 5, f'fill="{INK}"/'))
    lines = ["not finite"]
    if v:
        shapes += _arrow(place(q), (v[0], v[1]), LONGEST / largest[0], "v\N{PRIME}")
        shapes += _turning((width - 36, 34), v[2] / largest[1])
        x, y, omega = (significant(x, 4) for x in v)
        lines = [f"v\N{PRIME} = ({x}, {y}) m/s", f"{OMEGA} = {omega} rad/s"]
    if v and touches:
        force = _force(scene, v)
        shapes += _arrow(place(lowest), force, LONGEST / largest[2], "f", "5 3")
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
    out = [line(*start, *tip, dash, 2), _head(tip, x / length, y / length)]
    return [*out, text(*beside, words, "middle")]


def _head(tip: Place, x: float, y: float) -> str:
    """The head of an arrow in the direction (x, y)."""
    base = (tip[0] - 9 * x, tip[1] - 9 * y)
    triangle = [tip, (base[0] - 4 * y, base[1] + 4 * x), (base[0] + 4 * y, base[1] - 4 * x)]
    return f'<path d="{through(triangle)}Z" fill="{INK}"/>'


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
    drawn = f'<path d="{arc}{tip[0]:.1f} {tip[1]:.1f}" fill="none" stroke="{INK}"/>'
    ahead = math.copysign(1, -share)
    head = _head(tip, -ahead * math.sin(end), ahead * math.cos(end))
    return [drawn, head, text(centre[0], centre[1] + 5, OMEGA, "middle")]


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
    return out + [circle(places[t], size, f'fill="{fill}" stroke="{INK}"/') for t in marks]
