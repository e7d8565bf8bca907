"""A result is named by all that it follows from, and nothing else makes it stale."""

import json
from dataclasses import replace
from pathlib import Path

import pytest
from bounce_grader.classroom.intake import students
from bounce_grader.classroom.work import results, task
from bounce_grader.classroom.work.task import Stamp, Task
from conftest import write

STAMP = Stamp("kit", "fixtures", "options")


def made(tmp_path: Path, text: bytes = b"// x", stamp: Stamp = STAMP) -> Task:
    folder = write(tmp_path / "all" / "anna", {"part2_lcp.cpp": text}).parent
    (student,) = students.read(folder).students
    return task.task_of(student, stamp, tmp_path, speed=False, trust=False)


def test_a_result_is_named_by_all_that_it_follows_from(tmp_path: Path) -> None:
    stamps = [STAMP, *(replace(STAMP, **{name: "2"}) for name in ("kit", "fixtures", "options"))]
    keys = {made(tmp_path, stamp=stamp).key for stamp in stamps} | {made(tmp_path, b"// y").key}
    assert len(keys) == 5 and made(tmp_path).key in keys


def test_a_task_can_be_sent_as_json(tmp_path: Path) -> None:
    sent = made(tmp_path)
    assert task.from_json(json.loads(json.dumps(sent.as_json()))) == sent


@pytest.mark.parametrize(
    "changed",
    [
        "grader/bounce_grader/grading/judging.py",
        "grader/bounce_grader/classroom/work/unit.py",
        "grader/runner/prelude.sed",
        "tests/parts/cases.cpp",
    ],
)
def test_another_kit_is_known_wherever_it_lies(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, changed: str
) -> None:
    """Even in a folder with the name of one of the kit's own."""
    root = tmp_path / "classroom" / "formats"
    folders = {"ROOT": root, "CONTRACT": root / "student/include", "HANDOUT": root / "student"}
    for name, folder in folders.items():
        monkeypatch.setattr(results, name, folder)
    needed = ("grader/bounce_grader/classroom/work/unit.py", "grader/parts.json", changed)
    later = ("grader/bounce_grader/formats/html.py", "tests/kit/judge/judge_test.cpp")
    write(root, {name: b"0" for name in (*needed, *later)})
    before = results._kit_digest()
    write(root, {name: b"changed" for name in later})
    assert results._kit_digest() == before
    write(root, {changed: b"2"})
    assert results._kit_digest() != before
