"""Works out the facts of the page on speed and accuracy from its tables."""

import math
from statistics import linear_regression, median_high
from typing import Any

from bounce_study import analytic, chart_speed, facts_peers, measurements
from bounce_study.chart_style import FINE, FINEST
from bounce_study.measurements import Run
from bounce_study.tables import number, numbers, Tables

README_SCENE = chart_speed.README_SCENE
ENDS = 1e300  # less than the infinite ratio of a method that never gets there
Facts = dict[str, Any]


def facts(tables: Tables) -> Facts:
    runs = measurements.read(tables)
    ours = [run for run in runs if not run.peer]
    scenes = measurements.scenes(ours)
    compared = measurements.compared(tables)
    source = "peers_beside" if compared else "speed_accuracy"
    analytic_checks = analytic.checks(tables)
    return {
        "scenes": len(scenes),
        "methods": len(measurements.methods(ours)),
        "runs": len(ours),
        **{name: tables[source].origin.get(name, "?") for name in ("machine", "times", "date")},
        "ours_csv": source,
        "peers": measurements.peers(runs),
        "engines": len(_engines(runs)),
        "peer_leads": _peer_leads(tables, scenes) if compared else [],
        "peer_closest": _peer_closest(tables) if compared else None,
        "analytic_checks": analytic_checks,
        "analytic_worst": max(analytic_checks, key=lambda check: check.error),
        **_fastest(ours),
        "fixed_reached": _reached(ours, "assignment_fast", FINE),
        "scaled_reached": _reached(ours, "assignment_delta_dt", FINE),
        "failures": _failures(runs),
        "tipped": _tipped(tables),
        "truth_apart": _truth_apart(ours),
        "starts": measurements.STARTS,
        "step_ratio": measurements.step_ratio(ours),
        "steps": [run.setting for run in ours if run.step],
        "profile": _profile(runs),
        "profile_problems": len(scenes) * len(measurements.TOLERANCES),
        "tolerances": measurements.TOLERANCES,
        "order": _order(tables),
        "low_orders": _low_orders(tables),
        "panel": _panel(ours),
        **_ratios(ours, tables),
    }


def _reached(runs: list[Run], method: str, tolerance: float) -> int:
    """Counts the scenes in which the method comes within the tolerance."""
    return len({run.scene for run in runs if run.method == method and run.error <= tolerance})


def _fastest(ours: list[Run]) -> Facts:
    """Finds the fastest and the second method in each scene, for both tolerances."""

    def fastest(scene: str, tolerance: float) -> list[Run | None]:
        return [*measurements.ranking(ours, scene, tolerance), None, None][:2]

    def others(place: int) -> list[Facts]:
        firsts = [(scene, runs[place]) for scene, runs in rows]
        methods = [(scene, run.method if run else "no method") for scene, run in firsts]
        return [{"scene": s, "method": m} for s, m in methods if m != "event_driven"]

    scenes = measurements.scenes(ours)
    rows = [(scene, fastest(scene, FINE) + fastest(scene, FINEST)) for scene in scenes]
    return {"fastest": rows, "other_wins": others(0), "other_wins_finest": others(2)}


def _peer_leads(tables: Tables, scenes: list[str]) -> list[Facts]:
    """Compares our best with the best of the engines, for both tolerances."""
    leads = []
    for tolerance, name in ((FINE, "a millimetre"), (FINEST, "a micrometre")):
        ratios = [_least_ratio(tables, scene, tolerance) for scene in scenes]
        ahead = sum(ratio > 1 for ratio in ratios)
        missed = sum(map(math.isinf, ratios))
        leads.append({"tolerance": name, "ahead": ahead, "missed": missed})
    return leads


def _engines(runs: list[Run]) -> set[str]:
    names = set(measurements.peers(runs)) - set(measurements.SAME_SCHEME)
    return {facts_peers.engine_of(name) for name in names}


def _peer_closest(tables: Tables) -> Facts | None:
    """Finds the engine, scene and step that come closest to ours at the same error."""
    scenes = {row["scene"] for row in tables["peers_ratios"].rows}
    rows = [row for scene in sorted(scenes) for row in facts_peers.compared(tables, scene)]
    if not rows:
        return None
    closest = min(rows, key=lambda row: float(row["times"] or 0))
    titles = facts_peers.titles(tables)
    return {**closest, "title": titles.get(closest["engine"], closest["engine"])}


def _least_ratio(tables: Tables, scene: str, tolerance: float) -> float:
    """Says how many times as long the closest engine takes to come within the tolerance, by the
    median over the rounds; infinite where none does, 0 where none of ours does."""
    rows = tables["peers_ratios"].where(scene=scene, within="tolerance")
    own = [row for row in rows if math.isclose(number(row, "error_m"), tolerance)]
    return min((number(row, "times") if row["times"] else 0.0 for row in own), default=math.inf)


def _ratios(ours: list[Run], tables: Tables) -> Facts:
    """Divides the time of each method by the plain scheme's."""
    ratios = tables["speed_ratios"]
    rows = []
    for method in measurements.methods(ours):
        times = numbers(ratios.where(method=method), "times_of_assignment")
        reached = [_reached(ours, method, tolerance) for tolerance in (FINE, FINEST)]
        rows.append((method, *reached, median_high(times), min(times), max(times)))
    fast = ratios.where(method="assignment_fast")
    return {
        "by_method": rows,
        "fast_gains": [1 / time for time in numbers(fast, "times_of_assignment")],
        "ratio_dt": number(fast[0], "setting"),
    }


def _failures(runs: list[Run]) -> list[Facts]:
    """Lists for each method and reason the scenes in which it stays above the tolerance."""
    failures: dict[tuple[str, str], list[Run]] = {}
    for method in measurements.methods(runs):
        for scene in measurements.scenes(runs):
            own = measurements.of(runs, scene, method)
            reason = measurements.failure(own, FINE)
            if reason:
                least = min(own, key=lambda run: run.error)
                failures.setdefault((method, reason), []).append(least)
    return [
        {"method": method, "reason": reason, "least": least}
        for (method, reason), least in failures.items()
    ]


def _tipped(tables: Tables) -> Facts:
    """How a tipping square leaves the ground, by springs and by Newton's law for both corners."""
    rows = {row["quantity"]: number(row, "value") for row in tables["examples"].rows}
    names = {"held": "v_n of the held corner", "other": "v_n of the other corner", "omega": "omega"}
    return {
        law: {key: rows[f"{name}, {law}"] for key, name in names.items()}
        for law in ("springs", "Newton")
    }


def _truth_apart(ours: list[Run]) -> float:
    """Says how far the tightest event-driven run in double gets from the truth in long double."""
    event_driven = [run for run in ours if run.method == "event_driven"]
    tightest = min(run.setting for run in event_driven)
    return max(run.error for run in event_driven if run.setting == tightest)


def _low_orders(tables: Tables) -> list[Facts]:
    """Finds the scenes where delta in proportion to dt converges with an order below one, over the
    finer half of the steps."""
    table, low = tables["order"], []
    for scene in table.distinct("scene"):
        rows = table.where(scene=scene, method="assignment_delta_dt")
        ends = [rows[len(rows) // 2], rows[-1]]
        if min(numbers(ends, "error_m")) > 0:
            error, other_error = map(math.log, numbers(ends, "error_m"))
            dt, other_dt = map(math.log, numbers(ends, "dt_s"))
            order = (error - other_error) / (dt - other_dt)
            if 0.2 < order < 0.75:
                low.append({"scene": scene, "order": order})
    return low


def _order(tables: Tables) -> Facts:
    """Measures how a scheme that shares only the model with the truth converges to it."""
    table = tables["order"]
    slopes, last = {}, {}
    for scene in table.distinct("scene"):
        rows = table.where(scene=scene, method="moreau_jean_2")
        errors = numbers(rows, "error_m")
        last[scene] = errors[-1]
        if errors[0] > 1e-9 and errors[-1] > 1e-12:
            x, y = map(math.log, numbers(rows, "dt_s")), map(math.log, errors)
            slopes[scene] = linear_regression(list(x), list(y)).slope
    return {
        "slopes": list(slopes.values()),
        "median": median_high(slopes.values()),
        "least_scene": min(slopes, key=lambda scene: slopes[scene]),
        "worst": max(last.values()),
        "worst_scene": max(last, key=lambda scene: last[scene]),
        "finest": min(numbers(table.rows, "dt_s")),
    }


def _panel(ours: list[Run]) -> Facts:
    """Describes the panel that the README shows."""
    ranking = measurements.ranking(ours, README_SCENE, FINE)
    fixed = measurements.of(ours, README_SCENE, "assignment_fast")
    return {
        "scene": README_SCENE,
        "first": ranking[0],
        "stepping": next((run for run in ranking if run.step), None),
        "fixed": min(run.error for run in fixed),
    }


def _profile(runs: list[Run]) -> list[tuple[str, list[float]]]:
    """Gives for each method the shares of the problems in which it is the fastest, takes at most
    ten times as long as the fastest, and gets there at all."""
    return [
        (method, [sum(r <= most for r in ratios) / len(ratios) for most in (1, 10, ENDS)])
        for method, ratios in chart_speed.profiles(runs).items()
    ]
