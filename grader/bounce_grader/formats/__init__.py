"""Makes reports from the score record: one module for each format, none of which starts a process.

May import: common, grading.
"""

from importlib import import_module
from typing import Any

from bounce_grader.common.escaping import json_document

NAMES = ("gradescope", "github", "html", "junit", "json", "markdown")


def render(name: str, record: dict[str, Any]) -> str:
    """The report on a record."""
    if name == "json":
        return json_document(record, indent=1)
    module = import_module(f"{__name__}.{name}")
    return str(module.render(record)).rstrip("\n")


def refused(name: str | None, sentence: str) -> str:
    """The report on a submission that can't be read; empty for formats without one."""
    if name not in NAMES or name == "json":
        return ""
    module = import_module(f"{__name__}.{name}")
    return str(module.refused(sentence)) if hasattr(module, "refused") else ""
