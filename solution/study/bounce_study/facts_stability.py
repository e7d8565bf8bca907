"""Works out the facts of the page on stability from its tables."""

from statistics import median_high
from typing import Any

from bounce_study.chart_maps import LEAST_GAIN
from bounce_study.chart_stability import distance, is_wrong
from bounce_study.tables import number, numbers, Row, Tables

Facts = dict[str, Any]


def facts(tables: Tables) -> Facts:
    return {
        **_energy(tables),
        **_rest(tables),
        **_landing(tables),
        **_depth(tables),
        **_floor(tables),
        **_sweeps(tables),
        **_solutions(tables),
        **_almost_flat(tables),
        **_scales(tables),
        "bad_inputs": tables["bad_input"].rows,
    }


def _example(tables: Tables, example: str, quantity: str) -> float:
    rows = tables["examples"].where(example=example, quantity=quantity)
    return number(rows[0], "value")


def _energy(tables: Tables) -> Facts:
    table = tables["energy_gain"]
    newton = table.where(law="newton")
    gains = [row for row in newton if number(row, "largest_gain") > LEAST_GAIN]
    below = [row for row in gains if number(row, "epsilon") < number(row, "limit_epsilon")]
    above = [row for row in newton if number(row, "epsilon") > number(row, "limit_epsilon")]
    others = table.where(law="poisson") + table.where(law="stronge")
    return {
        "kane": {
            law: _example(tables, "kane", f"energy after / before, {law}")
            for law in ("Newton", "Poisson", "Stronge")
        },
        "gain_points": len(newton),
        "gain_count": len(gains),
        "gain_below": len(below),
        "gain_above": len(above),
        "gain_missed": len(above) - (len(gains) - len(below)),
        "gain_largest": max(gains, key=lambda row: number(row, "largest_gain")),
        "gain_others": sum(gain > LEAST_GAIN for gain in numbers(others, "largest_gain")),
        "gain_limit": _example(tables, "rectangle", "least epsilon that can gain"),
    }


def _rest(tables: Tables) -> Facts:
    table = tables["rest_and_drift"]
    rest = {
        method: [
            {"away": distance(row), "drift": number(row, "drift_m"), "setting": row["setting"]}
            for row in table.where(method=method)
        ]
        for method in table.distinct("method")
    }
    moved = {name for name, rows in rest.items() if any(r["away"] or r["drift"] for r in rows)}
    return {"rest": rest, "rest_still": [method for method in rest if method not in moved]}


def _landing(tables: Tables) -> Facts:
    table = tables["flat_landing"]
    methods = table.distinct("method")

    def spin(method: str, theta: str) -> float:
        return number(table.where(method=method, theta_rad=theta)[0], "omega_rad_s")

    def is_mirrored(method: str) -> bool:
        one, other = spin(method, "1e-16"), spin(method, "-1e-16")
        return abs(one) > 0.1 and abs(one + other) < 1e-6

    def least_turning_tilt(method: str) -> float:
        rows = [r for r in table.where(method=method) if abs(number(r, "omega_rad_s")) > 0.1]
        return min(theta for theta in numbers(rows, "theta_rad") if theta > 0)

    flat = {method: abs(spin(method, "0")) for method in methods}
    return {
        "landing_spun": [
            {"method": method, "omega": omega} for method, omega in flat.items() if omega > 0.1
        ],
        "landing_mirrored": list(filter(is_mirrored, methods)),
        "landing_upright": [method for method, omega in flat.items() if omega == 0],
        "landing_event_from": least_turning_tilt("event_driven"),
        "landing_two_from": least_turning_tilt("moreau_jean_2"),
        "landing_event": abs(spin("event_driven", "1e-06")),
    }


def _depth(tables: Tables) -> Facts:
    table, far = tables["depth"], 0.05

    def share(method: str) -> float:
        fast = [row for row in table.where(method=method) if number(row, "v_dt_m") >= far]
        return median_high(number(row, "depth_m") / number(row, "v_dt_m") for row in fast)

    return {
        "depth": table.where(method="assignment", speed_m_s="60", dt_s="0.01")[0],
        "depth_far": far,
        "depth_assignment": share("assignment"),
        "depth_moreau_jean": share("moreau_jean_2"),
    }


def _floor(tables: Tables) -> Facts:
    """Compares a fixed delta with one in proportion to dt, at the finest step, by scene."""
    table, delta = tables["order"], 1e-3
    rows = []
    cured: list[str] = []
    uncured: list[str] = []
    for scene in table.distinct("scene"):
        fixed = numbers(table.where(scene=scene, method="assignment_fast"), "error_m")
        scaled = numbers(table.where(scene=scene, method="assignment_delta_dt"), "error_m")
        rows.append((scene, fixed[-1], fixed[-1] / delta, scaled[-1]))
        if fixed[-1] > fixed[-2] / 1.2 > 0:
            (cured if scaled[-1] < fixed[-1] / 10 else uncured).append(scene)
    return {"floor": rows, "floor_cured": cured, "floor_uncured": uncured}


def _sweeps(tables: Tables) -> Facts:
    table = tables["gauss_seidel"]
    stack, corner = table.where(problem="mass_ratio"), table.where(problem="one_corner_mu")
    heavy = [row for row in stack if number(row, "value") >= 1]
    endless = [row for row in corner if number(row, "share_without_end") > 0]
    clean = [row for row in corner if number(row, "share_without_end") == 0]
    return {
        "sweeps_low": stack[0],
        "sweeps_high": stack[-1],
        "sweeps_off": max(
            abs(number(row, "sweeps") / number(row, "predicted_sweeps") - 1) for row in heavy
        ),
        "endless_from": endless[0]["value"] if endless else "no value that was tried",
        "endless_worst": max(corner, key=lambda row: number(row, "share_without_end")),
        "endless_clean": max(numbers(clean, "value")),
        "stack_pivots": sorted({row["lemke_pivots"] for row in stack}),
        "literal": _example(tables, "gauss_seidel", "defined on the 4x4 of eq. (9)"),
    }


def _solutions(tables: Tables) -> Facts:
    rows = tables["solution_count"].rows
    below = [row for row in rows if number(row, "mu") < number(row, "mu_star")]
    above = [row for row in rows if number(row, "mu") > number(row, "mu_star")]
    missed = [row for row in above if number(row, "most_solutions") < 2]
    return {
        "several_below": sum(number(row, "most_solutions") > 1 for row in below),
        "several_points_below": len(below),
        "several_above": len(above) - len(missed),
        "several_points": len(above),
        # Just above the limit only fast sliding has several solutions, and velocities are sampled.
        "several_missed": [number(row, "mu") / number(row, "mu_star") - 1 for row in missed],
        "several_most": max((row["most_solutions"] for row in rows), key=float),
        "mu_star_least": _example(tables, "rectangle", "least mu with a <= mu |b|"),
        "mu_star_tan": _example(tables, "rectangle", "tan alpha there"),
        "painleve": {name: _example(tables, "painleve", name) for name in ("mu", "p_1", "v_t")},
        "painleve_impulses": [
            row["value"]
            for row in tables["examples"].where(example="painleve", quantity="f_n dt / m")
        ],
    }


def _almost_flat(tables: Tables) -> Facts:
    rows = tables["almost_flat"].rows
    wrong = [row for row in rows if number(row, "lemke_8x8_wrong_of_4000") > 0]
    return {
        "flat_worst": max(rows, key=lambda row: number(row, "lemke_8x8_residual_m_s")),
        "flat_wrong": sum(int(row["lemke_8x8_wrong_of_4000"]) for row in rows),
        "flat_tried": 4000 * len(rows),
        "flat_wrong_angles": numbers(wrong, "theta_rad"),
        "flat_merged": max(numbers(rows, "merged_residual_m_s")),
        "flat_rays": sum(int(row["lemke_8x8_rays_of_4000"]) for row in rows),
        "flat_coarse": rows[0],
        "flat_fine": [row for row in rows if number(row, "theta_rad") > 0][-1],
    }


def _scales(tables: Tables) -> Facts:
    table = tables["scaling"]
    rows = []
    for step in table.distinct("dt_s"):
        right = [row for row in table.where(dt_s=step) if not is_wrong(row, "plain_lemke_error")]
        rows.append((float(step), numbers(right, "m_kg")))
    return {
        "scales": rows,
        "scale_closed": max(numbers(table.rows, "closed_form_error")),
        "scale_given": max(numbers(table.rows, "given_lemke_error")),
    }
