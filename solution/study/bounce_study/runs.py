"""Speed against accuracy, as the charts and the pages read it: our table alone; or, where engines
were measured, theirs and what our methods took in the same rounds. Times of two runs are never mixed."""

import math
from dataclasses import dataclass, replace

from bounce_study.tables import number, Row, Tables

COLUMNS = ("scene", "method", "setting", "setting_is", "ns_per_simulated_second", "error_m", "note")
PEERS = ("peers", "peers_beside", "peers_ratios")  # of one run
SAME_SCHEME = {"numpy": "assignment"}
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
    for name in ("speed_accuracy", *PEERS[:2]):
        if name in tables:
            tables[name].require(COLUMNS)
    alone = [_run(row, False) for row in tables["speed_accuracy"].rows]
    if not compared(tables):
        return alone
    known = {run.scene for run in alone}
    notes = {(run.scene, run.method): run.note for run in alone}
    ours = [_run(row, False) for row in tables["peers_beside"].rows]
    engines = [_run(row, True) for row in tables["peers"].rows]
    return [_noted(run, notes) for run in ours + engines if run.scene in known]


def compared(tables: Tables) -> bool:
    """Whether engines were measured beside the methods as they are now: errors don't depend on the
    machine's mood, so that others than in speed_accuracy.csv are those of another program."""
    if not all(name in tables for name in PEERS):
        return False
    now = {_point(row): number(row, "error_m") for row in tables["speed_accuracy"].rows}
    beside = tables["peers_beside"].rows
    return all(
        math.isclose(number(row, "error_m"), now[_point(row)], rel_tol=1e-3, abs_tol=1e-12)
        for row in beside
        if _point(row) in now
    )


def origin(tables: Tables) -> dict[str, str]:
    """Of the table that the times are from."""
    return tables["peers_beside" if compared(tables) else "speed_accuracy"].origin


def _point(row: Row) -> tuple[str, str, str]:
    return row["scene"], row["method"], row["setting"]


def _noted(run: Run, notes: dict[tuple[str, str], str]) -> Run:
    """With the reason in speed_accuracy.csv for this method, or for one of the same scheme."""
    same = SAME_SCHEME.get(run.method, run.method)
    return replace(run, note=run.note or notes.get((run.scene, same), ""))


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
