"""Charts of speed against accuracy: a panel for each scene, the order of convergence, and the
performance profile."""

import math
import textwrap
from typing import Any

from bounce_study import chart_style, measurements
from bounce_study.chart_style import scene_label, Style
from bounce_study.measurements import Run
from bounce_study.point_labels import PointLabels
from bounce_study.tables import number, numbers, Tables

COLUMNS = 3
LEFT, RIGHT = 1e-8, 30.0  # m: what is more exact lies in a strip at the left edge
README_SCENE = "oblique_bounce"
TIME = "CPU time per simulated second, ns"


def panels(tables: Tables) -> bytes:
    runs = measurements.read(tables)
    scenes = measurements.scenes(runs)
    rows = math.ceil((len(scenes) + 1) / COLUMNS)
    layout = {"figsize": (chart_style.WIDTH * 1.3, 3.2 * rows), "sharex": True, "sharey": True}
    figure, grid = chart_style.pyplot().subplots(rows, COLUMNS, **layout)
    for axes, scene in zip(grid.flat, scenes):
        _lines(axes, runs, scene)
    _label_lowest(grid, len(scenes), "error, m")
    for axes in grid[:, 0]:
        axes.set_ylabel(TIME)
    _legend(grid.flat[len(scenes)], runs)
    digits = _digits(runs)
    _explain_marks(figure, digits, 215)
    for axes, scene in zip(grid.flat, scenes):
        _label_points(axes, runs, scene, digits)
    return chart_style.svg(figure)


def one(tables: Tables) -> bytes:
    """Draws a single panel, for the README."""
    runs = [run for run in measurements.read(tables) if run.scene == README_SCENE]
    layout = {"figsize": (8.4, 5.2), "gridspec_kw": {"width_ratios": [2.2, 1]}}
    figure, (axes, key) = chart_style.pyplot().subplots(1, 2, **layout)
    _lines(axes, runs, README_SCENE)
    axes.set(xlabel="error, m", ylabel=TIME)
    key.axis("off")
    _legend(key, runs)
    digits = _digits(runs)
    _explain_marks(figure, digits, 125)
    _label_points(axes, runs, README_SCENE, digits)
    return chart_style.svg(figure)


def _label_lowest(grid: Any, used: int, label: str) -> None:
    """Leaves out the panels after the used ones, and labels the abscissa below the others."""
    for axes in grid.flat[used:]:
        axes.axis("off")
    for axes in grid.flat[max(0, used - grid.shape[1]) : used]:
        axes.tick_params(labelbottom=True)
        axes.set_xlabel(label)


def _line_of(runs: list[Run], scene: str, method: str) -> list[Run]:
    """Gives the runs of a line, from the largest step to the smallest."""
    line = [run for run in measurements.of(runs, scene, method) if math.isfinite(run.error)]
    return sorted(line, key=lambda run: -run.setting)


def _point(run: Run) -> tuple[float, float]:
    return max(run.error, LEFT), run.ns


def _lines(axes: Any, runs: list[Run], scene: str) -> None:
    axes.set(xscale="log", yscale="log", xlim=(LEFT / 3, RIGHT), title=scene_label(scene))
    axes.axvspan(LEFT / 3, LEFT * 3, color="#eeeeee", zorder=0)
    axes.axvline(chart_style.FINE, color="black", linewidth=0.8, linestyle=(0, (1, 2)))
    for method in measurements.methods(runs)[::-1]:
        line = _line_of(runs, scene, method)
        if line:
            _draw_line(axes, line, chart_style.style(method, measurements.peers(runs)))


def _draw_line(axes: Any, line: list[Run], style: Style) -> None:
    x, y = zip(*map(_point, line))
    marked = [i for i, run in enumerate(line) if _is_marked(run)]
    axes.plot(x, y, **style.line(), markevery=marked, zorder=2 if line[0].peer else 3)
    if not measurements.failure(line, chart_style.FINE):
        return
    if chart_style.is_letter(style):  # the letter stays, within an open mark
        axes.plot(x[-1:], y[-1:], "o", mfc="none", mec="black", mew=0.8, ms=10, zorder=4)
    else:
        axes.plot(x[-1:], y[-1:], style.marker, mfc="white", mec=style.color, ms=8, zorder=4)


def _is_marked(run: Run) -> bool:
    """Says whether a run has a mark: the steps two to a factor of ten, and every tolerance."""
    halves = 2 * math.log10(run.setting)
    return not run.step or abs(halves - round(halves)) < 0.03


def _label_points(axes: Any, runs: list[Run], scene: str, digits: dict[str, str]) -> None:
    """Writes the reasons of failures first, then settings where there is room."""
    labels = PointLabels(axes)
    lines = [_line_of(runs, scene, method) for method in measurements.methods(runs)]
    lines = [line for line in lines if line]
    for line in lines:
        for run in filter(_is_marked, line):
            labels.occupy(*_point(run), 4)
    for line in lines:
        reason = measurements.failure(line, chart_style.FINE)
        if reason:
            labels.add(digits[reason], *_point(line[-1]), 8, 5, fontweight="bold", zorder=6)
    for line in lines:
        if not line[0].peer:
            _label_settings(labels, line)


def _label_settings(labels: PointLabels, line: list[Run]) -> None:
    """Writes the steps or the tolerances that are powers of ten."""
    color = chart_style.style(line[0].method, []).color
    for run in line:
        power = math.log10(run.setting)
        if abs(power - round(power)) < 1e-4:
            readable = color if color != chart_style.ORANGE else "#9a6a00"
            labels.add(f"1e{round(power)}", *_point(run), 6, 3, color=readable, zorder=5)


def _digits(runs: list[Run]) -> dict[str, str]:
    """Numbers the reasons for which a method doesn't come within the tolerance; letters are
    engines."""
    reasons = {
        measurements.failure(measurements.of(runs, scene, method), chart_style.FINE)
        for scene in measurements.scenes(runs)
        for method in measurements.methods(runs)
    }
    return {reason: str(i) for i, reason in enumerate(sorted(reasons - {""}), start=1)}


def _legend(axes: Any, runs: list[Run]) -> None:
    peers = measurements.peers(runs)
    styles = [chart_style.style(method, peers) for method in measurements.methods(runs)]
    handles = [_handle(style.label, style.line()) for style in styles]
    handles.append(_handle("1 mm", {"color": "black", "linewidth": 0.8, "ls": (0, (1, 2))}))
    axes.legend(handles=handles, loc="upper left", handlelength=3.2, labelspacing=0.35)


def _handle(label: str, line: dict[str, Any]) -> Any:
    """Makes an entry of a legend."""
    return chart_style.pyplot().Line2D([], [], label=label, **line)


def _explain_marks(figure: Any, digits: dict[str, str], width: int) -> None:
    """Says below the panels what the marks mean."""
    text = "At points: Δt in s, where there is room; event-driven: the tolerance."
    text += " Grey strip: 1e-8 m or less."
    if digits:
        text += " An open mark ends a line that is never within 1 mm, because "
        text += "; ".join(f"({digit}) {reason}" for reason, digit in digits.items()) + "."
    lines = textwrap.wrap(text, width)
    room = (len(lines) + 0.5) * 0.155 / figure.get_figheight()
    figure.text(0.02, 0.1 / figure.get_figheight(), "\n".join(lines), va="bottom", fontsize=7.5)
    figure.tight_layout(rect=(0, room, 1, 1))


def order(tables: Tables) -> bytes:
    """Draws error / dt over dt: level where the order is one, rising to the left at a floor."""
    table = tables["order"]
    scenes = table.distinct("scene")
    lines = {method: _order_line(method) for method in table.distinct("method")}
    rows = math.ceil((len(scenes) + 1) / 3)
    layout = {"figsize": (chart_style.WIDTH, 2.6 * rows), "sharex": True}
    figure, grid = chart_style.pyplot().subplots(rows, 3, **layout)
    for axes, scene in zip(grid.flat, scenes):
        axes.set(xscale="log", yscale="log", title=scene_label(scene))
        for method, line in lines.items():
            own = table.where(scene=scene, method=method)
            ratios = [(dt, number(r, "error_m") / dt) for r, dt in zip(own, numbers(own, "dt_s"))]
            points = [(x, y) for x, y in ratios if math.isfinite(y) and y > 1e-7]
            if points:
                axes.plot(*zip(*points), **line)
        if not axes.lines:
            chart_style.note(axes, "every method is exact here")
    _label_lowest(grid, len(scenes), "Δt, s")
    for axes in grid[:, 0]:
        axes.set_ylabel("error / Δt, m/s")
    handles = [_handle(chart_style.method_label(name), line) for name, line in lines.items()]
    grid.flat[len(scenes)].legend(handles=handles, loc="center left", handlelength=3.2)
    figure.tight_layout()
    return chart_style.svg(figure)


def _order_line(method: str) -> dict[str, Any]:
    """The plain form lies upon the fast one, which is drawn wide and pale below it."""
    line = chart_style.style(method, []).line()
    if method == "assignment_fast":
        return line | {"linewidth": 4.0, "markersize": 5.5, "alpha": 0.55, "zorder": 1}
    if method == "assignment":
        return line | {"linewidth": 0.9, "markersize": 2.5, "zorder": 2.5}
    return line | {"linewidth": 1.0, "markersize": 0.8 * line["markersize"]}


def profile(tables: Tables) -> bytes:
    """Draws Dolan and Moré's profile: the share of problems that a method solves within a factor of
    the fastest. Our methods and the peers have a panel each, with the same scales; every line ends,
    and is named, where it stays level."""
    runs = measurements.read(tables)
    ratios = profiles(runs)
    peers = measurements.peers(runs)
    groups = [("our methods", [m for m in ratios if m not in peers])]
    groups += [("engines and numpy", peers)] if peers else []
    layout = {"figsize": (chart_style.WIDTH, 4.2), "squeeze": False, "sharey": True}
    figure, grid = chart_style.pyplot().subplots(1, len(groups), **layout)
    furthest = max(r for own in ratios.values() for r in own if math.isfinite(r))
    for axes, (title, group) in zip(grid[0], groups):
        axes.set_title(title)
        _profile_panel(axes, {method: ratios[method] for method in group}, peers, furthest)
    grid[0][0].set_ylabel("share of the problems")
    figure.tight_layout()
    return chart_style.svg(figure)


def _profile_panel(
    axes: Any, ratios: dict[str, list[float]], peers: list[str], furthest: float
) -> None:
    """Draws from the fastest method's time to `furthest` times that."""
    end = furthest**1.08
    styles = [chart_style.style(method, peers) for method in ratios]
    shares = [_share(own) for own in ratios.values()]
    for style, own in zip(styles, ratios.values()):
        _profile_line(axes, own, style, end)
    axes.set_xscale("log")
    axes.set_xlim(0.7, end**1.56)
    axes.set_ylim(0, 1.12)
    axes.set_xlabel("times the time of the fastest method of the problem")
    for style, share, height in zip(styles, shares, _apart(shares, 0.045)):
        beside = {"textcoords": "data", "va": "center", "fontsize": 7.5}
        line = {"arrowprops": {"arrowstyle": "-", "linewidth": 0.5, "color": chart_style.GREY}}
        name = (end**1.04, height)
        axes.annotate(style.label, (end, share), name, **beside, **line)


def _share(ratios: list[float]) -> float:
    return sum(map(math.isfinite, ratios)) / len(ratios)


def _apart(heights: list[float], gap: float) -> list[float]:
    """Moves heights up where two would be closer than the gap."""
    moved = list(heights)
    below = 0.0
    for i in sorted(range(len(heights)), key=lambda i: heights[i]):
        moved[i] = below = max(heights[i], below + gap)
    return moved


def _profile_line(axes: Any, ratios: list[float], style: Style, end: float) -> None:
    solved = sorted(ratio for ratio in ratios if math.isfinite(ratio))
    x = [*solved[:1], *solved, end]
    y = [0.0, *(sum(r <= t for r in ratios) / len(ratios) for t in x[1:])]
    axes.step(x, y, where="post", **{**style.line(), "markevery": max(1, len(x) // 5)})


def profiles(runs: list[Run]) -> dict[str, list[float]]:
    """Divides each method's time by that of the fastest, for each scene and tolerance."""
    ratios: dict[str, list[float]] = {method: [] for method in measurements.methods(runs)}
    for scene in measurements.scenes(runs):
        for tolerance in measurements.TOLERANCES:
            ranking = measurements.ranking(runs, scene, tolerance)
            times = {run.method: run.ns / ranking[0].ns for run in ranking}
            for method, own in ratios.items():
                own.append(times.get(method, math.inf))
    return ratios
