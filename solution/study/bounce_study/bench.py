"""./kit study bench ADAPTER: how fast and how exact an engine is in the study's scenes, beside the
study's methods. docs/studies/bench/README.md says what an adapter is."""

import json
import math
import os
from pathlib import Path
from typing import Any

import pandas as pd

from bounce_grader.common.errors import UsageError
from bounce_grader.common.files import write_whole
from bounce_grader.common.paths import FIXTURES
from bounce_grader.sandbox import processes
from bounce_study import charts, style, tables
from bounce_study.facts import compared
from bounce_study.numbers import metres, ratio, time

STUDY = FIXTURES / "study"
STEPS = (
    0.03,
    0.01,
    0.003,
    0.001,
    3e-4,
    1e-4,
)  # s, or nearly so: a step divides the times' distance
LIMITS = processes.Limits(60, 120, None, 64 << 20, output=1 << 20)
OWN = "own engine"  # which may have the name of another
ASKED = ("l", "m", "mu", "epsilon", "g")


def run(adapter: Path, out: Path) -> int:
    """Asks the adapter for every scene and step, prints its table, and writes bench.csv and a chart
    with its line. Raises UsageError, with the scene and the step, if an answer can't be used."""
    truth = tables.read(STUDY / "truth.csv")
    rows = []
    for file in sorted((FIXTURES / "scenes").glob("*.json")):
        scene = json.loads(file.read_text("utf-8"))
        own = truth[truth["scene"] == scene["name"]]
        gap = scene["compare"]["until"] / len(own)
        for step in dict.fromkeys(gap / max(1, round(gap / step)) for step in STEPS):
            rows.append(_measured(adapter, scene, step, own))
    runs = pd.DataFrame(rows)
    style.ENGINES[OWN] = (adapter.stem, style.INK, "s", "-")
    ours = tables.read(STUDY / "speed_accuracy.csv")
    whole = pd.concat([ours, runs.assign(method=OWN)])
    print(_table(runs, compared(whole).query("method == @OWN")))
    for name, data in {
        "bench.csv": runs.to_csv(index=False, float_format="%.5g"),
        "bench.svg": charts.speed_accuracy({"speed_accuracy": whole}),
    }.items():
        write_whole(out / name, data)
    print(f"{out} holds bench.csv and bench.svg")
    return 0


def _measured(adapter: Path, scene: dict[str, Any], step: float, truth: Any) -> dict[str, Any]:
    """A run: its error, and its time."""
    params, times = scene["params"], [float(t) for t in truth["t_s"]]
    question = {name: params[name] for name in ASKED} | {name: scene[name] for name in ("q", "v")}
    question |= {"step": step, "times": times}
    where = f"{adapter.name} in {scene['name']} with a step of {step:.3g} s"
    done = processes.run([os.path.abspath(adapter)], LIMITS, stdin=json.dumps(question).encode())
    if not done.ok:
        raise UsageError(f"{where} failed: {done.err.strip()[-200:] or f'status {done.code}'}")
    try:
        poses, ns = _read(done.out)
        expected = truth[["x_m", "y_m", "theta_rad"]].to_numpy()
        rho = params["l"] / math.sqrt(2)
        errors = [
            math.hypot(x - a, y - b, rho * math.remainder(theta - c, 2 * math.pi))
            for (x, y, theta), (a, b, c) in zip(poses, expected, strict=True)
        ]
    except (ValueError, TypeError, LookupError, OverflowError) as problem:
        wanted = f'{{"q": [[x, y, theta] for each of {len(times)} times], "ns": nanoseconds}}'
        raise UsageError(f"{where} printed no {wanted}: {problem}") from problem
    error = max(errors) if all(map(math.isfinite, errors)) else math.inf
    times_row = {"setting": step, tables.TIME: ns / times[-1], "error_m": error}
    return {"scene": scene["name"], **times_row}


def _read(printed: bytes) -> tuple[list[list[float]], float]:
    """Poses and nanoseconds of an answer, as adapter.schema.json describes it: JSON has null for a
    number that isn't finite."""
    answer = json.loads(printed)
    poses = [[math.nan if x is None else x + 0.0 for x in pose] for pose in answer["q"]]
    if not 0 < answer["ns"] < math.inf:
        raise ValueError("ns is not positive")
    return poses, answer["ns"] + 0.0


def _table(runs: Any, beside: Any) -> str:
    """A line for each scene."""
    rows = []
    for scene, own in runs.groupby("scene"):
        best = own.loc[own["error_m"].idxmin()]
        times = beside[beside["scene"] == scene]["times"]
        rows.append(
            {
                "scene": style.scene_label(scene),
                "least error": metres(best["error_m"]),
                "step": f"{best['setting']:.2g} s",
                "a simulated second takes": time(best[tables.TIME]),
                "times as long as the study's fastest that is no worse": (
                    ratio(times.min()) if len(times) else "no run within a centimetre"
                ),
            }
        )
    return str(pd.DataFrame(rows).to_string(index=False))
