"""The drawings of the class's page, as SVG: black, white and one grey, so that no colour is needed
to read them."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from bounce_grader.common import escaping
from bounce_grader.common.svg import INK, line, rect, svg, text, upward

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


@dataclass(frozen=True)
class Way:
    """A curve: at each time step, the time over the solution's at 1 ms, and the error in m."""

    places: tuple[tuple[float, float | None], ...]
    kind: str  # as a Dot's, or "solution" or "least"
    title: str
    labels: tuple[str, ...] = ()  # of the places


def histogram(scores: Sequence[float], most: float) -> str:
    """How many have how many points, in ten columns; full marks have a column of their own."""
    counts = [0] * 11
    for score in scores:
        counts[10 if score >= most else min(9, int(10 * score / most))] += 1
    top, height, base = max([*counts, 1]), 190, 220
    step = WIDTH / 11
    out = [line(0, base, WIDTH, base)]
    for i, count in enumerate(counts):
        tall = height * count / top
        x = i * step
        out.append(rect(x + 3, base - tall, step - 6, tall, "#444"))
        if count:
            out.append(text(x + step / 2, base - tall - 6, str(count), "middle"))
        low, high = most * i / 10, most * (i + 1) / 10
        label = f"{most:g}" if i == 10 else f"{low:g}–{high:g}"
        out.append(text(x + step / 2, base + 20, label, "middle"))
    out.append(text(WIDTH / 2, base + 44, "points", "middle"))
    return svg(out, WIDTH, base + 54, "How many submissions have how many points")


def bars(rows: Sequence[Bar], label: str) -> str:
    """One line each: the words, a bar, and the number."""
    tall, start, end = 26, 445, 625
    out = []
    for i, row in enumerate(rows):
        y = i * tall + 6
        weight = "bold" if row.heading else "normal"
        out.append(text(0 if row.heading else 14, y + 14, row.label, "start", weight))
        out.append(rect(start, y + 2, end - start, 14, "none", "#999"))
        out.append(rect(start, y + 2, (end - start) * row.share, 14, "#444"))
        out.append(text(end + 8, y + 14, row.note, "start", weight))
    return svg(out, WIDTH, len(rows) * tall + 12, label)


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

    out = [rect(left, top, width, height, "none", "#111")]
    for decade in range(x_low, x_high + 1):
        x = place_x(10.0**decade)
        out.append(line(x, bottom, x, bottom + 5))
        out.append(text(x, bottom + 20, f"{10.0**decade:g}", "middle"))
    for decade in range(y_low + 1, y_high + 1, 4):
        y = place_y(10.0**decade)
        out.append(line(left - 5, y, left, y))
        out.append(text(left - 9, y + 5, f"1e{decade}", "end"))
    limit = place_y(right)
    out.append(f'<path d="M{left} {limit:.1f}h{width}" stroke="#111" stroke-dasharray="6 4"/>')
    out.append(text(left + width - 6, limit - 6, "right answers are below this line", "end"))
    solution = place_x(1.0)
    dash = 'stroke="#111" stroke-dasharray="2 4"'
    out.append(f'<path d="M{solution:.1f} {top}v{height}" {dash}/>')
    out.append(text(solution + 6, top + 16, "the solution's time", "start"))
    out.append(text(left + width + 22, bottom + 20, "not timed", "start"))
    out.append(text(left - 9, top - 26, "not finite,", "end"))
    out.append(text(left - 9, top - 10, "or missing", "end"))
    out += [_dot(place_x(dot.x, i), place_y(dot.y, i), dot) for i, dot in enumerate(dots)]
    out.append(text(left + width / 2, bottom + 44, "time of a step, over the solution's", "middle"))
    out.append(upward(16, top + height / 2, "largest error"))
    return svg(out, WIDTH, bottom + 54, "Speed against accuracy, one mark for each submission")


def _decades(values: Iterable[float], low: float, high: float) -> tuple[int, int]:
    logs = [math.log10(min(max(value, low), high)) for value in values]
    first, last = math.floor(min(logs)), math.ceil(max(logs))
    return first, max(last, first + 1)


def _log(value: float, low: float, high: float) -> float:
    """Within the axis, where it would leave it."""
    return min(max(math.log10(value) if value > 0 else low, low), high)


def _dot(x: float, y: float, dot: Dot) -> str:
    """Three shapes, which grey doesn't take apart: a disc, a ring and a cross."""
    title = f"<title>{escaping.html(dot.title)}</title>"
    if dot.kind == "none":
        arms = f"M{x - 4:.1f} {y - 4:.1f}l8 8m0-8l-8 8"
        return f'<path d="{arms}" stroke="#111" stroke-width="1.5">{title}</path>'
    fill = 'fill="#111" fill-opacity=".55"' if dot.kind == "full" else 'fill="none"'
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" {fill} stroke="#111">{title}</circle>'


def ways(curves: Sequence[Way], fine: float) -> str:
    """The error against the time, both in powers of ten, with a line at an error that is fine."""
    left, top, width, height = 90, 20, WIDTH - 130, 380
    places = [place for curve in curves for place in curve.places]
    xs = _decades((x for x, _ in places), 1e-4, 1e5)
    ys = _decades([fine, *(y for _, y in places if y is not None)], 1e-9, 1e2)
    bottom = top + height

    def place(x: float, y: float | None) -> tuple[float, float]:
        across = (_log(x, *xs) - xs[0]) / (xs[1] - xs[0])
        up = 1.0 if y is None else (_log(y, *ys) - ys[0]) / (ys[1] - ys[0])
        return left + width * across, bottom - height * up

    out = [_markers(len(curves)), rect(left, top, width, height, "none", INK)]
    for decade in range(xs[0], xs[1] + 1):
        x, _ = place(10.0**decade, 1)
        out += [line(x, bottom, x, bottom + 5), text(x, bottom + 20, f"{10.0**decade:g}", "middle")]
    for decade in range(ys[0], ys[1] + 1):
        _, y = place(1, 10.0**decade)
        out += [line(left - 5, y, left, y), text(left - 9, y + 5, f"1e{decade} m", "end")]
    _, limit = place(1, fine)
    out += [line(left, limit, left + width, limit, "2 3")]
    out += [_way(curve, [place(*at) for at in curve.places]) for curve in curves]
    said = "CPU time for a second of motion, over the solution's at dt = 1 ms"
    out += [text(left + width / 2, bottom + 44, said, "middle")]
    out += [upward(16, top + height / 2, "largest error")]
    return svg(out, WIDTH, bottom + 54, "Speed against accuracy, one line for each submission")


def _markers(number: int) -> str:
    """What stands at each place of a curve, by its kind. The more curves, the fainter each is."""
    faint = min(0.5, max(0.07, 20 / number))
    shapes = {
        "full": f'<circle r="3" cx="5" cy="5" fill="#111" fill-opacity="{faint:.2f}"/>',
        "some": f'<circle r="3" cx="5" cy="5" fill="none" stroke="#111" opacity="{2 * faint:.2f}"/>',
        "none": f'<path d="M2 2l6 6m0-6l-6 6" stroke="#111" opacity="{2 * faint:.2f}"/>',
        "solution": '<rect x="1" y="1" width="8" height="8" fill="#fff" stroke="#111"/>',
        "least": '<path d="M5 0l5 9H0z" fill="#fff" stroke="#111"/>',
    }
    drawn = "".join(
        f'<marker id="{kind}" refX="5" refY="5" markerWidth="10" markerHeight="10" '
        f'markerUnits="userSpaceOnUse">{shape}</marker>'
        for kind, shape in shapes.items()
    )
    rules = "".join(f".{kind}{{marker:url(#{kind})}}" for kind in shapes)
    lines = f".way{{fill:none;stroke:#111;stroke-width:.8;stroke-opacity:{faint:.2f}}}"
    bold = ".solution{stroke-width:2.5;stroke-opacity:1;stroke-dasharray:6 4}"
    dots = ".least{stroke-width:2;stroke-opacity:1;stroke-dasharray:1.5 4}"
    dots += ".label{paint-order:stroke;stroke:#fff;stroke-width:4}"
    return f"<defs>{drawn}</defs><style>{rules}{lines}{bold}{dots}</style>"


def _way(curve: Way, places: Sequence[tuple[float, float]]) -> str:
    drawn = "L".join(f"{x:.0f} {y:.0f}" for x, y in places)
    title = f"<title>{escaping.html(curve.title)}</title>"
    labels = "".join(text(x + 8, y - 8, said) for (x, y), said in zip(places, curve.labels))
    drawn = f'<path class="way {curve.kind}" d="M{drawn}">{title}</path>'
    return drawn + (f'<g class="label">{labels}</g>' if labels else "")
