"""Shared by the Python tests: puts the grader on the path, and makes submissions from the
solution."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

pytest.register_assert_rewrite("animation_page", "handed_in")  # they check on behalf of tests

import clusters
from hypothesis import settings

# The same inputs each time, whatever else the machine does.
settings.register_profile("kit", derandomize=True, deadline=None, database=None, max_examples=200)
settings.load_profile("kit")


@pytest.hookimpl(tryfirst=True)  # type: ignore[misc]  # before what isn't wanted is left out
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Puts the tests that share one worker first, and then those that take long: the others have the
    rest to do meanwhile."""
    items.sort(key=lambda item: ("xdist_group" not in item.keywords, "long" not in item.keywords))


ROOT = Path(__file__).resolve().parents[2]
SOLUTION = ROOT / "solution" / "src"
Grade = Callable[..., Any]  # a report
Patch = pytest.MonkeyPatch
Printed = pytest.CaptureFixture[str]


def solution_files() -> dict[str, bytes]:
    return {file.name: file.read_bytes() for file in SOLUTION.glob("*.cpp")}


def write(folder: Path, files: dict[str, bytes]) -> Path:
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text)
    return folder


@pytest.fixture
def grade(tmp_path: Path) -> Grade:
    """Grades the solution with some files replaced, added, or (None) removed."""
    from bounce_grader.grading.grade import grade as grade_path
    from bounce_grader.grading.report import report

    def graded(changes: dict[str, bytes | None]) -> Any:
        files: dict[str, bytes | None] = {**solution_files(), **changes}
        present = {name: text for name, text in files.items() if text is not None}
        return report(grade_path(write(tmp_path / "submission", present)))

    return graded


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[clusters.Cluster]:
    with clusters.started(tmp_path) as made:
        yield made


@pytest.fixture(scope="session")
def driver(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    import animation_page

    with animation_page.started(tmp_path_factory.mktemp("browser")) as made:
        yield made


def points(record: dict[str, Any]) -> list[float]:
    return [part["score"] for part in record["parts"]]


def lost(record: dict[str, Any]) -> list[str]:
    return sorted(c["id"] for part in record["parts"] for c in part["checks"] if not c["passed"])


@pytest.fixture(scope="session")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A student's folder, for all tests that drive ./check: its first build takes longer than they
    do."""
    import handed_out

    return handed_out.unzipped(tmp_path_factory.mktemp("student"))
