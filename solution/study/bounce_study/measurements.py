"""Reads the timed runs: those of our table alone; or, where engines were measured, theirs and those
of our methods in the same rounds. Times of two measurements are never mixed."""

import itertools
import math
from dataclasses import dataclass, replace

from bounce_study.tables import number, Row, Tables

COLUMNS = ("scene", "method", "setting", "setting_is", "ns_per_simulated_second", "error_m", "note")
PEERS = ("peers", "peers_beside", "peers_ratios")  # of one measurement
SAME_SCHEME = {"numpy": "assignment"}
STARTS = 5  # as in solution/study/starts.hpp
# s, as in solution/study/peers/: below, an engine's steps are further apart
CLOSE, CLOSE_OF_NUMPY = 1e-3, 1e-2
TOLERANCES = (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)


@dataclass(frozen=True)
class Run:
    """A timed simulation of a scene."""

    scene: str
    method: str
    setting: float
    step: bool  # the setting is a time step; otherwise a tolerance
    ns: float  # per simulated second
    error: float  # m
    note: str
    peer: bool


def read(tables: Tables) -> list[Run]:
    for name in ("speed_accuracy", *PEERS[:2]):
        if name in tables:
            tables[name].require(COLUMNS)
    alone = [run_of(row, False) for row in tables["speed_accuracy"].rows]
    if not compared(tables):
        return alone
    known = {run.scene for run in alone}
    notes = {(run.scene, run.method): run.note for run in alone}
    ours = [run_of(row, False) for row in tables["peers_beside"].rows]
    engines = [run_of(row, True) for row in tables["peers"].rows]
    return [_with_note(run, notes) for run in ours + engines if run.scene in known]


def compared(tables: Tables) -> bool:
    """Says whether engines were measured beside the methods as they are now. Errors don't depend on
    the machine's load: if they differ from speed_accuracy.csv, the program was another."""
    if not all(name in tables for name in PEERS):
        return False
    now = {_key(row): number(row, "error_m") for row in tables["speed_accuracy"].rows}
    return all(
        math.isclose(number(row, "error_m"), now[_key(row)], rel_tol=1e-3, abs_tol=1e-12)
        for row in tables["peers_beside"].rows
        if _key(row) in now
    )


def step_ratio(runs: list[Run]) -> float:
    """Gives the largest ratio of neighbouring close steps of a method in a scene."""
    by_line: dict[tuple[str, str], set[float]] = {}
    for run in runs:
        if run.step and run.setting > 0.97 * (CLOSE_OF_NUMPY if run.method == "numpy" else CLOSE):
            by_line.setdefault((run.scene, run.method), set()).add(run.setting)
    lines = [sorted(steps) for steps in by_line.values()]
    return max(large / small for line in lines for small, large in itertools.pairwise(line))


def _key(row: Row) -> tuple[str, str, str]:
    return row["scene"], row["method"], row["setting"]


def _with_note(run: Run, notes: dict[tuple[str, str], str]) -> Run:
    """Adds the note in speed_accuracy.csv for this method, or for one of the same scheme."""
    scheme = SAME_SCHEME.get(run.method, run.method)
    return replace(run, note=run.note or notes.get((run.scene, scheme), ""))


def run_of(row: Row, peer: bool) -> Run:
    names = ("setting", "ns_per_simulated_second", "error_m")
    setting, ns, error = (number(row, name) for name in names)
    step = row["setting_is"] == "dt_s"
    return Run(row["scene"], row["method"], setting, step, ns, error, row["note"], peer)


def scenes(runs: list[Run]) -> list[str]:
    return list(dict.fromkeys(run.scene for run in runs))


def methods(runs: list[Run]) -> list[str]:
    return list(dict.fromkeys(run.method for run in runs))


def peers(runs: list[Run]) -> list[str]:
    return methods([run for run in runs if run.peer])


def of(runs: list[Run], scene: str, method: str) -> list[Run]:
    return [run for run in runs if run.scene == scene and run.method == method]


def ranking(runs: list[Run], scene: str, tolerance: float) -> list[Run]:
    """Lists each method's fastest run with an error of at most `tolerance`, fastest first."""
    exact = [run for run in runs if run.scene == scene and run.error <= tolerance]
    fastest: dict[str, Run] = {}
    for run in sorted(exact, key=lambda run: (run.ns, run.method)):
        fastest.setdefault(run.method, run)
    return list(fastest.values())


def failure(runs: list[Run], tolerance: float) -> str:
    """Says why a method never comes within the tolerance in a scene, without the numbers of this
    scene: by its note, or by its last steps where a table has none. Empty where it does."""
    if not runs or min(run.error for run in runs) <= tolerance:
        return ""
    note = runs[-1].note
    if note.startswith("stalls"):
        return note.partition(": ")[2].replace("delta ", "δ ").replace(" dt ", " Δt ")
    if note and not note.startswith("order"):
        return note
    if converges(runs):
        return "still converges: needs a smaller Δt than was tried"
    return "stalls: a smaller Δt does not help, or the error falls more slowly than √Δt"


def _finest(runs: list[Run]) -> Run:
    return min(runs, key=lambda run: run.setting)


def _coarser(runs: list[Run], times: float) -> Run | None:
    """Gives the run with the least step that is this many times the finest or more."""
    least = 0.97 * times * _finest(runs).setting
    coarser = [run for run in runs if run.setting >= least]
    return _finest(coarser) if coarser else None


def converges(runs: list[Run]) -> bool:
    """Says whether the error falls with the root of the step or faster at the end, over a factor of
    three and of ten."""
    last, middle, before = _finest(runs), _coarser(runs, 3), _coarser(runs, 10)
    if middle is None or before is None:
        return False
    root = math.sqrt(last.setting / before.setting)
    return last.error < middle.error < before.error and last.error <= root * before.error
