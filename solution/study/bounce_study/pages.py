"""The pages: a template's {names} stand for facts, each worked out from the tables beside the page.

So a page holds when it is measured again, and a number can't be typed wrong:
tests/kit/solution/test_study_pages.py checks that the templates have none of their own.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from bounce_grader.common.errors import KitError
from bounce_study import facts_models, facts_speed, facts_stability
from bounce_study.tables import Tables

TEMPLATES = Path(__file__).parent / "pages"
NAME = re.compile(r"\{([a-z0-9_]+)\}")
IMAGE = re.compile(r"\]\(([a-z_]+\.svg)\)")
Facts = dict[str, str]
# What the README of the kit says under its panel, in the line after the next.
PANEL = re.compile(r"(?<=speed_accuracy_one\.svg\)\n\n).+")
README_SENTENCE = (
    "In the scene {one_scene}, the fastest method within a millimetre ({one_first}) takes "
    "{one_first_time} per simulated second; the fastest of those that step {one_second_time}; "
    "with fixed δ the assignment's scheme never gets closer than {one_fixed}."
)


@dataclass(frozen=True)
class Page:
    name: str
    needs: tuple[str, ...]
    facts: tuple[Callable[[Tables], Facts], ...]


SPEED_PAGE = "speed_accuracy.md"
SPEED = ("speed_accuracy", "speed_ratios", "order", "truth")
STABILITY = (
    "energy_gain",
    "examples",
    "rest_and_drift",
    "flat_landing",
    "depth",
    "order",
    "gauss_seidel",
    "solution_count",
    "almost_flat",
    "scaling",
    "bad_input",
)
MODELS = ("least_model", "chosen_model")
PAGES = (
    Page(SPEED_PAGE, SPEED, (facts_speed.facts,)),
    Page("stability.md", STABILITY, (facts_stability.facts,)),
    Page("least_model.md", MODELS, (facts_models.facts,)),
    Page(
        "README.md",
        SPEED + STABILITY + MODELS,
        (facts_speed.facts, facts_stability.facts, facts_models.facts),
    ),
)


def fill(tables: Tables, charts: set[str]) -> dict[str, str]:
    """The pages of which all tables and charts are there."""
    filled = {}
    for page in PAGES:
        template = (TEMPLATES / page.name).read_text(encoding="utf-8")
        if all(t in tables for t in page.needs) and set(IMAGE.findall(template)) <= charts:
            filled[page.name] = _fill(page, template, tables)
    return filled


def _fill(page: Page, template: str, tables: Tables) -> str:
    facts = _facts(page, tables)

    def fact(match: re.Match[str]) -> str:
        if match[1] not in facts:
            raise KitError(f"{page.name}: there is no fact {match[1]}")
        return facts[match[1]]

    return NAME.sub(fact, template)


def with_panel(readme: str, tables: Tables) -> str:
    """The kit's README with the sentence under its panel as the tables have it now."""
    sentence = README_SENTENCE.format(**facts_of(SPEED_PAGE, tables))
    return PANEL.sub(lambda _: sentence, readme)


def facts_of(name: str, tables: Tables) -> Facts:
    """All that the page may name."""
    return _facts(next(page for page in PAGES if page.name == name), tables)


def _facts(page: Page, tables: Tables) -> Facts:
    facts = origin(tables[page.needs[0]].origin)
    for work_out in page.facts:
        facts |= work_out(tables)
    return facts


def origin(comments: dict[str, str]) -> Facts:
    return {
        name: comments.get(name, "?") for name in ("machine", "compiler", "flags", "times", "date")
    }
