"""What the page on stability says, from its tables."""

from collections.abc import Callable

from bounce_study import words
from bounce_study.chart_maps import LEAST_GAIN
from bounce_study.chart_stability import is_wrong
from bounce_study.tables import number, numbers, Row, Tables

Facts = dict[str, str]


def facts(tables: Tables) -> Facts:
    groups: tuple[Callable[[Tables], Facts], ...] = (
        _energy,
        _rest,
        _landing,
        _depth,
        _floor,
        _sweeps,
        _solutions,
        _flat,
        _scales,
        _bad,
    )
    found: Facts = {}
    for group in groups:
        found |= group(tables)
    return found


def _example(tables: Tables, example: str, quantity: str) -> float:
    rows = tables["examples"].where(example=example, quantity=quantity)
    return number(rows[0], "value")


def _energy(tables: Tables) -> Facts:
    table = tables["energy_gain"]
    newton = table.where(law="newton")
    gains = [row for row in newton if number(row, "largest_gain") > LEAST_GAIN]
    below = [r for r in gains if number(r, "epsilon") < number(r, "limit_epsilon")]
    above = [r for r in newton if number(r, "epsilon") > number(r, "limit_epsilon")]
    missed = len(above) - (len(gains) - len(below))
    largest = max(gains, key=lambda row: number(row, "largest_gain"))
    others = [
        number(row, "largest_gain") for row in table.rows if row["law"] in ("poisson", "stronge")
    ]

    def ratio(law: str) -> float:
        return _example(tables, "kane", f"energy after / before, {law}")

    return {
        "kane_newton": f"{100 * (ratio('Newton') - 1):.0f} %",
        "kane_poisson": f"{100 * (1 - ratio('Poisson')):.0f} %",
        "kane_stronge": f"{100 * (1 - ratio('Stronge')):.0f} %",
        "gain_points": str(len(newton)),
        "gain_count": str(len(gains)),
        "gain_below": str(len(below)),
        "gain_above": str(len(above)),
        "gain_missed": f"all but {missed} do (angles and directions are sampled)"
        if missed
        else "all do",
        "gain_largest": f"{100 * number(largest, 'largest_gain'):.0f} %",
        "gain_largest_mu": largest["mu"],
        "gain_largest_epsilon": largest["epsilon"],
        "gain_others": str(sum(gain > LEAST_GAIN for gain in others)),
        "gain_limit": words.short(_example(tables, "rectangle", "least epsilon that can gain")),
    }


def _away(row: Row) -> float:
    return max(number(row, "height_m"), number(row, "depth_m"))


def _rest(tables: Tables) -> Facts:
    table = tables["rest_and_drift"]
    found: Facts = {}
    for method in ("assignment", "assignment_delta_dt", "assignment_delta_0", "moreau_jean_1"):
        rows = table.where(method=method)
        for name, row in (("coarse", rows[0]), ("fine", rows[-1])):
            found[f"{method}_away_{name}"] = words.metres(_away(row))
            found[f"{method}_drift_{name}"] = words.metres(number(row, "drift_m"))
    rows = table.where(method="assignment")
    away = {name: max(map(_away, table.where(method=name))) for name in table.distinct("method")}
    drift = {
        name: max(numbers(table.where(method=name), "drift_m")) for name in table.distinct("method")
    }
    still = [name for name in away if away[name] == 0 and drift[name] == 0]
    return found | {
        "rest_coarse": words.plain(number(rows[0], "setting")),
        "rest_fine": words.plain(number(rows[-1], "setting")),
        "rest_still": words.listed(words.method(name) for name in still),
    }


def _landing(tables: Tables) -> Facts:
    table = tables["flat_landing"]

    def omega(method: str, theta: str) -> float:
        return number(table.where(method=method, theta_rad=theta)[0], "omega_rad_s")

    def mirrored(method: str) -> bool:
        one, other = omega(method, "1e-16"), omega(method, "-1e-16")
        return abs(one) > 0.1 and abs(one + other) < 1e-6

    def first(method: str) -> str:
        """The least tilt after which it turns."""
        turning = [
            number(row, "theta_rad")
            for row in table.where(method=method)
            if number(row, "theta_rad") > 0 and abs(number(row, "omega_rad_s")) > 0.1
        ]
        return words.plain(min(turning))

    methods = table.distinct("method")
    return {
        "landing_spun": words.listed(
            f"{words.method(m)} ({words.short(abs(omega(m, '0')))} rad/s)"
            for m in methods
            if abs(omega(m, "0")) > 0.1
        ),
        "landing_mirrored": words.listed(words.method(m) for m in methods if mirrored(m)),
        "landing_upright": words.listed(words.method(m) for m in methods if omega(m, "0") == 0),
        "landing_event_from": first("event_driven"),
        "landing_two_from": first("moreau_jean_2"),
        "landing_event": words.short(abs(omega("event_driven", "1e-06"))),
    }


def _depth(tables: Tables) -> Facts:
    table, far = tables["depth"], 0.05
    row = table.where(method="assignment", speed_m_s="60", dt_s="0.01")[0]

    def share(method: str) -> float:
        fast = [r for r in table.where(method=method) if number(r, "v_dt_m") >= far]
        return words.median(number(r, "depth_m") / number(r, "v_dt_m") for r in fast)

    return {
        "depth_speed": row["speed_m_s"],
        "depth_dt": row["dt_s"],
        "depth_epsilon": row["epsilon"],
        "depth_far": words.metres(far),
        "depth_deep": words.metres(number(row, "depth_m")),
        "depth_assignment": words.short(share("assignment")),
        "depth_moreau_jean": words.short(share("moreau_jean_2")),
    }


def _floor(tables: Tables) -> Facts:
    """The error of the fixed delta at the finest step, in units of delta, by scene."""
    table, delta = tables["order"], 1e-3
    rows = []
    cured: list[str] = []
    uncured: list[str] = []
    for scene in table.distinct("scene"):
        fixed = numbers(table.where(scene=scene, method="assignment_fast"), "error_m")
        scaled = numbers(table.where(scene=scene, method="assignment_delta_dt"), "error_m")
        floor = fixed[-1] > fixed[-2] / 1.2 > 0
        if floor:
            (cured if scaled[-1] < fixed[-1] / 10 else uncured).append(words.scene(scene))
        rows.append(
            [
                words.scene(scene),
                words.metres(fixed[-1]),
                words.short(fixed[-1] / delta),
                words.metres(scaled[-1]),
            ]
        )
    header = ["scene", "error, fixed δ, finest Δt", "in units of δ", "error, δ ∝ Δt"]
    return {
        "floor_table": words.table(header, rows),
        "floor_scenes": str(len(cured) + len(uncured)),
        "floor_cured": str(len(cured)),
        "floor_uncured": words.listed(uncured),
        "floor_of": str(len(rows)),
    }


def _sweeps(tables: Tables) -> Facts:
    table = tables["gauss_seidel"]
    stack, corner = table.where(problem="mass_ratio"), table.where(problem="one_corner_mu")
    off = [
        abs(number(row, "sweeps") / number(row, "predicted_sweeps") - 1)
        for row in stack
        if number(row, "value") >= 1
    ]
    endless = [row for row in corner if number(row, "share_without_end") > 0]
    last_clean = max(
        number(row, "value") for row in corner if number(row, "share_without_end") == 0
    )
    worst = max(corner, key=lambda row: number(row, "share_without_end"))
    literal = _example(tables, "gauss_seidel", "defined on the 4x4 of eq. (9)")
    return {
        "sweeps_low_ratio": stack[0]["value"],
        "sweeps_low": stack[0]["sweeps"],
        "sweeps_high_ratio": stack[-1]["value"],
        "sweeps_high": stack[-1]["sweeps"],
        "sweeps_off": f"{100 * max(off):.1f} %",
        "endless_from": endless[0]["value"] if endless else "no value that was tried",
        "endless_sweeps": worst["most_sweeps"],
        "stack_pivots": words.listed(sorted({row["lemke_pivots"] for row in stack})),
        "endless_clean": words.short(last_clean),
        "endless_most": f"{100 * number(worst, 'share_without_end'):.0f} %",
        "literal": "is defined" if literal else "is undefined",
    }


def _solutions(tables: Tables) -> Facts:
    rows = tables["solution_count"].rows
    several = [r for r in rows if number(r, "most_solutions") > 1]
    below = [r for r in several if number(r, "mu") < number(r, "mu_star")]
    above = [r for r in rows if number(r, "mu") > number(r, "mu_star")]
    missed = [r for r in above if number(r, "most_solutions") < 2]
    impulses = tables["examples"].where(example="painleve", quantity="f_n dt / m")
    return {
        "several_below": str(len(below)),
        "several_points_below": str(sum(number(r, "mu") < number(r, "mu_star") for r in rows)),
        "several_above": str(sum(number(r, "most_solutions") > 1 for r in above)),
        "several_points": str(len(above)),
        "several_missed": _missed(missed),
        "several_most": max((r["most_solutions"] for r in rows), key=float),
        "mu_star_least": words.short(_example(tables, "rectangle", "least mu with a <= mu |b|"), 4),
        "mu_star_tan": words.short(_example(tables, "rectangle", "tan alpha there")),
        "painleve_mu": words.plain(_example(tables, "painleve", "mu")),
        "painleve_p_1": words.plain(_example(tables, "painleve", "p_1")),
        "painleve_v_t": words.plain(_example(tables, "painleve", "v_t")),
        "painleve_impulses": words.listed(row["value"] for row in impulses),
    }


def _missed(rows: list[Row]) -> str:
    """Velocities are sampled, and just above the limit only fast sliding has several solutions."""
    if not rows:
        return ""
    above = max(number(r, "mu") / number(r, "mu_star") - 1 for r in rows)
    return (
        f" The other {len(rows)} are at most {100 * above:.1f} % above μ*, where it takes "
        "faster sliding than was sampled."
    )


def _flat(tables: Tables) -> Facts:
    rows = tables["almost_flat"].rows
    worst = max(rows, key=lambda row: number(row, "lemke_8x8_residual_m_s"))
    wrong = [row for row in rows if number(row, "lemke_8x8_wrong_of_4000") > 0]
    angles = numbers(wrong, "theta_rad")
    tilted = [row for row in rows if number(row, "theta_rad") > 0]
    return {
        "flat_theta": words.plain(number(worst, "theta_rad")),
        "flat_residual": words.short(number(worst, "lemke_8x8_residual_m_s")),
        "flat_wrong": str(sum(int(row["lemke_8x8_wrong_of_4000"]) for row in rows)),
        "flat_tried": str(4000 * len(rows)),
        "flat_from": words.plain(min(angles)) if angles else "none",
        "flat_to": words.plain(max(angles)) if angles else "none",
        "flat_merged": words.short(max(numbers(rows, "merged_residual_m_s"))),
        "flat_rays": str(sum(int(row["lemke_8x8_rays_of_4000"]) for row in rows)),
        "flat_pivot": words.plain(number(rows[0], "lemke_8x8_least_pivot")),
        "flat_coarse": words.plain(number(rows[0], "theta_rad")),
        "flat_literal_coarse": words.short(number(rows[0], "merged_in_8x8_residual_m_s")),
        "flat_fine": words.plain(number(tilted[-1], "theta_rad")),
        "flat_literal_fine": words.short(number(tilted[-1], "merged_in_8x8_residual_m_s")),
    }


def _scales(tables: Tables) -> Facts:
    table = tables["scaling"]
    rows = []
    for step in table.distinct("dt_s"):
        own = table.where(dt_s=step)
        right = [number(r, "m_kg") for r in own if not is_wrong(r, "plain_lemke_error")]
        rows.append(
            [words.plain(float(step)), f"{words.plain(min(right))} to {words.plain(max(right))}"]
        )
    return {
        "scale_table": words.table(["Δt, s", "masses with which plain Lemke is right, kg"], rows),
        "scale_closed": words.short(max(numbers(table.rows, "closed_form_error"))),
        "scale_given": words.short(max(numbers(table.rows, "given_lemke_error"))),
    }


def _bad(tables: Tables) -> Facts:
    rows = [[r["input"], r["unchecked"], r["checked"]] for r in tables["bad_input"].rows]
    return {"bad_table": words.table(["input", "nobody checks", "the study's reader says"], rows)}
