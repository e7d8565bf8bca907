"""Lays out reports: one module for each format."""

from importlib import import_module
from bounce_grader.common.escaping import json_document
from bounce_grader.grading.report import Report

NAMES = ("gradescope", "github", "html", "junit", "json", "markdown")
OF_UNREADABLE = ("gradescope", "github", "html")  # those that report on what can't be read


def render(name: str, record: Report) -> str:
    """The text of a report."""
    if name == "json":
        return json_document(record, indent=1)
    return str(import_module(f"{__name__}.{name}").render(record)).removesuffix("\n")


def refused(name: str | None, sentence: str) -> str:
    """The report on a submission that can't be read; empty for formats without one."""
    known = name in OF_UNREADABLE
    return str(import_module(f"{__name__}.{name}").refused(sentence)) if known else ""
