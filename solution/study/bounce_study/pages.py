"""Fills the pages: Jinja2 templates in pages/, whose numbers are worked out in facts.py."""

from collections.abc import Callable
from pathlib import Path

import jinja2

from bounce_study import chart_stability, facts, numbers
from bounce_study.facts import Facts
from bounce_study.tables import origins, Tables

TEMPLATES = Path(__file__).parent / "pages"
SPEED = ("speed_accuracy",)
STABILITY = (
    *("energy_gain", "examples", *chart_stability.NEEDS[1:], "almost_flat", "event_limits"),
    *("large_friction", "speed_accuracy"),
)
MODELS = ("least_model", "chosen_model", "random_models")
MEASURED = ("measured_laws", "measured_body")
EVERY = (facts.speed, facts.peers, facts.stability, facts.models, facts.tolerance, facts.measured)
Work = tuple[Callable[[Tables], Facts], ...]
PAGES: dict[str, tuple[tuple[str, ...], Work]] = {
    "speed_accuracy": (SPEED, (facts.speed, facts.peers)),
    "peers": (SPEED, (facts.peers,)),
    "stability": (STABILITY, (facts.speed, facts.stability)),
    "least_model": (MODELS, (facts.models,)),
    "tolerance": (("tolerance",), (facts.tolerance,)),
    "measured": (MEASURED, (facts.measured,)),
    "README": ((*STABILITY, *MODELS, "endings", "tolerance", *MEASURED), (*EVERY, facts.scenes)),
}


def fill(tables: Tables) -> dict[str, str]:
    """Fills the pages whose tables are all there."""
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(TEMPLATES),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        keep_trailing_newline=True,
    )
    for write in (numbers.short, numbers.ratio, numbers.metres, numbers.time):
        environment.filters[write.__name__] = write
    filled = {}
    for name, (needs, work) in PAGES.items():
        if all(table in tables for table in needs):
            known: Facts = {"measured_on": origins(tables, needs)}
            for facts_of in work:
                known |= facts_of(tables)
            if name != "peers" or known["peers"] is not None:
                filled[f"{name}.md"] = environment.get_template(f"{name}.md").render(known)
    return filled
