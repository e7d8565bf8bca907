"""Other programs' wording changes from version to version: what compilers, linkers, sanitizers,
archivers and the box's program print is garbled here, letter by letter. The points stay."""

import codecs
from pathlib import Path
from typing import Any

import pytest
from bounce_grader.grading.grade import grade, Options
from bounce_grader.sandbox import processes
from conftest import Patch, ROOT
from handed_in import submission_of
from handed_out import check, put, unzipped

GALLERY = ROOT / "tests" / "submissions"
NAMES = [
    "broken/part1_syntax_error",
    "broken/part1_allocates_without_end",
    "broken/part2_undefined_helper",
    "broken/part2_aborts",
    "broken/part2_eigen_index_out_of_range",
    "broken/part3_null_pointer",
    "mistakes/part3_friction_sign",
]
GARBLING = """#!/bin/sh
[ -e "$0.garbles" ] || exec /usr/bin/g++ "$@"
/usr/bin/g++ "$@" 2>"$0.$$"
status=$?
tr 'a-zA-Z' 'n-za-mN-ZA-M' <"$0.$$" >&2
exit $status
"""


def verdicts(record: dict[str, Any]) -> list[Any]:
    return [(p["status"], [check["score"] for check in p["checks"]]) for p in record["parts"]]


def graded(name: str, folder: Path) -> list[Any]:
    return verdicts(grade(submission_of(GALLERY / name, folder), Options(sanitize=False)))


@pytest.mark.parametrize("name", NAMES)
def test_other_words_change_no_points(name: str, tmp_path: Path, monkeypatch: Patch) -> None:
    before = graded(name, tmp_path / "before")
    run, said = processes.run, []

    def garbled(command: list[str], *rest: Any, **more: Any) -> processes.Result:
        result = run(command, *rest, **more)
        if Path(command[0]).name == "judge":
            return result
        said.append(result.err)
        places = codecs.encode(result.out.decode(), "rot13").encode() if "-i" in command else b""
        return result._replace(err=codecs.encode(result.err, "rot13"), out=places or result.out)

    monkeypatch.setattr(processes, "run", garbled)
    assert graded(name, tmp_path / "after") == before
    assert any(said) or "part1_syntax" not in name


@pytest.mark.long
def test_a_check_gives_the_same_points_whatever_its_compiler_says(tmp_path: Path) -> None:
    home, compiler = unzipped(tmp_path), tmp_path / "g++"
    compiler.write_text(GARBLING)
    compiler.chmod(0o755)

    def points(name: str) -> str:
        put(home, name)
        (home / "src/part1_contacts.cpp").touch()
        done = check(home, CXX=str(compiler))
        [line] = (line for line in done.stdout.splitlines() if "Score on" in line)
        return line

    before = {name: points(name) for name in NAMES}
    (tmp_path / "g++.garbles").touch()
    assert {name: points(name) for name in NAMES} == before
