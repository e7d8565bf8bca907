"""Draws the chart of the class page as SVG: speed against accuracy, in black, white and grey."""

import statistics
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from bounce_grader.classroom.grading.summary import Summary
from bounce_grader.common.numbers import metres, short
from bounce_grader.formats.figures import Axes, CLASSES, decades, Drawing, INK, NAMES
from bounce_grader.formats.figures import line, Place, rect, svg, text, through, title, WORDS
from bounce_grader.grading import speed

WIDTH = 720


class Curve(NamedTuple):
    """A curve with a point for each time step: CPU time as a multiple of the solution's at 1 ms,
    and error in m."""

    places: Sequence[tuple[float, float | None]]
    kind: str  # whether it got "full", "some" or no ("none") points; or "solution" or "least"
    title: str
    labels: Sequence[str] = ()  # of the places


def of_class(summaries: Sequence[Summary], names: Mapping[str, str]) -> Drawing | None:
    """All submissions' curves in one chart, with those of the solution and of the least model. Each
    one's unit of time is the solution's, measured in the same run."""
    graded = [s for s in summaries if s.score is not None]
    curves = []
    for one in graded:
        kind = "full" if one.has_all_points else "some" if one.score else "none"
        words = f"{names[one.student.id]}: {short(one.score or 0)} points"
        curves.append(Curve(_over_solution(one, "submission"), kind, words))
    curves = [curve for curve in curves if curve.places]
    usual = [_median(summaries, whose) for whose in ("solution", "least")]
    return error_against_time([*curves, *filter(None, usual)], speed.FINE) if curves else None


def _over_solution(summary: Summary, whose: str) -> list[tuple[float, float | None]]:
    unit = [point.ns for point in summary.curves.get("solution", ()) if point.dt >= speed.STEP]
    return [(p.ns / unit[-1], p.error) for p in summary.curves.get(whose, ()) if unit]


def _median(summaries: Sequence[Summary], whose: str) -> Curve | None:
    """The median over all runs of the solution's or the least model's curve."""
    runs = [(s, places) for s in summaries if (places := _over_solution(s, whose))]
    if not runs:
        return None
    first, errors = runs[0]
    times = [statistics.median(step) for step in zip(*([x for x, _ in run] for _, run in runs))]
    places = [(x, error) for x, (_, error) in zip(times, errors)]
    steps = [f"{short(1000 * point.dt)} ms" for point in first.curves[whose]]
    return Curve(places, whose, NAMES[whose], steps if whose == "solution" else ())


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
