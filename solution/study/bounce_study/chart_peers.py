"""One step of each engine, in flight and in contact."""

from typing import Any

from bounce_study import look, words
from bounce_study.tables import number, Row, Tables

KINDS = (("contact", look.BLUE, ""), ("flight", look.SKY, "////"))
HEIGHT = 0.38  # of a bar; a row is 1


def steps(tables: Tables) -> bytes:
    """Bars of the time, with quartiles, and beside each its ratio to our fastest form."""
    table = tables["peers_steps"]
    titles = {row["engine"]: row["title"] for row in tables["peers_settings"].rows}
    contact = table.where(kind="contact")
    order = [row["engine"] for row in sorted(contact, key=lambda row: -number(row, "ns_per_step"))]
    plt = look.pyplot()
    figure, axes = plt.subplots(figsize=(look.WIDTH * 0.8, 0.42 * len(order) + 0.9))
    axes.set_xscale("log")
    for i, (kind, color, hatch) in enumerate(KINDS):
        rows = {row["engine"]: row for row in table.where(kind=kind)}
        at = [place + (0.5 - i) * HEIGHT for place in range(len(order))]
        _bars(axes, at, [rows[engine] for engine in order], color, hatch, kind)
    axes.set_yticks(range(len(order)))
    axes.set_yticklabels([titles.get(engine) or words.method(engine) for engine in order])
    axes.set_xlim(1, 8 * max(number(row, "ns_per_step") for row in table.rows))
    axes.set_xlabel("CPU time of a step, ns; at the end of a bar: times our fastest form's")
    axes.grid(axis="y", visible=False)
    axes.legend(loc="lower right")
    figure.tight_layout()
    return look.svg(figure)


def _bars(axes: Any, at: list[float], rows: list[Row], color: str, hatch: str, label: str) -> None:
    ns = [number(row, "ns_per_step") for row in rows]
    below = [x - number(row, "lower_quartile") for x, row in zip(ns, rows)]
    above = [number(row, "upper_quartile") - x for x, row in zip(ns, rows)]
    axes.barh(
        at,
        ns,
        HEIGHT,
        xerr=(below, above),
        color=color,
        hatch=hatch,
        edgecolor="white",
        linewidth=0,
        error_kw={"elinewidth": 0.8, "capsize": 2},
        label=label,
    )
    for place, x, row in zip(at, ns, rows):
        spot = max(x, number(row, "upper_quartile"))
        times = words.times(number(row, "ratio"))
        axes.annotate(
            times, (spot, place), (4, 0), textcoords="offset points", va="center", fontsize=7
        )
