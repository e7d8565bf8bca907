"""Writes the handout: one zip with all that a student needs, and nothing else.

It holds the folder student/, its Markdown as pages for a browser, the tests that a student's build
runs, the public fixtures with the answers of known mistakes, and the manifest of checks, whose
points the texts say. Times and permissions are fixed, so that the same kit gives the same bytes.
"""

import argparse
from pathlib import Path

from bounce_grader.common.paths import HANDOUT, ROOT
from bounce_grader.grading.examples import TABLE
from bounce_grader.grading.fixtures import PUBLIC
from bounce_grader.publish import archive, handout_data, handout_page
from bounce_grader.publish.handout_page import with_points

TOP = "bounce"  # the folder in the zip
TESTS = ("*.?pp", "linked/*.?pp")
# Made by working in student/.
SKIPPED = {"build", "animation.html", "real.html", "study.html", "__pycache__"}
OF_EDITORS = {".clangd", ".devcontainer", ".vscode"}  # other names with a dot are left out
PAGES = ("README", "explore", "hints/*")
PROGRAMS = {"check"}
WITH_POINTS = {".md", ".hpp"}  # the files of student/ that may say points


def run(options: argparse.Namespace) -> int:
    print(f"{options.out} holds {write(options.out)} files")
    return 0


def files() -> dict[str, Path]:
    """The files of the handout, as path in the zip -> file of the kit, in order."""
    chosen = {str(f.relative_to(HANDOUT)): f for f in archive.files_in(HANDOUT, _is_skipped)}
    tests = ROOT / "tests" / "parts"
    for pattern in TESTS:
        chosen |= {f"tests/{f.relative_to(tests)}": f for f in tests.glob(pattern) if f.is_file()}
    diagnosis = ROOT / "grader" / "diagnosis"
    chosen |= {f"tests/diagnosis/{f.name}": f for f in diagnosis.iterdir()}
    runner = ROOT / "grader" / "runner"
    chosen |= {
        f"tests/{name}": runner / name for name in ("frame.hpp", "messages.hpp", "crash.hpp")
    }
    chosen |= {f"tests/linked/{f.name}": f for f in runner.glob("given_part*.cpp")}
    chosen["tests/linked/crash.cpp"] = runner / "crash.cpp"
    chosen |= {f"fixtures/public/{f.relative_to(PUBLIC)}": f for f in PUBLIC.rglob("*.json")}
    chosen[f"fixtures/public/{TABLE.name}"] = TABLE
    chosen["tests/parts.json"] = ROOT / "grader" / "parts.json"
    chosen[".clang-format"] = ROOT / ".clang-format"
    return dict(sorted(chosen.items()))


def contents() -> dict[str, bytes]:
    """What the zip holds, by path in it: these files, the pages made of Markdown, and the numbers
    of the study and of measured impacts."""
    texts = [file for name in PAGES for file in HANDOUT.glob(f"{name}.md")]
    made = {
        str(file.relative_to(HANDOUT).with_suffix(".html")): handout_page.page(file)
        for file in texts
    }
    made["tests/checks.txt"] = handout_data.checks().encode()
    made["fixtures/study.txt"] = handout_data.study().encode()
    made["fixtures/measured.txt"] = handout_data.measured().encode()
    held = {name: _as_handed_out(file) for name, file in files().items()}
    return dict(sorted({**held, **made}.items()))


def _as_handed_out(file: Path) -> bytes:
    data = file.read_bytes()
    if file.suffix in WITH_POINTS and file.is_relative_to(HANDOUT):
        return with_points(data.decode()).encode()
    return data


def _is_skipped(path: Path) -> bool:
    is_hidden = path.name.startswith(".") and path.name not in OF_EDITORS
    return path.name in SKIPPED or is_hidden


def write(path: Path) -> int:
    """Writes the zip, whole or not at all, and returns how many files it holds."""
    held = {
        f"{TOP}/{name}": (data, 0o755 if name in PROGRAMS else 0o644)
        for name, data in contents().items()
    }
    archive.write(path, held, compressed=False)
    return len(held)
