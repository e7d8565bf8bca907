"""Writes the handout: one zip with all that a student needs, and nothing else.

It holds the folder student/, its Markdown as pages for a browser, the tests that a student's build
runs, the public fixtures with the answers of known mistakes, and the manifest of checks, whose
points the texts say. Times and permissions are fixed, so that the same kit gives the same bytes.
"""

import zipfile
from collections.abc import Iterator
from pathlib import Path

from bounce_grader.common.errors import UsageError
from bounce_grader.common.paths import HANDOUT, ROOT
from bounce_grader.grading.fixtures import PUBLIC
from bounce_grader.publish import handout_measured, handout_page, handout_study
from bounce_grader.publish.points import with_points

TOP = "bounce"  # the folder in the zip
TESTS = ("*.?pp", "linked/*.?pp")
# Made by working in student/.
SKIPPED = {"build", "animation.html", "real.html", "study.html", "__pycache__"}
OF_EDITORS = {".clangd", ".devcontainer", ".vscode"}  # other names with a dot are left out
PAGES = ("README", "explore")
PROGRAMS = {"check"}
WITH_POINTS = {".md", ".hpp"}  # the files of student/ that may say points
EPOCH = (1980, 1, 1, 0, 0, 0)


def files() -> dict[str, Path]:
    """The files of the handout, as path in the zip -> file of the kit, in order."""
    chosen = {str(f.relative_to(HANDOUT)): f for f in _regular(HANDOUT)}
    tests = ROOT / "tests" / "parts"
    for pattern in TESTS:
        chosen |= {f"tests/{f.relative_to(tests)}": f for f in tests.glob(pattern) if f.is_file()}
    diagnosis = ROOT / "grader" / "diagnosis"
    chosen |= {f"tests/diagnosis/{f.name}": f for f in diagnosis.iterdir()}
    chosen |= {f"fixtures/public/{f.relative_to(PUBLIC)}": f for f in PUBLIC.rglob("*.json")}
    chosen["tests/parts.json"] = ROOT / "grader" / "parts.json"
    chosen[".clang-format"] = ROOT / ".clang-format"
    return dict(sorted(chosen.items()))


def contents() -> dict[str, bytes]:
    """What the zip holds, by path in it: these files, the pages made of Markdown, and the numbers
    of the study and of measured impacts."""
    made = {f"{name}.html": handout_page.page(HANDOUT / f"{name}.md") for name in PAGES}
    made["fixtures/study.txt"] = handout_study.text().encode()
    made["fixtures/measured.txt"] = handout_measured.text().encode()
    held = {name: _as_handed_out(file) for name, file in files().items()}
    return dict(sorted({**held, **made}.items()))


def _as_handed_out(file: Path) -> bytes:
    data = file.read_bytes()
    if file.suffix in WITH_POINTS and file.is_relative_to(HANDOUT):
        return with_points(data.decode()).encode()
    return data


def _regular(folder: Path) -> Iterator[Path]:
    for path in folder.iterdir():
        is_hidden = path.name.startswith(".") and path.name not in OF_EDITORS
        if path.name in SKIPPED or is_hidden or path.is_symlink():
            continue
        if path.is_dir():
            yield from _regular(path)
        else:
            yield path


def write(path: Path) -> int:
    """Writes the zip, whole or not at all, and returns how many files it holds."""
    temporary = path.with_name(path.name + ".part")
    held = contents()
    try:
        with zipfile.ZipFile(temporary, "w") as archive:
            for name, data in held.items():
                _add(archive, name, data)
        temporary.replace(path)
    except OSError as error:
        temporary.unlink(missing_ok=True)
        raise UsageError(f"{path} can't be written: {error.strerror}") from error
    return len(held)


def _add(archive: zipfile.ZipFile, name: str, data: bytes) -> None:
    # Stored and not compressed: another version of zlib would give other bytes.
    entry = zipfile.ZipInfo(f"{TOP}/{name}", EPOCH)
    entry.create_system = 3  # Unix, so that permissions are kept
    entry.external_attr = (0o100755 if name in PROGRAMS else 0o100644) << 16
    archive.writestr(entry, data)
