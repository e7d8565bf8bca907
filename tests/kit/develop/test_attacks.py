"""Random submissions that attack: six in each run, the same each time. ./kit test --long
runs five hundred, different ones each day.

It also tests that a broken promise is noticed.
"""

import random
import re
import subprocess
import sys

import pytest
from conftest import ROOT
from fuzzing import nasty, nasty_words
from fuzzing.attacks import some_attack

COUNT, FIRST = 6, 7040
ONE_FOLDER = pytest.mark.xdist_group("attacks")  # of tests with the same seed
# Programs that replace the kit.
LEAKING = """
import os, subprocess, sys
print(os.environ["BOUNCE_CANARY"])
open(os.path.join(os.environ["TMPDIR"], "left"), "w")
subprocess.Popen(["/usr/bin/sleep", "600"], start_new_session=True)
print("Traceback (most recent call last)", file=sys.stderr)
sys.exit(3)
"""
UNJUST = """
import json, re, sys
parts = [{"part": number, "score": 0, "message": "lost"} for number in range(1, 5)]
json.dump({"parts": parts, "box": "full"}, open(sys.argv[sys.argv.index("--json") + 1], "w"))
"""


def python(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, *arguments],
        cwd=ROOT,
        env={
            "PATH": "/usr/bin:/bin",
            "PYTHONPATH": f"{ROOT / 'grader'}:{ROOT / 'tests/kit/support'}",
        },
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.mark.slow
def test_attacks_break_no_promise() -> None:
    done = python("-m", "fuzzing", "attacks", str(COUNT), str(FIRST))
    assert done.returncode == 0, done.stdout + done.stderr


def test_an_attack_depends_on_its_seed_alone() -> None:
    for seed in range(50):
        first, again = (some_attack(random.Random(seed), ["/secret"]) for _ in range(2))
        assert first == again
        assert first.honest_users or first.archive or 0 < len(first.files)


def test_a_string_of_cpp_is_one_whatever_is_in_it() -> None:
    for words in (*nasty_words.DECISIVE, *nasty_words.WORDS, "".join(map(chr, range(1, 256)))):
        spelled = nasty_words.quoted(words)
        assert spelled.isascii() and spelled.isprintable()
        assert spelled.count('"') == 2


def test_what_only_says_something_leaves_nothing_to_link() -> None:
    """Helpers of such pieces are linked with honest parts, which a missing name would break on a
    student's machine, too."""
    declared = 0
    for seed in range(300):
        head = nasty.some_piece(random.Random(seed), [], nasty.OF_TEXT).head
        for name in re.findall(r"\bvoid (\w+)\(\)", head):
            declared += 1
            assert f"void {name}() {{" in head
    assert declared


def problems_with(kit: str, seed: int) -> str:
    """The problems that are found if another program replaces the kit."""
    told = f"""
from fuzzing import attack_run
attack_run.MAIN = {kit!r}
attack_run._rendered = lambda name, record, submission: b""
attack_run._keep = lambda submission, seed, problems: None
print(*attack_run.attacked({seed}, "full")[1], sep=chr(10))
"""
    done = python("-c", told)
    assert done.returncode == 0, done.stderr
    return done.stdout


def seed_of(kind: str) -> int:
    """The seed of an attack: a folder with an honest part, or a class."""
    made = ((seed, some_attack(random.Random(f"attacks {seed}"), [])) for seed in range(99))
    if kind == "class":
        return next(seed for seed, attack in made if attack.is_class)
    return next(seed for seed, attack in made if attack.files and attack.honest_parts)


@ONE_FOLDER
@pytest.mark.slow
@pytest.mark.parametrize("kind", ["folder", pytest.param("class", marks=pytest.mark.long)])
def test_what_a_grading_gives_away_or_leaves_behind_is_noticed(kind: str) -> None:
    said = problems_with(LEAKING, seed_of(kind))
    for problem in (
        "exit status 3",
        "a traceback",
        "1 processes are left behind",
        "left in the temporary folder: ['left']",
        "the secret is in standard output",
    ):
        assert problem in said


@ONE_FOLDER
def test_points_that_an_honest_part_loses_are_noticed() -> None:
    assert "is honest, and has 0 points: lost" in problems_with(UNJUST, seed_of("folder"))
