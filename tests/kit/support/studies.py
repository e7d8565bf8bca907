"""The committed study: its tables, as the tests of its charts and pages read them."""

from bounce_grader.common.paths import FIXTURES, ROOT
from bounce_study import tables

STUDIES = ROOT / "docs" / "studies"
SCENES = FIXTURES / "scenes"


def committed() -> tables.Tables:
    return {file.stem: tables.read(file) for file in sorted(STUDIES.glob("*.csv"))}
