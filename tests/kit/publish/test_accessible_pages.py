"""axe-core, Deque's checker, finds no fault in the pages that students and instructors read, in
light and dark. It comes by npm: `npm install -g axe-core`."""

import json
import subprocess
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from animation_page import file as animation
from bounce_grader import cli
from bounce_grader.formats import html
from bounce_grader.common.paths import HANDOUT
from bounce_grader.publish import handout_page
from conftest import ROOT, solution_files, write

FIND = """
const done = arguments[arguments.length - 1];
axe.run().then(
  (found) => done(found.violations.map((v) => v.id + ": " + v.nodes.map((n) => n.html).join(" "))),
  (error) => done([String(error)]));
"""


@cache
def checker() -> str:
    try:
        root = subprocess.run(["npm", "root", "-g"], capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        pytest.skip("npm is not installed")
    program = Path(root.stdout.strip()) / "axe-core" / "axe.min.js"
    if not program.exists():
        pytest.skip("axe-core is not installed: npm install -g axe-core")
    return program.read_text("utf-8")


def graded(tmp_path: Path) -> Path:
    wrong = ROOT / "tests" / "submissions" / "mistakes" / "part3_friction_sign"
    files = solution_files() | {f.name: f.read_bytes() for f in wrong.glob("*.cpp")}
    folder, record = write(tmp_path / "doejane", files), tmp_path / "record.json"
    assert cli.main(["grade", str(folder), "--no-sanitize", "--speed", "--json", str(record)]) == 0
    page = tmp_path / "grade.html"
    page.write_text(html.render(json.loads(record.read_text()), "doejane"), "utf-8")
    return page


def of_a_class(tmp_path: Path) -> Path:
    for name in ("anna", "bert"):
        comment = f"// by {name}\n".encode()
        write(tmp_path / "in" / name, {f: comment + t for f, t in solution_files().items()})
    out = tmp_path / "out"
    assert cli.main(["class", str(tmp_path / "in"), "--speed", "--out", str(out)]) == 0
    return out / "class.html"


def of_the_handout(name: str) -> Callable[[Path], Path]:
    def made(tmp_path: Path) -> Path:
        page = tmp_path / f"{name}.html"
        page.write_bytes(handout_page.page(HANDOUT / f"{name}.md"))
        return page

    return made


def faults(driver: Any, page: Path, scheme: str) -> list[str]:
    features = [{"name": "prefers-color-scheme", "value": scheme}]
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})
    driver.get(page.as_uri())
    driver.execute_script(checker())
    found: list[str] = driver.execute_async_script(FIND)
    return found


MADE = {
    "grade": graded,
    "class": of_a_class,
    "handout": of_the_handout("README"),
    "explore": of_the_handout("explore"),
}


@pytest.mark.long
@pytest.mark.parametrize("name", MADE)
def test_a_page_has_no_fault(name: str, tmp_path: Path, driver: Any) -> None:
    checker()
    page = MADE[name](tmp_path)
    assert {scheme: faults(driver, page, scheme) for scheme in ("light", "dark")} == {
        "light": [],
        "dark": [],
    }


@pytest.mark.long
@pytest.mark.usefixtures("driver")
def test_the_animation_has_no_fault(animation: Path, driver: Any) -> None:
    assert [faults(driver, animation, scheme) for scheme in ("light", "dark")] == [[], []]
