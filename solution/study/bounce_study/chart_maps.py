"""Charts over two parameters: the energy that an impact gains, and how many solutions it has."""

import math
from typing import Any

from bounce_study import chart_style
from bounce_study.tables import number, Row, Tables

SQUARE = math.pi / 4  # rad: the lowest corner of a square leans no farther
LEAST_GAIN = 1e-12  # below it is rounding
GAINS = (0.0, 0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 1.0)


def energy_gain(tables: Tables) -> bytes:
    import numpy as np

    table = tables["energy_gain"]
    laws = [law for law in table.distinct("law") if _gains(table.where(law=law))]
    plt = chart_style.pyplot()
    others = [law.capitalize() for law in table.distinct("law") if law not in laws]
    size = (chart_style.WIDTH * (0.35 + 0.25 * len(laws)), 4.0)
    figure, grid = plt.subplots(1, len(laws), figsize=size, sharey=True, squeeze=False)
    norm = plt.matplotlib.colors.BoundaryNorm(GAINS, 256)
    for axes, law in zip(grid[0], laws):
        x, y, gain = _mesh(table.where(law=law), "mu", "epsilon", "largest_gain")
        shades = np.ma.masked_less(gain, LEAST_GAIN)
        filled = axes.pcolormesh(
            x, y, shades, norm=norm, cmap="cividis_r", shading="nearest", rasterized=True
        )
        limits = {number(row, "mu"): number(row, "limit_epsilon") for row in table.where(law=law)}
        if law == "newton":
            dashed = {"color": "black", "linestyle": (0, (4, 2)), "lw": 1.6}
            axes.plot(list(limits), list(limits.values()), **dashed)
            axes.text(0.04, 0.62, "below the dashed line no gain\nis possible: analytic limit")
        axes.set(title=f"{law.capitalize()}'s law", xlabel="μ", ylim=(0, 1))
    if others:
        grid[0][-1].set_xlabel(f"μ      ({' and '.join(others)}: no gain anywhere, not drawn)")
    grid[0][0].set_ylabel("ε")
    figure.tight_layout(rect=(0, 0, 0.84, 1))
    bar = figure.add_axes((0.86, 0.18, 0.02, 0.7))
    figure.colorbar(filled, cax=bar, label="largest gain, share of the corner's energy")
    return chart_style.svg(figure)


def _gains(rows: list[Row]) -> bool:
    return any(number(row, "largest_gain") > LEAST_GAIN for row in rows)


def solution_count(tables: Tables) -> bytes:
    import numpy as np

    table = tables["solution_count"]
    plt = chart_style.pyplot()
    figure, axes = plt.subplots(figsize=(chart_style.WIDTH * 0.72, 4.2))
    one = plt.matplotlib.colors.ListedColormap([chart_style.SKY])
    x, y, count = _mesh(table.rows, "alpha_rad", "mu", "most_solutions")
    several = np.ma.masked_less(count, 2)
    axes.pcolormesh(x, y, several, cmap=one, shading="nearest", rasterized=True)
    axes.contourf(x, y, count, [2.5, 3.5], colors="none", hatches=["///"])
    stars = {number(row, "alpha_rad"): number(row, "mu_star") for row in table.rows}
    axes.plot(list(stars), list(stars.values()), color="black", label="μ*(α), where a = μ |b|")
    axes.axvspan(SQUARE, 1.57, color="#dddddd", alpha=0.45, zorder=3)
    axes.text(SQUARE + 0.03, 0.3, "longer rectangles:\nno square's lowest corner", zorder=4)
    leaning = "α, rad: how far the line from the centre to the corner leans"
    axes.set(xlim=(0, 1.57), ylim=(0, 4), xlabel=leaning, ylabel="μ")
    patches = plt.matplotlib.patches
    handles = [
        patches.Patch(facecolor="white", edgecolor="black", label="one solution always"),
        patches.Patch(facecolor=chart_style.SKY, hatch="///", label="three for some velocities"),
        *axes.get_legend_handles_labels()[0],
    ]
    axes.legend(handles=handles, loc="center left", bbox_to_anchor=(1.01, 0.5))
    figure.tight_layout()
    return chart_style.svg(figure)


def _mesh(rows: list[Row], x: str, y: str, value: str) -> tuple[list[float], list[float], Any]:
    values = {(number(row, x), number(row, y)): number(row, value) for row in rows}
    xs, ys = sorted({key[0] for key in values}), sorted({key[1] for key in values})
    return xs, ys, [[values[a, b] for a in xs] for b in ys]
