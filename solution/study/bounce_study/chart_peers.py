"""The chart of one step of each engine, in flight and in contact."""

from typing import Any

from bounce_study import chart_style, numbers
from bounce_study.tables import number, Row, Tables

KINDS = (("contact", chart_style.BLUE, "o"), ("flight", chart_style.VERMILION, "D"))
APART = 0.3  # between the two kinds of a row, whose height is 1


def steps(tables: Tables) -> bytes:
    """Draws the times as dots, with quartiles, and beside each its ratio to our fastest form."""
    table = tables["peers_steps"]
    titles = {row["engine"]: row["title"] for row in tables["peers_settings"].rows}
    contact = table.where(kind="contact")
    order = [row["engine"] for row in sorted(contact, key=lambda row: -number(row, "ns_per_step"))]
    size = (chart_style.WIDTH * 0.8, 0.42 * len(order) + 0.9)
    figure, axes = chart_style.pyplot().subplots(figsize=size)
    axes.set_xscale("log")
    for i, (kind, color, mark) in enumerate(KINDS):
        rows = {row["engine"]: row for row in table.where(kind=kind)}
        style = {"color": color, "fmt": mark, "markersize": 5}
        places = [place + (0.5 - i) * APART for place in range(len(order))]
        _dots(axes, places, [rows[engine] for engine in order], label=kind, **style)
    axes.set_yticks(range(len(order)))
    axes.set_yticklabels([titles.get(name) or chart_style.method_label(name) for name in order])
    axes.set_xlim(1, 8 * max(number(row, "ns_per_step") for row in table.rows))
    axes.set_xlabel("CPU time of a step, ns; beside a dot: times our fastest form's")
    axes.grid(axis="y", visible=False)
    axes.legend(loc="upper right")
    figure.tight_layout()
    return chart_style.svg(figure)


def _dots(axes: Any, places: list[float], rows: list[Row], **style: Any) -> None:
    ns = [number(row, "ns_per_step") for row in rows]
    below = [x - number(row, "lower_quartile") for x, row in zip(ns, rows)]
    above = [number(row, "upper_quartile") - x for x, row in zip(ns, rows)]
    axes.errorbar(ns, places, xerr=(below, above), elinewidth=0.8, capsize=2, **style)
    beside = {"textcoords": "offset points", "va": "center", "fontsize": 7}
    for place, x, row in zip(places, ns, rows):
        end = max(x, number(row, "upper_quartile"))
        axes.annotate(numbers.ratio(number(row, "ratio")), (end, place), (4, 0), **beside)
