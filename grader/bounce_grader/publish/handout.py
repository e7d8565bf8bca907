"""Writes the handout: one zip with all that a student needs, and nothing else.

It holds the folder student/, the tests that a student's build runs, the public fixtures with the
answers of known mistakes, and the manifest of checks. Times and permissions are fixed, so that the
same kit gives the same bytes.
"""

import zipfile
from collections.abc import Iterator
from pathlib import Path

from bounce_grader.common.errors import UsageError
from bounce_grader.common.paths import HANDOUT, ROOT
from bounce_grader.grading.fixtures import PUBLIC

TOP = "bounce"  # the folder in the zip
TESTS = (
    "answers.?pp",
    "cases.?pp",
    "diagnostic_questions.?pp",
    "feedback.?pp",
    "pattern.?pp",
    "picture.?pp",
    "recognise.?pp",
    "submission.hpp",
    "wrong_*.?pp",
    "part?_*_test.cpp",
    "linked/*.?pp",
)
SKIPPED = {"build", "animation.html", "__pycache__"}  # made by working in student/
PROGRAMS = {"check"}
EPOCH = (1980, 1, 1, 0, 0, 0)


def files() -> dict[str, Path]:
    """The files of the handout, as path in the zip -> file of the kit, in order."""
    chosen = {str(f.relative_to(HANDOUT)): f for f in _regular(HANDOUT)}
    tests = ROOT / "tests" / "parts"
    for pattern in TESTS:
        chosen |= {f"tests/{f.relative_to(tests)}": f for f in tests.glob(pattern) if f.is_file()}
    chosen |= {f"fixtures/public/{f.relative_to(PUBLIC)}": f for f in PUBLIC.rglob("*.json")}
    chosen["tests/parts.json"] = ROOT / "grader" / "parts.json"
    return dict(sorted(chosen.items()))


def _regular(folder: Path) -> Iterator[Path]:
    for path in folder.iterdir():
        if path.name in SKIPPED or path.name.startswith(".") or path.is_symlink():
            continue
        if path.is_dir():
            yield from _regular(path)
        else:
            yield path


def write(path: Path) -> int:
    """Writes the zip, whole or not at all, and returns how many files it holds."""
    temporary = path.with_name(path.name + ".part")
    try:
        with zipfile.ZipFile(temporary, "w") as archive:
            for name, file in files().items():
                _add(archive, name, file)
        temporary.replace(path)
    except OSError as error:
        temporary.unlink(missing_ok=True)
        raise UsageError(f"{path} can't be written: {error.strerror}") from error
    return len(files())


def _add(archive: zipfile.ZipFile, name: str, file: Path) -> None:
    # Stored and not compressed: another version of zlib would give other bytes.
    entry = zipfile.ZipInfo(f"{TOP}/{name}", EPOCH)
    entry.create_system = 3  # Unix, so that permissions are kept
    entry.external_attr = (0o100755 if name in PROGRAMS else 0o100644) << 16
    archive.writestr(entry, file.read_bytes())
