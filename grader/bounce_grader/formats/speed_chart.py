"""Charts speed against accuracy as SVG: the error over CPU time, a curve for each program.

The ink is that of the surrounding text, so a chart works on paper, in the dark and in grey. What tells
curves apart is their place, marks and dashes, never colour alone. The words and colours are those of
the handout's own charts; the marks are drawn in chart_marks.svg, by the kind of the curve.
"""

import math
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import NamedTuple

from markupsafe import Markup

from bounce_grader.common.escaping import html
from bounce_grader.common.numbers import metres, seconds, short
from bounce_grader.common.paths import HANDOUT
from bounce_grader.grading import speed

LEFT, RIGHT, TOP, BOTTOM = 90, 680, 20, 400  # px: where the axes end, of 720 x 454
# The curve's class by what it shows; delta is in proportion to dt, as in the handout's second line.
CLASSES = {"submission": "own k1", "solution": "k2", "least": "k4"}
NAMES = {
    "submission": "yours",
    "solution": "assignment's scheme, as the course solves it",
    "least": "no more model than each step needs",
}
Place = tuple[float, float]  # px, to the right and down


STYLE = Markup((HANDOUT / "given" / "page" / "chart.css").read_text("utf-8"))
MARKS = Path(__file__).with_name("chart_marks.svg")


class Curve(NamedTuple):
    """A curve with a point for each time step: CPU time over the solution's at 1 ms; error in m."""

    places: Sequence[tuple[float, float | None]]
    kind: str  # whose; of one among a class, whether it got "full", "some" or no ("none") points
    title: str
    labels: Sequence[str] = ()  # of the places


def of_one(measured: speed.Measured) -> Markup:
    """A submission's curve, with its time steps, beside the solution's and the least model's."""
    shown = [curve for curve in curves_of(measured, "submission").values() if curve.places]
    return error_over_time(shown, "Speed against accuracy")


def curves_of(measured: speed.Measured, labelled: str) -> dict[str, Curve]:
    """What was timed together, by whose it is, one of them with its time steps. The unit of time is
    the solution's, measured in the same run."""
    points = {whose: speed.curve(measured, whose) for whose in NAMES}
    unit = [point.ns for point in points["solution"] if point.dt >= speed.STEP]
    curves = {}
    for whose, name in NAMES.items():
        places = [(p.ns / unit[-1], p.error) for p in points[whose] if unit]
        labels = [seconds(1e9 * p.dt) for p in points[whose] if whose == labelled]
        curves[whose] = Curve(places, whose, name, labels)
    return curves


def error_over_time(curves: Sequence[Curve], label: str) -> Markup:
    """The curves on logarithmic axes, fainter if there are many, and a line at what is enough."""
    places = [place for curve in curves for place in curve.places]
    x = _axis((x for x, _ in places), 1e-4, 1e5, LEFT, RIGHT)
    y = _axis((speed.FINE, *(y for _, y in places if y is not None)), 1e-9, 1e2, BOTTOM, TOP)
    limit, middle = y.at(speed.FINE), (TOP + BOTTOM) / 2
    shapes = [
        MARKS.read_text("utf-8"),
        _line((LEFT, TOP), (RIGHT, TOP), (RIGHT, BOTTOM), (LEFT, BOTTOM), (LEFT, TOP)),
        *(_line((x.at(tick), BOTTOM), (x.at(tick), BOTTOM + 5)) for tick in x.ticks),
        *(_text(x.at(tick), BOTTOM + 20, short(tick), "middle") for tick in x.ticks),
        *(_line((LEFT - 5, y.at(tick)), (LEFT, y.at(tick))) for tick in y.ticks),
        *(_text(LEFT - 9, y.at(tick) + 5, metres(tick), "end") for tick in y.ticks),
        f'<g stroke-dasharray="2 3">{_line((LEFT, limit), (RIGHT, limit))}</g>',
        *(_curve(curve, x, y) for curve in curves),
        _text((LEFT + RIGHT) / 2, 444, "time, over the solution's at dt = 1 ms", "middle"),
        f'<g transform="rotate(-90 16 {middle:.1f})">{_text(16, middle, "error", "middle")}</g>',
    ]
    faint = f"--faint:{min(0.5, max(0.07, 20 / len(curves))):.2f}"
    head = f'viewBox="0 0 720 454" role="img" aria-label="{html(label)}" style="{faint}"'
    return Markup(f"<svg {head}>{''.join(shapes)}</svg>")


class _Axis(NamedTuple):
    """A logarithmic axis: the exponents at its ends, and where these are, in px."""

    first: int
    last: int
    begin: float
    end: float

    def at(self, value: float | None) -> float:
        """The position of a value in px. One outside goes to the nearest end, None to the last."""
        log = self.last if value is None else math.log10(value) if value > 0 else self.first
        share = (min(max(log, self.first), self.last) - self.first) / (self.last - self.first)
        return self.begin + (self.end - self.begin) * share

    @property
    def ticks(self) -> list[float]:
        """All powers of ten."""
        return [10.0**decade for decade in range(self.first, self.last + 1)]


def _axis(values: Iterable[float], low: float, high: float, begin: float, end: float) -> _Axis:
    """An axis around the values, which are clamped to low and high."""
    logs = [math.log10(min(max(value, low), high)) for value in values] or [0.0]
    first = math.floor(min(logs))
    return _Axis(first, max(math.ceil(max(logs)), first + 1), begin, end)


def _curve(curve: Curve, x: _Axis, y: _Axis) -> str:
    """A curve with its tooltip, and labels above and below its places in turn."""
    places = [(x.at(time), y.at(error)) for time, error in curve.places]
    style = CLASSES.get(curve.kind) or CLASSES["submission"] + " of-one"
    tooltip = f"<title>{html(curve.title)}</title>"
    drawn = f'<path class="curve {curve.kind} {style}" d="{_through(places, 0)}">{tooltip}</path>'
    labels = ""
    for number, ((right, down), label) in enumerate(zip(places, curve.labels)):
        aside, anchor = (-8, "end") if right > RIGHT - 60 else (8, "start")
        below = bool(number % 2) != (down < TOP + 20)
        labels += _text(right + aside, down + (20 if below else -8), label, anchor)
    return drawn + (f'<g class="label">{labels}</g>' if labels else "")


def _text(x: float, y: float, words: str, anchor: str) -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{html(words)}</text>'


def _line(*places: Place) -> str:
    return f'<path d="{_through(places)}" fill="none" stroke="currentColor"/>'


def _through(places: Iterable[Place], decimals: int = 1) -> str:
    """The straight lines from place to place, as a path's "d"."""
    return "M" + "L".join(f"{x:.{decimals}f} {y:.{decimals}f}" for x, y in places)
