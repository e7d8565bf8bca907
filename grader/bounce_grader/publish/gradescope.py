"""./kit gradescope: packs the kit into one zip, an autograder to upload to Gradescope."""

import stat
import zipfile
from collections.abc import Iterator
from pathlib import Path

from bounce_grader.common.errors import UsageError
from bounce_grader.common.paths import ROOT
from bounce_grader.grading import fixtures

# Only these: a course may keep submissions and results in the kit's folder, too.
PACKED = (
    *("CMakeLists.txt", "CMakePresets.json", "LICENSE", "README.md", "pyproject.toml", "kit"),
    *("CHANGELOG.md", "CONTRIBUTING.md", "docs", "fixtures", "grader", "solution", "student"),
    "tests",
)
BUILT = "student/build"  # by working in the handout; other folders of that name hold sources
LEFT_OUT = {
    "__pycache__",
    ".pytest_cache",
    ".mypy_cache",
    "hidden",
}
TIME = (2000, 1, 1, 0, 0, 0)  # fixed, so that the same kit gives the same bytes

# Gradescope runs this once, as root, in a container of Ubuntu 22.04.
SETUP = """#!/usr/bin/env bash
# Installs what the kit needs and builds it; the solution has to get all points here.
set -euo pipefail
cd /autograder/source
chmod +x kit run_autograder
./kit grade solution --speed --min-score 100
"""

# Gradescope runs this for each submission. If the kit fails, it leaves no results.json; Gradescope
# then reports a failure of the autograder, and nobody gets a zero.
RUN = """#!/usr/bin/env bash
set -uo pipefail
cd /autograder/source
results=/autograder/results/results.json
metadata=/autograder/submission_metadata.json
[ -e "$metadata" ] && set -- --before "$metadata"
./kit grade /autograder/submission --speed --format gradescope "$@" >"$results.part"
status=$?
# 0: graded; 2: the submission can't be read, and the file says so to the student.
if [ "$status" -ne 0 ] && [ "$status" -ne 2 ] || [ ! -s "$results.part" ]; then
  rm -f "$results.part"
  exit "$status"
fi
mv "$results.part" "$results"
"""


def write(path: Path) -> None:
    """Writes the zip: the kit's files, the course's secret, and the two scripts."""
    secret = fixtures.secret().encode() + b"\n"
    temporary = path.with_name(path.name + ".part")
    try:
        temporary.touch(mode=0o600)  # it holds the secret
        with zipfile.ZipFile(temporary, "w", zipfile.ZIP_DEFLATED) as archive:
            _add(archive, "setup.sh", SETUP.encode(), 0o755)
            _add(archive, "run_autograder", RUN.encode(), 0o755)
            _add(archive, "course-secret", secret, 0o600)  # the autograder runs as root
            for file in sorted(_packed(ROOT)):
                mode = 0o755 if file.stat().st_mode & 0o100 else 0o644
                _add(archive, file.relative_to(ROOT).as_posix(), file.read_bytes(), mode)
        temporary.replace(path)
    except OSError as error:
        temporary.unlink(missing_ok=True)
        raise UsageError(f"{path} can't be written: {error.strerror}") from error


def _packed(root: Path) -> Iterator[Path]:
    for name in PACKED:
        if (root / name).is_dir():
            built = root / BUILT
            yield from (f for f in _files(root / name) if not f.is_relative_to(built))
        else:
            yield root / name


def _files(folder: Path) -> Iterator[Path]:
    for child in folder.iterdir():
        if child.name in LEFT_OUT or child.is_symlink():
            continue
        if child.is_dir():
            yield from _files(child)
        elif child.suffix != ".zip":
            yield child


def _add(archive: zipfile.ZipFile, name: str, data: bytes, mode: int) -> None:
    info = zipfile.ZipInfo(name, TIME)
    info.compress_type = zipfile.ZIP_DEFLATED
    info.external_attr = (stat.S_IFREG | mode) << 16
    archive.writestr(info, data)
