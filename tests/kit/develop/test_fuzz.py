"""A few thousand inputs for each reader of fuzzing/, and handmade inputs that mutation rarely
finds. ./kit test --long takes a million for each."""

import json
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import fuzzing
import pytest
from bounce_grader.common.errors import KitError
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import WORK_FOLDER
from bounce_grader.grading import judging
from bounce_grader.sandbox import processes
from bounce_grader.sandbox.box import Box
from fuzzing import answers

COUNT = 5000


@pytest.mark.parametrize("name", fuzzing.READERS)
def test_whatever_comes_is_taken_within_the_limits_or_refused(name: str) -> None:
    taken = fuzzing.run(name, 0, COUNT)
    assert taken >= fuzzing.READERS[name].least_taken * COUNT


K = 64 * 1024
FOLDER = f"/{WORK_FOLDER}"
TOWERS = {
    "colons": ":1" * (K // 2),
    "digits": ":" + "1" * K,
    "errors without a place": ": error: " * (K // 9),
    "places without an error": ":1:1: " * (K // 6),
    "quotes": 'a:1:1: error: "' + "A_" * (K // 2),
    "many quotes": "a:1:1: error: " + '"AAAAAAAA' * (K // 9),
    "missing symbols": "undefined symbol: " * (K // 18),
    "missing symbols and lines": "undefined symbol: \n>>> referenced by " * (K // 37),
    "folders": FOLDER * (K // len(FOLDER)),
    "folders without a line": (FOLDER + "x/") * (K // len(FOLDER) // 2) + ":?",
    "folders and lines": (FOLDER + "x/a:1") * (K // len(FOLDER) // 2) + "x",
    "spaces": " " * K,
    "lines": "\n" * K,
}


@pytest.mark.parametrize("tower", TOWERS)
def test_what_a_compiler_says_is_read_in_no_time(tower: str) -> None:
    """A submission can put text there by #error, #line and its names."""
    start = time.process_time()
    answers.check_compiler(TOWERS[tower].encode())
    assert time.process_time() - start < 0.5


def test_what_addr2line_says_of_a_megabyte_is_read_in_no_time() -> None:
    start = time.process_time()
    assert judging.place_in((FOLDER + "x/").encode() * 50_000 + b"y.cpp:?") is None
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


def test_a_place_is_one_line_of_bounded_length() -> None:
    line = f"/tmp/{WORK_FOLDER}a1b2/sources/src/part1_contacts.cpp:12 (discriminator 3)\n"
    assert judging.place_in(f"??:0\n{line}".encode()) == "src/part1_contacts.cpp:12"
    assert judging.place_in(f"{FOLDER}x/sources/{'a' * 9999}:1".encode()) is None
    assert (
        judging.place_in(f"{FOLDER}x/sources/\x1b[2J:1".encode())
        == "\N{REPLACEMENT CHARACTER}[2J:1"
    )


def answered(change: Callable[[Any], object]) -> bytes:
    answer = json.loads(answers.judge_seeds()[0])
    change(answer)
    return json.dumps(answer).encode()


def shown(change: Callable[[Any], object]) -> bytes:
    answer = json.loads(answers.judge_seeds()[1])
    change(answer["checks"][0]["revealed"]["shown"])
    return json.dumps(answer).encode()


def test_what_a_case_shows_is_taken() -> None:
    assert judging.read_answer(shown(lambda s: None), parts()[3])


def test_a_check_that_the_manifest_leaves_out_is_dropped() -> None:
    fewer = parts()[3]._replace(checks=parts()[3].checks[1:])
    found = judging.read_answer(shown(lambda s: None), fewer)["checks"]
    assert [check["id"] for check in found] == [check.id for check in fewer.checks]


@pytest.mark.parametrize(
    "out",
    [
        b"",
        b"null",
        b"[]",
        b"{}",
        b"\xff",
        b"[" * 100_000,
        b"9" * 5000,
        answered(lambda a: a.update(largest_error=float("nan"))),
        answered(lambda a: a.update(largest_error=float("inf"))),
        answered(lambda a: a.update(largest_error="0")),
        answered(lambda a: a.update(checks=None)),
        answered(lambda a: a.update(checks=[])),
        answered(lambda a: a["checks"].append(a["checks"][0])),
        answered(lambda a: a["checks"][0].update(passed=1)),
        answered(lambda a: a["checks"][0].update(status="fine")),
        answered(lambda a: a["checks"][0].pop("stack")),
        answered(lambda a: a.update(largest_error=10**400)),
        answers.judge_seeds()[0].replace(b"1e-13", b"1e999"),
        shown(lambda s: s["scene"]["g"].pop()),
        shown(lambda s: s["scene"]["q"].append(0)),
        shown(lambda s: s["scene"].update(v=7)),
        shown(lambda s: s["scene"].update(l=10**400)),
        shown(lambda s: s["quantities"][0].update(got=[[10**400]])),
    ],
)
def test_half_an_answer_of_the_judge_is_a_fault_of_the_kit(out: bytes) -> None:
    with pytest.raises(KitError, match="the judge's"):
        judging.read_answer(out, parts()[3])
