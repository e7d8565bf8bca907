"""The packages of the grader import only what the table of docs/architecture.md says."""

import re

import pytest
from conftest import ROOT

TEXT = (ROOT / "docs" / "architecture.md").read_text("utf-8")
ROWS = re.findall(r"^\| `([a-z/]+)/` \|.*\| ?(.*?) \|$", TEXT.partition("| package |")[2], re.M)
TABLE = {package: set(re.findall(r"`([a-z.]+)`", others)) for package, others in ROWS}


@pytest.mark.parametrize("package", TABLE)
def test_a_package_imports_what_the_table_says(package: str) -> None:
    own = package.replace("/", ".")
    levels = [name.replace("/", ".") for name in TABLE]
    assert all(levels.index(other) < levels.index(own) for other in TABLE[package])
    sources = (ROOT / "grader" / "bounce_grader" / package).glob("*.py")
    text = "\n".join(file.read_text("utf-8") for file in sources)
    modules = re.findall(r"^ *from bounce_grader\.([a-z._]+) import", text, re.M)
    modules += re.findall(r"^ *from bounce_grader import ([a-z_]+)", text, re.M)
    used = {level for level in levels for m in modules if f"{m}.".startswith(f"{level}.")}
    assert used - {own} <= TABLE[package]
