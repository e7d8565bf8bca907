"""Works out the facts of the page on measured impacts and drops from its tables."""

from typing import Any

from bounce_study.chart_measured import FAR, LAWS
from bounce_study.tables import number, Row, Tables

Facts = dict[str, Any]
ONE, TWO, ALL = "squares, one corner", "squares, two corners", "squares"
OVAL, BOTH = "ellipses", "both shapes, one corner"
CLASSES = {
    ONE: "a corner of a square",
    TWO: "a side that lands nearly flat",
    ALL: "all impacts of squares with one parameter set",
    OVAL: "ellipses",
    BOTH: "corners and ellipses with one parameter set",
}
# What the answer calls the laws.
IN_WORDS = {
    "frictionless": "Newton's restitution without friction",
    "sticking": "a corner that always sticks",
    "newton": "Newton's restitution with Coulomb's friction",
    "poisson_normal": "Poisson's restitution with friction in compression alone",
    "stronge_normal": "Stronge's restitution with friction in compression alone",
    "routh_poisson": "Coulomb's friction followed through the impact (Routh), with Poisson's "
    "restitution",
    "routh_stronge": "Coulomb's friction followed through the impact (Routh), with Stronge's "
    "restitution",
    "compliant": "a compliant contact, with a spring along the tangent under Coulomb's bound",
    "two_frictionless": "both corners at once without friction",
    "two_newton": "both corners at once with Newton's restitution and Coulomb's friction",
    "two_poisson": "both corners at once with Poisson's restitution and Coulomb's friction",
    "sequence_newton": "one corner after the other, each by Newton's restitution and Coulomb's "
    "friction",
    "sequence_routh": "one corner after the other, each by Coulomb's friction followed through the "
    "impact (Routh) with Stronge's restitution",
}
TIMES = ("0.1", "0.2", "0.3", "0.4", "0.5")  # s: of the table of drops
LEFT_OUT = "left out: "
LEVEL = 95  # % of an interval, as ladder.py draws it


def facts(tables: Tables) -> Facts:
    ladder = tables["measured_ladder"]
    groups = {name: _group(ladder.where(group=name)) for name in ladder.distinct("group")}
    values = {row["quantity"]: row["value"] for row in tables["measured_extraction"].rows}
    left_out = [
        (k.removeprefix(LEFT_OUT), int(v)) for k, v in values.items() if k.startswith(LEFT_OUT)
    ]
    bodies = tables["measured_bodies"]
    found = {
        (row["hypothesis"], row["quantity"]): _halves(row)
        for row in tables["measured_findings"].rows
    }
    return {
        "groups": groups,
        "one": groups[ONE],
        "two": groups[TWO],
        "all": groups[ALL],
        "oval": groups[OVAL],
        "both": groups[BOTH],
        "values": values,
        "least_words": _least_words(groups),
        "left_out": left_out,
        "left_share": 100 * sum(count for _, count in left_out) / int(values["events"]),
        "bodies": {name: _group(bodies.where(group=name)) for name in bodies.distinct("group")},
        "finding": found,
        "published_side": found["as published", "side, m"][0],
        "level": LEVEL,
        "inertia_steps": _steps(tables),
        "far": FAR / 1e3,
        **_drops(tables),
    }


def _group(rows: list[Row]) -> Facts:
    laws = {row["law"]: row for row in rows}
    least = next(row for row in rows if row["least"] == "1")
    best = next(row for row in rows if row["best"] == "1")
    return {
        "rows": rows,
        "laws": laws,
        "least": least,
        "best": best,
        "least_name": IN_WORDS.get(least["law"], LAWS[least["law"]]),
        "best_name": LAWS[best["law"]],
        "title": LAWS,
        "over_floor": number(best, "median_m_s") / max(number(best, "floor_m_s"), 1e-9),
    }


def _least_words(groups: dict[str, Facts]) -> dict[str, list[str]]:
    """The classes by their least model, in words."""
    classes: dict[str, list[str]] = {}
    for name, words in CLASSES.items():
        classes.setdefault(groups[name]["least_name"], []).append(words)
    return classes


def _halves(row: Row) -> tuple[float, float]:
    return number(row, "first_half"), number(row, "second_half")


def _steps(tables: Tables) -> list[tuple[str, dict[str, tuple[float, float]]]]:
    """What each hypothesis about the square makes of its inertia."""
    rows = tables["measured_findings"].where(about="inertia")
    steps: dict[str, dict[str, tuple[float, float]]] = {}
    for row in rows:
        steps.setdefault(row["hypothesis"], {})[row["quantity"]] = _halves(row)
    return [(name, own) for name, own in steps.items() if "side, m" in own]


def _drops(tables: Tables) -> Facts:
    table = tables["measured_drops"]
    models = table.distinct("model")
    at = {(row["model"], row["t_s"]): row for row in table.rows}
    horizon = {name: number(table.where(model=name)[0], "horizon_s") for name in models}
    first = number(table.rows[0], "first_impact_s")
    spread = {time: number(at[models[0], time], "spread_m") for time in TIMES}
    return {
        "drop_times": [float(time) for time in TIMES],
        "drop_rows": [
            (LAWS[name], [number(at[name, time], "median_m") for time in TIMES], horizon[name])
            for name in models
        ],
        "drop_count": table.rows[0]["drops"],
        "drop_first": first,
        "drop_spread": list(spread.values()),
        "drop_longest": max(horizon, key=lambda name: horizon[name]),
        "drop_horizon": horizon,
    }
