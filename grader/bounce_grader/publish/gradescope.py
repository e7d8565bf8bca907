"""./kit gradescope: packs the kit into one zip, an autograder to upload to Gradescope."""

import argparse
from collections.abc import Iterator
from pathlib import Path

from bounce_grader.common.files import write_asked, zipped
from bounce_grader.common.paths import ROOT
from bounce_grader.grading import fixtures

# Only these: a course may keep submissions and results in the kit's folder, too.
FILES = "CMakeLists.txt CMakePresets.json LICENSE README.md pyproject.toml kit CHANGELOG.md"
PACKED = f"{FILES} CONTRIBUTING.md docs fixtures grader solution student tests".split()
BUILT = ROOT / "student" / "build"  # by working there; other folders of that name hold sources
LEFT_OUT = {"__pycache__", ".pytest_cache", ".mypy_cache", "hidden"}
SCRIPTS = {"setup.sh": "gradescope_setup.sh", "run_autograder": "gradescope_run.sh"}


def run(options: argparse.Namespace) -> int:
    """Writes the zip: the kit's files, the course's secret, and the two scripts."""
    here = Path(__file__).parent
    held = {name: ((here / script).read_bytes(), 0o755) for name, script in SCRIPTS.items()}
    held["course-secret"] = fixtures.secret().encode() + b"\n", 0o600  # read as root
    for file in sorted(_packed(ROOT)):
        mode = 0o755 if file.stat().st_mode & 0o100 else 0o644
        held[file.relative_to(ROOT).as_posix()] = file.read_bytes(), mode
    write_asked(options.out, zipped(held, compressed=True), mode=0o600)
    return 0


def _packed(root: Path) -> Iterator[Path]:
    for place in (root / name for name in PACKED):
        for file in [place, *place.rglob("*")]:
            inside = file.relative_to(root).parts
            is_left_out = LEFT_OUT & {*inside} or BUILT in file.parents or file.suffix == ".zip"
            if file.is_file() and not file.is_symlink() and not is_left_out:
                yield file
