"""The charts, and the tables that each is drawn from."""

from collections.abc import Callable
from typing import Any

import numpy as np

from bounce_study import chart_stability, style
from bounce_study.tables import FINE, Tables, TIME

README_SCENE = "oblique_bounce"
LEFT, RIGHT = 1e-8, 30.0  # m: what is more exact lies at the left edge
COLUMNS = 3
LAWS = {
    "frictionless": "no friction",
    "sticking": "always sticks",
    "newton": "Newton (the assignment's)",
    "poisson": "Poisson",
    "compliant": "compliant",
}


def _legend(axes: Any, panel: Any) -> None:
    handles, labels = panel.get_legend_handles_labels()
    axes.axis("off")
    axes.legend(handles, labels, loc="center left", handlelength=3.2)


def _time_over_error(axes: Any, runs: Any) -> None:
    axes.set(xscale="log", yscale="log", xlim=(LEFT / 3, RIGHT))
    axes.axvline(FINE, color="black", linewidth=0.8, linestyle=(0, (1, 2)), label="1 mm")
    for method, own in runs.groupby("method", sort=False):
        front = 2 if method in style.ENGINES else 3
        error, time = own["error_m"].clip(lower=LEFT), own[TIME] / 1e3
        axes.plot(error, time, **style.line(method), zorder=front)


def _by_scene(runs: Any, height: float, x: str, y: str, draw: Callable[[Any, Any], None]) -> bytes:
    """A panel for each scene, and the legend in one more."""
    scenes = runs.groupby("scene")
    rows = -(-(len(scenes) + 1) // COLUMNS)
    size = (style.WIDTH, height * rows)
    layout = {"sharex": True, "sharey": True, "layout": "constrained"}
    figure, grid = style.pyplot().subplots(rows, COLUMNS, figsize=size, **layout)
    for axes in grid.flat[len(scenes) :]:
        axes.axis("off")
    for axes, (scene, own) in zip(grid.flat, scenes):
        draw(axes, own)
        axes.set_title(style.scene_label(scene))
    _legend(grid.flat[len(scenes)], grid.flat[0])
    figure.supxlabel(x)
    figure.supylabel(y)
    return style.svg(figure)


def speed_accuracy(tables: Tables) -> bytes:
    runs, time = tables["speed_accuracy"], "CPU time per simulated second, µs"
    return _by_scene(runs, 3.0, "error, m", time, _time_over_error)


def speed_accuracy_one(tables: Tables) -> bytes:
    """A single panel, for the README."""
    runs = tables["speed_accuracy"].query("scene == @README_SCENE")
    layout = {"width_ratios": [2.2, 1], "layout": "constrained"}
    figure, (axes, key) = style.pyplot().subplots(1, 2, figsize=(8.4, 5.0), **layout)
    _time_over_error(axes, runs)
    axes.set(xlabel="error, m", ylabel="CPU time per simulated second, µs")
    axes.set_title(f"{style.scene_label(README_SCENE)}: left and below is better")
    _legend(key, axes)
    return style.svg(figure)


def order(tables: Tables) -> bytes:
    """Error / dt over dt: level where the order is one, rising to the left at a floor."""
    runs = tables["speed_accuracy"].query("method != 'event_driven' and method in @style.METHODS")
    return _by_scene(runs, 2.4, "Δt, s", "error / Δt, m/s", _error_over_step)


def _error_over_step(axes: Any, runs: Any) -> None:
    axes.set(xscale="log", yscale="log", ylim=(1e-6, 1e5))
    for method, own in runs.groupby("method", sort=False):
        own = own[own["error_m"] > 1e-12]
        axes.plot(own["setting"], own["error_m"] / own["setting"], **style.line(method))


def least_model(tables: Tables) -> bytes:
    """Error above time for each scene; the least model within the tolerance is black."""
    scenes = tables["least_model"].groupby("scene")
    layout = {"figsize": (1.4 * len(scenes), 4.6), "sharex": True, "sharey": "row"}
    figure, grid = style.pyplot().subplots(2, len(scenes), layout="constrained", **layout)
    for (above, below), (scene, rungs) in zip(grid.T, scenes):
        places = np.arange(len(rungs))
        right = rungs["error_m"] <= FINE
        shade = np.select([rungs["least"] == 1, right], ["black", "#bbbbbb"], "white")
        dots = {"c": shade, "edgecolors": "black", "linewidths": 0.8, "s": 36, "zorder": 3}
        above.scatter(places, rungs["error_m"].clip(5e-16).replace(np.inf, np.nan), **dots)
        endless = places[np.isinf(rungs["error_m"])]
        above.scatter(endless, np.full(len(endless), 1e2), marker="x", color="black")
        below.scatter(places, rungs[TIME] / 1e3, **dots)
        above.axhline(FINE, color="black", linewidth=0.8, linestyle=(0, (1, 2)))
        above.set(yscale="log", title=style.scene_label(scene))
        below.set(yscale="log", xticks=places)
    grid[0, 0].set_ylabel("error, m")
    grid[1, 0].set_ylabel("CPU time per simulated second, µs")
    names = "   ".join(f"{i}: {name}" for i, name in enumerate(style.MODELS.values()))
    figure.supxlabel(
        f"{names}\nblack: the least within 1 mm   grey: larger   white: "
        "wrong   ×: its impacts go on without an end"
    )
    return style.svg(figure)


def measured_laws(tables: Tables) -> bytes:
    """Each law's median error on the test impacts with its interval, beside the best impulse."""
    shapes = tables["measured_laws"].groupby("shape", sort=False)
    layout = {"figsize": (8.4, 2.1 * len(shapes)), "sharex": True, "layout": "constrained"}
    figure, grid = style.pyplot().subplots(len(shapes), 1, squeeze=False, **layout)
    for axes, (shape, rows) in zip(grid.flat, shapes):
        axes.axvspan(rows["floor_low"].iloc[0], rows["floor_high"].iloc[0], color="#dddddd")
        for place, row in enumerate(rows.itertuples()):
            color = style.BLUE if row.least else style.INK
            axes.plot([row.lower_quartile, row.upper_quartile], 2 * [place], color="#bbbbbb")
            axes.plot([row.median_low, row.median_high], 2 * [place], color=color, linewidth=3)
            axes.plot(row.median_m_s, place, "s" if row.least else "o", color=color)
        axes.set(xscale="log", title=f"{shape}: {rows['tested'].iloc[0]} test impacts")
        axes.set_yticks(range(len(rows)), [LAWS[law] for law in rows["law"]])
        axes.invert_yaxis()
    grid[-1, 0].set_xlabel("median error of the velocity after an impact, m/s")
    return style.svg(figure)


def square(_: Tables) -> bytes:
    """The symbols of all pages at a square, whose lowest corner is just above delta."""
    figure, axes = style.pyplot().subplots(figsize=(4.2, 2.2), layout="constrained")
    (cosine, sine), height, delta = (np.cos(0.35), np.sin(0.35)), 0.78, 0.08
    turn = np.array([[cosine, -sine], [sine, cosine]])
    x, y = turn @ (np.array([[-1, 1, 1, -1, -1], [-1, -1, 1, 1, -1]]) / 2) + [[0], [height]]
    axes.plot(x, y, color=style.BLUE)
    axes.plot([0, x[0]], [height, y[0]], color=style.BLUE, linestyle=(0, (1, 1)))
    axes.plot([x[0], x[0] + 0.7], [y[0], y[0]], color=style.INK, linewidth=0.6)
    axes.plot(x[0], y[0], "o", color=style.VERMILION)
    axes.axhline(0, color="black")
    axes.axhline(delta, color="black", linewidth=0.8, linestyle=(0, (4, 3)))
    arrow = {"arrowstyle": "->", "color": style.VERMILION}
    axes.annotate("", (0.45, height - 0.3), (0, height), arrowprops=arrow)
    spin = arrow | {"connectionstyle": "arc3,rad=0.5"}
    axes.annotate("", (-0.12, height + 0.22), (0.2, height + 0.16), arrowprops=spin)
    for place, text in {
        (x[0] + 0.52, y[0] + 0.05): "θ",
        ((x[1] + x[2]) / 2 + 0.05, (y[1] + y[2]) / 2): "l",
        ((x[0] - 0.12) / 2, (height + y[0]) / 2 + 0.06): "ρ",
        (0.42, height - 0.22): "v",
        (0.04, height + 0.34): "ω",
        (x[0] - 0.42, y[0] + 0.04): "corner",
        (0.9, delta + 0.03): "δ: the assignment's contact",
        (0.9, -0.14): "ground: y = 0, friction μ, restitution ε",
    }.items():
        axes.text(*place, text)
    axes.set(aspect="equal", xlim=(-0.8, 2.7), ylim=(-0.2, 1.5))
    axes.axis("off")
    return style.svg(figure)


CHARTS: dict[str, tuple[tuple[str, ...], Callable[[Tables], bytes]]] = {
    "square": (("speed_accuracy",), square),
    "speed_accuracy": (("speed_accuracy",), speed_accuracy),
    "speed_accuracy_one": (("speed_accuracy",), speed_accuracy_one),
    "order": (("speed_accuracy",), order),
    "stability": (chart_stability.NEEDS, chart_stability.draw),
    "least_model": (("least_model",), least_model),
    "measured_laws": (("measured_laws",), measured_laws),
}


def draw(tables: Tables) -> dict[str, bytes]:
    """Draws the charts whose tables are all there."""
    return {
        f"{name}.svg": chart(tables)
        for name, (needs, chart) in CHARTS.items()
        if all(table in tables for table in needs)
    }
