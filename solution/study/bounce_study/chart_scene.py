"""The picture of ./kit study simulate: the motion, what each model gets wrong, and time over error
of the methods."""

from typing import Any

import numpy as np

from bounce_study import style

SQUARES = 12  # of the motion that are drawn
NEVER = 1e3  # m: where the bar of a model ends whose impacts go on without an end
LEAST = 1e-17


def draw(answer: dict[str, Any], side: float, tolerance: float) -> bytes:
    layout = {"figsize": (14.5, 4.2), "layout": "constrained", "width_ratios": [1, 1, 1, 0.55]}
    figure, (motion, models, methods, key) = style.pyplot().subplots(1, 4, **layout)
    _motion(motion, np.array(answer["q"]), side)
    _models(models, answer["models"], tolerance)
    _methods(methods, answer["methods"])
    for axes, line in ((models, models.axvline), (methods, methods.axvline)):
        line(tolerance, color="black", linewidth=0.8, linestyle=(0, (1, 2)), label="tolerance")
        axes.set(xscale="log", xlabel="error, m")
    key.axis("off")  # beside the data
    key.legend(*methods.get_legend_handles_labels(), loc="center left", fontsize=6.5)
    return style.svg(figure)


def _motion(axes: Any, q: Any, side: float) -> None:
    corners = side / 2 * np.array([[1, -1, -1, 1, 1], [1, 1, -1, -1, 1]])
    for x, y, theta in q[np.linspace(0, len(q) - 1, min(SQUARES, len(q))).astype(int)]:
        turn = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])
        axes.plot(*(turn @ corners + [[x], [y]]), color=style.BLUE, linewidth=0.7)
    axes.plot(q[:, 0], q[:, 1], color=style.VERMILION)
    axes.axhline(0, color="black")
    axes.set(title="the motion, its centre in red", xlabel="x, m", ylabel="y, m", aspect="equal")
    axes.locator_params(axis="x", nbins=4)  # a high motion leaves little room below it


def _models(axes: Any, models: Any, tolerance: float) -> None:
    errors = np.array([NEVER if model["error"] is None else model["error"] for model in models])
    least = [model["least"] for model in models]
    shades = np.select([least, errors <= tolerance], ["black", "#bbbbbb"], "white")
    names = [style.MODELS[model["model"]] for model in models]
    axes.barh(names, np.clip(errors, 10 * LEAST, NEVER), left=LEAST, color=shades, ec="black")
    for place, model in enumerate(models):
        if model["error"] is None:
            axes.text(
                10 * LEAST, place, "its impacts go on without an end", va="center", fontsize=6.5
            )
    axes.invert_yaxis()
    axes.set(title="models: black the least within, white wrong", xlim=(LEAST, NEVER))


def _methods(axes: Any, runs: Any) -> None:
    for method in dict.fromkeys(run["method"] for run in runs):
        own = [run for run in runs if run["method"] == method and run["error"] is not None]
        errors = np.clip([run["error"] for run in own], 1e-9, None)
        axes.plot(errors, [run["ns"] for run in own], **style.line(method))
    within = [run for run in runs if run["within"]]
    if within:
        best = min(within, key=lambda run: run["ns"])
        ring = {"marker": "o", "markersize": 9, "fillstyle": "none", "linestyle": "none"}
        axes.plot(max(best["error"], 1e-9), best["ns"], color="black", label="cheapest", **ring)
    axes.set(yscale="log", ylabel="CPU time, ns", title="methods: left and below is better")
