"""Whole gradings beside those of the gallery: what the record says, and that a fault of the kit's is
no verdict."""

import json
import os
import subprocess
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import golden
import pytest
from bounce_grader.build import compile as compiling, toolchain
from bounce_grader.common.errors import KitError
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import CONTRACT, RUNNER
from bounce_grader.grading import fixtures, judging
from bounce_grader.grading.grade import grade as grade_path, Options
from bounce_grader.sandbox import box
from conftest import ROOT, SOLUTION, Grade, points, solution_files, write

FULL: list[float] = [part.points for part in parts()]
PART1 = solution_files()["part1_contacts.cpp"].decode()


def angles(folder: Path) -> list[float]:
    checks = json.loads((folder / "part1_contacts.json").read_text())["checks"]
    return [case["input"]["q"][2] for cases in checks.values() for case in cases]


def with_angles(text: str) -> str:
    """The code of a part 1 that knows the cases."""
    public = " || ".join(f"q(2) == {angle!r}" for angle in angles(fixtures.PUBLIC))
    hidden = next(a for a in angles(fixtures.hidden_folder()) if abs(a) > 7)  # after a turn
    return text.replace("PUBLIC_ANGLE", public).replace("HIDDEN_ANGLE", repr(hidden))


def changes(row: dict[str, Any]) -> dict[str, bytes | None]:
    files = {name: text * row.get("times", 1) for name, text in row.get("write", {}).items()}
    for name, edits in row.get("edit", {}).items():
        files[name] = solution_files()[name].decode()
        for old, new in edits:
            assert files[name].count(old) == 1, old
            files[name] = files[name].replace(old, with_angles(new))
    return {name: text.encode() for name, text in files.items()}


def words(part: dict[str, Any]) -> list[str]:
    return [
        part["message"],
        *(check["message"] for check in part["checks"]),
        *part["patterns"],
        *part["remarks"],
    ]


ROWS = golden.rows(Path(__file__).parent / "gradings.toml", "grading")


@pytest.mark.parametrize("row", ROWS)
def test_the_record_says_what_is_so(grade: Grade, row: dict[str, Any]) -> None:
    record = grade(changes(row))
    said = "\n".join(line for part in record["parts"] for line in words(part))
    if "points" in row or not row.get("edit"):
        assert points(record) == row.get("points", FULL), said
    assert [m["name"] for part in record["parts"] for m in part["mistakes"]] == row.get(
        "mistakes", []
    )
    with_parts = [part["graded_with"] for part in record["parts"]]
    assert with_parts == row.get("graded_with", with_parts)
    checks = [check for part in record["parts"] for check in part["checks"]]
    costs = {c["id"]: c["mistake"]["name"] for c in checks if c["mistake"]}
    assert costs.items() >= row.get("costs", {}).items()
    for sentence in row.get("says", []):
        assert sentence in said
    assert not any(sentence in said for sentence in row.get("never", []))
    assert [check["id"] for check in checks] == [c.id for part in parts() for c in part.checks]
    for part in record["parts"]:
        assert part["score"] == sum(check["score"] for check in part["checks"])
    assert record["score"] == sum(points(record)) and record["max_score"] == 100


def test_a_grading_says_the_same_again_and_writes_nothing_where_it_is(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write(tmp_path / "x", {**solution_files(), "part1_contacts.cpp": PART1[:-30].encode()})
    before = {file: file.stat().st_mtime_ns for file in tmp_path.rglob("*")}
    monkeypatch.chdir(tmp_path)
    assert {**grade_path(Path("x")), "seconds": {}} == {**grade_path(Path("x")), "seconds": {}}
    assert {file: file.stat().st_mtime_ns for file in tmp_path.rglob("*")} == before


FORGED = '#line 7 "../../etc/a.cpp"\n+;\n'
PLACES = {"+;\n": (2, 1), FORGED: (0, 0), '#include "helper.hpp"\n': (1, 1)}


@pytest.mark.parametrize("text", PLACES)
@pytest.mark.parametrize("top", ["", "my hw (v2)/été a%b"])
def test_a_place_is_a_line_of_what_was_handed_in(tmp_path: Path, top: str, text: str) -> None:
    files = {"part2_lcp.cpp": f"\n{text}".encode(), "helper.hpp": b"}\n"}
    record = grade_path(
        write(tmp_path, {f"{top}/{name}".strip("/"): files[name] for name in files})
    )
    name = "helper.hpp" if "helper" in text else "part2_lcp.cpp"
    line, column = PLACES[text]
    place = {"file": f"{top}/{name}".strip("/"), "line": line, "column": column}
    assert record["parts"][1]["place"] == place and "place" not in record["parts"][0]


# --- what a submission could learn ---


def test_parts_with_given_answers_are_judged_one_after_the_other(
    grade: Grade, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Side by side, an answer that is given to a later part could reach an earlier one."""
    running, judged, original = [0], [], judging.judge

    def counted(*arguments: Any, **named: Any) -> judging.Judged:
        running[0] += 1
        judged.append((arguments[0].number, running[0]))
        try:
            return original(*arguments, **named)
        finally:
            running[0] -= 1

    monkeypatch.setattr(judging, "judge", counted)
    twice = {file: text + b"\nint defined_twice;\n" for file, text in solution_files().items()}
    assert points(grade({**twice})) == FULL
    assert judged == [(1, 1), (2, 1), (3, 1), (4, 1)]


def test_a_compiler_reads_no_hidden_case_and_no_other_submission(
    grade: Grade, tmp_path: Path
) -> None:
    other = write(tmp_path / "another", solution_files()) / "part1_contacts.cpp"
    for secret in (fixtures.hidden_folder() / "part1_contacts.json", other):
        part = grade({"part1_contacts.cpp": f'#include "{secret}"\n'.encode()})["parts"][0]
        assert f"'{secret}' file not found" in part["message"]
    by_gcc = f'#ifdef __clang__\n#error\n#endif\n#include "{other}"\n'
    assert points(grade({"part1_contacts.cpp": by_gcc.encode()})) == [0, 30, 30, 10]


@pytest.mark.parametrize("sign", ["-", pytest.param("", marks=pytest.mark.long)])
def test_what_is_asked_does_not_tell_what_was_right(grade: Grade, sign: str) -> None:
    """Else a program that guesses would learn from the next question whether it guessed rightly, as
    one that counts them here."""
    cases = len(angles(fixtures.PUBLIC)) + len(angles(fixtures.hidden_folder()))
    for number, status in ((2 * cases, "crashed"), (2 * cases + 1, "graded")):
        counting = f"static int asked = 0; if (++asked == {number}) std::abort(); Vector3 "
        changed = f"{counting}J_t(1, 0, -r.y()); J_t = {sign}J_t;"
        part1 = PART1.replace("const Vector3 J_t(1, 0, -r.y());", changed)
        record = grade({"part1_contacts.cpp": f"#include <cstdlib>\n{part1}".encode()})
        assert record["parts"][0]["status"] == status


def test_what_the_compiler_can_see_was_made_without_the_solution() -> None:
    """Precompiled headers and objects store the paths of their sources."""
    names = {file.name for file in RUNNER.iterdir()}
    assert not any(name.startswith("part") for name in names), names
    for file in RUNNER.iterdir():
        assert str(ROOT / "solution").encode() not in file.read_bytes(), file.name
    for name in ("graded.pch", "given_part1.o.d"):
        assert str(CONTRACT / "bounce" / "types.hpp").encode() in (RUNNER / name).read_bytes()


# --- the fault of the kit is nobody's zero ---

Patch = pytest.MonkeyPatch
NO_CHECKS = (
    '\'{"checks": [], "largest_error": 0, "asked_given": false, "mistakes": [], "patterns": []}\''
)


def judge_that(patch: Patch, script: Path, does: str) -> None:
    script.write_text(f"#!/bin/sh\n{does}\n")
    script.chmod(0o755)
    patch.setattr(judging, "JUDGE", script)


def box_that_fails(patch: Patch, _: Path, after: int) -> None:
    box.choose()  # which would try it, too
    to_run, calls = box.Box.to_run, iter(range(99))

    def fails(its: box.Box, program: Path, *_: bool) -> list[str]:
        return to_run(its, program) if next(calls) < after else ["/bin/sh", "-c", "echo no room"]

    patch.setattr(box.Box, "to_run", fails)


def compiler_that_fails(patch: Patch, nothing: Path) -> None:
    for name in ("clang", "gcc"):
        patch.setattr(toolchain, name, lambda *_: ["/bin/false"])
    patch.setattr(compiling, "place_of", lambda name: nothing)


@pytest.mark.parametrize(
    "make, sentence",
    [
        (partial(judge_that, does="exit 1"), "the judge failed on part"),
        (partial(judge_that, does=f"echo {NO_CHECKS}"), "lack some of parts.json"),
        (compiler_that_fails, "box couldn.t be made"),
        *((partial(box_that_fails, after=n), "couldn't be made: no room") for n in (0, 1, 3)),
    ],
)
def test_a_fault_of_the_kit_is_no_verdict(
    monkeypatch: Patch, tmp_path: Path, make: Callable[[Patch, Path], None], sentence: str
) -> None:
    make(monkeypatch, tmp_path / "x")
    with pytest.raises(KitError, match=sentence):
        grade_path(SOLUTION)


def test_without_a_box_only_trusted_code_is_run(monkeypatch: Patch) -> None:
    monkeypatch.setattr(box, "choose", box.choose.__wrapped__)  # and tries them again
    monkeypatch.setattr(box, "problem_of", lambda its: {"none": None}.get(its.kind, "no Landlock"))
    with pytest.raises(KitError, match="--trust-submission"):
        grade_path(SOLUTION)
    record = grade_path(SOLUTION, Options(boxes=("full", "reduced", "none")))
    assert record["score"] == 100 and record["box"] == "none"


def test_without_bubblewrap_the_reduced_box_is_used_and_said(monkeypatch: Patch) -> None:
    monkeypatch.setattr(box, "choose", box.choose.__wrapped__)
    monkeypatch.setattr(box, "which", lambda name: None)
    record = grade_path(SOLUTION)
    assert record["score"] == 100 and record["box"] == "reduced"
    with pytest.raises(KitError, match="full: bubblewrap isn't installed"):
        grade_path(SOLUTION, Options(boxes=("full",)))


def test_a_pipe_is_written_to_and_stays_one(tmp_path: Path) -> None:
    """And so does a device: --json /dev/null must not replace it by a file."""
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    reader = subprocess.Popen(["/bin/cat", str(pipe)], stdout=subprocess.PIPE)
    command = [str(ROOT / "kit"), "grade", str(SOLUTION), "--no-sanitize", "--json", str(pipe)]
    assert subprocess.run(command, check=False, stdout=subprocess.DEVNULL).returncode == 0
    assert json.loads(reader.communicate()[0])["score"] == 100
    assert pipe.is_fifo()
