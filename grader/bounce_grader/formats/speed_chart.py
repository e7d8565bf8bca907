"""Draws the error over the CPU time for a second of motion, on logarithmic axes. The words and
colours are those of the handout's own charts. The curves differ in marks and dashes, so that no
colour is needed."""

from collections.abc import Sequence

from bounce_grader.common import svg
from bounce_grader.common.chart_style import CLASSES, NAMES, WORDS
from bounce_grader.common.numbers import metres, seconds
from bounce_grader.common.svg import Axes, Drawing
from bounce_grader.grading import speed
from bounce_grader.grading.speed import Measured, Point

WIDTH, HEIGHT = 480, 430
LEFT, RIGHT, TOP, BOTTOM = 80, 28, 96, 52  # px around the axes
LABEL = 45  # px: the width of a step's label
LARGEST, LEAST = 1e2, 1e-9  # m: errors beyond are drawn at the edge
Curves = dict[str, list[Point]]


def of_all(measured: Measured) -> Drawing:
    """The chart for all scenes together, with time steps written at the submission's points."""
    curves = {whose: speed.curve(measured, whose) for whose in speed.CURVES}
    return _chart(
        curves,
        f"{WORDS['ErrorOverTime']}: the worst of {len(measured['scenes'])} scenes",
        labelled=True,
    )


def of_scene(scene: Measured) -> Drawing:
    curves = {
        whose: [Point(p["dt"], p["ns"], p["error"]) for p in scene[whose]] for whose in speed.CURVES
    }
    return _chart(curves, scene["title"], labelled=False)


def _chart(curves: Curves, title: str, labelled: bool) -> Drawing:
    points = [point for curve in curves.values() for point in curve]
    axes = Axes(
        svg.decades((p.ns for p in points), 1, 1e12),
        svg.decades((LARGEST if p.error is None else p.error for p in points), LEAST, LARGEST),
        *(LEFT, TOP, WIDTH - LEFT - RIGHT, HEIGHT - TOP - BOTTOM),
    )
    shapes = [svg.text(WIDTH / 2, 16, title, "middle", svg.BOLD), *_frame(axes), *_legend(curves)]
    for whose in reversed(speed.CURVES):
        shapes += _curve(whose, curves[whose], axes)
    if labelled:
        shapes += _steps(curves["submission"], axes)
    return svg.svg(shapes, WIDTH, HEIGHT, title)


def _frame(axes: Axes) -> list[str]:
    out = [svg.rect(axes.left, axes.top, axes.width, axes.height, "none", svg.INK)]
    out += axes.ticks(seconds, metres, gap=8)
    if axes.y[0] < -3 < axes.y[1]:
        _, y = axes.at(1, speed.FINE)
        out.append(svg.line(LEFT, y, WIDTH - RIGHT, y, "2 3"))
    return out + axes.names(WORDS["Time"], WORDS["Error"], gap=BOTTOM - 10)


def _legend(curves: Curves) -> list[str]:
    out, y = [], 38
    for whose in filter(curves.__getitem__, speed.CURVES):
        out += [_line(whose, [(LEFT, y), (LEFT + 32, y)]), _mark(whose, LEFT + 16, y)]
        out += [svg.text(LEFT + 38, y + 5, NAMES[whose])]
        y += 20
    return out


def _curve(whose: str, points: Sequence[Point], axes: Axes) -> list[str]:
    places = [axes.at(point.ns, point.error) for point in points]
    out = [_line(whose, places)] if places else []
    for point, (x, y) in zip(points, places):
        error = "not finite" if point.error is None else metres(point.error)
        words = f"{NAMES[whose]}, {speed.step(point)}: {error} in {seconds(point.ns)}"
        out.append(_mark(whose, x, y, svg.title(words)))
    return out


def _line(whose: str, places: Sequence[svg.Place]) -> str:
    return f'<path class="curve {CLASSES[whose]}" d="{svg.through(places)}"/>'


def _steps(points: Sequence[Point], axes: Axes) -> list[str]:
    """The labels of the time steps: the first one below its point, out of the way of the second;
    none where it would cover the one before."""
    out, last = [], 0.0
    for i, point in enumerate(points):
        x, y = axes.at(point.ns, point.error)
        if i == 0:
            out.append(svg.text(x, y + 24, speed.step(point), "middle"))
        elif x - last < LABEL:
            continue
        elif x > WIDTH - RIGHT - 50:
            out.append(svg.text(x - 9, y + 16, seconds(1e9 * point.dt), "end"))
        else:
            out.append(svg.text(x + 6, y - 8, seconds(1e9 * point.dt)))
        last = x if i else last
    return out


def _mark(whose: str, x: float, y: float, title: str = "") -> str:
    """The mark of a curve: a disc, a square or a cross."""
    kind = f'class="{CLASSES[whose]}"'
    if whose == "submission":
        place = f'cx="{x:.1f}" cy="{y:.1f}"'
        return f'<circle {place} r="2.5" stroke-width="5" fill="none" {kind}>{title}</circle>'
    if whose == "solution":
        return (
            f'<rect x="{x - 4.5:.1f}" y="{y - 4.5:.1f}" width="9" height="9" '
            f'stroke-width="1.5" class="hollow {CLASSES[whose]}">{title}</rect>'
        )
    return f'<path d="{svg.cross(x, y, 5)}" stroke-width="1.5" {kind}>{title}</path>'
