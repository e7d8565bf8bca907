"""./kit gradescope: packs the kit into one zip, an autograder to upload to Gradescope."""

from collections.abc import Iterator
from pathlib import Path

from bounce_grader.common.paths import ROOT
from bounce_grader.grading import fixtures
from bounce_grader.publish import archive

# Only these: a course may keep submissions and results in the kit's folder, too.
PACKED = (
    *("CMakeLists.txt", "CMakePresets.json", "LICENSE", "README.md", "pyproject.toml", "kit"),
    *("CHANGELOG.md", "CONTRIBUTING.md", "docs", "fixtures", "grader", "solution", "student"),
    "tests",
)
BUILT = "student/build"  # by working in the handout; other folders of that name hold sources
LEFT_OUT = {"__pycache__", ".pytest_cache", ".mypy_cache", "hidden"}

SCRIPTS = {"setup.sh": "gradescope_setup.sh", "run_autograder": "gradescope_run.sh"}


def write(path: Path) -> None:
    """Writes the zip: the kit's files, the course's secret, and the two scripts."""
    here = Path(__file__).parent
    held = {name: ((here / script).read_bytes(), 0o755) for name, script in SCRIPTS.items()}
    held["course-secret"] = fixtures.secret().encode() + b"\n", 0o600  # read as root
    for file in sorted(_packed(ROOT)):
        mode = 0o755 if file.stat().st_mode & 0o100 else 0o644
        held[file.relative_to(ROOT).as_posix()] = file.read_bytes(), mode
    archive.write(path, held, compressed=True)


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
