"""Speed against accuracy, drawn: the error against the time that a second of motion takes, both in
powers of ten. The curves differ in their marks and dashes, so that no colour is needed."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from bounce_grader.common import escaping, numbers, svg
from bounce_grader.grading import speed
from bounce_grader.grading.speed import Measured, Point

WIDTH, HEIGHT = 480, 400
LEFT, RIGHT, TOP, BOTTOM = 80, 28, 66, 52  # around the axes
LARGEST, LEAST = 1e2, 1e-9  # m: what is beyond is drawn at the edge
NAMES = {"submission": "yours", "solution": "the solution", "least": "least model"}
DASHES = {"submission": "", "solution": "6 4", "least": "1.5 4"}


@dataclass(frozen=True)
class Axes:
    """Powers of ten, from and to."""

    x: tuple[int, int]
    y: tuple[int, int]

    def at(self, ns: float, error: float | None) -> tuple[float, float]:
        metres = LARGEST if error is None else min(max(error, LEAST), LARGEST)
        return (
            LEFT + (WIDTH - LEFT - RIGHT) * _share(ns, self.x),
            HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * _share(metres, self.y),
        )


def _share(value: float, decades: tuple[int, int]) -> float:
    low, high = decades
    return (min(max(math.log10(value), low), high) - low) / (high - low)


def page_section(found: Measured) -> str:
    """The chart of all scenes together, what it means, and a chart for each scene; or why there is
    none."""
    said = " ".join(speed.sentences(found))
    if "otherwise" in found:
        return f"<h2>Speed against accuracy</h2><p>{escaping.html(said)}</p>"
    if not found.get("scenes"):
        return ""
    whole = {whose: speed.curve(found, whose) for whose in speed.CURVES}
    title = f"The worst of {len(found['scenes'])} scenes"
    scenes = "".join(_scene(scene) for scene in found["scenes"])
    return (
        "<h2>Speed against accuracy</h2>"
        f"<p>{escaping.html(said)} This gives and costs no points.</p>"
        f'<figure class="chart">{chart(whole, title, True)}</figure>'
        '<p class="small">Each point is a time step dt; where a line falls, smaller steps are '
        "worth their time. Further left is faster, further down more exact. The largest error is "
        "that of the worst scene; delta is dt times 0.1 m/s. The solution was timed in the same "
        "run.</p>"
        f"<details><summary>Scene by scene</summary><div class='charts'>{scenes}</div></details>"
    )


def _scene(scene: Measured) -> str:
    curves = {
        whose: [Point(p["dt"], p["ns"], p["error"]) for p in scene[whose]] for whose in speed.CURVES
    }
    return f"<figure>{chart(curves, scene['title'], False)}</figure>"


def chart(curves: dict[str, list[Point]], title: str, labelled: bool) -> str:
    points = [point for curve in curves.values() for point in curve]
    axes = Axes(
        _decades((p.ns for p in points), 1, 1e12),
        _decades((LARGEST if p.error is None else p.error for p in points), LEAST, LARGEST),
    )
    shapes = [svg.text(WIDTH / 2, 16, title, "middle", "bold"), *_frame(axes), *_legend(curves)]
    for whose in reversed(speed.CURVES):
        shapes += _curve(whose, curves[whose], axes)
    if labelled:
        shapes += _steps(curves["submission"], axes)
    return svg.svg(shapes, WIDTH, HEIGHT, title)


def _decades(values: Iterable[float], low: float, high: float) -> tuple[int, int]:
    logs = [math.log10(min(max(value, low), high)) for value in values] or [0.0]
    first, last = math.floor(min(logs)), math.ceil(max(logs))
    return first, max(last, first + 1)


def _frame(axes: Axes) -> list[str]:
    right, bottom = WIDTH - RIGHT, HEIGHT - BOTTOM
    out = [svg.rect(LEFT, TOP, right - LEFT, bottom - TOP, "none", svg.INK)]
    for decade in range(axes.x[0], axes.x[1] + 1):
        x, _ = axes.at(10.0**decade, 1)
        out += [svg.line(x, bottom, x, bottom + 5)]
        out += [svg.text(x, bottom + 20, numbers.seconds(10.0**decade), "middle")]
    for decade in range(axes.y[0], axes.y[1] + 1):
        _, y = axes.at(1, 10.0**decade)
        out += [svg.line(LEFT - 5, y, LEFT, y)]
        out += [svg.text(LEFT - 8, y + 5, numbers.metres(10.0**decade), "end")]
    if axes.y[0] < -3 < axes.y[1]:
        _, y = axes.at(1, speed.FINE)
        out.append(svg.line(LEFT, y, right, y, "2 3"))
    out.append(
        svg.text((LEFT + right) / 2, HEIGHT - 10, "CPU time for a second of motion", "middle")
    )
    return [*out, svg.upward(16, (TOP + bottom) / 2, "largest error")]


def _legend(curves: dict[str, list[Point]]) -> list[str]:
    out, x = [], LEFT
    for whose in speed.CURVES:
        if curves[whose]:
            out += [svg.line(x, 38, x + 26, 38, DASHES[whose], _thickness(whose))]
            out += [_mark(whose, x + 13, 38), svg.text(x + 31, 43, NAMES[whose])]
            x += 130
    return out


def _thickness(whose: str) -> float:
    return 2.5 if whose == "submission" else 1.5


def _curve(whose: str, points: Sequence[Point], axes: Axes) -> list[str]:
    places = [axes.at(point.ns, point.error) for point in points]
    out = [svg.path(places, DASHES[whose], _thickness(whose))] if places else []
    for point, (x, y) in zip(points, places):
        error = "not finite" if point.error is None else numbers.metres(point.error)
        said = f"{NAMES[whose]}, {speed.step(point)}: {error} in {numbers.seconds(point.ns)}"
        out.append(_mark(whose, x, y, said))
    return out


def _steps(points: Sequence[Point], axes: Axes) -> list[str]:
    """The time steps, at their points: the first one below, out of the way of the next."""
    out = []
    for i, point in enumerate(points):
        x, y = axes.at(point.ns, point.error)
        if i == 0:
            out.append(svg.text(x, y + 24, speed.step(point), "middle"))
        else:
            said = numbers.seconds(1e9 * point.dt)
            ends = x > WIDTH - RIGHT - 50
            out.append(
                svg.text(x - 9, y + 16, said, "end") if ends else svg.text(x + 6, y - 8, said)
            )
    return out


def _mark(whose: str, x: float, y: float, said: str = "") -> str:
    """A disc, a square and a cross."""
    title = f"<title>{escaping.html(said)}</title>" if said else ""
    if whose == "submission":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="5" fill="{svg.INK}">{title}</circle>'
    if whose == "solution":
        return (
            f'<rect x="{x - 4.5:.1f}" y="{y - 4.5:.1f}" width="9" height="9" class="hollow" '
            f'stroke="{svg.INK}" stroke-width="1.5">{title}</rect>'
        )
    arms = f"M{x - 5:.1f} {y - 5:.1f}l10 10m0-10l-10 10"
    return f'<path d="{arms}" stroke="{svg.INK}" stroke-width="1.5">{title}</path>'
