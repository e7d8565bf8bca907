"""Charts speed against accuracy as SVG: the error over CPU time, a curve for each program.

The ink is that of the surrounding text, so a chart works on paper, in the dark and in grey. What tells
curves apart is their place, marks and dashes, never colour alone. The words and colours are those of
the handout's own charts.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from bounce_grader.common.escaping import html
from bounce_grader.common.numbers import metres, seconds, short
from bounce_grader.common.paths import HANDOUT
from bounce_grader.grading import speed
from bounce_grader.grading.speed import Measured, Point

WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 720, 454, 90, 20, 40, 54  # px, and around the axes
# The curve's class by what it shows; delta is in proportion to dt, as in the handout's second line.
CLASSES = {"submission": "own k1", "solution": "k2", "least": "k4"}
NAMES = {
    "submission": "yours",
    "solution": "assignment's scheme, as the course solves it",
    "least": "no more model than each step needs",
}
Curves = Mapping[str, Sequence[Point]]  # by whose they are, as in speed.CURVES
Place = tuple[float, float]  # px, to the right and down


class Drawing(str):
    """Finished SVG, CSS or HTML, which a template inserts without escaping."""

    def __html__(self) -> str:
        return self


STYLE = Drawing((HANDOUT / "given" / "page" / "chart.css").read_text("utf-8"))


class Curve(NamedTuple):
    """A curve with a point for each time step: CPU time as a multiple of the solution's at 1 ms,
    and error in m."""

    places: Sequence[tuple[float, float | None]]
    kind: str  # whose; of one among a class, whether it got "full", "some" or no ("none") points
    title: str
    labels: Sequence[str] = ()  # of the places


def of_one(measured: Measured) -> Drawing:
    """A submission's curve, with its time steps, beside the solution's and the least model's."""
    curves = {whose: speed.curve(measured, whose) for whose in speed.CURVES}
    steps = [seconds(1e9 * point.dt) for point in curves["submission"]]
    return error_over_time(
        [
            Curve(over_solution(curves, whose), whose, name, steps * (whose == "submission"))
            for whose, name in NAMES.items()
            if curves[whose]
        ],
        "Speed against accuracy",
    )


def over_solution(curves: Curves, whose: str) -> list[tuple[float, float | None]]:
    """The places of a curve. The unit of time is the solution's, measured in the same run."""
    unit = [point.ns for point in curves.get("solution", ()) if point.dt >= speed.STEP]
    return [(p.ns / unit[-1], p.error) for p in curves.get(whose, ()) if unit]


def error_over_time(curves: Sequence[Curve], label: str) -> Drawing:
    """The curves on logarithmic axes, with a line at the error that is near enough."""
    places = [place for curve in curves for place in curve.places]
    axes = _Axes(
        _decades((x for x, _ in places), 1e-4, 1e5),
        _decades([speed.FINE, *(y for _, y in places if y is not None)], 1e-9, 1e2),
    )
    right, bottom, middle = WIDTH - RIGHT, HEIGHT - BOTTOM, (TOP + HEIGHT - BOTTOM) / 2
    limit = axes.at(1, speed.FINE)[1]
    shapes = [
        _markers(len(curves)),
        _line((LEFT, TOP), (right, TOP), (right, bottom), (LEFT, bottom), (LEFT, TOP)),
        *axes.ticks(),
        f'<g stroke-dasharray="2 3">{_line((LEFT, limit), (right, limit))}</g>',
        *(_curve(curve, axes) for curve in curves),
        _text((LEFT + right) / 2, bottom + 44, "time, over the solution's at dt = 1 ms", "middle"),
        f'<g transform="rotate(-90 16 {middle:.1f})">{_text(16, middle, "error", "middle")}</g>',
    ]
    size = f'viewBox="0 0 {WIDTH} {HEIGHT}" role="img" aria-label="{html(label)}"'
    return Drawing(f"<svg {size}>{''.join(shapes)}</svg>")


def _decades(values: Iterable[float], low: float, high: float) -> tuple[int, int]:
    """The exponents of the powers of ten around the values, which are clamped to low and high."""
    logs = [math.log10(min(max(value, low), high)) for value in values] or [0.0]
    first, last = math.floor(min(logs)), math.ceil(max(logs))
    return first, max(last, first + 1)


class _Axes(NamedTuple):
    """Logarithmic axes: the exponents at their ends."""

    x: tuple[int, int]
    y: tuple[int, int]

    def at(self, x: float, y: float | None) -> Place:
        """The position of a point in px. A point outside goes to the edge, and to the top if y is
        None."""
        across, up = _share(x, self.x), _share(math.inf if y is None else y, self.y)
        bottom = HEIGHT - BOTTOM
        return LEFT + (WIDTH - LEFT - RIGHT) * across, bottom - (bottom - TOP) * up

    def ticks(self) -> list[str]:
        """Ticks at all powers of ten."""
        out = []
        for decade in range(self.x[0], self.x[1] + 1):
            x, bottom = self.at(10.0**decade, 0)
            out += [_line((x, bottom), (x, bottom + 5))]
            out += [_text(x, bottom + 20, short(10.0**decade), "middle")]
        for decade in range(self.y[0], self.y[1] + 1):
            left, y = self.at(0, 10.0**decade)
            out += [_line((left - 5, y), (left, y))]
            out += [_text(left - 9, y + 5, metres(10.0**decade), "end")]
        return out


def _share(value: float, decades: tuple[int, int]) -> float:
    """0 at the lower end of an axis, 1 at the upper one."""
    low, high = decades
    log = math.log10(value) if value > 0 else low
    return (min(max(log, low), high) - low) / (high - low)


def _markers(number: int) -> str:
    """The styles of curves and of their marks, by kind. The more curves, the fainter each is."""
    faint = min(0.5, max(0.07, 20 / number))
    ink, hollow = 'stroke="currentColor"', 'style="fill:var(--paper,#fff)"'
    ring, cross = '<circle r="3" cx="5" cy="5"', '<path d="M2 2l6 6m0-6l-6 6"'
    shapes = {
        "submission": '<circle r="4" cx="5" cy="5" fill="currentColor"/>',
        "full": f'{ring} fill="currentColor" fill-opacity="{faint:.2f}"/>',
        "some": f'{ring} fill="none" {ink} opacity="{2 * faint:.2f}"/>',
        "none": f'{cross} {ink} opacity="{2 * faint:.2f}"/>',
        "solution": f'<rect x="1" y="1" width="8" height="8" {hollow} {ink}/>',
        "least": f'<path d="M5 0l5 9H0z" {hollow} {ink}/>',
    }
    drawn = "".join(
        f'<marker id="{kind}" refX="5" refY="5" markerWidth="10" markerHeight="10" '
        f'markerUnits="userSpaceOnUse">{shape}</marker>'
        for kind, shape in shapes.items()
    )
    rules = "".join(f".{kind}{{marker:url(#{kind})}}" for kind in shapes)
    lines = f".curve.of-one{{stroke-width:.8;stroke-opacity:{faint:.2f};stroke-dasharray:none}}"
    label = ".label{paint-order:stroke;stroke:var(--paper,#fff);stroke-width:4}"
    return f"<defs>{drawn}</defs><style>{rules}{lines}{label}</style>"


def _curve(curve: Curve, axes: _Axes) -> str:
    """A curve with its tooltip, and labels above and below its places in turn."""
    places = [axes.at(*place) for place in curve.places]
    style = CLASSES.get(curve.kind) or CLASSES["submission"] + " of-one"
    tooltip = f"<title>{html(curve.title)}</title>"
    drawn = f'<path class="curve {curve.kind} {style}" d="{_through(places, 0)}">{tooltip}</path>'
    labels = ""
    for number, ((x, y), label) in enumerate(zip(places, curve.labels)):
        to_the_left = x > WIDTH - RIGHT - 60
        below = bool(number % 2) != (y < TOP + 20)
        anchor = "end" if to_the_left else "start"
        beside = x - 8 if to_the_left else x + 8, y + 20 if below else y - 8
        labels += _text(*beside, label, anchor)
    return drawn + (f'<g class="label">{labels}</g>' if labels else "")


def _text(x: float, y: float, words: str, anchor: str) -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{html(words)}</text>'


def _line(*places: Place) -> str:
    return f'<path d="{_through(places)}" fill="none" stroke="currentColor"/>'


def _through(places: Iterable[Place], decimals: int = 1) -> str:
    """The straight lines from place to place, as a path's "d"."""
    return "M" + "L".join(f"{x:.{decimals}f} {y:.{decimals}f}" for x, y in places)
