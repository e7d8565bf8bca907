"""Whole gradings: what a fault costs, what it never costs, and the content of the record."""

import json
import os
import re
import subprocess
from pathlib import Path
from typing import Any

import pytest
from bounce_grader import cli
from bounce_grader.build import compiler, object_cache
from bounce_grader.common.errors import KitError
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import CONTRACT, RUNNER
from bounce_grader.grading import fixtures, judging
from bounce_grader.grading.grade import grade as grade_path, Options
from bounce_grader.sandbox.box import Box
from conftest import ROOT, SOLUTION, Grade, points, solution_files, write

FULL: list[float] = [part.points for part in parts()]
SIGNATURES = {
    1: "Contact get_contacts(const Vector3& q, const Parameters& params)",
    2: "Lcp form_lcp(const Jacobian& J, const Vector3& v, const Parameters& params)",
    3: "State step(const Vector3& q, const Vector3& v, const Parameters& params)",
    4: "Trajectory simulate(const Vector3& q, const Vector3& v, const Parameters& params)",
}
NAN_ANSWERS = {
    1: "return {Jacobian::Constant(NAN), NAN};",
    2: "return {Eigen::Matrix4d::Constant(NAN), Eigen::Vector4d::Constant(NAN)};",
    3: "return {Vector3::Constant(NAN), Vector3::Constant(NAN)};",
    4: "return {Eigen::Matrix3Xd::Constant(3, params.T, NAN),"
    " Eigen::Matrix3Xd::Constant(3, params.T, NAN)};",
}
FAULTS = {
    "syntax error": ("int x = ;", "does_not_compile", "expected expression"),
    "crash": ("*(volatile int*)nullptr = 1; std::abort();", "crashed", "segmentation fault"),
    "endless loop": ("for (volatile int i = 0;; i = 1 - i) {}", "timed_out", "CPU time"),
    "NaN": ("", "graded", "check"),
}


def source(part: int, body: str) -> bytes:
    stem = parts()[part - 1].stem
    include = f"#include <bounce/{stem}.hpp>\n#include <cmath>\n#include <cstdlib>\n"
    return f"{include}namespace bounce {{ {SIGNATURES[part]} {{ {body} }} }}\n".encode()


def kit(*arguments: str, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [str(ROOT / "kit"), *arguments],
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=False,
    )


# --- points ---


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


@pytest.mark.parametrize("sign", ["-", ""], ids=["wrong", "right"])
@pytest.mark.usual(1)
def test_what_is_asked_does_not_tell_what_was_right(grade: Grade, sign: str) -> None:
    """Else a program that guesses would learn from the next question whether it guessed rightly, as
    one that counts them here."""
    folders = (fixtures.PUBLIC, fixtures.hidden_folder())
    files = [json.loads((folder / "part1_contacts.json").read_text()) for folder in folders]
    cases = sum(len(check) for file in files for check in file["checks"].values())
    solution = solution_files()["part1_contacts.cpp"].decode()
    assert "J_t(1, 0, -r.y());" in solution
    for number, status in ((2 * cases, "crashed"), (2 * cases + 1, "graded")):
        counting = f"static int asked = 0; if (++asked == {number}) std::abort(); Vector3 "
        changed = f"{counting}J_t(1, 0, -r.y()); J_t = {sign}J_t;"
        part1 = solution.replace("const Vector3 J_t(1, 0, -r.y());", changed)
        record = grade({"part1_contacts.cpp": f"#include <cstdlib>\n{part1}".encode()})
        assert record["parts"][0]["status"] == status


@pytest.mark.parametrize("part", [1, *(pytest.param(n, marks=pytest.mark.long) for n in (2, 4)), 3])
@pytest.mark.parametrize("fault", FAULTS)
@pytest.mark.usual(4)
def test_a_fault_costs_its_own_part_alone(grade: Grade, part: int, fault: str) -> None:
    body, status, sentence = FAULTS[fault]
    record = grade({parts()[part - 1].file: source(part, body or NAN_ANSWERS[part])})
    left = 1 if (fault, part) == ("NaN", 4) else 0  # NaN in T columns has the right shape
    assert points(record) == [left if p == part else FULL[p - 1] for p in (1, 2, 3, 4)]
    failed = record["parts"][part - 1]
    assert failed["status"] == status and sentence in failed["message"]
    assert "\n" not in failed["message"]


def test_a_missing_part_costs_its_own_points_alone(grade: Grade) -> None:
    record = grade({"part1_contacts.cpp": None})
    assert points(record) == [0, 30, 30, 10]
    assert record["parts"][0]["status"] == "not_submitted"
    assert record["parts"][0]["message"] == "part1_contacts.cpp isn't among the files submitted"


def test_a_compile_error_names_file_line_and_column(grade: Grade) -> None:
    record = grade({"part2_lcp.cpp": b"\n\nint x = ;\n"})
    message = record["parts"][1]["message"]
    assert message.startswith("part2_lcp.cpp:3:9: expected expression. Often this line")


def test_a_crash_names_the_line(grade: Grade) -> None:
    lines = source(3, "\n\n\n*(volatile int*)nullptr = 1; return {q, v};")
    message = grade({"part3_step.cpp": lines})["parts"][2]["message"]
    assert message.endswith("at part3_step.cpp:7"), message


def test_an_assertion_of_eigen_names_the_line_that_broke_it(grade: Grade) -> None:
    lines = source(1, "Eigen::VectorXd h(4); int k = 4;\nreturn {Jacobian::Zero(), h(k)};")
    message = grade({"part1_contacts.cpp": lines})["parts"][0]["message"]
    assert "an assertion failed: an index is out of range" in message, message
    assert message.endswith("at part1_contacts.cpp:5"), message


def test_an_exception_is_told_by_what_it_says(grade: Grade) -> None:
    thrown = "#include <stdexcept>\n".encode() + source(1, 'throw std::runtime_error("not yet");')
    record = grade({"part1_contacts.cpp": thrown})
    assert "the program threw an exception: not yet" in record["parts"][0]["checks"][0]["message"]


def test_what_a_submission_says_moves_no_cursor(grade: Grade) -> None:
    wild = source(2, r'throw std::runtime_error("\x1b[2J\x9b\xffred");')
    record = grade({"part2_lcp.cpp": b"#include <stdexcept>\n" + wild})
    message = record["parts"][1]["checks"][0]["message"]
    assert "\x1b" not in message and "red" in message


def test_a_part_that_clang_refuses_and_gcc_takes_counts(grade: Grade) -> None:
    gnu = b"#ifdef __clang__\n#error not for clang\n#endif\n"
    assert points(grade({"part4_simulate.cpp": gnu + _solution("part4_simulate")})) == FULL


def _solution(stem: str) -> bytes:
    return (SOLUTION / f"{stem}.cpp").read_bytes()


def test_nothing_is_written_where_it_was_graded(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write(tmp_path / "submission", solution_files())
    before = {file: file.stat().st_mtime_ns for file in tmp_path.rglob("*")}
    monkeypatch.chdir(tmp_path)
    assert grade_path(Path("submission"))["score"] == 100
    assert {file: file.stat().st_mtime_ns for file in tmp_path.rglob("*")} == before


# --- the record ---


def test_the_record_names_every_check_once_and_adds_up(grade: Grade) -> None:
    for changes in ({}, {"part3_step.cpp": source(3, NAN_ANSWERS[3])}, {"part2_lcp.cpp": None}):
        record = grade(changes)
        ids = [check["id"] for part in record["parts"] for check in part["checks"]]
        assert ids == [check.id for part in parts() for check in part.checks]
        for part in record["parts"]:
            assert part["score"] == sum(check["score"] for check in part["checks"])
            assert part["max_score"] == sum(check["max_score"] for check in part["checks"])
        assert record["score"] == sum(points(record)) and record["max_score"] == 100


def test_the_manifest_adds_up() -> None:
    assert FULL == [30, 30, 30, 10]
    for part in parts():
        assert sum(check.points for check in part.checks) == part.points
        assert 5 <= len(part.checks) <= 7


def test_the_same_submission_gives_the_same_record(grade: Grade) -> None:
    def settled(record: dict[str, Any]) -> dict[str, Any]:
        return {key: value for key, value in record.items() if key != "seconds"}

    wrong: dict[str, bytes | None] = {"part1_contacts.cpp": source(1, NAN_ANSWERS[1])}
    assert settled(grade(wrong)) == settled(grade(wrong))


def test_a_hidden_answer_is_never_shown(grade: Grade) -> None:
    """For a part that is right only on public cases: its report must hold no expected number."""
    public = json.loads((fixtures.PUBLIC / "part1_contacts.json").read_text())["checks"]
    angles = sorted({case["input"]["q"][2] for cases in public.values() for case in cases})
    known = " || ".join(f"q(2) == {angle!r}" for angle in angles)
    right = _solution("part1_contacts").replace(b"Contact get_contacts(", b"static Contact right(")
    memorised = source(1, f"if ({known}) return right(q, params); return {{Jacobian::Zero(), 0}};")
    part = grade({"part1_contacts.cpp": right + memorised})["parts"][0]
    assert part["score"] == 0
    for check in part["checks"]:
        assert "(a hidden case)" in check["message"]
        assert "expected is not shown, this case is hidden" in check["message"]


# --- the fault of the kit is nobody's zero ---


def test_a_judge_that_fails_is_no_verdict(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(judging, "JUDGE", Path("/bin/false"))
    with pytest.raises(KitError, match="the judge failed on part"):
        grade_path(SOLUTION)


def test_a_judge_that_leaves_a_check_out_is_no_verdict(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    forged = tmp_path / "judge"
    forged.write_text(
        '#!/bin/sh\necho \'{"checks": [], "largest_error": 0, "mistakes": [], "patterns": []}\'\n'
    )
    forged.chmod(0o755)
    monkeypatch.setattr(judging, "JUDGE", forged)
    with pytest.raises(KitError, match="lack some of parts.json"):
        grade_path(SOLUTION)


@pytest.mark.parametrize("working", [0, 1, 3])
def test_a_box_that_fails_in_the_midst_is_no_verdict(
    monkeypatch: pytest.MonkeyPatch, working: int
) -> None:
    to_run, calls = Box.to_run, iter(range(99))

    def fails(box: Box, program: Path) -> list[str]:
        return to_run(box, program) if next(calls) < working else ["/bin/sh", "-c", "echo no room"]

    monkeypatch.setattr(Box, "to_run", fails)
    with pytest.raises(KitError, match="couldn't be made: no room"):
        grade_path(SOLUTION)


def test_an_unforeseen_error_is_the_kits_and_no_low_score(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fails(*_: object) -> None:
        raise AttributeError("nobody thought of it")

    monkeypatch.setattr("bounce_grader.grading.grade.grade", fails)
    assert cli.main(["grade", str(SOLUTION)]) == 3
    assert (
        capsys.readouterr().err
        == "kit: the kit itself failed: AttributeError: nobody thought of it\n"
    )


def test_what_two_helpers_both_define_costs_no_part_that_needs_neither(grade: Grade) -> None:
    twice = b"int twice() { return 2; }\n"
    assert points(grade({"a.cpp": twice, "b.cpp": twice})) == [30, 30, 30, 10]


def test_a_compiler_that_fails_is_no_verdict(
    monkeypatch: pytest.MonkeyPatch, grade: Grade, tmp_path: Path
) -> None:
    for name in ("clang", "gcc"):
        monkeypatch.setattr(compiler, name, lambda *_: ["/bin/false"])
    monkeypatch.setattr(object_cache, "place", lambda name: tmp_path / "nothing-kept")
    broken: dict[str, bytes | None] = {part.file: b"\n" for part in parts()}
    with pytest.raises(KitError, match="box couldn.t be made"):
        grade(broken)


def test_without_a_box_only_trusted_code_is_run(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("bounce_grader.sandbox.box._held", lambda kind: Path("/nonexistent"))
    monkeypatch.setattr("bounce_grader.sandbox.box._remember", lambda held: None)
    fails = {"full": "no namespaces", "reduced": "no Landlock"}
    monkeypatch.setattr("bounce_grader.sandbox.box.problem_of", lambda box: fails.get(box.kind))
    with pytest.raises(KitError, match="--trust-submission"):
        grade_path(SOLUTION)
    record = grade_path(SOLUTION, Options(boxes=("full", "reduced", "none")))
    assert record["score"] == 100 and record["box"] == "none"


def test_without_bubblewrap_the_reduced_box_is_used_and_said(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("bounce_grader.sandbox.box.which", lambda name: None)
    record = grade_path(SOLUTION)
    assert record["score"] == 100 and record["box"] == "reduced"
    with pytest.raises(KitError, match="full: bubblewrap isn't installed"):
        grade_path(SOLUTION, Options(boxes=("full",)))


def test_what_the_compiler_can_see_was_made_without_the_solution() -> None:
    """Precompiled headers and objects store the paths of their sources."""
    names = {file.name for file in RUNNER.iterdir()}
    assert not any(name.startswith("part") for name in names), names
    for file in RUNNER.iterdir():
        assert str(ROOT / "solution").encode() not in file.read_bytes(), file.name
    for name in ("prelude.pch", "speed.pch", "given_part1.o.d"):
        assert str(CONTRACT / "bounce" / "types.hpp").encode() in (RUNNER / name).read_bytes()
    assert str(RUNNER / "solvers.hpp").encode() in (RUNNER / "solvers.pch").read_bytes()


# --- the command ---


def test_exit_status_and_json(tmp_path: Path) -> None:
    file = tmp_path / "record.json"
    done = kit("grade", str(SOLUTION), "--no-sanitize", "--json", str(file), "--min-score", "100")
    assert done.returncode == 0 and "Score 100 / 100" in done.stdout and done.stderr == ""
    assert json.loads(file.read_text())["score"] == 100

    done = kit("grade", str(ROOT / "student"), "--json", "-", "--min-score", "0.5")
    assert done.returncode == 1 and json.loads(done.stdout)["score"] == 0

    done = kit("grade", str(tmp_path / "nowhere"))
    assert done.returncode == 2 and done.stdout == "" and done.stderr.count("\n") == 1
    assert kit("grade").returncode == 2
    assert (
        kit("grade", str(SOLUTION), "--no-sanitize", "--json", "/nonexistent/x.json").returncode
        == 2
    )


def test_a_pipe_is_written_to_and_stays_one(tmp_path: Path) -> None:
    """And so does a device: --json /dev/null must not replace it by a file."""
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    reader = subprocess.Popen(["/bin/cat", str(pipe)], stdout=subprocess.PIPE)
    assert kit("grade", str(SOLUTION), "--no-sanitize", "--json", str(pipe)).returncode == 0
    assert json.loads(reader.communicate()[0])["score"] == 100
    assert pipe.is_fifo()


def test_speed_is_a_ratio_of_one_run() -> None:
    done = kit("grade", str(SOLUTION), "--no-sanitize", "--speed", "--json", "-")
    speed = json.loads(done.stdout)["speed"]
    assert speed["submission_ns"] > 0 and speed["solution_ns"] > 0
    assert speed["ratio"] == pytest.approx(speed["submission_ns"] / speed["solution_ns"])
    assert 0 < speed["largest_error"] < 1e-9


@pytest.mark.parametrize("installed", [False, True])
def test_missing_packages_are_named_and_nothing_is_fetched_where_none_is_missing(
    tmp_path: Path, installed: bool
) -> None:
    """The kit in a fresh folder, on a machine where dpkg knows of all packages or of none."""
    programs = {
        "dpkg-query": "echo installed" if installed else "exit 1",
        "apt-get": f"touch {tmp_path}/asked",
        "sudo": f"touch {tmp_path}/asked",
    }
    write(tmp_path / "bin", {name: f"#!/bin/sh\n{do}\n".encode() for name, do in programs.items()})
    copy = write(tmp_path, {"kit": (ROOT / "kit").read_bytes()}) / "kit"
    for program in [copy, *(tmp_path / "bin").iterdir()]:
        program.chmod(0o755)
    done = subprocess.run(
        [str(copy), "grade", "x"],
        env={
            "PATH": f"{tmp_path / 'bin'}:{os.environ['PATH']}",
            **({} if installed else {"KIT_NO_INSTALL": "1"}),
        },
        capture_output=True,
        text=True,
        check=False,
    )
    assert not (tmp_path / "asked").exists() and done.stdout == ""
    if not installed:
        assert done.returncode == 3
        assert "apt-get install -y --no-install-recommends" in done.stderr
        assert "libeigen3-dev" in done.stderr and done.stderr.count("\n") == 1
    else:
        assert (tmp_path / "build" / "kit" / "installed-to-grade").exists()
        assert "apt-get" not in done.stderr


def test_a_grading_imports_nothing_that_takes_longer_than_a_judge() -> None:
    """Each of these takes 10 to 50 ms to import; a grading takes some 300 ms in all."""
    (start,) = re.findall(r"^import='(.+)'$", (ROOT / "kit").read_text(), re.MULTILINE)
    start += "; import bounce_grader.__main__"
    command = ["/usr/bin/python3", "-IS", "-X", "importtime", "-c", start, str(ROOT / "grader")]
    done = subprocess.run(
        [*command, "grade", "--no-sanitize", str(SOLUTION)], capture_output=True, text=True
    )
    assert done.returncode == 0 and "Score 100 / 100" in done.stdout
    imported = set(re.findall(r"^import time:.*\| *(\S+)$", done.stderr, re.MULTILINE))
    assert "bounce_grader.grading.judging" in imported
    slow = {"dataclasses", "logging", "asyncio", "multiprocessing", "rich", "jinja2", "html", "xml"}
    assert not imported & slow
