"""Charts of measured impacts and drops."""

from typing import Any

from bounce_study import chart_style
from bounce_study import numbers as numbers_of
from bounce_study.tables import number, numbers, Row, Tables

LAWS = {
    "frictionless": "no friction",
    "sticking": "always sticks",
    "newton": "Newton (the assignment's)",
    "poisson_normal": "Poisson, normal only",
    "stronge_normal": "Stronge, normal only",
    "routh_poisson": "Routh with Poisson's",
    "routh_stronge": "Routh with Stronge's",
    "compliant": "compliant",
    "two_frictionless": "two corners, no friction",
    "two_newton": "two corners, Newton",
    "two_poisson": "two corners, Poisson",
    "sequence_newton": "corner after corner, Newton",
    "sequence_routh": "corner after corner, Routh",
    "assignment": "the assignment's scheme",
}
PANELS = ("squares, one corner", "squares, two corners", "ellipses")
FORECASTS = {
    "assignment": (chart_style.BLACK, (0, (4, 2))),
    "newton": (chart_style.VERMILION, "-"),
    "routh_stronge": (chart_style.BLUE, "-"),
    "compliant": (chart_style.GREEN, (0, (6, 1, 1, 1))),
    "two_newton": (chart_style.ORANGE, (0, (1, 1))),
}
FAR = 10.0  # mm


def ladder(tables: Tables) -> bytes:
    """Draws each law's judged median with its interval, beside the floor, for each class."""
    table = tables["measured_ladder"]
    groups = [table.where(group=name) for name in PANELS]
    heights = [len(rows) for rows in groups]
    figure, grid = chart_style.pyplot().subplots(
        len(groups),
        1,
        figsize=(chart_style.WIDTH * 0.8, 0.26 * sum(heights) + 0.75 * len(groups)),
        gridspec_kw={"height_ratios": heights},
        sharex=True,
    )
    for axes, name, rows in zip(grid, PANELS, groups):
        _rungs(axes, name, rows)
    grid[-1].set_xlabel("median error of the velocity after an impact, m/s")
    figure.tight_layout()
    return chart_style.svg(figure)


def _rungs(axes: Any, name: str, rows: list[Row]) -> None:
    axes.set(xscale="log", xlim=(4e-3, 4), ylim=(len(rows) - 0.4, -0.6))
    floor = [number(rows[0], column) for column in ("floor_low", "floor_m_s", "floor_high")]
    if floor[1] > 1e-4:
        axes.axvspan(floor[0], floor[2], color="#dddddd", zorder=0)
        axes.axvline(floor[1], color=chart_style.INK, linewidth=0.8)
        axes.annotate(
            "best impulse of all",
            (floor[1], 0),
            (6, 0),
            textcoords="offset points",
            va="center",
            fontsize=7,
        )
    for place, row in enumerate(rows):
        x = number(row, "median_m_s")
        low, high = number(row, "median_low"), number(row, "median_high")
        color = chart_style.BLUE if row["least"] == "1" else chart_style.INK
        quartiles = numbers([row], "lower_quartile") + numbers([row], "upper_quartile")
        axes.plot(quartiles, [place, place], color="#bbbbbb", linewidth=1.0, zorder=1)
        axes.plot([low, high], [place, place], color=color, linewidth=3.0, zorder=2)
        mark = "s" if row["least"] == "1" else "o"
        axes.plot([x], [place], mark, color=color, markersize=6 if mark == "s" else 4, zorder=3)
        text = " least model" if row["least"] == "1" else ""
        axes.annotate(
            f"{numbers_of.short(x)}{text}",
            (max(high, quartiles[1]), place),
            (5, 0),
            textcoords="offset points",
            va="center",
            fontsize=7,
        )
    axes.set_yticks(range(len(rows)))
    axes.set_yticklabels([LAWS[row["law"]] for row in rows])
    axes.set_title(f"{name}: {rows[0]['impacts_judged']} impacts judged", loc="left")
    axes.grid(axis="y", visible=False)


def drops(tables: Tables) -> bytes:
    """Draws the median error of the pose over time, and how fast two equal starts part."""
    table = tables["measured_drops"]
    figure, axes = chart_style.pyplot().subplots(figsize=(chart_style.WIDTH * 0.7, 4.2))
    axes.set(yscale="log", ylim=(1e-2, 1e2), xlabel="time after the start, ms")
    axes.set_ylabel("error of the pose, mm")
    for name, (color, dash) in FORECASTS.items():
        rows = table.where(model=name)
        t = [1e3 * v for v in numbers(rows, "t_s")]
        y = [1e3 * v for v in numbers(rows, "median_m")]
        axes.plot(t, y, color=color, linestyle=dash, label=LAWS[name], linewidth=1.3)
    t = [1e3 * v for v in numbers(rows, "t_s")]
    spread = [1e3 * v for v in numbers(rows, "spread_m")]
    axes.plot(
        t,
        spread,
        color=chart_style.GREY,
        linewidth=1.3,
        linestyle=(0, (3, 1, 1, 1, 1, 1)),
        label="two starts within the noise, apart",
    )
    axes.axhline(FAR, color="black", linewidth=0.8, linestyle=(0, (1, 2)))
    axes.annotate("the forecast ends", (0, FAR), (4, 3), textcoords="offset points", fontsize=7)
    first = 1e3 * number(table.rows[0], "first_impact_s")
    axes.axvline(first, color=chart_style.GREY, linewidth=0.8)
    axes.annotate(
        "first impact, median", (first, 1.3e-2), (4, 0), textcoords="offset points", fontsize=7
    )
    axes.legend(loc="lower right")
    figure.tight_layout()
    return chart_style.svg(figure)
