"""Curves that show where a method starts to fail, and what doesn't."""

import math
from typing import Any

from bounce_study import look
from bounce_study.tables import number, numbers, Row, Tables

SMALLEST = 1e-17


def _loglog(axes: Any, x: list[float], y: list[float], style: look.Style, label: str = "") -> None:
    """A zero lies on the lower edge."""
    axes.set_xscale("log")
    axes.set_yscale("log")
    shown = [max(value, SMALLEST) for value in y]
    axes.plot(x, shown, label=label or style.label, **style.line())


def gauss_seidel(tables: Tables) -> bytes:
    table = tables["gauss_seidel"]
    plt = look.pyplot()
    figure, (left, right) = plt.subplots(1, 2, figsize=(look.WIDTH, 3.4))
    rows = table.where(problem="mass_ratio")
    measured = look.Style("measured", look.BLUE, "o", "none")
    _loglog(left, numbers(rows, "value"), numbers(rows, "sweeps"), measured)
    left.plot(
        numbers(rows, "value"),
        numbers(rows, "predicted_sweeps"),
        color="black",
        linewidth=1.0,
        label="predicted: a factor of R / (1 + R) a sweep",
    )
    left.set_xlabel("mass ratio R of two squares, the heavier on top")
    left.set_ylabel("sweeps until nothing changes by 1e-9 m/s")
    left.legend()
    rows = table.where(problem="one_corner_mu")
    right.plot(
        numbers(rows, "value"),
        [100 * share for share in numbers(rows, "share_without_end")],
        color=look.VERMILION,
        marker="s",
    )
    right.axvline(4 / 3, color="black", linestyle=(0, (4, 2)), linewidth=1.0)
    right.annotate("μ = 4/3", (4 / 3, 1), (-5, 0), textcoords="offset points", ha="right")
    right.set_xlabel("μ")
    right.set_ylabel("random contacts of one corner without end, %")
    figure.tight_layout()
    return look.svg(figure)


def depth(tables: Tables) -> bytes:
    table = tables["depth"]
    plt = look.pyplot()
    figure, axes = plt.subplots(figsize=(look.WIDTH * 0.8, 3.8))
    for method in table.distinct("method"):
        rows = sorted(table.where(method=method), key=lambda row: number(row, "v_dt_m"))
        rows = [row for row in rows if number(row, "depth_m") > 0]
        style = look.METHODS[method]
        _loglog(axes, numbers(rows, "v_dt_m"), numbers(rows, "depth_m"), style)
        axes.lines[-1].set_linestyle("none")
    ends = [1e-4, 2.0]
    axes.plot(ends, ends, color="black", linewidth=1.0, label="depth = v Δt")
    axes.axhline(0.2, color=look.GREY, linewidth=0.8)
    axes.text(1.1e-4, 0.22, "side of the square", color="#555555")
    axes.set_ylim(1e-6, 3)
    axes.set_xlabel("v Δt, m")
    axes.set_ylabel("how deep the corner gets, m")
    axes.legend(loc="lower right")
    figure.tight_layout()
    return look.svg(figure)


def almost_flat(tables: Tables) -> bytes:
    rows = [row for row in tables["almost_flat"].rows if number(row, "theta_rad") > 0]
    x = numbers(rows, "theta_rad")
    plt = look.pyplot()
    figure, axes = plt.subplots(figsize=(look.WIDTH * 0.8, 3.8))
    lemke = look.Style("8×8, Lemke", look.VERMILION, "s")
    literal = look.Style("merged rows, in the 8×8", look.ORANGE, "o", (0, (4, 2)))
    merged = look.Style("merged rows, in their own problem", look.BLUE, "v", (0, (2, 1)))
    _loglog(axes, x, numbers(rows, "lemke_8x8_residual_m_s"), lemke)
    _loglog(axes, x, numbers(rows, "merged_in_8x8_residual_m_s"), literal)
    _loglog(axes, x, numbers(rows, "merged_residual_m_s"), merged)
    axes.set_ylim(SMALLEST / 3, 30)
    axes.set_xlabel("θ, rad: how far the lower side is from flat")
    axes.set_ylabel("worst residual of what is called solved, m/s")
    axes.legend(loc="lower center", ncol=3)
    figure.tight_layout()
    return look.svg(figure)


def flat_landing(tables: Tables) -> bytes:
    table = tables["flat_landing"]
    plt = look.pyplot()
    figure, axes = plt.subplots(figsize=(look.WIDTH * 0.8, 3.8))
    for method in table.distinct("method"):
        rows = sorted(table.where(method=method), key=lambda row: number(row, "theta_rad"))
        style = look.METHODS[method]
        axes.plot(
            numbers(rows, "theta_rad"),
            numbers(rows, "omega_rad_s"),
            label=style.label,
            **style.line(),
        )
    axes.set_xscale("symlog", linthresh=1e-16)
    powers = (-2, -6, -10, -14)
    ticks = [-(10.0**p) for p in powers] + [0.0] + [10.0**p for p in reversed(powers)]
    axes.set_xticks(ticks)
    axes.minorticks_off()
    axes.set_xlabel("θ at the start, rad")
    axes.set_ylabel("ω after the landing, rad/s")
    axes.legend(loc="upper left", bbox_to_anchor=(0.08, 1))
    figure.tight_layout()
    return look.svg(figure)


def rest_and_drift(tables: Tables) -> bytes:
    table = tables["rest_and_drift"]
    plt = look.pyplot()
    figure, (left, right) = plt.subplots(1, 2, figsize=(look.WIDTH, 4.4))
    methods = [m for m in table.distinct("method") if table.where(method=m, setting_is="dt_s")]
    for method in methods:
        rows = table.where(method=method, setting_is="dt_s")
        x, style = numbers(rows, "setting"), look.METHODS[method]
        _loglog(left, x, [max(_away(row), 1e-9) for row in rows], style)
        _loglog(right, x, [max(value, 1e-9) for value in numbers(rows, "drift_m")], style)
    left.set_ylabel("farthest from its height in ten seconds, m")
    right.set_ylabel("farthest drift along the ground in ten seconds, m")
    for axes in (left, right):
        axes.set_xlabel("Δt, s")
        axes.set_ylim(5e-10, 1)
        axes.text(1.05e-4, 1.7e-9, "1e-9 m or less", color="#555555")
    handles, labels = left.get_legend_handles_labels()
    figure.tight_layout(rect=(0, 0.13, 1, 1))
    figure.legend(handles, labels, loc="lower center", ncol=3, handlelength=3.2)
    return look.svg(figure)


def _away(row: Row) -> float:
    return max(number(row, "height_m"), number(row, "depth_m"))


SOLVERS = (
    ("plain_lemke_error", look.Style("Lemke, plain, 1e-12", look.VERMILION, "s")),
    (
        "given_lemke_error",
        look.Style("Lemke, scaled: the handout's", look.ORANGE, "o", (0, (4, 2))),
    ),
    ("closed_form_error", look.Style("closed form", look.BLUE, "v", (0, (2, 1)))),
)


def scaling(tables: Tables) -> bytes:
    table = tables["scaling"]
    steps = table.distinct("dt_s")
    plt = look.pyplot()
    figure, grid = plt.subplots(1, len(steps), figsize=(look.WIDTH, 3.6), sharey=True)
    for axes, step in zip(grid, steps):
        rows = table.where(dt_s=step)
        for column, style in SOLVERS:
            y = [min(value, 1e2) for value in numbers(rows, column)]
            _loglog(axes, numbers(rows, "m_kg"), y, style)
        axes.set_title(f"Δt = {float(step):g} s")
        axes.set_xlabel("m, kg")
        axes.set_ylim(SMALLEST / 30, 1e3)
    grid[0].set_ylabel("relative error of the impulse")
    handles, labels = grid[0].get_legend_handles_labels()
    figure.tight_layout(rect=(0, 0.08, 1, 1))
    figure.legend(handles, labels, loc="lower center", ncol=3, handlelength=3.2)
    return look.svg(figure)


def is_wrong(row: Row, column: str) -> bool:
    return not math.isfinite(number(row, column)) or number(row, column) > 1e-6
