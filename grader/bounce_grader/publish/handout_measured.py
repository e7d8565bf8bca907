"""Writes the file that the handout's `./check --real` compares `form_lcp` with: measured impacts of
one corner of a square, and the median error of each law of impact on them, from fixtures/study.
The licence of the data stands at the top of the file."""

from collections.abc import Iterator
from math import sqrt

from bounce_grader.common.paths import FIXTURES
from bounce_grader.publish import handout_study

SIMPLER = {
    "frictionless": "a corner without friction",
    "sticking": "a corner that always sticks",
}
ASSIGNMENT = "the assignment's law, as the course solves it"


def text() -> str:
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
    laws = {
        row["law"]: row
        for row in handout_study.rows("measured_laws.csv")
        if row["shape"] == "squares"
    }
    body = {row["quantity"]: row["value"] for row in handout_study.rows("measured_body.csv")}
    newton = laws["newton"]
    side = sqrt(6 * float(body["gyration_squared"]))
    yield f"square {side:.5g} {newton['mu']} {newton['epsilon']}"
    yield f"floor {newton['floor_m_s']}"
    yield f"assignment {newton['median_m_s']} {ASSIGNMENT}"
    for law, name in SIMPLER.items():
        yield f"law {laws[law]['median_m_s']} {name}"


def _impacts() -> Iterator[str]:
    for row in handout_study.rows("measured_impacts.csv"):
        yield " ".join(["impact", *list(row.values())[1:]])
