"""Makes a report of the score record: one module for each format, which starts nothing.

Imports: assignment, common, grading, submission.
"""

from pathlib import Path
from typing import Any

from bounce_grader.common.escaping import json_document

NAMES = ("gradescope", "prairielearn", "autolab", "github", "html", "junit", "json", "markdown")


def render(name: str, record: dict[str, Any], submission: Path) -> str:
    from bounce_grader.formats import (
        autolab,
        github,
        gradescope,
        html,
        junit,
        markdown,
        prairielearn,
    )

    if name == "github":
        github.leave(record, submission)
        return github.render(record, submission)
    if name == "html":
        return html.render(record).rstrip("\n")
    if name == "json":
        return json_document(record, indent=1)
    modules = {
        "gradescope": gradescope,
        "prairielearn": prairielearn,
        "autolab": autolab,
        "junit": junit,
        "markdown": markdown,
    }
    return modules[name].render(record)


def refused(name: str | None, sentence: str) -> str:
    """For a submission that can't be read, in the formats that have words for that; else empty."""
    from bounce_grader.formats import github, gradescope, html, prairielearn

    modules = {"gradescope": gradescope, "prairielearn": prairielearn}
    modules |= {"github": github, "html": html}
    return modules[name].refused(sentence) if name in modules else ""
