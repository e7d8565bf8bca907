"""Speed against accuracy, as the charts and the pages read it: our table, and any further one of the
same columns."""

import math
from dataclasses import dataclass

from bounce_grader.study.tables import Row, Tables, number

COLUMNS = ("scene", "method", "setting", "setting_is", "ns_per_simulated_second", "error_m", "note")
PEERS = ("peers",)
TOLERANCES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)


@dataclass(frozen=True)
class Run:
    scene: str
    method: str
    setting: float
    step: bool  # the setting is a time step; otherwise a tolerance
    ns: float  # per simulated second
    error: float  # m
    note: str
    peer: bool


def runs(tables: Tables) -> list[Run]:
    for name in ("speed_accuracy", *PEERS):
        if name in tables:
            tables[name].require(COLUMNS)
    ours = [_run(row, False) for row in tables["speed_accuracy"].rows]
    scenes = {run.scene for run in ours}
    peers = [_run(row, True) for name in PEERS if name in tables for row in tables[name].rows]
    return ours + [run for run in peers if run.scene in scenes]


def _run(row: Row, peer: bool) -> Run:
    return Run(
        scene=row["scene"],
        method=row["method"],
        setting=number(row, "setting"),
        step=row["setting_is"] == "dt_s",
        ns=number(row, "ns_per_simulated_second"),
        error=number(row, "error_m"),
        note=row["note"],
        peer=peer,
    )


def scenes(all_runs: list[Run]) -> list[str]:
    return list(dict.fromkeys(run.scene for run in all_runs))


def methods(all_runs: list[Run]) -> list[str]:
    return list(dict.fromkeys(run.method for run in all_runs))


def peers(all_runs: list[Run]) -> list[str]:
    return list(dict.fromkeys(run.method for run in all_runs if run.peer))


def least_time(all_runs: list[Run], scene: str, method: str, tolerance: float) -> float:
    """The least ns per simulated second with an error of at most `tolerance`; infinite where no
    setting that was tried gets there."""
    times = [
        run.ns
        for run in all_runs
        if run.scene == scene and run.method == method and run.error <= tolerance
    ]
    return min(times, default=math.inf)


def fastest(all_runs: list[Run], scene: str, tolerance: float) -> str | None:
    times = {m: least_time(all_runs, scene, m, tolerance) for m in methods(all_runs)}
    method = min(times, key=lambda m: times[m])
    return method if math.isfinite(times[method]) else None


def reason(own: list[Run]) -> str:
    """Why a method stays above the line in a scene, without the numbers of this scene: by its note,
    or by its last two steps where a table has none."""
    note = own[-1].note
    if note.startswith("stalls"):
        return note.partition(": ")[2].replace("delta ", "δ ").replace(" dt ", " Δt ")
    if note and not note.startswith("order"):
        return note
    finest = sorted(own, key=lambda run: run.setting)[:2]
    if note or (len(finest) == 2 and finest[0].error < 0.7 * finest[1].error):
        return "still converges: needs a smaller Δt than was tried"
    return "stalls: a smaller Δt does not help"
