"""axe-core, Deque's checker, finds no fault in the pages that students and instructors read, in
light and dark. It comes by npm: `npm install -g axe-core`."""

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest
from animation_page import written
from bounce_grader import cli
from bounce_grader.common.paths import HANDOUT
from bounce_grader.formats import html
from bounce_grader.publish import handout_page
from conftest import ROOT, solution_files, write

FIND = """
const done = arguments[arguments.length - 1];
axe.run().then(
  (found) => done(found.violations.map((v) => v.id + ": " + v.nodes.map((n) => n.html).join(" "))),
  (error) => done([String(error)]));
"""


def make(name: str, folder: Path) -> Path:
    """Makes a page, and gives its file."""
    page = folder / f"{name}.html"
    if name == "animation":
        written(page)
    elif name == "grade":
        wrong = ROOT / "tests/submissions/mistakes/part3_friction_sign"
        files = solution_files() | {f.name: f.read_bytes() for f in wrong.glob("*.cpp")}
        submission, record = str(write(folder / "doejane", files)), folder / "record.json"
        options = ["--no-sanitize", "--speed", "--json", str(record)]
        assert cli.main(["grade", submission, *options]) == 0
        page.write_text(html.render(json.loads(record.read_text()), "doejane"), "utf-8")
    elif name == "class":
        for student in ("anna", "bert"):
            comment = f"// by {student}\n".encode()
            texts = {file: comment + text for file, text in solution_files().items()}
            write(folder / "in" / student, texts)
        assert cli.main(["class", str(folder / "in"), "--speed", "--out", str(folder)]) == 0
    else:
        page.write_bytes(handout_page.page(HANDOUT / f"{name}.md"))
    return page


@pytest.mark.long
@pytest.mark.parametrize("name", ["grade", "class", "README", "explore", "animation"])
def test_a_page_has_no_fault(name: str, tmp_path: Path, driver: Any) -> None:
    npm = shutil.which("npm") or pytest.skip("npm is not installed")
    root = subprocess.run([npm, "root", "-g"], capture_output=True, text=True).stdout.strip()
    checker = Path(root) / "axe-core/axe.min.js"
    if not checker.exists():
        pytest.skip("axe-core is not installed: npm install -g axe-core")
    page = make(name, tmp_path)
    for scheme in ("light", "dark"):
        features = [{"name": "prefers-color-scheme", "value": scheme}]
        driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})
        driver.get(page.as_uri())
        driver.execute_script(checker.read_text("utf-8"))
        assert driver.execute_async_script(FIND) == [], scheme
