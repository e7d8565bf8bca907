"""Works out what the pages say, from the tables: a few numbers for the answers, and one table of
texts for each page."""

from typing import Any

import numpy as np
import pandas as pd

from bounce_study import charts, chart_stability
from bounce_study.numbers import interval, metres, ratio, short, time
from bounce_study.style import ENGINES, label, METHODS, scene_label
from bounce_study.tables import fastest, FINE, FINEST, Tables, TIME

Facts = dict[str, Any]
USEFUL = 1e-2  # m: engines with larger errors aren't compared
IN_SENTENCES = {
    "frictionless": "a law without friction",
    "sticking": "a law that always sticks",
    "newton": "Newton's law",
    "poisson": "Poisson's law",
    "compliant": "the compliant law",
}
STEP = 1e-3  # s, at which methods' times are compared


def speed(tables: Tables) -> Facts:
    runs = tables["speed_accuracy"]
    ours = runs[runs["method"].isin(METHODS)]
    closest = compared(runs).sort_values("times", kind="stable").drop_duplicates("scene")
    within = [{s: own for s, own in fastest(ours, e).groupby("scene")} for e in (FINE, FINEST)]
    rows = []
    for scene in ours["scene"].unique():
        firsts = [_named(part.get(scene), place) for part in within for place in (0, 1)]
        row = dict(zip(("within 1 mm", "second", "within 1 µm", "second "), firsts))
        rows.append({"scene": scene_label(scene), **row})
    table = pd.DataFrame(rows)
    if len(closest):
        by_scene = closest.set_index("scene").reindex(ours["scene"].unique())
        table["closest engine"] = [label(x) if x == x else "–" for x in by_scene["method"]]
        table["takes times as long"] = [ratio(x) if x == x else "–" for x in by_scene["times"]]
    winners = [[own["method"].iloc[0] for own in part.values()] for part in within]
    return {
        "speed": table,
        "speed_methods": _methods(runs),
        "scenes": len(table),
        "event_driven": [methods.count("event_driven") for methods in winners],
        "fixed": _reached(runs, "assignment", FINE),
        "scaled": _reached(runs, "assignment_delta_dt", FINE),
        "runs": len(runs),
    }


def _named(own: Any, place: int) -> str:
    if own is None or len(own) <= place:
        return "none"
    return f"{label(own['method'].iloc[place])}, {time(own[TIME].iloc[place])}"


def _reached(runs: Any, method: str, within: float) -> int:
    """In how many scenes the method comes within the tolerance."""
    own = runs[(runs["method"] == method) & (runs["error_m"] <= within)]
    return int(own["scene"].nunique())


def _methods(runs: Any) -> Any:
    """What each method reaches, and its time beside that of the assignment's scheme."""
    least = runs.groupby(["method", "scene"])["error_m"].min()
    near = runs[np.isclose(runs["setting"], STEP, rtol=0.1)].set_index("scene")
    own = near[near["method"] == "assignment"][TIME]
    rows = []
    for method in runs["method"].unique():
        worst = least[method].drop([s for s, e in least[method].items() if e <= FINE])
        times = near[near["method"] == method][TIME] / own
        rows.append(
            {
                "method": label(method),
                "scenes within 1 mm": _reached(runs, method, FINE),
                "within 1 µm": _reached(runs, method, FINEST),
                "time of a run at Δt 1 ms": ratio(times.median()) if len(times.dropna()) else "–",
                "never within 1 mm (least error)": ", ".join(
                    f"{scene_label(s)} ({metres(e)})" for s, e in worst.items()
                )
                or "–",
            }
        )
    return pd.DataFrame(rows)


def compared(runs: Any) -> Any:
    """For each useful run of an engine, how many times as long it takes as the fastest of ours that
    is no worse in that scene."""
    engines = runs[runs["method"].isin(ENGINES) & (runs["error_m"] <= USEFUL)]
    times = []
    for run in engines.itertuples():
        ours = runs[(runs["scene"] == run.scene) & runs["method"].isin(METHODS)]
        times.append(getattr(run, TIME) / ours[ours["error_m"] <= run.error_m][TIME].min())
    return engines.assign(times=times)


def peers(tables: Tables) -> Facts:
    runs = tables["speed_accuracy"]
    ratios = compared(runs)
    if ratios.empty:
        return {"peers": None}
    rows = []
    for engine, own in ratios.groupby("method", sort=False):
        nearest = own.loc[own["times"].idxmin()]
        rows.append(
            {
                "engine": label(engine),
                "scenes within 1 mm": _reached(runs, engine, FINE),
                "within 1 µm": _reached(runs, engine, FINEST),
                "comes closest in": scene_label(nearest["scene"]),
                "takes times as long": ratio(nearest["times"]),
                "at Δt": f"{short(nearest['setting'])} s",
                "with an error of": metres(nearest["error_m"]),
            }
        )
    nearest = ratios.loc[ratios["times"].idxmin()]
    return {
        "peers": pd.DataFrame(rows),
        "peer_ahead": int((ratios.groupby("scene")["times"].min() < 1).sum()),
        "peer_scenes": runs["scene"].nunique(),
        "peer_times": nearest["times"],
        "peer_closest": f"{label(nearest['method'])}, in {scene_label(nearest['scene'])}",
        "peer_never": int((~(ratios["times"] < np.inf)).sum()),
        "engines": runs.attrs.get("engines", "?"),
        "peer_origin": runs.attrs,
    }


def stability(tables: Tables) -> Facts:
    """One row for each failure: where theory lets it begin, what was measured, and its cure."""
    examples = tables["examples"].drop_duplicates("quantity").set_index("quantity")["value"]
    energy = tables["energy_gain"]
    gains = energy[energy["newton"] > chart_stability.LEAST_GAIN]
    below = gains[gains["epsilon"] < gains["limit_epsilon"]]
    others = (energy[["poisson", "stronge"]] > chart_stability.LEAST_GAIN).to_numpy().sum()
    rest = tables["rest_and_drift"].query("setting >= 1e-4")
    rest = rest[["height_m", "depth_m", "drift_m"]].max(axis=1).groupby(rest["method"]).max()
    landing = tables["flat_landing"]
    spin = landing[landing["theta_rad"] == 0].set_index("method")["omega_rad_s"].abs()
    deep = tables["depth"].query("v_dt_m >= 0.05")
    share = (deep["depth_m"] / deep["v_dt_m"]).groupby(deep["method"]).median()
    runs = tables["speed_accuracy"]
    finest = runs[runs["setting"] < 1.2e-5].groupby(["method", "scene"])["error_m"].last()
    fixed, scaled = finest["assignment"], finest["assignment_delta_dt"]
    sweeps = tables["gauss_seidel"]
    stack = sweeps[sweeps["problem"] == "mass_ratio"]
    corner = sweeps[sweeps["share_without_end"] > 0]
    count = tables["solution_count"]
    several = count[count["most_solutions"] > 1]
    flat = tables["almost_flat"]
    scale = tables["scaling"]
    right = scale[scale["plain_lemke_error"] < 1e-6].groupby("dt_s")["m_kg"].agg(["min", "max"])
    rows = [
        (
            "energy gained at an impact by Newton's law",
            f"ε above {short(examples['least epsilon that can gain'])}",
            f"{len(gains)} of {len(energy)} pairs of μ and ε gain, up to "
            f"{short(100 * gains['newton'].max())} %; {len(below)} below the limit",
            f"Poisson's or Stronge's law: {others} pairs gain",
        ),
        (
            "never at rest, with a fixed δ",
            "any Δt",
            f"moves {metres(rest['assignment'])} in ten seconds of rest; with δ = 0 "
            f"{metres(rest['assignment_delta_0'])}",
            f"two corners: {metres(rest['moreau_jean_2'])}",
        ),
        (
            "one corner where two touch",
            "θ = 0, where mirror symmetry wants ω = 0",
            f"ω is {short(spin['assignment'])} rad/s after a flat landing",
            f"two corners: {short(spin['moreau_jean_2'])} rad/s",
        ),
        (
            "through the ground",
            "v Δt",
            f"the assignment's scheme gets {short(share['assignment'])} v Δt deep, Moreau–Jean "
            f"{short(share['moreau_jean_2'])} v Δt",
            "the time of impact: event-driven",
        ),
        (
            "a fixed δ",
            "any Δt",
            f"stays above 1 mm in {(fixed > FINE).sum()} of {len(fixed)} scenes",
            f"δ ∝ Δt: above 1 mm in {(scaled > FINE).sum()}",
        ),
        (
            "Gauss–Seidel is slow",
            "a factor R / (1 + R) a sweep, for a mass ratio R",
            f"{int(stack['sweeps'].iloc[0])} sweeps at {short(stack['value'].iloc[0])}, "
            f"{int(stack['sweeps'].iloc[-1])} at {short(stack['value'].iloc[-1])}",
            f"Lemke's method: {int(stack['lemke_pivots'].max())} pivots at each",
        ),
        (
            "Gauss–Seidel never ends",
            f"μ above {short(examples['least mu with a <= mu |b|'])}",
            f"from μ = {short(corner['value'].min())} on, at most "
            f"{short(100 * corner['share_without_end'].max())} % of the contacts",
            "the closed form, by contact case",
        ),
        (
            "several solutions",
            "μ above μ*, where a = μ |b|",
            f"{len(several)} of {(count['mu'] > count['mu_star']).sum()} pairs of α and μ above it, "
            f"{(several['mu'] < several['mu_star']).sum()} below",
            "none within the model",
        ),
        (
            "almost flat",
            "θ so small that two friction rows differ by rounding",
            f"in {flat['lemke_8x8_wrong_of_4000'].sum()} of {4000 * len(flat)} contacts Lemke's "
            "method calls a wrong answer solved, off by up to "
            f"{short(flat['lemke_8x8_residual_m_s'].max())} m/s",
            f"merged friction rows: {short(flat['merged_residual_m_s'].max())} m/s",
        ),
        (
            "scales of m and Δt",
            "a fixed pivot tolerance",
            "Lemke is right for "
            + "; ".join(
                f"{short(row['min'], 1)} to {short(row['max'], 1)} kg at Δt {short(dt, 1)} s"
                for dt, row in right.iterrows()
            ),
            f"closed form: off by {short(scale['closed_form_error'].max())}",
        ),
    ]
    return {
        "stability": pd.DataFrame(rows, columns=["failure", "begins at", "measured", "cure"]),
        "gains": len(gains),
        "pairs": len(energy),
        "gains_below": len(below),
        "kane": 100 * (examples["energy after / before, Newton"] - 1),
    }


def models(tables: Tables) -> Facts:
    ladder, chosen, counts = (tables[n] for n in ("least_model", "chosen_model", "random_models"))
    gain = chosen.groupby("scene")["times_as_fast_as_moreau_jean"].median()
    rows, smaller = [], []
    for scene, rungs in ladder.groupby("scene"):
        least = rungs[rungs["least"] == 1].iloc[0]
        wrong = rungs.loc[: least.name]["error_m"].iloc[:-1]
        smaller += list(wrong)
        rows.append(
            {
                "scene": scene_label(scene),
                "least model": least["model"].replace("_", " "),
                "as expected": "yes" if least["expected"] else "no",
                "least error of a smaller one": metres(wrong.min()) if len(wrong) else "none is",
                "its time": time(least[TIME]),
                "the whole model": time(rungs[TIME].iloc[-1]),
                "chosen by steps: times as fast as Moreau–Jean": ratio(gain[scene]),
            }
        )
    same = counts["chosen"] == counts["least"]
    scenes, wrong = counts["scenes"].sum(), counts["chosen_wrong"].sum()
    return {
        "models": pd.DataFrame(rows),
        "random_scenes": scenes,
        "random_same": counts["scenes"][same].sum(),
        "random_wrong": wrong,
        "random_larger": scenes - counts["scenes"][same].sum() - wrong,
        "smaller_error": min(smaller),
        "moreau_jean_gain": chosen["times_as_fast_as_moreau_jean"].median(),
        "chosen_apart": chosen["distance_to_moreau_jean_m"].max(),
        "slower": int((chosen["times_as_fast_as_moreau_jean"] < 1).sum()),
        "chosen_runs": len(chosen),
        "endless": int((~np.isfinite(ladder["error_m"])).sum()),
    }


def tolerance(tables: Tables) -> Facts:
    table = tables["tolerance"]
    shown = pd.DataFrame({"tolerance": table["tolerance_m"].map(metres)})
    for name in ("free_flight", "event_driven", "refused"):
        shown[name.replace("_", " ")] = table[name]
    shown["error above its bound"] = table["violated"]
    shown["bound over error"] = table["bound_over_error"].map(ratio)
    shown["in nine of ten below"] = table["bound_over_error_90"].map(ratio)
    shown["time"] = table["ns"].map(time)
    shown["over the best choice's"] = table["time_over_best"].map(ratio)
    shown["in nine of ten below "] = table["time_over_best_90"].map(ratio)
    return {
        "tolerance": shown,
        "asked": table["scenes"].sum(),
        "answered": (table["scenes"] - table["refused"]).sum(),
        "violated": table["violated"].sum(),
        "bound": table["bound_over_error"].max(),
        "over_best": table["time_over_best"].max(),
    }


def measured(tables: Tables) -> Facts:
    table = tables["measured_laws"]
    figures = tables["measured_body"].copy()
    figures["value"] = figures["value"].map("{:g}".format)
    shown = pd.DataFrame({"shape": table["shape"], "law": table["law"].map(charts.LAWS)})
    for name, title in {"mu": "μ", "epsilon": "ε", "kappa": "stiffness t/n"}.items():
        columns = [table[column] for column in (name, f"{name}_low", f"{name}_high")]
        shown[title] = [interval(*values) for values in zip(*columns)]
    medians = zip(table["median_m_s"], table["median_low"], table["median_high"])
    shown["median error on the test, m/s"] = [interval(*values) for values in medians]
    behind = zip(table["behind_low"], table["behind_high"])
    texts = [f"{short(low)} to {short(high)}" for low, high in behind]
    shown["behind the best, m/s"] = np.where(table["best"] == 1, "best", texts)
    shapes = {}
    for shape, own in table.groupby("shape", sort=False):
        laws = own.set_index("law")
        least = own[own["least"] == 1].iloc[0]
        shapes[shape] = {"laws": laws, "least": IN_SENTENCES[least["law"]], "row": least}
    return {"laws": shown, "shapes": shapes, "figures": figures}
