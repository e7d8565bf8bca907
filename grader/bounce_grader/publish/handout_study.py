"""What the handout's study compares with, as text: every scene, and for three of them the truth
and what other methods reached in how much time. The numbers are those of fixtures/study, which
`./kit study` measures, and fixtures/scenes."""

import csv
import json
import math
from collections.abc import Iterator

from bounce_grader.common.chart_style import WORDS
from bounce_grader.common.paths import FIXTURES, SCENES

STUDIED = ("tumble", "oblique_bounce", "slide")
METHODS = {
    "assignment": WORDS["Assignment"],
    "moreau_jean_2": "Moreau\N{EN DASH}Jean scheme with two corners",
    "event_driven": "exact, event-driven simulation",
}
STUDIES = FIXTURES / "study"
KERNEL_NS = 62.0  # a call of solve_lcp, where the assignment's scheme took the times there


def text() -> str:
    others = sorted({file.stem for file in SCENES.glob("*.json")} - set(STUDIED))
    return "".join(line + "\n" for name in (*STUDIED, *others) for line in _scene(name))


def _scene(name: str) -> Iterator[str]:
    scene = json.loads((SCENES / f"{name}.json").read_text("utf-8"))
    p = scene["params"]
    numbers = [p["l"], p["m"], p["mu"], p["epsilon"], *p["g"], p["delta"], p["T"]]
    numbers += [*scene["q"], *scene["v"]]
    yield " ".join(["scene", name, *map(repr, map(float, numbers)), scene["title"]])
    if name not in STUDIED:
        return
    for row in rows("truth.csv"):
        if row["scene"] == name:
            yield " ".join(["truth", row["t_s"], row["x_m"], row["y_m"], row["theta_rad"]])
    for method, title in METHODS.items():
        reached = [
            f"{float(row['ns_per_simulated_second']) / KERNEL_NS:.4g} {float(row['own_error_m']):.4g}"
            for row in rows("speed_accuracy.csv")
            if (row["scene"], row["method"]) == (name, method) and _is_shown(row)
        ]
        yield " ".join(["other", *reached, title])


def _is_shown(row: dict[str, str]) -> bool:
    """Whether a row goes into the handout: all rows for a tolerance, but only two steps for each
    factor of ten."""
    halves = 2 * math.log10(float(row["setting"]))
    return row["method"] == "event_driven" or abs(halves - round(halves)) < 0.03


def rows(table: str) -> Iterator[dict[str, str]]:
    """The rows of a table of fixtures/study."""
    lines = (STUDIES / table).read_text("utf-8").splitlines()
    return csv.DictReader(line for line in lines if not line.startswith("#"))
