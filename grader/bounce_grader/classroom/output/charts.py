"""Draws the charts of the class page as SVG, in black, white and grey."""

from collections.abc import Sequence
from dataclasses import dataclass

from bounce_grader.common.numbers import metres, short
from bounce_grader.formats.figures import Axes, BOLD, CLASSES, decades, Drawing, INK
from bounce_grader.formats.figures import line, Place, rect, svg, text, through, title, WORDS

WIDTH = 720


@dataclass(frozen=True)
class Bar:
    """One bar of a chart: its label, length and note."""

    label: str
    share: float  # 0 to 1
    note: str
    heading: bool = False


@dataclass(frozen=True)
class Curve:
    """A curve with a point for each time step: CPU time as a multiple of the solution's at 1 ms,
    and error in m."""

    places: tuple[tuple[float, float | None], ...]
    kind: str  # whether it got "full", "some" or no ("none") points; or "solution" or "least"
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
    """Each label beside its place, above and below in turn, and within the frame."""
    out = []
    for number, ((x, y), label) in enumerate(zip(places, labels)):
        to_the_left = x > axes.left + axes.width - 60
        below = bool(number % 2) != (y < axes.top + 20)
        anchor = "end" if to_the_left else "start"
        out.append(text(x - 8 if to_the_left else x + 8, y + 20 if below else y - 8, label, anchor))
    return "".join(out)
