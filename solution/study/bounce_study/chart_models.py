"""No more model than a scene needs: the ladder, and what the simulator that chooses uses."""

import math
from typing import Any

from bounce_study import look
from bounce_study.tables import number, Row, Tables

MODELS = {
    "asleep": ("asleep", "#ffffff", ""),
    "ballistic": ("ballistic", look.SKY, ".."),
    "one_normal": ("1 corner, normal", look.ORANGE, "//"),
    "one_friction": ("1 corner, friction", look.VERMILION, "xx"),
    "two_normals": ("2 corners, normal", "#F0E442", "\\\\"),
    "two_frictions": ("2 corners, friction", look.BLUE, ""),
}
EXACT = 1e-16


def ladder(tables: Tables) -> bytes:
    """Error above, time below, for each scene; the least model within the line is black."""
    table = tables["least_model"]
    scenes = table.distinct("scene")
    plt = look.pyplot()
    columns = 4
    rows = math.ceil(len(scenes) / columns)
    figure = plt.figure(figsize=(look.WIDTH, 3.3 * rows + 0.4))
    outer = figure.add_gridspec(rows, columns, hspace=0.55, wspace=0.28)
    for i, scene in enumerate(scenes):
        inner = outer[i // columns, i % columns].subgridspec(2, 1, hspace=0.08)
        above, below = figure.add_subplot(inner[0]), figure.add_subplot(inner[1])
        own = table.where(scene=scene)
        _errors(above, own)
        _times(below, own)
        above.set_title(scene.replace("_", " "))
        if i % columns == 0:
            above.set_ylabel("error, m")
            below.set_ylabel("ns per s")
    figure.subplots_adjust(left=0.07, right=0.99, top=0.96, bottom=0.13)
    _model_key(figure, plt)
    return look.svg(figure)


def _model_key(figure: Any, plt: Any) -> None:
    words = "   ".join(f"{i}: {name}" for i, (name, _, _) in enumerate(MODELS.values()))
    figure.text(0.5, 0.055, words, ha="center")
    text = "black: the least within 1 mm      open: wrong      grey: right, and larger than needed"
    figure.text(0.5, 0.03, text + "      ×: ends at its cap on events", ha="center")


def _shades(own: list[Row]) -> list[str]:
    def shade(row: Row) -> str:
        if row["least"] == "1":
            return "black"
        return "#bbbbbb" if number(row, "error_m") <= look.FINE else "white"

    return [shade(row) for row in own]


def _errors(axes: Any, own: list[Row]) -> None:
    axes.set_yscale("log")
    axes.set_ylim(EXACT, 1e3)
    axes.axhline(look.FINE, color="black", linewidth=0.8, linestyle=(0, (1, 2)))
    for i, (row, shade) in enumerate(zip(own, _shades(own))):
        error = number(row, "error_m")
        if math.isfinite(error):
            axes.bar(i, max(error, EXACT * 5), color=shade, edgecolor="black", linewidth=0.7)
        else:
            axes.plot([i], [1e1], "x", color="black", markersize=6)
    axes.set_yticks([1e-15, 1e-9, 1e-3, 1e3])
    axes.set_xticks(range(len(own)))
    axes.tick_params(labelbottom=False)


def _times(axes: Any, own: list[Row]) -> None:
    axes.set_yscale("log")
    axes.set_ylim(10, 1e9)
    for i, (row, shade) in enumerate(zip(own, _shades(own))):
        time = number(row, "ns_per_simulated_second")
        axes.bar(i, time, color=shade, edgecolor="black", linewidth=0.7)
    axes.set_yticks([1e2, 1e5, 1e8])
    axes.set_xticks(range(len(own)))


def chosen(tables: Tables) -> bytes:
    """The share of the steps in each model, and how much faster than Moreau–Jean that is, by scene."""
    table = tables["chosen_model"]
    step = table.distinct("dt_s")[1]
    scenes = table.distinct("scene")
    plt = look.pyplot()
    figure, axes = plt.subplots(figsize=(look.WIDTH, 4.4))
    for i, scene in enumerate(scenes):
        own = table.where(scene=scene, dt_s=step)
        whole, left = sum(number(row, "steps") for row in own), 0.0
        for row in own:
            share = 100 * number(row, "steps") / whole
            label, color, hatch = MODELS[row["model"]]
            style = {"color": color, "hatch": hatch, "edgecolor": "black", "linewidth": 0.6}
            axes.barh(i, share, left=left, label=label if i == 0 else None, **style)
            left += share
        times = number(own[0], "times_as_fast_as_moreau_jean")
        axes.text(101, i, f"{times:.2g} times as fast", va="center")
    axes.set_yticks(range(len(scenes)), [scene.replace("_", " ") for scene in scenes])
    axes.invert_yaxis()
    axes.set_xlim(0, 100)
    axes.set_xlabel(f"share of the steps, %, with Δt = {float(step):g} s")
    axes.grid(False)
    figure.tight_layout(rect=(0, 0.1, 0.99, 1))
    handles, labels = axes.get_legend_handles_labels()
    figure.legend(handles, labels, loc="lower center", ncol=6)
    return look.svg(figure)
