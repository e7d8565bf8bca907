"""Draws the charts of the class page as SVG, in black, white and grey."""

from collections.abc import Sequence
from dataclasses import dataclass

from bounce_grader.common.numbers import metres, scientific_tick, short
from bounce_grader.formats.figures import Axes, BOLD, CLASSES, cross, decades, Drawing, INK
from bounce_grader.formats.figures import line, Place, rect, svg, text, through, title, WORDS

WIDTH = 720
LETTER, LINE = 8, 16  # px: at most the width of a letter, and the height of a line


@dataclass(frozen=True)
class Bar:
    """One bar of a chart: its label, length and note."""

    label: str
    share: float  # 0 to 1
    note: str
    heading: bool = False


@dataclass(frozen=True)
class Point:
    """A submission in the chart of speed against error."""

    x: float | None  # None: not measured
    y: float | None  # None: not finite
    kind: str  # whether it got "full", "some" or no ("none") points
    title: str


@dataclass(frozen=True)
class Curve:
    """A curve with a point for each time step: CPU time as a multiple of the solution's at 1 ms,
    and error in m."""

    places: tuple[tuple[float, float | None], ...]
    kind: str  # as a Point's, or "solution" or "least"
    title: str
    labels: tuple[str, ...] = ()  # of the places


def histogram(scores: Sequence[float], max_points: float) -> Drawing:
    """The distribution of points, in ten columns, and one more for full points."""
    counts = [0] * 11
    for score in scores:
        counts[10 if score >= max_points else min(9, int(10 * score / max_points))] += 1
    highest, height, base = max([*counts, 1]), 190, 220
    step = WIDTH / 11
    out = [line(0, base, WIDTH, base)]
    for i, count in enumerate(counts):
        tall = height * count / highest
        x = i * step
        out.append(rect(x + 3, base - tall, step - 6, tall, "#444"))
        if count:
            out.append(text(x + step / 2, base - tall - 6, str(count), "middle"))
        low, high = max_points * i / 10, max_points * (i + 1) / 10
        label = short(max_points) if i == 10 else f"{short(low)}–{short(high)}"
        out.append(text(x + step / 2, base + 20, label, "middle"))
    out.append(text(WIDTH / 2, base + 44, "points", "middle"))
    return svg(out, WIDTH, base + 54, "How many submissions have how many points")


def bars(rows: Sequence[Bar], label: str) -> Drawing:
    """Horizontal bars, each with its label and its number."""
    tall, start, end = 26, 445, 625
    out = []
    for i, row in enumerate(rows):
        y = i * tall + 6
        start_of_label, weight = (0, BOLD) if row.heading else (14, "")
        out.append(text(start_of_label, y + 14, row.label, "start", weight))
        out.append(rect(start, y + 2, end - start, 14, "none", "#999"))
        out.append(rect(start, y + 2, (end - start) * row.share, 14, "#444"))
        out.append(text(end + 8, y + 14, row.note, "start", weight))
    return svg(out, WIDTH, len(rows) * tall + 12, label)


def scatter(points: Sequence[Point], right: float) -> Drawing:
    """Error over time, on logarithmic axes, with a line at the tolerance `right`. Submissions that
    weren't timed are in a strip on the right, those with an infinite error in one at the top."""
    x_decades = decades([1.0, *(point.x for point in points if point.x)], 1e-3, 1e3)
    axes = Axes(x_decades, (-17, 3), left=90, top=56, width=WIDTH - 200, height=330)
    end = axes.left + axes.width
    solution, limit = axes.at(1.0, right)
    out = [
        rect(axes.left, axes.top, axes.width, axes.height, "none", "#111"),
        *axes.ticks(short, scientific_tick, range(-16, 4, 4)),
        f'<path d="M{axes.left} {limit:.1f}h{axes.width}" stroke="#111" stroke-dasharray="6 4"/>',
        text(end - 6, limit - 6, "right answers are below this line", "end"),
        f'<path d="M{solution:.1f} {axes.top}v{axes.height}" stroke="#111" '
        'stroke-dasharray="2 4"/>',
        text(solution + 6, axes.top + 16, "the solution's time"),
        text(end + 22, axes.bottom + 20, "not timed"),
        text(axes.left - 9, axes.top - 26, "not finite,", "end"),
        text(axes.left - 9, axes.top - 10, "or missing", "end"),
    ]
    for i, point in enumerate(points):
        x, y = axes.at(point.x or 0, point.y)
        not_timed, not_finite = end + 20 + 7 * (i % 10), axes.top - 12 - 5 * (i % 5)
        out.append(
            _point(not_timed if point.x is None else x, not_finite if point.y is None else y, point)
        )
    out += axes.names("time of a step, over the solution's", "largest error")
    label = "Speed against accuracy, one mark for each submission"
    return svg(out, WIDTH, axes.bottom + 54, label)


def _point(x: float, y: float, point: Point) -> str:
    """The mark of a submission: a disc, a ring or a cross, which differ even in grey."""
    words = title(point.title)
    if point.kind == "none":
        return f'<path d="{cross(x, y, 4)}" stroke="#111" stroke-width="1.5">{words}</path>'
    fill = 'fill="#111" fill-opacity=".55"' if point.kind == "full" else 'fill="none"'
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" {fill} stroke="#111">{words}</circle>'


def error_against_time(curves: Sequence[Curve], fine: float) -> Drawing:
    """The curves on logarithmic axes, with a line at the error `fine`, which is near enough."""
    places = [place for curve in curves for place in curve.places]
    axes = Axes(
        decades((x for x, _ in places), 1e-4, 1e5),
        decades([fine, *(y for _, y in places if y is not None)], 1e-9, 1e2),
        *(90, 20, WIDTH - 130, 380),
    )
    _, limit = axes.at(1, fine)
    out = [
        _markers(len(curves)),
        rect(axes.left, axes.top, axes.width, axes.height, "none", INK),
        *axes.ticks(short, metres),
        line(axes.left, limit, axes.left + axes.width, limit, "2 3"),
        *(_curve(curve, axes) for curve in curves),
        *axes.names(f"{WORDS['Time']}, over the solution's at dt = 1 ms", WORDS["Error"]),
    ]
    label = "Speed against accuracy, one line for each submission"
    return svg(out, WIDTH, axes.bottom + 54, label)


def _markers(number: int) -> str:
    """The styles of curves and of their marks, by kind. The more curves, the fainter each is."""
    faint = min(0.5, max(0.07, 20 / number))
    shapes = {
        "full": f'<circle r="3" cx="5" cy="5" fill="#111" fill-opacity="{faint:.2f}"/>',
        "some": '<circle r="3" cx="5" cy="5" fill="none" stroke="#111" '
        f'opacity="{2 * faint:.2f}"/>',
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
    lines = f".curve.of-one{{stroke-width:.8;stroke-opacity:{faint:.2f};stroke-dasharray:none}}"
    label = ".label{paint-order:stroke;stroke:#fff;stroke-width:4}"
    return f"<defs>{drawn}</defs><style>{rules}{lines}{label}</style>"


def _curve(curve: Curve, axes: Axes) -> str:
    places = [axes.at(*place) for place in curve.places]
    style = CLASSES.get(curve.kind) or CLASSES["submission"] + " of-one"
    kinds = f"curve {curve.kind} {style}"
    drawn = f'<path class="{kinds}" d="{through(places, 0)}">{title(curve.title)}</path>'
    labels = _labels(places, curve.labels, axes)
    return drawn + (f'<g class="label">{labels}</g>' if labels else "")


def _labels(places: Sequence[Place], labels: Sequence[str], axes: Axes) -> str:
    """Each label beside its place: within the frame, and not over another."""
    out, taken = [], list[Place]()
    for (x, y), label in zip(places, labels):
        width = LETTER * len(label)
        right = x + 8 + width < axes.left + axes.width
        start = x + 8 if right else x - 8 - width
        sides = [y - 8, y + 20, y - 26, y + 38, y - 44, y + 56]
        free = [at for at in sides if _is_free(start, at, width, taken, axes)]
        at = free[0] if free else sides[0]
        taken += [(start, at), (start + width, at)]
        out.append(text(start, at, label))
    return "".join(out)


def _is_free(x: float, y: float, width: float, taken: Sequence[Place], axes: Axes) -> bool:
    inside = axes.top + LINE < y < axes.bottom - 4
    return inside and not any(
        abs(y - other_y) < LINE and x - 4 < other_x < x + width + 4 for other_x, other_y in taken
    )
