"""Writes the handout: one zip with all that a student needs, and nothing else.

It holds the folder student/, its Markdown as pages for a browser, the tests that a student's build
runs, the public fixtures with the answers of known mistakes, and the manifest of checks, whose
points the texts say. Times and permissions are fixed, so that the same kit gives the same bytes.
"""

import argparse
from pathlib import Path

from bounce_grader.common.errors import UsageError
from bounce_grader.common.files import write_asked, zipped
from bounce_grader.common.paths import HANDOUT, ROOT
from bounce_grader.grading.examples import TABLE, wrong_in
from bounce_grader.publish import handout_data, handout_page, wrong_programs

TOP = "bounce"  # the folder in the zip
# Beside the folder student/: a folder of the zip, and the files of the kit in it.
FROM_THE_KIT = (
    ("", ".clang-format"),
    ("tests/", "tests/parts/*.?pp"),
    *(("tests/", f"grader/runner/{name}.hpp") for name in ("frame", "messages", "crash")),
    ("tests/diagnosis/", "grader/diagnosis/*"),
    ("given/words/", "grader/words/*.?pp"),
    ("given/words/", "grader/words/*.txt"),
    ("given/report/", "grader/report/main.cpp"),
    ("tests/linked/", "tests/parts/linked/*.?pp"),
    ("tests/linked/", "grader/runner/given_part*.cpp"),
    ("tests/linked/", "grader/runner/crash.cpp"),
    ("fixtures/public/", "fixtures/public/*.json"),
    ("fixtures/public/", f"fixtures/public/{TABLE.name}"),
    ("fixtures/public/mistakes/", "fixtures/public/mistakes/*.json"),
)
# Made by working in student/.
SKIPPED = {"build", "animation.html", "real.html", "study.html", "__pycache__"}
OF_EDITORS = {".clangd", ".devcontainer", ".vscode"}  # other names with a dot are left out
HAVE_PLACEHOLDERS = ("*.md", "hints/*.md", "include/bounce/part*.hpp")
HAVE_CASES = ("README.md", "examples.txt")


def run(options: argparse.Namespace) -> int:
    """Refuses what no longer follows from the default parameters."""
    if TABLE.read_text("utf-8") != wrong_programs.table():
        differs = f"fixtures/public/{TABLE.name} isn't what the kit writes"
        raise UsageError(f"{differs}: run ./kit fixtures")
    for name in HAVE_CASES:
        for wrong in wrong_in((HANDOUT / name).read_text("utf-8")):
            raise UsageError(f"student/{name}, {wrong}: work out this case again")
    print(f"{options.out} holds {write(options.out)} files")
    return 0


def files() -> dict[str, Path]:
    """The files of the handout, as path in the zip -> file of the kit, in order."""
    own = (file for file in HANDOUT.rglob("*") if file.is_file() and not file.is_symlink())
    within = {str(file.relative_to(HANDOUT)): file for file in own}
    chosen = {name: file for name, file in within.items() if not _is_skipped(name)}
    for to, pattern in FROM_THE_KIT:
        chosen |= {f"{to}{file.name}": file for file in ROOT.glob(pattern)}
    return dict(sorted(chosen.items()))


def contents() -> dict[str, bytes]:
    """What the zip holds, by path: these files, the pages, and the numbers of the study and of
    impacts."""
    held = {name: file.read_bytes() for name, file in files().items()}
    some = (file for pattern in HAVE_PLACEHOLDERS for file in HANDOUT.glob(pattern))
    texts = {str(file.relative_to(HANDOUT)): file.read_text("utf-8") for file in some}
    handout_page.require_placeholders(texts)
    held |= {name: handout_page.filled_in(text).encode() for name, text in texts.items()}
    for text in handout_page.sources():
        held[str(text.relative_to(HANDOUT).with_suffix(".html"))] = handout_page.page(text)
    held["tests/checks.txt"] = handout_data.checks().encode()
    held["tests/parts.json"] = handout_data.parts_and_checks().encode()
    held["fixtures/study.json"] = handout_data.study().encode()
    held["fixtures/measured.json"] = handout_data.measured().encode()
    return dict(sorted(held.items()))


def _is_skipped(name: str) -> bool:
    parts = {*name.split("/")} - OF_EDITORS
    return bool(parts & SKIPPED) or any(part.startswith(".") for part in parts)


def write(path: Path) -> int:
    """Writes the zip, whole or not at all, and returns how many files it holds."""
    modes = {"check": 0o755}
    held = {f"{TOP}/{n}": (data, modes.get(n, 0o644)) for n, data in contents().items()}
    write_asked(path, zipped(held, compressed=False), mode=0o600)
    return len(held)
