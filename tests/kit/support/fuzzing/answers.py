"""Fuzzes the judge's and the compiler's output, which a submission can influence."""

import json
from collections.abc import Callable
from functools import cache
from typing import Any

from bounce_grader.build import compiler, linking
from bounce_grader.common.errors import KitError
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import WORK_FOLDER
from bounce_grader.grading import judging, speed
from bounce_grader.sandbox.processes import Result

SHOWN = {
    "name": "a bounce",
    "input": "q = (1, 2, 3)",
    "sentence": "column 2 is the first wrong one",
    "contact": "corner 2 touches and sticks",
    "quantities": [
        {"name": "p", "unit": "m/s", "got": [[1, "nan"]], "right": [[True, False]]}
        | {"expected": [[1, 2.5]]}
    ],
    "scene": {"l": 0.2, "m": 0.3, "g": [0, -9.81, 0], "dt": 0.01, "delta": 0.001}
    | {"q": [0, 0.1, 0], "v": [1, 0, 0]},
    "path": {
        "first": 1,
        "got": [[0, 1, 2], ["inf", 0, 0]],
        "columns": [0],
        "expected": [[0, 1, 2]],
    },
}
POINTS = [{"dt": 0.01, "ns": 25000, "error": 0.12}, {"dt": 0.003, "ns": 81000, "error": None}]
TIMES = {
    "dt": [0.01, 0.003],
    "cut": "at dt = 0.001 s: the program crashed",
    "scenes": [
        {"scene": "tumble", "title": "Tumble", "seconds": 0.4}
        | {"submission": POINTS, "solution": POINTS, "least": POINTS[:1]}
    ],
}


@cache
def judge_seeds() -> list[bytes]:
    check = {"passed": True, "status": "graded", "stack": "", "message": ""}
    check |= {"shown": None, "revealed": None}
    wrong = {"passed": False, "status": "crashed", "stack": " 0x40 0x41", "message": "1 of 2\n got"}
    wrong |= {"shown": SHOWN, "revealed": {"message": "1 of 2", "shown": SHOWN}}
    ids = [check.id for check in parts()[3].checks]
    told = {"mistakes": ["part4_transposed"], "patterns": ["Column 0 is the first wrong one."]}
    return [
        json.dumps(
            {"checks": [{**verdict, "id": id} for id in ids], "largest_error": error, **told}
        ).encode()
        for verdict, error in ((check, 1e-13), (wrong, None))
    ] + [json.dumps(TIMES).encode(), b"[" * 3000]


def check_judge(data: bytes) -> bool:
    return any([_read(judging.read_answer, data, parts()[3]), _read(speed.read, data)])


def _read(reader: Callable[..., Any], *arguments: Any) -> bool:
    try:
        json.dumps(reader(*arguments), allow_nan=False)
    except KitError:
        return False
    return True


COMPILER_SEEDS = [
    b"part2_lcp.cpp:7:3: warning: x\npart2_lcp.cpp:9:1: error: expected expression\n",
    b"In file included from a b/h.hpp:1:\na b/h.hpp:3:9: fatal error: 'x' file not found\n",
    b'/usr/include/eigen3/Eigen/src/Core/Product.h:1:2: error: static_assert "INVALID_PRODUCT"\n'
    b"part2_lcp.cpp:11:30: note: in instantiation of function template\n",
    b"ld.lld: error: undefined symbol: r(double)\n>>> referenced by part3_step.cpp:12 (/tmp/x:12)\n",
    b"ld.lld: error: duplicate symbol: main\n",
    f"??:0\n/tmp/{WORK_FOLDER}x1/sources/src/part1_contacts.cpp:12 (discriminator 3)\n".encode(),
]


def check_compiler(data: bytes) -> bool:
    said = Result(1, 0.0, b"", data.decode("utf-8", "replace"), False, False)
    problem = compiler.compile_problem(said, "part2_lcp.cpp")
    link = linking.link_problem(said)
    place = judging.place_in(data)
    assert problem and "\n" not in problem and "\n" not in link
    assert place is None or len(place) <= 300
    return place is not None or ": " in problem
