"""Works out what the pages say, from the tables: a few numbers for the answers, and one table of
texts for each page."""

import json
from fractions import Fraction
from typing import Any

import numpy as np
import pandas as pd

from bounce_grader.common.paths import FIXTURES
from bounce_study import charts, chart_stability
from bounce_study.numbers import interval, metres, ratio, short, time
from bounce_study.style import ENGINES, label, METHODS, MODELS, scene_label
from bounce_study.tables import fastest, FINE, FINEST, leaders, Tables, TIME

Facts = dict[str, Any]
USEFUL = 1e-2  # m: engines with larger errors aren't compared
PROBLEMS = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)  # m: tolerances for which the fastest are counted
IN_SENTENCES = {
    "frictionless": "a law without friction",
    "sticking": "a law that always sticks",
    "newton": "Newton's law",
    "poisson": "Poisson's law",
    "compliant": "the compliant law",
}
STEP = 1e-3  # s, at which methods' times are compared
STIFFEST = 8  # of the ratios of stiffness that are tried


def speed(tables: Tables) -> Facts:
    runs = tables["speed_accuracy"]
    ours = runs[runs["method"].isin(METHODS)]
    closest = compared(runs).sort_values("times", kind="stable").drop_duplicates("scene")
    within = [dict(list(fastest(ours, e).groupby("scene"))) for e in (USEFUL, FINE, FINEST)]
    rows = []
    for scene in ours["scene"].unique():
        row = {"scene": scene_label(scene)}
        for part, tolerance in zip(within, ("1 cm", "1 mm", "1 µm")):
            first, second = (_named(part.get(scene), place) for place in (0, 1))
            row[f"fastest within {tolerance}"] = first if second == "none" else f"{first}; {second}"
        rows.append(row)
    table = pd.DataFrame(rows)
    if len(closest):
        by_scene = closest.set_index("scene").reindex(ours["scene"].unique())
        table["closest engine"] = [label(x) if x == x else "–" for x in by_scene["method"]]
        table["takes so many times as long"] = [
            ratio(x) if x == x else "–" for x in by_scene["times"]
        ]
    wins = pd.DataFrame({e: leaders(ours, e).value_counts() for e in PROBLEMS})
    order = [*METHODS, "tie", "alone"]
    wins = wins.reindex([name for name in order if name in wins.index]).fillna(0).astype(int)
    titles = {e: f"within {metres(e, 1)}" for e in wins}
    return {
        "speed": table,
        "wins": wins.rename(columns=titles, index=_label_or_tie).reset_index(
            names="fastest in scenes"
        ),
        "speed_methods": _methods(runs),
        "scenes": len(table),
        "event_driven": list(wins.loc["event_driven"]),
        "alone": wins.loc["alone"].iloc[-1] if "alone" in wins.index else 0,
        "fixed": _reached(runs, "assignment", FINE),
        "scaled": _reached(runs, "assignment_delta_dt", FINE),
        "runs": len(runs),
        "won": [(metres(e, 1), _won(ours, e)) for e in (USEFUL, FINE)],
    }


def _won(ours: Any, within: float) -> list[str]:
    """The scenes in which a method that steps leads, with both times."""
    first, runs = leaders(ours, within), fastest(ours, within).set_index(["scene", "method"])[TIME]
    texts = []
    for scene, method in first[~first.isin(["event_driven", "tie", "alone"])].items():
        ours_, theirs = runs.get((scene, "event_driven")), runs[scene, method]
        beside = f"event-driven {time(ours_)}" if ours_ else "event-driven never"
        texts.append(f"{label(method)} in {scene_label(scene)} ({time(theirs)}, {beside})")
    return texts


def _label_or_tie(method: str) -> str:
    others = {"tie": "none: the next takes less than twice as long", "alone": "only one gets there"}
    return others.get(method) or label(method)


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
                "time at Δt 1 ms": f"{ratio(times.median())}×" if len(times.dropna()) else "–",
                "not within 1 mm at any step tried (least error)": ", ".join(
                    f"{scene_label(s)} ({metres(e, 3)}{_falls(runs, method, s)})"
                    for s, e in worst.items()
                )
                or "–",
            }
        )
    return pd.DataFrame(rows)


def _falls(runs: Any, method: str, scene: str) -> str:
    """An arrow where the finest step has the least error, by a twentieth or more."""
    errors = runs[(runs["method"] == method) & (runs["scene"] == scene)]["error_m"]
    return " ↓" if errors.iloc[-1] < 0.95 * errors.iloc[:-1].min() else ""


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
                "takes so many times as long": ratio(nearest["times"]),
                "at Δt": f"{short(nearest['setting'])} s",
                "with an error of": metres(nearest["error_m"]),
            }
        )
    nearest = ratios.loc[ratios["times"].idxmin()]
    near = runs[np.isclose(runs["setting"], STEP, rtol=0.1)]
    flight = near[near["scene"] == "free_flight"].groupby("method")[TIME].mean()
    return {
        "siconos_flight": flight.get("siconos", np.nan) / flight.get("assignment", np.nan),
        "peers": pd.DataFrame(rows),
        "peer_ahead": int((ratios.groupby("scene")["times"].min() < 1).sum()),
        "peer_scenes": runs["scene"].nunique(),
        "peer_times": nearest["times"],
        "peer_closest": f"{label(nearest['method'])}, in {scene_label(nearest['scene'])}",
        "reached": {engine: _reached(runs, engine, FINE) for engine in ENGINES},
        "engines": runs.attrs.get("engines", "?"),
    }


def stability(tables: Tables) -> Facts:
    """The numbers of the table of failures: where each begins, what was measured, and its cure."""
    examples = tables["examples"].drop_duplicates("quantity").set_index("quantity")["value"]
    energy = tables["energy_gain"]
    gains = energy[energy["newton"] > chart_stability.LEAST_GAIN]
    others = energy[["poisson", "stronge"]] > chart_stability.LEAST_GAIN
    limits = energy.drop_duplicates("mu").set_index("mu")["limit_epsilon"]
    landing = tables["flat_landing"].pivot(
        index="theta_rad", columns="method", values="omega_rad_s"
    )
    apart = landing[landing["event_driven"] - landing["moreau_jean_2"] > 0.1].loc[0:]
    deep = tables["depth"].query("depth_m > 0")
    runs = tables["speed_accuracy"]
    finest = runs[runs["setting"] < 1.2e-5].groupby(["method", "scene"])["error_m"].last()
    sweeps = tables["gauss_seidel"]
    corner = sweeps[sweeps["share_without_end"] > 0]
    count = tables["solution_count"].query("alpha_rad <= @chart_stability.STEEPEST")
    several = count[count["most_solutions"] > 1]
    flat = tables["almost_flat"]
    return {
        "gains": len(gains),
        "pairs": len(energy),
        "pairs_above": (energy["epsilon"] > energy["limit_epsilon"]).sum(),
        "gains_below": (gains["epsilon"] < gains["limit_epsilon"]).sum(),
        "gains_by_others": others.to_numpy().sum(),
        "largest_gain": 100 * gains["newton"].max(),
        "least_limit": limits.min(),
        "least_limit_from": limits[limits < limits.min() + 1e-4].index[0],
        "first_limit": (limits.index[1], limits.iloc[1]),
        "rest": tables["rest_and_drift"].set_index(["method", "setting"]).max(axis=1),
        "off": tables["slope_and_energy"].set_index(["case", "tilt_rad", "method", "setting"])[
            "off"
        ],
        "bounce": tables["restitution"].set_index(["lands_on", "epsilon", "method", "setting"]),
        "limits": tables["event_limits"].set_index(["case", "value"]),
        "blurred_from": _blurred(tables["event_limits"], "tumbling").min(),
        "blurred_below": _blurred(tables["event_limits"], "balance").max(),
        "throws": tables["large_friction"].set_index(["mu", "method", "dt_s"]),
        "flat": landing.loc[0].abs(),
        "apart": (apart.index.min(), apart.index.max(), apart["event_driven"].max()),
        "depth_off": (deep["depth_m"] / chart_stability.predicted_depth(deep) - 1).abs().max(),
        "unseen": len(tables["depth"]) - len(deep),
        "stack": sweeps[sweeps["problem"] == "mass_ratio"],
        "endless_from": corner["value"].min(),
        "endless_share": 100 * corner["share_without_end"].max(),
        "least_mu": Fraction(examples["least mu with a <= mu |b|"]).limit_denominator(10),
        "several": len(several),
        "several_below": (several["mu"] < several["mu_star"]).sum(),
        "above_mu_star": (count["mu"] > count["mu_star"]).sum(),
        "flat_contacts": 4000 * len(flat),
        "flat_wrong": flat[flat["lemke_8x8_wrong_of_4000"] > 0],
        "merged_off": flat["merged_residual_m_s"].max(),
        "stays": (finest > FINE).groupby("method").sum(),
    }


def _blurred(limits: Any, case: str) -> Any:
    """The values at which rounding moves the event-driven motion by more than a millimetre."""
    return limits[(limits["case"] == case) & (limits["off_m"] > FINE)]["value"]


def models(tables: Tables) -> Facts:
    ladder, chosen, counts = (tables[n] for n in ("least_model", "chosen_model", "random_models"))
    gain = chosen.groupby("scene")["times_as_fast_as_moreau_jean"].median()
    slow = chosen[chosen["times_as_fast_as_moreau_jean"] < 1]
    rows, smaller, spread = [], [], []
    for scene, rungs in ladder.groupby("scene"):
        least = rungs[rungs["least"] == 1].iloc[0]
        wrong = rungs.loc[: least.name]["error_m"].iloc[:-1]
        smaller += list(wrong)
        equal = rungs[(rungs["error_m"] <= FINE) & (rungs["model"] != "asleep")][TIME]
        spread.append(equal.max() / equal.min() - 1)
        rows.append(
            {
                "scene": scene_label(scene),
                "least model": MODELS[least["model"]],
                "as expected": "yes" if least["expected"] else "no",
                "least error of a smaller one": metres(wrong.min()) if len(wrong) else "none is",
                "its time per second": time(least[TIME]),
                "the whole model": time(rungs[TIME].iloc[-1]),
                "chosen in each step: times as fast as Moreau–Jean": ratio(gain[scene]),
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
        "moreau_jean_gain": gain.median(),
        "flight_gain": gain["free_flight"],
        "spread": 100 * max(spread),
        "wrong_error": counts[counts["chosen_wrong"] > 0]["largest_error_m"].max(),
        "chosen_apart": chosen["distance_to_moreau_jean_m"].max(),
        "slower": [f"{scene_label(run.scene)} at Δt {run.dt_s:g} s" for run in slow.itertuples()],
        "foretold": f"{ladder.query('least == 1')['expected'].sum()} of {len(rows)}",
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
    shown["time of a motion"] = table["ns"].map(time)
    shown["over the best choice's"] = table["time_over_best"].map(ratio)
    shown["in nine of ten below "] = table["time_over_best_90"].map(ratio)
    return {
        "tolerance": shown,
        "asked": table["scenes"].sum(),
        "answered": (table["scenes"] - table["refused"]).sum(),
        "violated": table["violated"].sum(),
        "scenes_asked": table["scenes"].max(),
        "bound": table["bound_over_error"].max(),
        "over_best": [ratio(table["time_over_best"].agg(f)) for f in ("min", "max")],
        "over_best_90": [ratio(table["time_over_best_90"].agg(f)) for f in ("min", "max")],
    }


def measured(tables: Tables) -> Facts:
    table = tables["measured_laws"]
    figures = tables["measured_body"].copy()
    known = figures.set_index("quantity")["value"]
    figures["value"] = figures["value"].map("{:g}".format)
    shown = pd.DataFrame({"shape": table["shape"], "law": table["law"].map(charts.LAWS)})
    for name, title in {"mu": "μ", "epsilon": "ε", "kappa": "stiffness t/n"}.items():
        columns = [table[column] for column in (name, f"{name}_low", f"{name}_high")]
        shown[title] = [interval(*values) for values in zip(*columns)]
    at_end = table["kappa"] == STIFFEST
    shown["stiffness t/n"] = np.where(at_end, "≥ ", "") + shown["stiffness t/n"]
    medians = zip(table["median_m_s"], table["median_low"], table["median_high"])
    shown["median error on the test, m/s"] = [interval(*values) for values in medians]
    behind = zip(table["behind_low"], table["behind_high"])
    texts = [f"{short(low)} to {short(high)}" for low, high in behind]
    shown["behind the best law, m/s"] = np.where(table["best"] == 1, "best law", texts)
    shapes = {}
    for shape, own in table.groupby("shape", sort=False):
        laws = own.set_index("law")
        least = own[own["least"] == 1].iloc[0]
        share = 100 * laws.median_m_s.newton / known[f"approach of {shape}, m/s"]
        shapes[shape] = {"laws": laws, "least": IN_SENTENCES[least["law"]], "row": least}
        shapes[shape] |= {"approach": known[f"approach of {shape}, m/s"], "share": share}
    return {
        "laws": shown,
        "shapes": shapes,
        "figures": figures,
        "side": known["side"],
        "used": known["impacts of one corner"],
        "left_out": known[known.index.str.startswith("left out")].sum(),
    }


def scenes(tables: Tables) -> Facts:
    """What happens in each scene, and how long it is compared."""
    endings, rows = tables["endings"].set_index("scene"), []
    for file in sorted((FIXTURES / "scenes").glob("*.json")):
        scene = json.loads(file.read_text("utf-8"))
        happens = scene["why"].partition(". ")[0].removesuffix(".")
        end = endings.loc[scene["name"]]
        since = f" from {end.still_from_s:g} s on" if end.still_from_s > 0 else ""
        until = f"{scene['compare']['until']:g} s"
        rows.append((scene_label(scene["name"]), happens, until, end.impacts, end.ending + since))
    columns = ["scene", "what happens", "compared for", "impacts until then", "in the end"]
    return {"scene_table": pd.DataFrame(rows, columns=columns)}
