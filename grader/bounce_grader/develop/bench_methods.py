"""Times a step and an LCP of each contact method, for ./kit bench. Goals are ratios to a contact
step of `assignment`, the assignment's scheme without the shortcuts of `assignment_fast`, measured
in the same run."""

import json
import subprocess

from bounce_grader.common.paths import BUILD
from bounce_grader.develop.bench import Line

PROGRAM = BUILD / "kit_methods_bench"
PLAIN = "step: assignment, contact"
GOALS = {  # the largest allowed ratio to the plain contact step
    "step: assignment_fast, contact": 12 / 24,
    "step: assignment_fast, flight": 3 / 24,
    "LCP: closed form": 6 / 24,
}


def lines() -> list[Line]:
    done = subprocess.run(
        [str(PROGRAM), "--benchmark_format=json"], stdout=subprocess.PIPE, check=True
    )
    all_runs = json.loads(done.stdout)["benchmarks"]
    ns = {run["name"]: float(run["ns_each"]) for run in all_runs}
    rows = []
    for run in all_runs:
        name = run["name"]
        left = f"  residual {run['residual']:.1e} m/s" if "residual" in run else ""
        rows.append(Line(name + left, ns[name], "ns"))
        if name in GOALS:
            ratio, goal = ns[name] / ns[PLAIN], GOALS[name]
            words = f"at most {goal:.2g}"
            rows.append(Line("  times the plain contact step", ratio, "", words, ratio <= goal))
    return rows
