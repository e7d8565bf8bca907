"""Pages from Jinja2 templates. Whatever a page is given is escaped where it is printed."""

from functools import cache
from pathlib import Path
from typing import Any

from bounce_grader.common.escaping import html
from bounce_grader.common.packages import find_installed

PACKAGE = Path(__file__).resolve().parents[1]


def fill(template: str, **values: Any) -> str:
    """`template` is a path in this package; a name that it lacks raises jinja2.UndefinedError."""
    return str(_environment().get_template(template).render(values))


@cache
def _environment() -> Any:
    find_installed()
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    return Environment(
        loader=FileSystemLoader(PACKAGE),
        autoescape=True,
        finalize=_escaped,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )


def _escaped(value: Any) -> Any:
    """Jinja asks this for every printed value, and would itself leave controls and commands in it.
    A drawing and a macro's markup have __html__, and stay."""
    from markupsafe import Markup

    return value if hasattr(value, "__html__") else Markup(html(str(value)))
