"""Charts of the least model of each scene, and of the models that the choosing simulator takes."""

import math
from typing import Any

from bounce_study import chart_style
from bounce_study.chart_style import scene_label
from bounce_study.tables import number, numbers, Row, Tables

MODELS = {
    "asleep": ("asleep", "#ffffff", ""),
    "ballistic": ("ballistic", chart_style.SKY, ".."),
    "one_normal": ("1 corner, normal", chart_style.ORANGE, "//"),
    "one_friction": ("1 corner, friction", chart_style.VERMILION, "xx"),
    "two_normals": ("2 corners, normal", "#F0E442", "\\\\"),
    "two_frictions": ("2 corners, friction", chart_style.BLUE, ""),
}
EXACT = 1e-16


def ladder(tables: Tables) -> bytes:
    """Draws error above time for each scene; the least model within the tolerance is black."""
    table = tables["least_model"]
    scenes = table.distinct("scene")
    columns = 4
    rows = math.ceil(len(scenes) / columns)
    figure = chart_style.pyplot().figure(figsize=(chart_style.WIDTH, 3.3 * rows + 0.4))
    outer = figure.add_gridspec(rows, columns, hspace=0.55, wspace=0.28)
    for i, scene in enumerate(scenes):
        inner = outer[i // columns, i % columns].subgridspec(2, 1, hspace=0.08)
        above, below = figure.add_subplot(inner[0]), figure.add_subplot(inner[1])
        models = table.where(scene=scene)
        _errors(above, models)
        _times(below, models)
        above.set_title(scene_label(scene))
        if i % columns == 0:
            above.set_ylabel("error, m")
            below.set_ylabel("ns per s")
    figure.subplots_adjust(left=0.07, right=0.99, top=0.96, bottom=0.13)
    names = "   ".join(f"{i}: {name}" for i, (name, _, _) in enumerate(MODELS.values()))
    figure.text(0.5, 0.055, names, ha="center")
    text = "black: the least within 1 mm      open: wrong      grey: right, and larger than needed"
    figure.text(0.5, 0.03, text + "      ×: ends at its cap on events", ha="center")
    return chart_style.svg(figure)


def _dot(axes: Any, i: int, height: float, row: Row) -> None:
    right = "#bbbbbb" if number(row, "error_m") <= chart_style.FINE else "white"
    shade = "black" if row["least"] == "1" else right
    axes.plot([i], [height], "o", mfc=shade, mec="black", mew=0.8, markersize=6)


def _errors(axes: Any, models: list[Row]) -> None:
    axes.set(yscale="log", ylim=(EXACT, 1e3))
    axes.axhline(chart_style.FINE, color="black", linewidth=0.8, linestyle=(0, (1, 2)))
    for i, row in enumerate(models):
        error = number(row, "error_m")
        if math.isfinite(error):
            _dot(axes, i, max(error, EXACT * 5), row)
        else:
            axes.plot([i], [1e1], "x", color="black", markersize=6)
    axes.set(yticks=[1e-15, 1e-9, 1e-3, 1e3], xticks=range(len(models)))
    axes.set_xlim(-0.5, len(models) - 0.5)
    axes.tick_params(labelbottom=False)


def _times(axes: Any, models: list[Row]) -> None:
    axes.set(yscale="log", ylim=(10, 1e9))
    for i, row in enumerate(models):
        _dot(axes, i, number(row, "ns_per_simulated_second"), row)
    axes.set(yticks=[1e2, 1e5, 1e8], xticks=range(len(models)), xlim=(-0.5, len(models) - 0.5))


def chosen(tables: Tables) -> bytes:
    """Draws each model's share of the steps by scene, and the gain over Moreau–Jean."""
    table = tables["chosen_model"]
    step = table.distinct("dt_s")[1]
    scenes = table.distinct("scene")
    figure, axes = chart_style.pyplot().subplots(figsize=(chart_style.WIDTH, 4.4))
    for i, scene in enumerate(scenes):
        rows = table.where(scene=scene, dt_s=step)
        all_steps, left = sum(numbers(rows, "steps")), 0.0
        for row in rows:
            share = 100 * number(row, "steps") / all_steps
            label, color, hatch = MODELS[row["model"]]
            style = {"color": color, "hatch": hatch, "edgecolor": "black", "linewidth": 0.6}
            axes.barh(i, share, left=left, label=label if i == 0 else None, **style)
            left += share
        times = number(rows[0], "times_as_fast_as_moreau_jean")
        axes.text(101, i, f"{times:.2g} times as fast", va="center")
    axes.set_yticks(range(len(scenes)), list(map(scene_label, scenes)))
    axes.invert_yaxis()
    axes.set(xlim=(0, 100), xlabel=f"share of the steps, %, with Δt = {float(step):g} s")
    axes.grid(False)
    chart_style.legend_below(figure, axes, (0, 0.1, 0.99, 1), ncol=6)
    return chart_style.svg(figure)
