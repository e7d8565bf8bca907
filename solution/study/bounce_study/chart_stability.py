"""Charts of where each method starts to fail, and of the methods that don't."""

import math
from typing import Any

from bounce_study import chart_style
from bounce_study.chart_style import Style
from bounce_study.tables import number, numbers, Row, Tables

SMALLEST = 1e-17


def _loglog(axes: Any, x: list[float], y: list[float], style: Style) -> None:
    """Draws a line; a zero lies on the lower edge."""
    axes.set(xscale="log", yscale="log")
    axes.plot(x, [max(value, SMALLEST) for value in y], label=style.label, **style.line())


def _wide_panel() -> tuple[Any, Any]:
    figure, axes = chart_style.pyplot().subplots(figsize=(chart_style.WIDTH * 0.8, 3.8))
    return figure, axes


def gauss_seidel(tables: Tables) -> bytes:
    table = tables["gauss_seidel"]
    figure, (left, right) = chart_style.pyplot().subplots(1, 2, figsize=(chart_style.WIDTH, 3.4))
    rows = table.where(problem="mass_ratio")
    measured = Style("measured", chart_style.BLUE, "o", "none")
    _loglog(left, numbers(rows, "value"), numbers(rows, "sweeps"), measured)
    predicted = {"linewidth": 1.0, "label": "predicted: a factor of R / (1 + R) a sweep"}
    left.plot(numbers(rows, "value"), numbers(rows, "predicted_sweeps"), color="black", **predicted)
    left.set_xlabel("mass ratio R: the upper square's over the lower's")
    left.set_ylabel("sweeps until nothing changes by 1e-9 m/s")
    left.legend()
    rows = table.where(problem="one_corner_mu")
    endless = [100 * share for share in numbers(rows, "share_without_end")]
    right.plot(numbers(rows, "value"), endless, color=chart_style.VERMILION, marker="s")
    right.axvline(4 / 3, color="black", linestyle=(0, (4, 2)), linewidth=1.0)
    right.annotate("μ = 4/3", (4 / 3, 1), (-5, 0), textcoords="offset points", ha="right")
    right.set(xlabel="μ", ylabel="random contacts of one corner without end, %")
    figure.tight_layout()
    return chart_style.svg(figure)


def depth(tables: Tables) -> bytes:
    table = tables["depth"]
    figure, axes = _wide_panel()
    for method in table.distinct("method"):
        rows = sorted(table.where(method=method), key=lambda row: number(row, "v_dt_m"))
        rows = [row for row in rows if number(row, "depth_m") > 0]
        style = chart_style.METHODS[method]
        _loglog(axes, numbers(rows, "v_dt_m"), numbers(rows, "depth_m"), style)
        axes.lines[-1].set_linestyle("none")
    ends = [1e-4, 2.0]
    axes.plot(ends, ends, color="black", linewidth=1.0, label="depth = v Δt")
    axes.axhline(0.2, color=chart_style.GREY, linewidth=0.8)
    axes.text(1.1e-4, 0.22, "side of the square", color="#555555")
    axes.set(ylim=(1e-6, 3), xlabel="v Δt, m", ylabel="how deep the corner gets, m")
    axes.legend(loc="lower right")
    figure.tight_layout()
    return chart_style.svg(figure)


def almost_flat(tables: Tables) -> bytes:
    rows = [row for row in tables["almost_flat"].rows if number(row, "theta_rad") > 0]
    x = numbers(rows, "theta_rad")
    figure, axes = _wide_panel()
    lemke = Style("8×8, Lemke", chart_style.VERMILION, "s")
    literal = Style("merged rows, in the 8×8", chart_style.ORANGE, "o", (0, (4, 2)))
    merged = Style("merged rows, in their own problem", chart_style.BLUE, "v", (0, (2, 1)))
    _loglog(axes, x, numbers(rows, "lemke_8x8_residual_m_s"), lemke)
    _loglog(axes, x, numbers(rows, "merged_in_8x8_residual_m_s"), literal)
    _loglog(axes, x, numbers(rows, "merged_residual_m_s"), merged)
    axes.set_ylim(SMALLEST / 3, 30)
    axes.set_xlabel("θ, rad: how far the lower side is from flat")
    axes.set_ylabel("worst residual of what is called solved, m/s")
    axes.legend(loc="lower center", ncol=3)
    figure.tight_layout()
    return chart_style.svg(figure)


def flat_landing(tables: Tables) -> bytes:
    table = tables["flat_landing"]
    figure, axes = _wide_panel()
    for method in table.distinct("method"):
        rows = sorted(table.where(method=method), key=lambda row: number(row, "theta_rad"))
        style = chart_style.METHODS[method]
        x, y = numbers(rows, "theta_rad"), numbers(rows, "omega_rad_s")
        axes.plot(x, y, label=style.label, **style.line())
    axes.set_xscale("symlog", linthresh=1e-16)
    tilts = [10.0**power for power in (-14, -10, -6, -2)]
    axes.set_xticks([-tilt for tilt in reversed(tilts)] + [0.0] + tilts)
    axes.minorticks_off()
    axes.set(xlabel="θ at the start, rad", ylabel="ω after the landing, rad/s")
    axes.legend(loc="upper left", bbox_to_anchor=(0.08, 1))
    figure.tight_layout()
    return chart_style.svg(figure)


def rest_and_drift(tables: Tables) -> bytes:
    table = tables["rest_and_drift"]
    figure, (left, right) = chart_style.pyplot().subplots(1, 2, figsize=(chart_style.WIDTH, 4.8))
    methods = [m for m in table.distinct("method") if table.where(method=m, setting_is="dt_s")]
    for method in methods:
        rows = table.where(method=method, setting_is="dt_s")
        x, style = numbers(rows, "setting"), chart_style.METHODS[method]
        _loglog(left, x, [max(distance(row), 1e-9) for row in rows], style)
        _loglog(right, x, [max(value, 1e-9) for value in numbers(rows, "drift_m")], style)
    left.set_ylabel("farthest from its height in ten seconds, m")
    right.set_ylabel("farthest drift along the ground in ten seconds, m")
    for axes in (left, right):
        axes.set(xlabel="Δt, s", ylim=(5e-10, 1))
        axes.text(1.05e-4, 1.7e-9, "1e-9 m or less", color="#555555")
    event_driven = table.where(method="event_driven")
    if event_driven:  # it has no step
        still = max(max(distance(row), number(row, "drift_m")) for row in event_driven)
        line = chart_style.METHODS["event_driven"].line() | {"marker": "none"}
        for axes in (left, right):
            axes.axhline(max(still, 1e-9), label="event-driven (no step)", **line, zorder=1)
    for axes, place in ((left, 0.08), (right, 0.56)):
        figure.text(place, 0.01, _coincident(axes), va="bottom", fontsize=7, color="#555555")
    chart_style.legend_below(
        figure, left, (0, 0.22, 1, 1), ncol=3, handlelength=3.2, bbox_to_anchor=(0.5, 0.08)
    )
    return chart_style.svg(figure)


def _coincident(axes: Any) -> str:
    """Says which lines lie upon each other, to a tenth of a decade."""
    lines: dict[tuple[float, ...], list[str]] = {}
    for line in axes.lines:
        if len(line.get_ydata()) > 2:
            heights = tuple(round(10 * math.log10(value)) for value in line.get_ydata())
            lines.setdefault(heights, []).append(line.get_label())
    upon = [" on ".join(reversed(names)) for names in lines.values() if len(names) > 1]
    return "\n".join(f"upon each other: {names}" for names in upon)


def distance(row: Row) -> float:
    """The largest distance from the height at which the square was laid."""
    return max(number(row, "height_m"), number(row, "depth_m"))


SOLVERS = (
    ("plain_lemke_error", Style("Lemke, plain, 1e-12", chart_style.VERMILION, "s")),
    (
        "given_lemke_error",
        Style("Lemke, scaled: the handout's", chart_style.ORANGE, "o", (0, (4, 2))),
    ),
    ("closed_form_error", Style("closed form", chart_style.BLUE, "v", (0, (2, 1)))),
)


def scaling(tables: Tables) -> bytes:
    table = tables["scaling"]
    steps = table.distinct("dt_s")
    figure, grid = chart_style.pyplot().subplots(
        1, len(steps), figsize=(chart_style.WIDTH, 3.6), sharey=True
    )
    for axes, step in zip(grid, steps):
        rows = table.where(dt_s=step)
        for column, style in SOLVERS:
            y = [min(value, 1e2) for value in numbers(rows, column)]
            _loglog(axes, numbers(rows, "m_kg"), y, style)
        axes.set(title=f"Δt = {float(step):g} s", xlabel="m, kg", ylim=(SMALLEST / 30, 1e3))
    grid[0].set_ylabel("relative error of the impulse")
    chart_style.legend_below(figure, grid[0], (0, 0.08, 1, 1), ncol=3, handlelength=3.2)
    return chart_style.svg(figure)


def is_wrong(row: Row, column: str) -> bool:
    return not math.isfinite(number(row, column)) or number(row, column) > 1e-6
