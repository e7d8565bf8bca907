"""Fills the pages. Their sentences are templates in pages/; every number in them is worked out from
the tables beside the page.

So a page holds when it is measured again, and a number can't be typed wrong:
tests/kit/solution/test_study_pages.py checks that the templates have none of their own.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import jinja2

from bounce_grader.common.errors import UsageError
from bounce_study import chart_style, numbers
from bounce_study import (
    facts_measured,
    facts_models,
    facts_peers,
    facts_speed,
    facts_stability,
    facts_tolerance,
)
from bounce_study.measured_part import TABLES as MEASURED
from bounce_study.tables import Tables

TEMPLATES = Path(__file__).parent / "pages"
IMAGE = re.compile(r"\]\(([a-z_]+\.svg)\)")
# What the README of the kit says under its panel, in the line after the next.
PANEL = re.compile(r"(?<=speed_accuracy_one\.svg\)\n\n).+")
Facts = dict[str, Any]


@dataclass(frozen=True)
class Page:
    name: str
    needs: tuple[str, ...]
    facts: tuple[Callable[[Tables], Facts], ...]


SPEED_PAGE, PEERS_PAGE = "speed_accuracy.md", "peers.md"
SPEED = ("speed_accuracy", "speed_ratios", "order", "truth", "examples")
STABILITY = tuple(
    "energy_gain examples rest_and_drift flat_landing depth order gauss_seidel solution_count "
    "almost_flat scaling bad_input".split()
)
MODELS = ("least_model", "chosen_model", "random_models")
TOLERANCE = ("tolerance",)
PEERS = tuple(f"peers{name}" for name in ("", "_beside", "_ratios", "_settings", "_steps"))
PAGES = (
    Page(SPEED_PAGE, SPEED, (facts_speed.facts,)),
    Page("stability.md", STABILITY, (facts_stability.facts,)),
    Page("least_model.md", MODELS, (facts_models.facts,)),
    Page("tolerance.md", TOLERANCE, (facts_tolerance.facts,)),
    Page("measured.md", MEASURED, (facts_measured.facts,)),
    Page(
        "README.md",
        SPEED + STABILITY + MODELS + TOLERANCE + MEASURED,
        (
            facts_speed.facts,
            facts_stability.facts,
            facts_models.facts,
            facts_tolerance.facts,
            facts_measured.facts,
        ),
    ),
    Page(PEERS_PAGE, (*PEERS, "peers_variants"), (facts_peers.facts,)),
)
NUMBERS = "short plain ratio percent metres plain_metres time plain_time".split()


def _environment() -> jinja2.Environment:
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(TEMPLATES),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters |= {
        **{name: _filter(getattr(numbers, name)) for name in NUMBERS},
        "number_word": numbers.number_word,
        "listed": numbers.listed,
        "method": chart_style.method_label,
        "scene": chart_style.scene_label,
        "in_sentence": facts_peers.in_sentence,
        "cell": lambda text: text.replace("|", "\\|"),  # of a Markdown table
    }
    return environment


def _filter(write: Callable[..., str]) -> Callable[..., str]:
    """Makes a filter that also takes a number as the text that a table has."""

    def written(value: float | str, *digits: int) -> str:
        try:
            return write(float(value), *digits)
        except ValueError as error:
            raise UsageError(f"{value!r} is no number; measure it again") from error

    return written


def fill(tables: Tables, charts: set[str]) -> dict[str, str]:
    """Fills the pages whose tables and charts are all there."""
    return {
        page.name: render(page.name, tables)
        for page in PAGES
        if all(name in tables for name in page.needs)
        and charts.issuperset(IMAGE.findall((TEMPLATES / page.name).read_text(encoding="utf-8")))
    }


def render(name: str, tables: Tables) -> str:
    return _environment().get_template(name).render(facts_of(name, tables))


def with_panel(readme: str, tables: Tables) -> str:
    """Replaces the sentence under the panel of the kit's README."""
    sentence = _environment().get_template("panel.md").render(facts_of(SPEED_PAGE, tables))
    return PANEL.sub(lambda _: sentence.rstrip("\n"), readme)


def facts_of(name: str, tables: Tables) -> Facts:
    """Gives all that the page's template may name."""
    page = next(page for page in PAGES if page.name == name)
    origin = tables[page.needs[0]].origin
    facts: Facts = {
        name: origin.get(name, "?") for name in ("machine", "compiler", "flags", "times", "date")
    }
    facts |= {"fine": chart_style.FINE, "finest": chart_style.FINEST}
    for facts_from in page.facts:
        facts |= facts_from(tables)
    return facts
