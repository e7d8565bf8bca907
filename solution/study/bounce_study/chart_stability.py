"""The chart of where each method starts to fail: a panel for each failure."""

from typing import Any

import numpy as np

from bounce_study import style
from bounce_study.tables import Tables

LEAST_GAIN = 1e-12  # below it is rounding
SMALLEST = 1e-17
NEEDS = tuple(
    "energy_gain rest_and_drift flat_landing depth gauss_seidel solution_count almost_flat "
    "scaling".split()
)


def draw(tables: Tables) -> bytes:
    panels = (_energy, _rest, _landing, _depth, _sweeps, _endless, _solutions, _flat, _scaling)
    figure, grid = style.pyplot().subplots(3, 3, figsize=(12.5, 11.5), layout="constrained")
    for axes, panel in zip(grid.flat, panels):
        panel(axes, tables)
        if axes.get_legend_handles_labels()[0]:
            axes.legend(fontsize=6.5)
    return style.svg(figure)


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
    axes.plot(limit["mu"], limit["limit_epsilon"], "k--", label="no gain below: analytic limit")
    axes.figure.colorbar(shades, ax=axes, label="share of the corner's energy")
    axes.set(title="Energy gained by Newton's law", xlabel="μ", ylabel="ε", ylim=(0, 1))


def _rest(axes: Any, tables: Tables) -> None:
    table = tables["rest_and_drift"].query("method != 'event_driven'")
    away = table[["height_m", "depth_m", "drift_m"]].max(axis=1).clip(lower=1e-9)
    for method, rows in table.assign(away=away).groupby("method", sort=False):
        axes.plot(rows["setting"], rows["away"], **style.line(method))
    axes.set(title="Never at rest", xscale="log", yscale="log")
    axes.set(xlabel="Δt, s", ylabel="farthest in ten seconds of rest, m")


def _landing(axes: Any, tables: Tables) -> None:
    for method, rows in tables["flat_landing"].groupby("method", sort=False):
        rows = rows.sort_values("theta_rad")
        axes.plot(rows["theta_rad"], rows["omega_rad_s"], **style.line(method))
    axes.set_xscale("symlog", linthresh=1e-16)
    tilts = np.array([1e-14, 1e-8, 1e-2])
    axes.set_xticks([*-tilts[::-1], 0, *tilts])
    axes.set(title="One corner where two touch")
    axes.set(xlabel="θ at the start, rad", ylabel="ω after the landing, rad/s")


def _depth(axes: Any, tables: Tables) -> None:
    for method, rows in tables["depth"].groupby("method", sort=False):
        axes.plot(rows["v_dt_m"], rows["depth_m"], **style.line(method) | {"linestyle": "none"})
    axes.plot([1e-4, 2], [1e-4, 2], color="black", linewidth=0.8, label="v Δt")
    axes.set(title="Through the ground", xscale="log", yscale="log", ylim=(1e-6, 3))
    axes.set(xlabel="v Δt, m", ylabel="how deep a corner gets, m")


def _sweeps(axes: Any, tables: Tables) -> None:
    rows = tables["gauss_seidel"].query("problem == 'mass_ratio'")
    axes.plot(rows["value"], rows["sweeps"], "o", color=style.BLUE, label="Gauss–Seidel, sweeps")
    axes.plot(rows["value"], rows["predicted_sweeps"], "k-", label="predicted")
    axes.plot(
        rows["value"], rows["lemke_pivots"], "s", color=style.VERMILION, label="Lemke, pivots"
    )
    axes.set(title="Two squares, one on the other", xscale="log", yscale="log", xlabel="mass ratio")


def _endless(axes: Any, tables: Tables) -> None:
    rows = tables["gauss_seidel"].query("problem == 'one_corner_mu'")
    axes.plot(rows["value"], 100 * rows["share_without_end"], "s-", color=style.VERMILION)
    axes.axvline(4 / 3, color="black", linestyle="--", label="μ = 4/3, the least μ*")
    axes.set(title="Gauss–Seidel without end", xlabel="μ", ylabel="contacts of one corner, %")


def _solutions(axes: Any, tables: Tables) -> None:
    table = tables["solution_count"]
    several = table["most_solutions"].where(table["most_solutions"] > 1)
    _map(axes, table.assign(several=several), "alpha_rad", "mu", "several")
    star = table.drop_duplicates("alpha_rad")
    axes.plot(star["alpha_rad"], star["mu_star"], "k-", label="μ*, where a = μ |b|")
    axes.axvspan(np.pi / 4, 1.57, color="#dddddd", alpha=0.6, label="no square's lowest corner")
    axes.set(title="Several solutions", ylim=(0, 4), ylabel="μ")
    axes.set(xlabel="α, rad: how far the line to the corner leans")


def _flat(axes: Any, tables: Tables) -> None:
    rows = tables["almost_flat"]
    lines = {"lemke_8x8_residual_m_s": ("8×8, Lemke", style.VERMILION, "s")}
    lines["merged_residual_m_s"] = ("merged rows", style.BLUE, "v")
    for column, (name, color, mark) in lines.items():
        residual = rows[column].clip(lower=SMALLEST)
        axes.plot(rows["theta_rad"], residual, marker=mark, color=color, label=name)
    axes.set(title="Almost flat", xscale="log", yscale="log")
    axes.set(xlabel="θ of the side, rad", ylabel="worst residual of “solved”, m/s")


def _scaling(axes: Any, tables: Tables) -> None:
    for (dt, rows), dash in zip(tables["scaling"].groupby("dt_s"), (":", "--", "-")):
        error = rows["plain_lemke_error"].clip(SMALLEST, 1e2)
        axes.plot(rows["m_kg"], error, dash, color=style.VERMILION, label=f"Lemke, Δt {dt:g} s")
    closed = tables["scaling"].groupby("m_kg")["closed_form_error"].max()
    axes.plot(closed.index, closed, color=style.BLUE, marker="v", label="closed form, any Δt")
    axes.set(title="Scales", xscale="log", yscale="log")
    axes.set(xlabel="m, kg", ylabel="relative error of the impulse")
