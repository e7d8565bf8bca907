"""axe-core, Deque's checker, finds no fault in the pages that students and instructors read, in
light and dark. It comes by npm: `npm install -g axe-core`."""

import shutil
import subprocess
from itertools import product
from pathlib import Path
from typing import Any

import pytest
from animation_page import written
from bounce_grader import cli
from bounce_grader.common.paths import HANDOUT
from bounce_grader.publish import handout_page
from conftest import ROOT, solution_files, write

FIND = """
const done = arguments[arguments.length - 1];
axe.run().then(
  (found) => done(found.violations.map((v) => v.id + ": " + v.nodes.map((n) => n.html).join(" "))),
  (error) => done([String(error)]));
"""


def pages(folder: Path) -> list[Path]:
    written(folder / "animation.html")
    for name in ("README", "explore"):
        (folder / f"{name}.html").write_bytes(handout_page.page(HANDOUT / f"{name}.md"))
    wrong = (ROOT / "tests/submissions/mistakes/part3_friction_sign").glob("*.cpp")
    write(folder / "in/anna", solution_files())
    write(folder / "in/bert", solution_files() | {file.name: file.read_bytes() for file in wrong})
    assert cli.main(["class", str(folder / "in"), "--speed", "--out", str(folder)]) == 0
    return [*folder.glob("*.html"), *folder.glob("feedback/bert*")]


@pytest.mark.long
def test_no_page_has_a_fault(tmp_path: Path, driver: Any) -> None:
    npm = shutil.which("npm") or pytest.skip("npm is not installed")
    root = subprocess.run([npm, "root", "-g"], capture_output=True, text=True).stdout.strip()
    checker = Path(root) / "axe-core/axe.min.js"
    if not checker.exists():
        pytest.skip("axe-core is not installed: npm install -g axe-core")
    made = pages(tmp_path)
    assert len(made) == 5
    for page, scheme in product(made, ("light", "dark")):
        features = [{"name": "prefers-color-scheme", "value": scheme}]
        driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})
        driver.get(page.as_uri())
        driver.execute_script(checker.read_text("utf-8"))
        assert driver.execute_async_script(FIND) == [], f"{page.name}, {scheme}"
