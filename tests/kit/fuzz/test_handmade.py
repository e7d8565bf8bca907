"""Handmade inputs that mutation rarely finds: towers of one thing, and half an answer of the
judge."""

import json
import time
from pathlib import Path

import pytest
from bounce_grader.common.errors import KitError
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import WORK_FOLDER
from bounce_grader.grading import judging
from bounce_grader.sandbox import processes
from bounce_grader.sandbox.box import Box
from edits import edited
from test_readers import check_compiler, SEEDS

K = 64 * 1024
FOLDER = f"/{WORK_FOLDER}"
TOWERS = [(":1", ""), ("1", ":"), (": error: ", ""), (":1:1: ", ""), (" ", ""), ("\n", "")]
TOWERS += [("A_", 'a:1:1: error: "'), ('"AAAAAAAA', "a:1:1: error: "), ("undefined symbol: ", "")]
TOWERS += [("undefined symbol: \n>>> referenced by ", ""), (FOLDER, ""), (FOLDER + "x/a:1", "")]
TOWERS += [("A<", "/e.h:1:1: error: x\npart2_lcp.cpp:1:1: note: 'Eigen::"), (FOLDER + "x/", "")]


@pytest.mark.parametrize("piece, before", TOWERS, ids=range(len(TOWERS)))
def test_what_a_compiler_says_is_read_in_no_time(piece: str, before: str) -> None:
    """A submission can put text there by #error, #line and its names."""
    start = time.process_time()
    tower = before + piece * (K // len(piece))
    for end in ("", "'", ":?", "x"):
        check_compiler((tower + end).encode())
    assert time.process_time() - start < 0.5


def test_what_addr2line_says_of_a_megabyte_is_read_in_no_time() -> None:
    start = time.process_time()
    assert judging.place_in((FOLDER + "x/").encode() * 50_000 + b"y.cpp:?") is None
    assert judging.place_in(f"{FOLDER}x/sources/{'a' * 9999}:1".encode()) is None
    assert time.process_time() - start < 0.5


@pytest.mark.parametrize("flooded", [False, True])
def test_what_addr2line_says_counts_if_it_ended_in_order(
    flooded: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    line = f"/tmp/{WORK_FOLDER}a1b2/sources/part1_contacts.cpp:12\n".encode()
    result = processes.Result(0, 0.0, line, "", too_long=False, flooded=flooded)
    monkeypatch.setattr(processes, "run", lambda *_, **__: result)
    files = frozenset({"part1_contacts.cpp"})
    place = judging._place(f" 0x{flooded:016x}", Path("runner"), files, Box("none"))
    assert place == (None if flooded else "part1_contacts.cpp:12")


RIGHT, WRONG = ((SEEDS / f"{name}.json").read_bytes() for name in ("right", "crashed"))
SHOWN = "checks 0 revealed shown"
HUGE = "1" + "0" * 400
EDITS = ["largest_error = NaN", "largest_error = Infinity", 'largest_error = "0"']
EDITS += ["checks = null", "checks = []", "checks 0", "checks 0 passed = 1", "checks 0 stack"]
EDITS += [
    'checks 0 status = "fine"',
    f"largest_error = {HUGE}",
    'checks 1 id = "part4.HasTColumns"',
]
EDITS += [f"{SHOWN} scene g 2", f"{SHOWN} scene q = [0, 0, 0, 0]", f"{SHOWN} scene v = 7"]
EDITS += [f"{SHOWN} scene l = {HUGE}", f"{SHOWN} quantities 0 got = [[{HUGE}]]"]
EDITS += [f"checks = {json.dumps(json.loads(RIGHT)['checks'] * 2)}"]
ANSWERS = [b"", b"null", b"[]", b"{}", b"\xff", b"[" * 100_000, b"9" * 5000]
ANSWERS += [json.dumps(edited(json.loads(WRONG), edit)).encode() for edit in EDITS]
ANSWERS += [RIGHT.replace(b"1e-13", b"1e999")]


@pytest.mark.parametrize("out", ANSWERS, ids=range(len(ANSWERS)))
def test_half_an_answer_of_the_judge_is_a_fault_of_the_kit(out: bytes) -> None:
    with pytest.raises(KitError, match="the judge's"):
        judging.read_answer(out, parts()[3])


def test_a_whole_answer_is_taken_without_checks_that_the_manifest_leaves_out() -> None:
    assert judging.read_answer(WRONG, parts()[3])
    fewer = parts()[3]._replace(checks=parts()[3].checks[1:])
    checks = judging.read_answer(WRONG, fewer)["checks"]
    assert [check["id"] for check in checks] == [check.id for check in fewer.checks]
