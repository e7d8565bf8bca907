"""docs/studies/peers.md: a template, and facts worked out from the tables beside the page."""

import csv
import math
import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

TEMPLATE = Path(__file__).parent / "pages" / "peers.md"
FINE, FINEST = 1e-3, 1e-6  # m
LEAD_TOLERANCES = (FINE, FINEST)
DIFFERS = 3.0
ORIGIN = ("machine", "compiler", "flags", "times", "date")
RATIO = ("times", "lower_quartile", "upper_quartile")

OURS = {
    "assignment": "the assignment's scheme, plain",
    "assignment_fast": "the assignment's scheme, fastest",
    "assignment_delta_dt": "the assignment's scheme, δ per Δt",
    "moreau_jean_1": "Moreau-Jean, one corner",
    "moreau_jean_2": "Moreau-Jean, two corners",
    "penalty": "springs and dampers",
    "event_driven": "event-driven",
}

Row = dict[str, str]


@dataclass(frozen=True)
class Point:
    scene: str
    method: str
    dt: float
    ns: float  # per simulated second
    error: float  # m


@dataclass(frozen=True)
class Data:
    origin: dict[str, str]
    settings: list[Row]
    steps: list[Row]
    variants: list[Row]
    lcp: list[Row]
    notes: list[Row]
    ratios: list[Row]
    peers: list[Point]
    ours: list[Point]

    @property
    def scenes(self) -> list[str]:
        return list(dict.fromkeys(point.scene for point in self.ours))

    def engines(self) -> list[str]:
        """Those of the sweep, without numpy: it is the assignment's scheme."""
        return [row["engine"] for row in self.settings if row["swept"] == "1" and not _own(row)]

    def title(self, engine: str) -> str:
        titles = {row["engine"]: row["title"] for row in self.settings}
        return titles.get(engine) or OURS.get(engine) or engine


def page(folder: Path) -> str:
    facts = facts_of(read(folder))
    return re.sub(r"\{([a-z_]+)\}", lambda name: facts[name[1]], TEMPLATE.read_text())


def read(folder: Path) -> Data:
    peers = _rows(folder / "peers.csv")
    lcp = folder / "peers_lcp.csv"
    return Data(
        origin=_origin(folder / "peers.csv"),
        settings=_rows(folder / "peers_settings.csv"),
        steps=_rows(folder / "peers_steps.csv"),
        variants=_rows(folder / "peers_variants.csv"),
        lcp=_rows(lcp) if lcp.exists() else [],
        notes=[row for row in peers if row["note"]],
        ratios=_rows(folder / "peers_ratios.csv"),
        peers=[_point(row) for row in peers],
        ours=[_point(row) for row in _rows(folder / "peers_beside.csv")],
    )


def _rows(file: Path) -> list[Row]:
    lines = file.read_text().splitlines()
    return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def _origin(file: Path) -> dict[str, str]:
    comments = [
        line[2:].partition(": ") for line in file.read_text().splitlines() if line[0] == "#"
    ]
    return {name: value for name, _, value in comments}


def _point(row: Row) -> Point:
    return Point(
        row["scene"],
        row["method"],
        float(row["setting"]),
        float(row["ns_per_simulated_second"]),
        float(row["error_m"]),
    )


def _own(row: Row) -> bool:
    return row["engine"] in ("numpy", "assignment", "assignment_fast")


# --- facts ---


def facts_of(data: Data) -> dict[str, str]:
    by_kind = {kind: [row for row in data.steps if row["kind"] == kind] for kind in _kinds(data)}
    contact = by_kind["contact"]
    engines = [row for row in contact if not _own(row)]
    fastest = min(engines, key=lambda row: float(row["ns_per_step"]))
    ours = next(row for row in contact if row["engine"] == "assignment_fast")
    numpy = next((row for row in contact if row["engine"] == "numpy"), None)
    return {
        **{name: data.origin.get(name, "?") for name in ORIGIN},
        "scene_count": _count(len(data.scenes)),
        "lead_sentence": _lead_sentence(data),
        "ours_contact": _time(float(ours["ns_per_step"])),
        "fastest_contact_name": data.title(fastest["engine"]),
        "fastest_contact_ratio": _times(float(fastest["ratio"])),
        "numpy_contact_ratio": _times(float(numpy["ratio"])) if numpy else "?",
        "contact_error_sentence": _contact_error_sentence(data, contact),
        "agreement_sentence": _agreement_sentence(data),
        "settings_table": _settings_table(data),
        "dt": _seconds(float(contact[0]["dt_s"])),
        "steps_table": _steps_table(data, by_kind),
        "least_dt": _seconds(min(p.dt for p in data.peers if p.method != "numpy")),
        "numpy_dt": _seconds(
            min([p.dt for p in data.peers if p.method == "numpy"], default=math.inf)
        ),
        "lead_table": _lead_table(data),
        "fine": _metres(FINE),
        "finest": _metres(FINEST),
        "errors_table": _errors_table(data),
        "failures": _failures(data),
        "variant_dt": _seconds(min(float(row["dt_s"]) for row in data.variants)),
        "variants_table": _variants_table(data),
        "soft_sentence": _soft_sentence(data),
        "dantzig_sentence": _dantzig_sentence(data),
        "lcp_contacts": data.lcp[0]["contacts"] if data.lcp else "no",
        "lcp_table": _lcp_table(data),
        "lcp_sentence": _lcp_sentence(data),
    }


def _kinds(data: Data) -> list[str]:
    return list(dict.fromkeys(row["kind"] for row in data.steps))


def least_time(points: list[Point], scene: str, error: float) -> Point | None:
    """The fastest that is no worse than `error`."""
    good = [p for p in points if p.scene == scene and p.error <= error]
    return min(good, key=lambda p: p.ns) if good else None


@dataclass(frozen=True)
class Lead:
    """How many times as long an engine takes as ours at the same error or less."""

    times: float  # 0 where none of ours is as good
    lower: float
    upper: float
    engine: str


def _lead(row: Row) -> Lead:
    times, lower, upper = (float(row[name] or 0) for name in RATIO)
    return Lead(times, lower, upper, row["engine"])


def lead(data: Data, scene: str) -> Lead:
    """That of the closest engine."""
    rows = [r for r in data.ratios if r["scene"] == scene and r["within"] == "peer's own"]
    leads = [_lead(row) for row in rows if row["engine"] != "numpy"]
    return min(leads, key=lambda each: each.times)


def _lead_sentence(data: Data) -> str:
    leads = {scene: lead(data, scene) for scene in data.scenes}
    behind = [scene for scene, each in leads.items() if each.times <= 1]
    least = min(leads, key=lambda scene: leads[scene].times)
    closest = leads[least]
    if behind:
        return f"Except for {_listed(_scene(s) for s in behind)}, where an engine is ahead."
    return (
        "In each of them some method of ours is faster than every engine at the same error; the "
        f"closest is {data.title(closest.engine)} in {_scene(least)}, which takes "
        f"{_times(closest.times)} times as long."
    )


def _contact_error_sentence(data: Data, contact: list[Row]) -> str:
    ours = next(row for row in contact if row["engine"] == "assignment_fast")
    engines = [row for row in contact if not _own(row)]
    best = min(engines, key=lambda row: float(row["error_m"]))
    return (
        f"after a second of sliding, with the same step of {_seconds(float(ours['dt_s']))}, it is "
        f"{_metres(float(ours['error_m']))} off, and {data.title(best['engine'])} "
        f"{_metres(float(best['error_m']))}."
    )


def _agreement_sentence(data: Data) -> str:
    together = []
    for scene in data.scenes:
        close = {p.method for p in data.peers if p.scene == scene and p.error <= FINE}
        together.append(len(close & set(data.engines())))
    least = min(range(len(together)), key=lambda i: together[i])
    return (
        f"in every scene at least {_count(together[least])} of the {_count(len(data.engines()))} "
        f"come within {_metres(FINE)} of it as their steps shrink, with {_scene(data.scenes[least])} "
        "the hardest."
    )


def _settings_table(data: Data) -> str:
    header = ["engine", "version", "numbers", "planar by", "ε", "μ", "contact", "Euler, with"]
    names = ("title", "version", "numbers", "planar", "restitution", "friction", "contact", "order")
    return _table(header, [[row[name] for name in names] for row in data.settings])


def _steps_table(data: Data, by_kind: dict[str, list[Row]]) -> str:
    header = ["", "flight", "times", "quartiles", "error", "contact", "times", "quartiles", "error"]
    rows = []
    for contact in sorted(by_kind["contact"], key=lambda row: float(row["ns_per_step"])):
        flight = next(r for r in by_kind["flight"] if r["engine"] == contact["engine"])
        row = [data.title(contact["engine"])]
        for kind in (flight, contact):
            spread = " to ".join(
                _times(float(kind[name])) for name in ("ratio_lower", "ratio_upper")
            )
            row += [_time(float(kind["ns_per_step"])), _times(float(kind["ratio"])), spread]
            row.append(_metres(float(kind["error_m"])))
        rows.append(row)
    return _table(header, rows)


def _lead_table(data: Data) -> str:
    engines = [p for p in data.peers if p.method != "numpy"]
    header = ["scene"]
    for tolerance in LEAD_TOLERANCES:
        header += [f"ours, {_metres(tolerance)}", "engines"]
    rows = []
    for scene in data.scenes:
        row = [_scene(scene)]
        for tolerance in LEAD_TOLERANCES:
            row.append(_who(data, least_time(data.ours, scene, tolerance)))
            row.append(_who(data, least_time(engines, scene, tolerance)))
        closest = lead(data, scene)
        spread = f"{_times(closest.lower)} to {_times(closest.upper)}"
        rows.append([*row, _times(closest.times), spread, data.title(closest.engine)])
    return _table([*header, "times at the same error", "quartiles", "closest"], rows)


def _who(data: Data, point: Point | None) -> str:
    return f"{_time(point.ns)}, {data.title(point.method)}" if point else "never"


def _errors_table(data: Data) -> str:
    engines = data.engines()
    least = {
        (scene, engine): min(p.error for p in data.peers if p.scene == scene and p.method == engine)
        for scene in data.scenes
        for engine in engines
    }
    rows = [[_scene(s), *(_metres(least[s, e]) for e in engines)] for s in data.scenes]
    for tolerance in LEAD_TOLERANCES:
        reached = [sum(least[s, e] <= tolerance for s in data.scenes) for e in engines]
        rows.append([f"scenes within {_metres(tolerance)}", *(str(n) for n in reached)])
    return _table(["scene", *(data.title(engine) for engine in engines)], rows)


def _failures(data: Data) -> str:
    """By engine: where it has stalled, and where it still converges and needs a smaller step."""
    lines = []
    for engine in data.engines():
        said = {row["scene"]: row["note"] for row in data.notes if row["method"] == engine}
        stalled = {s: note for s, note in said.items() if note.startswith("stalls")}
        slow = [f"{_scene(s)} ({note})" for s, note in said.items() if s not in stalled]
        parts = []
        if stalled:
            reason = next(iter(stalled.values())).partition(": ")[2]
            parts.append(f"stalls in {_listed(map(_scene, stalled))}: {reason}")
        if slow:
            parts.append(f"still converges in {_listed(slow)}")
        if parts:
            lines.append(f"- {data.title(engine)} {'; it '.join(parts)}.")
    return "\n".join(lines) or "- None."


def _variant_errors(data: Data, scene: str, engine: str) -> list[float]:
    """From the largest step to the smallest."""
    own = [row for row in data.variants if row["scene"] == scene and row["engine"] == engine]
    return [float(row["error_m"]) for row in sorted(own, key=lambda row: -float(row["dt_s"]))]


def _variants(data: Data) -> list[str]:
    return list(dict.fromkeys(row["engine"] for row in data.variants if row["swept"] == "0"))


def _variants_table(data: Data) -> str:
    rows = []
    for scene in data.scenes:
        for engine in _variants(data):
            error = _variant_errors(data, scene, engine)[-1]
            best = _variant_errors(data, scene, engine.partition("_")[0])[-1]
            if error > DIFFERS * best and error > FINE:
                rows.append([data.title(engine), _scene(scene), _metres(error), _metres(best)])
    return _table(["settings", "scene", "error", "with those of the sweep"], sorted(rows))


def _dantzig_sentence(data: Data) -> str:
    scene = "oblique_bounce"
    said = _listed(
        _over_steps(data, scene, engine) for engine in _variants(data) if "_dantzig" in engine
    )
    return f"In the {_scene(scene)}, {_steps_swept(data)}, {said}."


def _soft_sentence(data: Data) -> str:
    scene = "flat_drop"
    engines = [e for e in ("mujoco", "mujoco_5") if _variant_errors(data, scene, e)]
    said = _listed(_over_steps(data, scene, engine) for engine in engines)
    return f"In the {_scene(scene)}, {_steps_swept(data)}, {said}." if engines else ""


def _steps_swept(data: Data) -> str:
    steps = [float(row["dt_s"]) for row in data.variants]
    return f"with steps from {_seconds(max(steps))} to {_seconds(min(steps))}"


def _over_steps(data: Data, scene: str, engine: str) -> str:
    errors = _variant_errors(data, scene, engine)
    return (
        f"{data.title(engine)} stays between {_metres(min(errors))} and {_metres(max(errors))} off "
        f"({_metres(errors[-1])} with the smallest)"
    )


def _lcp_table(data: Data) -> str:
    header = ["solver", "one LCP", "times", "residual, m/s", "refused", "wrong"]
    return _table(
        header,
        [
            [
                row["solver"],
                _time(float(row["ns_per_lcp"])),
                _times(float(row["ratio"])),
                _short(float(row["residual_m_per_s"])),
                row["refused"],
                row["wrong"],
            ]
            for row in data.lcp
        ],
    )


def _lcp_sentence(data: Data) -> str:
    siconos = [row for row in data.lcp if row["solver"].startswith("Siconos")]
    if not siconos:
        return "Siconos was not installed."
    best = min(siconos, key=lambda row: float(row["ns_per_lcp"]))
    apart = max(float(row["difference_m_per_s"]) for row in siconos)
    return (
        f"All agree with the closed form to {_short(apart)} m/s, and the fastest of Siconos takes "
        f"{_times(float(best['ratio']))} times as long."
    )


# --- words ---


def _short(value: float) -> str:
    if value == 0:
        return "0"
    if not math.isfinite(value):
        return "∞"
    if 1e-3 <= abs(value) < 1e4:
        return f"{float(f'{value:.2g}'):g}"
    mantissa, _, power = f"{value:.1e}".partition("e")
    return f"{float(mantissa):g}e{int(power)}"


def _times(value: float) -> str:
    if value < 10:
        return f"{value:.2g}"
    digits = 2 - math.floor(math.log10(value)) - 1
    return f"{round(value, digits):,.0f}"


def _time(ns: float) -> str:
    ns = float(f"{ns:.2g}")
    for size, unit in ((1e9, "s"), (1e6, "ms"), (1e3, "µs")):
        if ns >= size:
            return f"{_short(ns / size)} {unit}"
    return f"{_short(ns)} ns"


def _seconds(value: float) -> str:
    return f"{_short(value)} s"


def _metres(value: float) -> str:
    value = float(f"{value:.2g}")
    for size, unit in ((1.0, "m"), (1e-2, "cm"), (1e-3, "mm"), (1e-6, "µm")):
        if value >= size:
            return f"{_short(value / size)} {unit}"
    return f"{_short(value)} m"


def _count(n: int) -> str:
    words = "no one two three four five six seven eight nine ten eleven twelve".split()
    return words[n] if n < len(words) else str(n)


def _scene(name: str) -> str:
    return name.replace("_", " ")


def _listed(names: Iterable[str]) -> str:
    words = list(names)
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"


def _table(header: list[str], rows: list[list[str]]) -> str:
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)
