"""Fills Jinja2 templates. Every value is escaped when it is printed."""

from functools import cache
from pathlib import Path
from typing import Any

from bounce_grader.common.escaping import html

PACKAGE = Path(__file__).resolve().parents[1]


def fill(template: str, **values: Any) -> str:
    """Fills a template, given by its path in this package. A missing value raises
    jinja2.UndefinedError."""
    return str(_environment().get_template(template).render(values))


@cache
def _environment() -> Any:
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
    """Escapes each printed value; Jinja's own escaping would leave control characters and commands
    to CI in it. Drawings and markup of macros have __html__, and stay as they are."""
    from markupsafe import Markup

    return value if hasattr(value, "__html__") else Markup(html(str(value)))
