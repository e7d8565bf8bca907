"""Draws in SVG for pages: shapes and logarithmic axes; the words and colours of charts.

They use the colour of the surrounding text, so they work on paper, in the dark and in grey. What
tells curves and answers apart is their place, labels, marks and dashes, never colour alone.
"""

import math
from collections.abc import Callable, Iterable
from typing import NamedTuple

from bounce_grader.common.escaping import html
from bounce_grader.common.paths import HANDOUT

INK = "currentColor"
BOLD = ' style="font-weight:bold"'  # an attribute for text()
Place = tuple[float, float]  # px, to the right and down


class Drawing(str):
    """Finished SVG, which a template inserts without escaping."""

    def __html__(self) -> str:
        return self


# The words and colours of charts of error over time are those of the handout's own charts.
WORDS = {
    "ErrorOverTime": "Error over time",
    "Time": "time of a simulated second",
    "Error": "error",
    "Yours": "yours",
    "Assignment": "assignment's scheme, as the course solves it",
}
STYLE = Drawing((HANDOUT / "given" / "page" / "chart.css").read_text("utf-8"))
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


def circle(place: Place, r: float, attributes: str, inside: str | None = None) -> str:
    end = "/>" if inside is None else f">{inside}</circle>"
    return f'<circle cx="{place[0]:.1f}" cy="{place[1]:.1f}" r="{r:g}" {attributes}{end}'


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
