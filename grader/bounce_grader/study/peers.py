"""The engines that people use, and numpy, beside our methods: `./kit study --peers`, which installs
and builds what is needed, runs this."""

import csv
import io
import json
import math
import os
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from bounce_grader import processes
from bounce_grader.errors import KitError
from bounce_grader.files import write_whole
from bounce_grader.paths import BUILD, FIXTURES, ROOT
from bounce_grader.study import peers_page

PROGRAM = BUILD / "bounce_peers"
SCENES = FIXTURES / "scenes"
STEPS = ROOT / "solution" / "study" / "peers" / "steps"
NUMPY = ROOT / "solution" / "study" / "peers" / "assignment_in_numpy.py"
NUMPY_SETTINGS = {
    "engine": "numpy",
    "title": "numpy",
    "swept": "1",
    "numbers": "double",
    "planar": "by nature",
    "restitution": "the assignment's p (eq. 10)",
    "friction": "the assignment's V (eq. 9), Lemke",
    "contact": "the assignment's scheme with its fixed delta",
    "order": "velocity first",
}

Row = dict[str, str]


@dataclass(frozen=True)
class Table:
    """A CSV with comment lines above its header."""

    comments: list[str]
    rows: list[Row]

    def text(self) -> str:
        out = io.StringIO()
        writer = csv.DictWriter(out, list(self.rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(self.rows)
        return "".join(f"{line}\n" for line in self.comments) + out.getvalue()


def run(out: Path, quick: bool) -> None:
    """Writes peers.csv, with the columns of speed_accuracy.csv, the tables beside it and the page,
    all of them or none."""
    if not PROGRAM.exists():
        raise KitError("the engines are not built: run ./kit study --peers")
    print("kit: running the engines, which takes some minutes", file=sys.stderr)
    out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=".measuring-", dir=out) as name:
        folder = Path(name)
        extent = ["--quick"] if quick else []
        done = processes.run([str(PROGRAM), str(SCENES), str(STEPS), name, *extent])
        if not done.ok:
            raise KitError(f"bounce_peers failed: {done.err.strip()}")
        add_numpy(folder, quick)
        page = peers_page.page(folder)
        for table in sorted(folder.glob("peers*.csv")):
            os.replace(table, out / table.name)
    write_whole(out / "peers.md", page)


def read(file: Path) -> Table:
    lines = file.read_text().splitlines()
    comments = [line for line in lines if line.startswith("#")]
    return Table(comments, list(csv.DictReader(lines[len(comments) :])))


def add_numpy(out: Path, quick: bool) -> None:
    """Runs the assignment in numpy and adds its rows to the tables of bounce_peers."""
    truth = _truth(read(out / "truth.csv"))
    dts = [1e-2, 3e-3, 1e-3] + ([] if quick else [3e-4, 1e-4])
    sweep = _run_numpy([(file, dt) for file in sorted(SCENES.glob("*.json")) for dt in dts], 3)
    kinds = _run_numpy([(file, None) for file in sorted(STEPS.glob("*.json"))], 9)
    peers, steps = read(out / "peers.csv"), read(out / "peers_steps.csv")
    settings = read(out / "peers_settings.csv")
    peers.rows.extend(_sweep_row(each, truth) for each in sweep)
    steps.rows.extend([_step_row(each, truth, steps) for each in kinds])
    settings.rows.append({"version": sweep[0]["version"], **NUMPY_SETTINGS})
    write_whole(out / "peers_steps.csv", steps.text())
    write_whole(out / "peers_settings.csv", settings.text())
    write_whole(out / "peers.csv", peers.text())


def _run_numpy(runs: list[tuple[Path, float | None]], turns: int) -> list[dict[str, Any]]:
    words = []
    scenes = []
    for file, dt in runs:
        scene = json.loads(file.read_text())
        scenes.append(scene)
        words += [str(file), str(dt or scene["params"]["dt"])]
    done = processes.run([sys.executable, str(NUMPY), str(turns), *words])
    if not done.ok:
        raise KitError(f"the assignment in numpy failed: {done.err.strip()[-500:]}")
    return [{**each, "data": scene} for each, scene in zip(json.loads(done.out), scenes)]


def _truth(table: Table) -> dict[str, list[list[float]]]:
    samples: dict[str, list[list[float]]] = {}
    for row in table.rows:
        motion = [float(row[name]) for name in ("x_m", "y_m", "theta_rad")]
        samples.setdefault(row["scene"], []).append(motion)
    return samples


def _error(run: dict[str, Any], truth: dict[str, list[list[float]]]) -> float:
    """The largest distance over the samples, as distance() in solution/study/scene.cpp."""
    scene = run["data"]
    arm = scene["params"]["l"] / math.sqrt(2) if scene["compare"]["quantity"] == "pose" else 0.0
    return max(
        math.hypot(x - s_x, y - s_y, arm * (theta - s_theta))
        for (x, y, theta), (s_x, s_y, s_theta) in zip(run["samples"], truth[run["scene"]])
    )


def _sweep_row(run: dict[str, Any], truth: dict[str, list[list[float]]]) -> Row:
    ns = run["ns"] / run["data"]["compare"]["until"]
    return {
        "scene": run["scene"],
        "method": "numpy",
        "setting": f"{run['dt']:.6g}",
        "setting_is": "dt_s",
        "ns_per_simulated_second": f"{ns:.6g}",
        "ns_per_step": f"{ns * run['dt']:.6g}",
        "error_m": f"{_error(run, truth):.6g}",
        "note": "",
    }


def _step_row(run: dict[str, Any], truth: dict[str, list[list[float]]], steps: Table) -> Row:
    ours = next(row["ns_per_step_ours"] for row in steps.rows if row["kind"] == run["scene"])
    ns = run["ns"] * run["dt"] / run["data"]["compare"]["until"]
    return {
        "engine": "numpy",
        "version": run["version"],
        "kind": run["scene"],
        "dt_s": f"{run['dt']:.6g}",
        "ns_per_step": f"{ns:.6g}",
        "ns_per_step_ours": ours,
        "ratio": f"{ns / float(ours):.6g}",
        "error_m": f"{_error(run, truth):.6g}",
    }
