"""Draws a submission's speed against its accuracy: error over CPU time."""

from collections.abc import Sequence

from bounce_grader.common.numbers import metres, seconds
from bounce_grader.formats.figures import Axes, BOLD, circle, CLASSES, cross, decades, Drawing, INK
from bounce_grader.formats.figures import line, NAMES, Place, rect, svg, text, through, title, WORDS
from bounce_grader.grading import speed
from bounce_grader.grading.speed import Measured, Point

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
        return circle(place, 2.5, f'stroke-width="5" fill="none" {kind}', words)
    if whose == "solution":
        return (
            f'<rect x="{x - 4.5:.1f}" y="{y - 4.5:.1f}" width="9" height="9" '
            f'stroke-width="1.5" class="hollow {CLASSES[whose]}">{words}</rect>'
        )
    return f'<path d="{cross(x, y, 5)}" stroke-width="1.5" {kind}>{words}</path>'
