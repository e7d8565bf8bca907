"""Tables of the handout, as text: the checks and their points, and from fixtures/ what it compares a
student's program with.

Of the study: every scene, and for three of them the truth and what other methods reached in how much
time. Of measured impacts: those of one corner of a square, and the median error of each law of impact
on them; the licence of the data stands at the top.
"""

import csv
import json
from collections.abc import Iterator
from math import log10, sqrt

from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import FIXTURES, SCENES
from bounce_grader.formats.speed_chart import NAMES

STUDIED = ("tumble", "oblique_bounce", "slide")
METHODS = {
    "assignment": NAMES["solution"],
    "moreau_jean_2": "Moreau\N{EN DASH}Jean scheme with two corners",
    "event_driven": "exact, event-driven simulation",
}
STUDIES = FIXTURES / "study"  # which ./kit study measures
KERNEL_NS = 62.0  # of a call of solve_lcp, where the assignment's scheme took these times
SIMPLER = {
    "frictionless": "a corner without friction",
    "sticking": "a corner that always sticks",
}
ASSIGNMENT = "the assignment's law, as the course solves it"


def checks() -> str:
    """For ./check: a line "part NUMBER STEM POINTS TITLE CALLS" for each part and "check ID POINTS
    TITLE" for each check, with tabs between."""
    lines: list[tuple[object, ...]] = []
    for part in parts():
        calls = " ".join(map(str, part.calls))
        lines.append(("part", part.number, part.stem, f"{part.points:g}", part.title, calls))
        lines += [("check", check.id, f"{check.points:g}", check.title) for check in part.checks]
    return "".join("\t".join(map(str, line)) + "\n" for line in lines)


def study() -> str:
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
    halves = 2 * log10(float(row["setting"]))
    return row["method"] == "event_driven" or abs(halves - round(halves)) < 0.03


def rows(table: str) -> Iterator[dict[str, str]]:
    """The rows of a table of fixtures/study."""
    lines = (STUDIES / table).read_text("utf-8").splitlines()
    return csv.DictReader(line for line in lines if not line.startswith("#"))


def measured() -> str:
    return "".join(line + "\n" for line in (*_licence(), *_laws(), *_impacts()))


def _licence() -> Iterator[str]:
    readme = (FIXTURES / "measured" / "README.md").read_text("utf-8")
    yield "# Impacts of a real square, worked out from the positions that N. Fazeli and colleagues"
    yield "# (MCube Lab, MIT) measured, published in DAIRLab/ImpactModeling under this licence:"
    for line in readme.partition("## Licence of the figures\n")[2].splitlines():
        yield f"# {line}".rstrip()
    yield "# square: l (of a uniform one with its inertia, m), mu, epsilon. floor, assignment, law:"
    yield "# the median error, m/s. impact: r of the corner (m), v before and after, as in part 1."


def _laws() -> Iterator[str]:
    laws = {row["law"]: row for row in rows("measured_laws.csv") if row["shape"] == "squares"}
    body = {row["quantity"]: row["value"] for row in rows("measured_body.csv")}
    newton = laws["newton"]
    side = sqrt(6 * float(body["gyration_squared"]))
    yield f"square {side:.5g} {newton['mu']} {newton['epsilon']}"
    yield f"floor {newton['floor_m_s']}"
    yield f"assignment {newton['median_m_s']} {ASSIGNMENT}"
    for law, name in SIMPLER.items():
        yield f"law {laws[law]['median_m_s']} {name}"


def _impacts() -> Iterator[str]:
    for row in rows("measured_impacts.csv"):
        yield " ".join(["impact", *list(row.values())[1:]])
