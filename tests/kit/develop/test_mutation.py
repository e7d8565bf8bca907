"""Measures the checks: every small change of the solution, and of right programs in other styles,
must lose points, and only in its own part. equivalent.json says of each change that may lose
nothing why it can't be told from the solution."""

import json
from pathlib import Path

import pytest
from bounce_grader.build.toolchain import compiler
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import RUNNER
from bounce_grader.grading.grade import grade as grade_path
from bounce_grader.sandbox import processes
from conftest import ROOT, SOLUTION, lost, solution_files, write
from mutations import KINDS, changes

GALLERY = ROOT / "tests" / "submissions" / "accepted"
STYLES = ("dynamic_matrices_and_lu", "vectors_and_algorithms")
FILES = [f"solution/{part.file}" for part in parts()]
FILES += [f"{style}/{f.name}" for style in STYLES for f in sorted((GALLERY / style).glob("p*.cpp"))]
REASONS: dict[str, dict[str, str]] = json.loads(
    Path(__file__).with_name("equivalent.json").read_text()
)


def text_of(file: str) -> str:
    style, name = file.split("/")
    return ((SOLUTION if style == "solution" else GALLERY / style) / name).read_text()


def compiles(text: str) -> bool:
    """By clang; what it refuses loses its part, and needs no grading."""
    flags = ["-fsyntax-only", "-include-pch", str(RUNNER / "prelude.pch"), "-x", "c++", "-"]
    command = [compiler(), f"@{RUNNER / 'clang_flags.txt'}", *flags]
    return processes.run(command, stdin=text.encode()).ok


def cases() -> list[tuple[str, str]]:
    return [(f, k) for f in FILES for k in KINDS if any(c.kind == k for c in changes(text_of(f)))]


@pytest.mark.long
@pytest.mark.parametrize("file, kind", cases())
def test_every_small_change_loses_points_or_is_excused(
    file: str, kind: str, tmp_path: Path
) -> None:
    name = Path(file).name
    own = {part.stem.split("_")[0] for part in parts() if part.file == name}
    unexplained = []
    for change in changes(text_of(file)):
        if change.kind != kind or not compiles(change.text):
            continue
        write(tmp_path, {**solution_files(), name: change.text.encode()})
        parts_lost = {check.split(".")[0] for check in lost(grade_path(tmp_path))}
        expected = set() if change.name in REASONS.get(file, {}) else own
        if parts_lost != expected:
            unexplained.append(f"{change.name}: loses points of {parts_lost or 'no part'}")
    assert not unexplained
