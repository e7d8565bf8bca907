"""The chart of where each method starts to fail: a panel for each failure."""

from typing import Any

import numpy as np

from bounce_study import style
from bounce_study.tables import Tables

LEAST_GAIN = 1e-12  # below it is rounding
FALL, DELTA, EPSILON = 9.81, 1e-3, 0.5  # g, m/s^2, delta, m, and epsilon of the table of depths
STEEPEST = np.pi / 4 + 1e-4  # rad, that the line to a square's lowest corner leans at most; rounded
NEEDS = tuple(
    "energy_gain rest_and_drift slope_and_energy restitution flat_landing depth gauss_seidel "
    "solution_count".split()
)


def draw(tables: Tables) -> bytes:
    figure, grid = style.pyplot().subplots(3, 3, figsize=(12.5, 11.5), layout="constrained")
    for axes, (title, panel) in zip(grid.flat, PANELS.items()):
        panel(axes, tables)
        axes.set_title(title)
        if axes.get_legend_handles_labels()[0]:
            axes.legend(fontsize=6.5, frameon=True, edgecolor="none", framealpha=0.9)
    return style.svg(figure)


def predicted_depth(table: Any) -> Any:
    """How deep theory lets a corner get that falls on the ground, m.

    The assignment's scheme sees a corner no sooner than after a whole step from just above delta.
    Moreau-Jean sees one that was just above the ground at the middle of a step a whole step lower,
    and lets it rise for half a step, epsilon times as fast.
    """
    way = table["v_dt_m"] + FALL * table["dt_s"] ** 2
    return np.where(table["method"] == "assignment", way - DELTA, (1 - EPSILON / 2) * way)


def _map(axes: Any, table: Any, x: str, y: str, value: str) -> Any:
    grid = table.pivot(index=y, columns=x, values=value)
    shown = np.ma.masked_invalid(grid.to_numpy())
    return axes.pcolormesh(
        grid.columns, grid.index, shown, cmap="cividis_r", shading="nearest", rasterized=True
    )


def _energy(axes: Any, tables: Tables) -> None:
    table = tables["energy_gain"]
    gain = table["newton"].where(table["newton"] > LEAST_GAIN)
    shades = _map(axes, table.assign(gain=gain), "mu", "epsilon", "gain")
    limit = table.drop_duplicates("mu")
    axes.plot(limit["mu"], limit["limit_epsilon"], "k--", label="theory: no gain below")
    axes.figure.colorbar(shades, ax=axes, label="energy gained / energy at the corner")
    axes.set(xlabel="μ", ylabel="ε", ylim=(0, 1))


def _rest(axes: Any, tables: Tables) -> None:
    table = tables["rest_and_drift"].query("method != 'event_driven'")
    away = table[["height_m", "depth_m", "drift_m"]].max(axis=1).clip(lower=1e-9)
    for method, rows in table.assign(away=away).groupby("method", sort=False):
        axes.plot(rows["setting"], rows["away"], **style.line(method))
    axes.set(xscale="log", yscale="log", xlabel="Δt, s")
    axes.set(ylabel="farthest in ten seconds of rest, m")


def _slope(axes: Any, tables: Tables) -> None:
    table = tables["slope_and_energy"].query("case == 'slope' and tilt_rad == 0.2")
    for method, rows in table[table["method"] != "event_driven"].groupby("method", sort=False):
        axes.plot(rows["setting"], rows["off"].clip(lower=1e-9), **style.line(method))
    axes.set(xscale="log", yscale="log", xlabel="Δt, s")
    axes.set(ylabel="off after 0.5 s on a slope of 0.2 rad, m")


def _restitution(axes: Any, tables: Tables) -> None:
    table = tables["restitution"].query("lands_on == 'face' and epsilon == @EPSILON")
    for method, rows in table[table["method"] != "event_driven"].groupby("method", sort=False):
        look = style.line(method)
        axes.plot(rows["setting"], rows[["least", "most"]].mean(axis=1), **look)
        axes.fill_between(
            rows["setting"], rows["least"], rows["most"], color=look["color"], alpha=0.15
        )
    axes.axhline(EPSILON, color="black", linewidth=0.8, label="ε")
    axes.set(xscale="log", ylim=(0.2, 0.8), xlabel="Δt, s")
    axes.set_ylabel("restitution that a face really gets")


def _landing(axes: Any, tables: Tables) -> None:
    for method, rows in tables["flat_landing"].groupby("method", sort=False):
        rows = rows.sort_values("theta_rad")
        axes.plot(rows["theta_rad"], rows["omega_rad_s"], **style.line(method))
    axes.set_xscale("symlog", linthresh=1e-16)
    tilts = np.array([1e-14, 1e-8, 1e-2])
    axes.set_xticks([*-tilts[::-1], 0, *tilts])
    axes.set(
        xlabel="θ at the start, rad: logarithmic on either side of 0",
        ylabel="ω after the landing, rad/s",
    )


def _depth(axes: Any, tables: Tables) -> None:
    table = tables["depth"].assign(predicted=predicted_depth(tables["depth"]))
    for method, rows in table[table["depth_m"] > 0].groupby("method", sort=False):
        marks = style.line(method) | {"linestyle": "none"}
        axes.plot(rows["predicted"], rows["depth_m"], **marks)
    axes.plot([1e-6, 2], [1e-6, 2], color="black", linewidth=0.8, label="theory")
    axes.set(xscale="log", yscale="log", ylabel="how deep a corner gets, m")
    axes.set(xlabel="v Δt + g Δt² − δ, and 3/4 (v Δt + g Δt²) for Moreau–Jean, m")


def _sweeps(axes: Any, tables: Tables) -> None:
    rows = tables["gauss_seidel"].query("problem == 'mass_ratio'")
    axes.plot(
        rows["value"], rows["sweeps"], "s", color=style.VERMILION, label="Gauss–Seidel, sweeps"
    )
    axes.plot(rows["value"], rows["predicted_sweeps"], "k-", label="theory")
    axes.plot(rows["value"], rows["lemke_pivots"], "v", color=style.BLUE, label="Lemke, pivots")
    axes.set(xscale="log", yscale="log", xlabel="R: mass of the upper square over the lower")


def _endless(axes: Any, tables: Tables) -> None:
    rows = tables["gauss_seidel"].query("problem == 'one_corner_mu'")
    axes.plot(rows["value"], 100 * rows["share_without_end"], "s-", color=style.VERMILION)
    axes.axvline(4 / 3, color="black", linestyle="--", label="theory: μ = 4/3")
    axes.set(xlabel="μ", ylabel="contacts of one corner without an end, %")


def _solutions(axes: Any, tables: Tables) -> None:
    table = tables["solution_count"]
    several = table["most_solutions"].where(table["most_solutions"] > 1)
    shades = _map(axes, table.assign(several=several), "alpha_rad", "mu", "several")
    color, most = shades.cmap(0), table["most_solutions"].max()
    axes.plot([], [], "s", color=color, label=f"up to {most} solutions; white: one")
    star = table.drop_duplicates("alpha_rad")
    axes.plot(star["alpha_rad"], star["mu_star"], "k-", label="theory: μ*")
    axes.axvspan(np.pi / 4, 1.57, color="#dddddd", alpha=0.6, label="another corner is lower")
    axes.set(ylim=(0, 4), ylabel="μ")
    axes.set(xlabel="α, rad: from the vertical to the line centre–corner")


PANELS = {  # by title, which the page's table repeats
    "Energy gained by Newton's law": _energy,
    "Never at rest": _rest,
    "Drift on a slope": _slope,
    "Another restitution": _restitution,
    "One corner where two touch": _landing,
    "Through the ground": _depth,
    "Gauss–Seidel is slow": _sweeps,
    "Gauss–Seidel never ends": _endless,
    "Several solutions": _solutions,
}
