"""Tables of the handout: the checks and their points, and from fixtures/ what it compares a
student's program with.

Of the study: every scene, and for three of them the truth and what other methods reached in how much
time. Of measured impacts: those of one corner of a square, and the median error of each law of impact
on them; the licence of the data stands at the top.
"""

import csv
import json
import re
from collections.abc import Iterator
from math import log10, sqrt

from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import FIXTURES, SCENES
from bounce_grader.formats.speed_chart import NAMES

PLACE = ("t_s", "x_m", "y_m", "theta_rad")  # of the truth, and its time
STUDIED = ("tumble", "oblique_bounce", "slide")
METHODS = {
    "assignment": NAMES["solution"],
    "moreau_jean_2": "Moreau\N{EN DASH}Jean scheme with two corners",
    "event_driven": "exact, event-driven simulation",
}
STUDIES = FIXTURES / "study"  # which ./kit study measures
KERNEL_NS = 62.0  # of a call of solve_lcp, where the assignment's scheme took these times
SIMPLER = {"frictionless": "a corner without friction", "sticking": "a corner that always sticks"}
ASSIGNMENT = "the assignment's law, as the course solves it"


def checks() -> str:
    """For ./check: a line "part NUMBER STEM POINTS TITLE STEMS" for each part, with the stems of
    those that it calls, and "check ID POINTS TITLE" for each check, with tabs between."""
    lines: list[tuple[object, ...]] = []
    for part in parts():
        calls = " ".join(other.stem for other in parts() if other.number in part.calls)
        lines.append(("part", part.number, part.stem, f"{part.points:g}", part.title, calls))
        lines += [("check", check.id, f"{check.points:g}", check.title) for check in part.checks]
    return "".join("\t".join(map(str, line)) + "\n" for line in lines)


def parts_and_checks() -> str:
    """The same as JSON, for services that grade with the handout."""
    entries = (part._asdict() | {"checks": [c._asdict() for c in part.checks]} for part in parts())
    return _text({"parts": [{"part": entry.pop("number")} | entry for entry in entries]})


def study() -> str:
    others = sorted({file.stem for file in SCENES.glob("*.json")} - set(STUDIED))
    return _text([_scene(name) for name in (*STUDIED, *others)])


def _scene(name: str) -> dict[str, object]:
    scene = json.loads((SCENES / f"{name}.json").read_text("utf-8"))
    kept = {key: scene[key] for key in ("name", "title", "params", "q", "v")}
    if name not in STUDIED:
        return kept | {"truth": [], "others": []}
    own = [row for row in rows("truth.csv") if row["scene"] == name]
    truth = [[float(row[key]) for key in PLACE] for row in own]
    timed, others = [row for row in rows("speed_accuracy.csv") if row["scene"] == name], []
    for method, title in METHODS.items():
        shown = [row for row in timed if row["method"] == method and _is_shown(row)]
        times = (float(row["ns_per_simulated_second"]) / KERNEL_NS for row in shown)
        errors = (float(row["own_error_m"]) for row in shown)
        reached = [[float(f"{x:.4g}") for x in both] for both in zip(times, errors)]
        others.append({"name": title, "reached": reached})
    return kept | {"truth": truth, "others": others}


def _is_shown(row: dict[str, str]) -> bool:
    """Whether a row is handed out: all for a tolerance, but two steps for each factor of ten."""
    halves = 2 * log10(float(row["setting"]))
    return row["method"] == "event_driven" or abs(halves - round(halves)) < 0.03


def rows(table: str) -> Iterator[dict[str, str]]:
    """The rows of a table of fixtures/study."""
    lines = (STUDIES / table).read_text("utf-8").splitlines()
    return csv.DictReader(line for line in lines if not line.startswith("#"))


def measured() -> str:
    readme = (FIXTURES / "measured" / "README.md").read_text("utf-8")
    laws = {row["law"]: row for row in rows("measured_laws.csv") if row["shape"] == "squares"}
    body = {row["quantity"]: row["value"] for row in rows("measured_body.csv")}
    newton = laws["newton"]
    bars = [(ASSIGNMENT, newton["median_m_s"])]
    bars += [(name, laws[law]["median_m_s"]) for law, name in SIMPLER.items()]
    bars.append(("the least that any push at the corner leaves", newton["floor_m_s"]))
    impacts = (list(map(float, list(row.values())[1:])) for row in rows("measured_impacts.csv"))
    return _text(
        {
            "source": "Impacts of a real square, worked out from the positions that N. Fazeli and "
            "colleagues (MCube Lab, MIT) measured, published in DAIRLab/ImpactModeling under this "
            "licence. l is that of a uniform square with its inertia, in m; error is the median one "
            "of a law, in m/s; r points from the centre to the corner, in m; velocities as in part 1.",
            "licence": readme.partition("## Licence of the figures\n")[2].strip().splitlines(),
            "l": float(f"{sqrt(6 * float(body['gyration_squared'])):.5g}"),
            "mu": float(newton["mu"]),
            "epsilon": float(newton["epsilon"]),
            "bars": [{"name": name, "error": float(error)} for name, error in bars],
            "impacts": [{"r": x[:2], "before": x[2:5], "after": x[5:]} for x in impacts],
        }
    )


def _text(data: object) -> str:
    """JSON with each list of numbers in a line."""
    lines = json.dumps(data, indent=1)
    return re.sub(r'\[[^]["{}]*\]', lambda numbers: " ".join(numbers[0].split()), lines) + "\n"
