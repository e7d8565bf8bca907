"""Works out the facts of the page on the engines from its tables."""

from statistics import median_high, quantiles
from typing import Any

from bounce_study import measurements
from bounce_study.chart_style import FINE, FINEST, METHODS
from bounce_study.measurements import Run
from bounce_study.tables import number, numbers, Row, Table, Tables

RATIO = ("times", "lower_quartile", "upper_quartile")
NO_ENGINES = ("numpy", "assignment", "assignment_fast", "moreau_jean_2")
USEFUL = 1e-2  # m: larger errors aren't compared
PACKAGED_BY = "Debian 12, of 2023,"
DIFFERS = 3.0  # times: what a setting has to change to be worth a row
Facts = dict[str, Any]


def facts(tables: Tables) -> Facts:
    peers = [measurements.run_of(row, True) for row in tables["peers"].rows]
    ours = [measurements.run_of(row, False) for row in tables["peers_beside"].rows]
    engines = [run for run in peers if run.method != "numpy"]
    scenes = measurements.scenes(ours)
    swept = [row["engine"] for row in tables["peers_settings"].where(swept="1")]
    names = [name for name in swept if name not in NO_ENGINES]
    leads = [_lead(tables, ours, engines, scene) for scene in scenes]
    least = _least_steps(engines)
    least_dt = median_high(least.values())  # of most engines
    dantzig = [name for name in _variant_names(tables) if "_dantzig" in name]
    return {
        "scenes": scenes,
        "engines": names,
        "titles": titles(tables),
        "packaged_by": PACKAGED_BY,
        "settings": tables["peers_settings"].rows,
        "steps": _steps(tables["peers_steps"]),
        **_contact_step(tables["peers_steps"]),
        "leads": leads,
        "closest": min(leads, key=lambda lead: lead["times"]),
        "ahead": [lead["scene"] for lead in leads if lead["times"] <= 1],
        "least_dt": least_dt,
        "starts": measurements.STARTS,
        "useful": USEFUL,
        "largest_dt": max(run.setting for run in engines),
        "close_dt": measurements.CLOSE,
        "other_least_dt": {name: dt for name, dt in least.items() if not 0.5 < dt / least_dt < 2},
        "step_ratio": measurements.step_ratio(engines),
        "saw_tooth": quantiles(_saw_tooth(tables), n=10),
        "numpy_dt": min((r.setting for r in peers if r.method == "numpy"), default=float("inf")),
        **_errors(engines, scenes, names),
        "failures": [_failure(peers, name) for name in names],
        "variant_steps": numbers(tables["peers_variants"].rows, "dt_s"),
        "variants": _variants(tables, scenes),
        "dantzig": _over_steps(tables, "oblique_bounce", dantzig),
        "soft": _over_steps(tables, "flat_drop", ["mujoco", "mujoco_5"]),
        **_lcp(tables),
    }


def _least_steps(engines: list[Run]) -> dict[str, float]:
    least: dict[str, float] = {}
    for run in engines:
        least[run.method] = min(run.setting, least.get(run.method, run.setting))
    return least


def titles(tables: Tables) -> dict[str, str]:
    """Names the engines, and our methods."""
    settings = tables["peers_settings"].rows if "peers_settings" in tables else []
    named = {row["engine"]: row["title"] for row in settings if row["title"]}
    return {name: style.label for name, style in METHODS.items()} | named


def in_sentence(title: str) -> str:
    """Writes a title without its comma, which would be taken for the sentence's."""
    name, _, settings = title.partition(", ")
    return f"{name} ({settings})" if settings else name


def _steps(table: Table) -> list[Facts]:
    """Gives for each engine the rows of its steps in flight and in contact."""
    flight = {row["engine"]: row for row in table.where(kind="flight")}
    contact = sorted(table.where(kind="contact"), key=lambda row: number(row, "ns_per_step"))
    return [{"engine": row["engine"], "kinds": [flight[row["engine"]], row]} for row in contact]


def _contact_step(table: Table) -> Facts:
    contact = {row["engine"]: row for row in table.where(kind="contact")}
    engines = [row for name, row in contact.items() if name not in NO_ENGINES]
    return {
        "ours_contact": contact["assignment_fast"],
        "numpy_contact": contact.get("numpy"),
        "two_corners_contact": contact["moreau_jean_2"],
        "fastest_contact": min(engines, key=lambda row: number(row, "ns_per_step")),
        "most_exact_contact": min(engines, key=lambda row: number(row, "error_m")),
    }


def _lead(tables: Tables, ours: list[Run], engines: list[Run], scene: str) -> Facts:
    """Says how many times as long the closest engine takes as ours at the same error or less (0:
    none of ours is as good), and the fastest of ours and of the engines, for both tolerances."""
    closest = min(compared(tables, scene), key=lambda row: float(row["times"] or 0))
    fastest = [
        next(iter(measurements.ranking(runs, scene, tolerance)), None)
        for tolerance in (FINE, FINEST)
        for runs in (ours, engines)
    ]
    ratio = {column: float(closest[column] or 0) for column in RATIO}
    at = {"dt": number(closest, "engine_dt_s"), "error": number(closest, "error_m")}
    return {"scene": scene, "engine": closest["engine"], "fastest": fastest, **ratio, **at}


def compared(tables: Tables, scene: str) -> list[Row]:
    """Gives the ratios at the error of each engine and step, where that is of use."""
    rows = tables["peers_ratios"].where(scene=scene, within="peer's own")
    own = [row for row in rows if row["engine"] not in NO_ENGINES]
    return [row for row in own if number(row, "error_m") <= USEFUL]


def engine_of(name: str) -> str:
    """Names the engine of one of its settings."""
    return name.partition("_")[0]


def _saw_tooth(tables: Tables) -> list[float]:
    """Divides the largest error of the starts by the least, for every engine and step."""
    rows = [row for row in tables["peers"].rows if float(row["least_error_m"]) > 1e-9]
    return [number(row, "largest_error_m") / number(row, "least_error_m") for row in rows]


def _errors(engines: list[Run], scenes: list[str], names: list[str]) -> Facts:
    least = {
        scene: [min(run.error for run in measurements.of(engines, scene, name)) for name in names]
        for scene in scenes
    }
    engines_of_all = {engine_of(name) for name in names}
    agreeing = {
        scene: len({engine_of(name) for name, error in zip(names, errors) if error <= FINE})
        for scene, errors in least.items()
    }
    hardest = min(scenes, key=lambda scene: (agreeing[scene], -min(least[scene])))
    return {
        "least_errors": least,
        "reached": {
            tolerance: [sum(e <= tolerance for e in errors) for errors in zip(*least.values())]
            for tolerance in (FINE, FINEST)
        },
        "number_of_engines": len(engines_of_all),
        "agreeing": sum(2 * number >= len(engines_of_all) for number in agreeing.values()),
        "hardest_scene": hardest,
        "hardest_error": min(least[hardest]),
    }


def _failure(peers: list[Run], engine: str) -> Facts:
    """Says where the engine has stalled, and where it still converges and needs a smaller step."""
    notes = {run.scene: run.note for run in peers if run.method == engine and run.note}
    stalled = [scene for scene, note in notes.items() if note.startswith("stalls")]
    others = {scene: note for scene, note in notes.items() if scene not in stalled}
    doubtful = [
        scene
        for scene in others
        if not measurements.converges(measurements.of(peers, scene, engine))
    ]
    return {
        "engine": engine,
        "stalled": stalled,
        "reason": notes[stalled[0]].partition(": ")[2] if stalled else "",
        "doubtful": doubtful,
        "slow": [{"scene": s, "note": note} for s, note in others.items() if s not in doubtful],
    }


def _variant_names(tables: Tables) -> list[str]:
    return list(dict.fromkeys(row["engine"] for row in tables["peers_variants"].where(swept="0")))


def variant_errors(tables: Tables, scene: str, engine: str) -> list[float]:
    """Gives the errors from the largest step to the smallest."""
    rows = tables["peers_variants"].where(scene=scene, engine=engine)
    return numbers(sorted(rows, key=lambda row: -number(row, "dt_s")), "error_m")


def _variants(tables: Tables, scenes: list[str]) -> list[tuple[str, str, float, float]]:
    """Lists title, scene, and the errors of the variant and of the settings in the sweep."""
    known, rows = titles(tables), []
    for scene in scenes:
        for engine in _variant_names(tables):
            error = variant_errors(tables, scene, engine)[-1]
            best = variant_errors(tables, scene, engine.partition("_")[0])[-1]
            if error > DIFFERS * best and error > FINE:
                rows.append((known[engine], scene, error, best))
    return sorted(rows)


def _over_steps(tables: Tables, scene: str, engines: list[str]) -> list[Facts]:
    errors = {engine: variant_errors(tables, scene, engine) for engine in engines}
    return [{"engine": engine, "errors": own} for engine, own in errors.items() if own]


def _lcp(tables: Tables) -> Facts:
    """Leaves Siconos out where it was not installed."""
    rows = tables["peers_lcp"].rows if "peers_lcp" in tables else []
    siconos = [row for row in rows if row["solver"].startswith("Siconos")]
    return {
        "lcp": rows,
        "lcp_given_more": next((row for row in rows if "given a, b and c" in row["solver"]), None),
        "siconos_apart": max(numbers(siconos, "difference_m_per_s"), default=0.0),
        "siconos_best": min(siconos, key=lambda row: number(row, "ns_per_lcp"), default=None),
    }
