"""What the page on speed and accuracy says, from its tables."""

import math

from bounce_study import analytic, chart_speed, look, runs, words
from bounce_study.runs import Run
from bounce_study.tables import number, Tables

FINE, FINER = 1e-3, 1e-6  # m
README_SCENE = chart_speed.README_SCENE


def facts(tables: Tables) -> dict[str, str]:
    all_runs = runs.runs(tables)
    ours = [run for run in all_runs if not run.peer]
    scenes = runs.scenes(ours)
    first = {(s, t): runs.fastest(ours, s, t) for s in scenes for t in (FINE, FINER)}
    wins = sum(first[s, FINE] == "event_driven" for s in scenes)
    return {
        "scenes": str(len(scenes)),
        "methods": str(len(runs.methods(ours))),
        "runs": str(len(ours)),
        **_origin(runs.origin(tables)),
        "ours_csv": "peers_beside" if runs.compared(tables) else "speed_accuracy",
        "peers": _peers(all_runs, tables),
        "peers_row": _peers_row(all_runs, tables),
        **_analytic(tables),
        "event_wins": str(wins),
        "event_wins_finer": str(sum(first[s, FINER] == "event_driven" for s in scenes)),
        "other_wins": words.listed(_others(first, scenes, FINE)),
        "fixed_reached": str(_reached(ours, scenes, "assignment_fast")),
        "scaled_reached": str(_reached(ours, scenes, "assignment_delta_dt")),
        "fastest_table": _fastest_table(ours, scenes),
        "reach_table": _reach_table(ours, scenes, tables),
        "failure_table": _failure_table(all_runs),
        "truth_apart": words.metres(_truth_apart(ours)),
        "coarsest": words.plain(max(r.setting for r in ours if r.step)),
        "finest": words.plain(min(r.setting for r in ours if r.step)),
        "profile_table": _profile_table(all_runs),
        "profile_problems": str(len(scenes) * len(runs.TOLERANCES)),
        "tolerances": words.listed(map(words.plain, runs.TOLERANCES)),
        **_order(tables),
        **_readme(ours),
        **_ratios(tables),
    }


def _reached(ours: list[Run], scenes: list[str], method: str, tolerance: float = FINE) -> int:
    return sum(math.isfinite(runs.least_time(ours, s, method, tolerance)) for s in scenes)


def _origin(comments: dict[str, str]) -> dict[str, str]:
    return {name: comments.get(name, "?") for name in ("machine", "times", "date")}


def _peers(all_runs: list[Run], tables: Tables) -> str:
    """The engines, where they were measured, and how the best of them compares with our best."""
    names = [words.peer(name) for name in runs.peers(all_runs)]
    if not names:
        return ""
    sentences = [
        f"Beside them, from the same rounds, in [peers.csv](peers.csv): {words.listed(names)}."
    ]
    scenes = runs.scenes(all_runs)
    for tolerance, name in ((FINE, "a millimetre"), (FINER, "a micrometre")):
        least = {scene: _least_ratio(tables, scene, tolerance) for scene in scenes}
        reached = [ratio for ratio in least.values() if math.isfinite(ratio)]
        ahead = sum(ratio > 1 for ratio in least.values())
        sentence = f"Within {name} a method of ours is faster than all of these in {ahead} of"
        sentence += f" {len(scenes)} scenes"
        if reached:
            sentence += f", at least {words.short(min(reached))} times"
        if len(reached) < len(scenes):
            sentence += f"; in {len(scenes) - len(reached)} none of these gets there"
        sentences.append(f"{sentence}.")
    return " ".join(sentences)


def _least_ratio(tables: Tables, scene: str, tolerance: float) -> float:
    """How many times as long the closest engine takes to come within the tolerance, by the median
    over the rounds; infinite where none does, 0 where none of ours does."""
    rows = tables["peers_ratios"].where(scene=scene, within="tolerance")
    own = [row for row in rows if math.isclose(number(row, "error_m"), tolerance)]
    return min((number(row, "times") if row["times"] else 0.0 for row in own), default=math.inf)


def _peers_row(all_runs: list[Run], tables: Tables) -> str:
    """A row for the page on the engines, which is there when they were measured."""
    if not runs.peers(all_runs):
        return ""
    sentence = _peers(all_runs, tables).partition(". ")[2]
    return f"| [engines that people use](peers.md) | {sentence} |\n"


def _analytic(tables: Tables) -> dict[str, str]:
    checks = analytic.checks(tables)
    rows = [[words.scene(c.scene), c.how, words.metres(c.error)] for c in checks]
    worst = max(checks, key=lambda check: check.error)
    return {
        "analytic_table": words.table(["scene", "what is known", "the truth is off by"], rows),
        "analytic_scenes": str(len(checks)),
        "analytic_worst": f"{words.metres(worst.error)} ({words.scene(worst.scene)})",
    }


def _others(first: dict[tuple[str, float], str | None], scenes: list[str], t: float) -> list[str]:
    return [
        f"{words.scene(s)} ({words.method(first[s, t] or 'no method')})"
        for s in scenes
        if first[s, t] != "event_driven"
    ]


def _fastest_table(ours: list[Run], scenes: list[str]) -> str:
    def line(scene: str) -> list[str]:
        cells = [words.scene(scene)]
        for tolerance in (FINE, FINER):
            times = {m: runs.least_time(ours, scene, m, tolerance) for m in runs.methods(ours)}
            ranked = sorted((ns, m) for m, ns in times.items() if math.isfinite(ns))
            cells += [f"{words.method(m)}, {words.time(ns)}" for ns, m in ranked[:2]]
            cells += ["none"] * (2 - len(ranked[:2]))
        return cells

    header = ["scene", "fastest within 1 mm", "second", "fastest within 1 µm", "second"]
    return words.table(header, map(line, scenes))


def _reach_table(ours: list[Run], scenes: list[str], tables: Tables) -> str:
    ratios = tables["speed_ratios"]

    def line(method: str) -> list[str]:
        own = [number(row, "times_of_assignment") for row in ratios.where(method=method)]
        reached = [_reached(ours, scenes, method, t) for t in (FINE, FINER)]
        spread = f"{words.short(min(own))} to {words.short(max(own))}"
        return [words.method(method), *map(str, reached), words.short(words.median(own)), spread]

    header = [
        "method",
        "scenes within 1 mm",
        "within 1 µm",
        "time, the plain scheme's = 1",
        "range",
    ]
    return words.table(header, map(line, runs.methods(ours)))


def _failure_table(all_runs: list[Run]) -> str:
    rows = []
    for method in runs.methods(all_runs):
        reasons: dict[str, list[str]] = {}
        for scene in runs.scenes(all_runs):
            own = [r for r in all_runs if r.scene == scene and r.method == method]
            if own and min(r.error for r in own) > look.FINE:
                least = words.metres(min(r.error for r in own))
                reasons.setdefault(runs.reason(own), []).append(f"{words.scene(scene)} ({least})")
        rows += [[words.method(method), why, ", ".join(where)] for why, where in reasons.items()]
    return words.table(["method", "why it stays above 1 mm", "scenes (its least error)"], rows)


def _truth_apart(ours: list[Run]) -> float:
    """The tightest event-driven run in double, from the truth in long double: the worst scene."""
    tightest = min(run.setting for run in ours if run.method == "event_driven")
    own = [r for r in ours if r.method == "event_driven" and r.setting == tightest]
    return max(run.error for run in own)


def _low_orders(tables: Tables) -> list[tuple[str, float]]:
    """Where delta in proportion to dt converges more slowly than with order one, and with which,
    over the finer half of the steps."""
    table, low = tables["order"], []
    for scene in table.distinct("scene"):
        own = table.where(scene=scene, method="assignment_delta_dt")
        one, other = own[len(own) // 2], own[-1]
        errors = number(one, "error_m"), number(other, "error_m")
        if min(errors) > 0:
            order = math.log(errors[0] / errors[1])
            order /= math.log(number(one, "dt_s") / number(other, "dt_s"))
            if 0.2 < order < 0.75:
                low.append((scene, order))
    return low


def _order(tables: Tables) -> dict[str, str]:
    """Convergence to the truth by a scheme that shares nothing with it but the model."""
    table = tables["order"]
    slopes, last = {}, {}
    for scene in table.distinct("scene"):
        own = table.where(scene=scene, method="moreau_jean_2")
        x = [math.log(number(row, "dt_s")) for row in own]
        errors = [number(row, "error_m") for row in own]
        last[scene] = errors[-1]
        if errors[0] > 1e-9 and last[scene] > 1e-12:
            y = [math.log(e) for e in errors]
            mx, my = sum(x) / len(x), sum(y) / len(y)
            slopes[scene] = sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum(
                (a - mx) ** 2 for a in x
            )
    low = _low_orders(tables)
    worst = max(last, key=lambda scene: last[scene])
    return {
        "order_scenes": str(len(slopes)),
        "order_median": words.short(words.median(slopes.values())),
        "order_least": words.short(min(slopes.values())),
        "order_least_scene": words.scene(min(slopes, key=lambda s: slopes[s])),
        "order_most": words.short(max(slopes.values())),
        "order_low": words.listed(f"{words.scene(s)} (about {words.short(x)})" for s, x in low),
        "order_worst": words.metres(last[worst]),
        "order_worst_scene": words.scene(worst),
        "order_finest": words.plain(min(number(row, "dt_s") for row in table.rows)),
    }


def _readme(ours: list[Run]) -> dict[str, str]:
    """The panel that the README shows."""
    own = [run for run in ours if run.scene == README_SCENE]
    first = runs.fastest(ours, README_SCENE, FINE) or "no method"
    stepping = {
        m: runs.least_time(ours, README_SCENE, m, FINE)
        for m in runs.methods(ours)
        if m != "event_driven"
    }
    second = min(stepping, key=lambda m: stepping[m])
    fixed = min(run.error for run in own if run.method == "assignment_fast")
    best = runs.least_time(ours, README_SCENE, first, FINE)
    return {
        "one_scene": words.scene(README_SCENE),
        "one_first": words.method(first),
        "one_first_time": words.time(best),
        "one_second_time": (
            f"({words.method(second)}) {words.time(stepping[second])}"
            if math.isfinite(stepping[second])
            else "never comes so near"
        ),
        "one_fixed": words.metres(fixed),
    }


def _ratios(tables: Tables) -> dict[str, str]:
    fast = tables["speed_ratios"].where(method="assignment_fast")
    gains = [1 / number(row, "times_of_assignment") for row in fast]
    return {
        "fast_least": words.short(min(gains)),
        "fast_most": words.short(max(gains)),
        "ratio_dt": words.plain(number(fast[0], "setting")),
    }


def _profile_table(all_runs: list[Run]) -> str:
    rows = []
    for method, ratios in chart_speed.profiles(all_runs).items():
        solved = [r for r in ratios if math.isfinite(r)]
        within = sum(r <= 10 for r in ratios)
        first = sum(r == 1 for r in ratios)
        shares = [f"{100 * n / len(ratios):.0f} %" for n in (first, within, len(solved))]
        rows.append([words.method(method), *shares])
    return words.table(["method", "fastest", "within ten times the fastest", "at all"], rows)
