"""Measures the checks: every small change of the solution, and of right programs in other styles,
must lose points, and only in its own part. equivalent.json says of each change that may lose
nothing why it may."""

import json
from contextlib import suppress
from pathlib import Path

import pytest
from bounce_grader.build import toolchain
from bounce_grader.common.manifest import parts
from bounce_grader.grading import judging
from bounce_grader.grading.grade import grade as grade_path
from conftest import lost, Patch, ROOT, SOLUTION, solution_files, write
from mutations import KINDS, changes

GALLERY = ROOT / "tests" / "submissions" / "accepted"
STYLES = ("plain_loops", "vectors_and_algorithms")
FILES = [f"solution/{part.file}" for part in parts()]
FILES += [f"{style}/{f.name}" for style in STYLES for f in sorted((GALLERY / style).glob("p*.cpp"))]
EQUIVALENT = Path(__file__).with_name("equivalent.json").read_text()
REASONS: dict[str, dict[str, str]] = json.loads(EQUIVALENT)


def text_of(file: str) -> str:
    style, name = file.split("/")
    return ((SOLUTION if style == "solution" else GALLERY / style) / name).read_text()


class Refused(Exception):
    """Clang doesn't compile it, so that it loses its part."""


def not_by_gcc(*_: object) -> None:
    raise Refused


def cases() -> list[tuple[str, str]]:
    return [(f, k) for f in FILES for k in KINDS if any(c.kind == k for c in changes(text_of(f)))]


@pytest.mark.long
@pytest.mark.parametrize("file, kind", cases())
def test_every_change_loses_points(
    file: str, kind: str, tmp_path: Path, monkeypatch: Patch
) -> None:
    monkeypatch.setattr(toolchain, "gcc", not_by_gcc)
    monkeypatch.setattr(judging, "with_cause", lambda part, judged, *_: judged)
    name, text = Path(file).name, text_of(file)
    own = {part.stem.split("_")[0] for part in parts() if part.file == name}

    def parts_lost(text: str, others: dict[str, bytes]) -> set[str]:
        folder = tmp_path / ("beside_others" if others else "alone")
        write(folder, {**others, name: text.encode()})
        found = {check.split(".")[0] for check in lost(grade_path(folder))}
        return found if others else found & own

    assert not parts_lost(text, solution_files())
    unexplained = []
    beside = solution_files()  # until one has lost points, and those of no other part
    for change in changes(text):
        if change.kind == kind:
            expected = set() if change.name in REASONS.get(file, {}) else own
            with suppress(Refused):
                if (found := parts_lost(change.text, beside if expected else {})) != expected:
                    unexplained.append(f"{change.name}: loses points of {found or 'no part'}")
                beside = {} if found else beside
    assert not unexplained
