"""The drawings of the class's page, as SVG: black, white and one grey, so that no colour is needed
to read them."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from bounce_grader.formats._escaping import to_html

WIDTH = 720


@dataclass(frozen=True)
class Bar:
    label: str
    share: float  # 0 to 1
    note: str
    heading: bool = False


@dataclass(frozen=True)
class Dot:
    x: float | None  # None: not measured
    y: float | None  # None: not finite
    kind: str  # "full", "some" or "none" of the points
    title: str


def histogram(scores: Sequence[float], most: float) -> str:
    """How many have how many points, in ten columns; full marks have a column of their own."""
    counts = [0] * 11
    for score in scores:
        counts[10 if score >= most else min(9, int(10 * score / most))] += 1
    top, height, base = max([*counts, 1]), 190, 220
    step = WIDTH / 11
    out = [_line(0, base, WIDTH, base)]
    for i, count in enumerate(counts):
        tall = height * count / top
        x = i * step
        out.append(_rect(x + 3, base - tall, step - 6, tall, "#444"))
        if count:
            out.append(_text(x + step / 2, base - tall - 6, str(count), "middle"))
        low, high = most * i / 10, most * (i + 1) / 10
        label = f"{most:g}" if i == 10 else f"{low:g}–{high:g}"
        out.append(_text(x + step / 2, base + 20, label, "middle"))
    out.append(_text(WIDTH / 2, base + 44, "points", "middle"))
    return _svg(out, base + 54, "How many submissions have how many points")


def bars(rows: Sequence[Bar], label: str) -> str:
    """One line each: the words, a bar, and the number."""
    line, start, end = 26, 445, 625
    out = []
    for i, row in enumerate(rows):
        y = i * line + 6
        weight = "bold" if row.heading else "normal"
        out.append(_text(0 if row.heading else 14, y + 14, row.label, "start", weight))
        out.append(_rect(start, y + 2, end - start, 14, "none", "#999"))
        out.append(_rect(start, y + 2, (end - start) * row.share, 14, "#444"))
        out.append(_text(end + 8, y + 14, row.note, "start", weight))
    return _svg(out, len(rows) * line + 12, label)


def scatter(dots: Sequence[Dot], right: float) -> str:
    """Both axes are powers of ten; a line at the tolerance, below which answers are right. A strip
    on the right holds what wasn't timed, one at the top what isn't finite."""
    left, top, width, height = 90, 56, WIDTH - 200, 330
    x_low, x_high = _decades([1.0, *(dot.x for dot in dots if dot.x)], 1e-3, 1e3)
    y_low, y_high = -17, 3
    bottom = top + height

    def place_x(x: float | None, at: int = 0) -> float:
        if x is None:
            return left + width + 20 + 7 * (at % 10)
        return left + width * (_log(x, x_low, x_high) - x_low) / (x_high - x_low)

    def place_y(y: float | None, at: int = 0) -> float:
        if y is None:
            return top - 12 - 5 * (at % 5)
        return bottom - height * (_log(y, y_low, y_high) - y_low) / (y_high - y_low)

    out = [_rect(left, top, width, height, "none", "#111")]
    for decade in range(x_low, x_high + 1):
        x = place_x(10.0**decade)
        out.append(_line(x, bottom, x, bottom + 5))
        out.append(_text(x, bottom + 20, f"{10.0**decade:g}", "middle"))
    for decade in range(y_low + 1, y_high + 1, 4):
        y = place_y(10.0**decade)
        out.append(_line(left - 5, y, left, y))
        out.append(_text(left - 9, y + 5, f"1e{decade}", "end"))
    limit = place_y(right)
    out.append(f'<path d="M{left} {limit:.1f}h{width}" stroke="#111" stroke-dasharray="6 4"/>')
    out.append(_text(left + width - 6, limit - 6, "right answers are below this line", "end"))
    solution = place_x(1.0)
    dash = 'stroke="#111" stroke-dasharray="2 4"'
    out.append(f'<path d="M{solution:.1f} {top}v{height}" {dash}/>')
    out.append(_text(solution + 6, top + 16, "the solution's time", "start"))
    out.append(_text(left + width + 22, bottom + 20, "not timed", "start"))
    out.append(_text(left - 9, top - 16, "not finite", "end"))
    out += [_dot(place_x(dot.x, i), place_y(dot.y, i), dot) for i, dot in enumerate(dots)]
    out.append(
        _text(left + width / 2, bottom + 44, "time of a step, over the solution's", "middle")
    )
    turned = f'transform="rotate(-90 16 {top + height / 2})"'
    out.append(
        f'<text x="16" y="{top + height / 2}" text-anchor="middle" {turned}>largest error</text>'
    )
    return _svg(out, bottom + 54, "Speed against accuracy, one mark for each submission")


def _decades(values: Iterable[float], low: float, high: float) -> tuple[int, int]:
    logs = [math.log10(min(max(value, low), high)) for value in values]
    first, last = math.floor(min(logs)), math.ceil(max(logs))
    return first, max(last, first + 1)


def _log(value: float, low: float, high: float) -> float:
    """Within the axis, where it would leave it."""
    return min(max(math.log10(value) if value > 0 else low, low), high)


def _dot(x: float, y: float, dot: Dot) -> str:
    """Three shapes, which grey doesn't take apart: a disc, a ring and a cross."""
    title = f"<title>{to_html(dot.title)}</title>"
    if dot.kind == "none":
        arms = f"M{x - 4:.1f} {y - 4:.1f}l8 8m0-8l-8 8"
        return f'<path d="{arms}" stroke="#111" stroke-width="1.5">{title}</path>'
    fill = 'fill="#111" fill-opacity=".55"' if dot.kind == "full" else 'fill="none"'
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" {fill} stroke="#111">{title}</circle>'


def _svg(shapes: list[str], height: float, label: str) -> str:
    return (
        f'<svg viewBox="0 0 {WIDTH} {height:.0f}" role="img" aria-label="{to_html(label)}">'
        f"{''.join(shapes)}</svg>"
    )


def _rect(x: float, y: float, w: float, h: float, fill: str, stroke: str = "none") -> str:
    size = f'width="{max(w, 0):.1f}" height="{max(h, 0):.1f}"'
    return f'<rect x="{x:.1f}" y="{y:.1f}" {size} fill="{fill}" stroke="{stroke}"/>'


def _text(x: float, y: float, words: str, anchor: str, weight: str = "normal") -> str:
    bold = ' style="font-weight:bold"' if weight == "bold" else ""
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{bold}>{to_html(words)}</text>'


def _line(x1: float, y1: float, x2: float, y2: float) -> str:
    return f'<path d="M{x1:.1f} {y1:.1f}L{x2:.1f} {y2:.1f}" stroke="#111"/>'
