"""./kit bench: what a grading costs, beside the plain way: a GoogleTest program built with the
submission. Measured here and now; the ratios are what can be compared between machines."""

import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from bounce_grader import build
from bounce_grader.box import Box
from bounce_grader.errors import KitError
from bounce_grader.manifest import parts
from bounce_grader.paths import BUILD, CONTRACT, REFERENCE_RUNNER, ROOT
from bounce_grader.submission import read

ROUNDS = 5
SOLUTION = ROOT / "solution" / "src"


def run() -> int:
    subprocess.run([str(BUILD / "kit_bench"), str(REFERENCE_RUNNER)], check=True)
    with tempfile.TemporaryDirectory(prefix="bounce-bench-") as name:
        folder = Path(name)
        fresh, again = [], []
        for number in range(ROUNDS):
            submission = _variant(folder / str(number), number)
            fresh.append(_seconds(_grading(submission)))
            again.append(_seconds(_grading(submission)))
        memory = _memory_of_compiling(_variant(folder / "memory", ROUNDS))
        plain = [_plain(submission, folder)]
    print()
    _line("a new submission, ./kit grade", fresh)
    _line("the same again (its objects are kept)", again)
    _line("the plain way: g++ and GoogleTest, linked with it", plain)
    ratio = statistics.median(plain) / statistics.median(fresh)
    print(f"{'the plain way takes':<54}{ratio:6.1f} times as long")
    print(f"{'largest process of a grading (the compiler)':<54}{memory:6.0f} MB")
    return 0


def _variant(folder: Path, number: int) -> Path:
    """The solution, a comment different, so that no part of it has been compiled before."""
    folder.mkdir()
    for file in SOLUTION.glob("*.cpp"):
        stamp = f"// {time.time_ns()} {number}\n"
        (folder / file.name).write_text(stamp + file.read_text())
    return folder


def _grading(submission: Path) -> list[str]:
    return [str(ROOT / "kit"), "grade", str(submission), "--min-score", "100"]


def _seconds(command: list[str]) -> float:
    start = time.monotonic()
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if done.returncode != 0:
        print(done.stdout.decode(), file=sys.stderr)
        raise KitError(f"{command[0]} ended with status {done.returncode}")
    return time.monotonic() - start


def _plain(submission: Path, folder: Path) -> float:
    """Compiles the submission with the tests, the fixtures' reader and GoogleTest, and runs it."""
    program = folder / "plain"
    tests = [str(ROOT / "tests" / f"{part.stem}_test.cpp") for part in parts()]
    linked = [str(ROOT / "tests" / "linked" / f"{part.stem}.cpp") for part in parts()]
    own = [str(submission / part.file) for part in parts()]
    command = [
        *("g++", "-std=c++20", "-O1", "-isystem", "/usr/include/eigen3", "-I", str(CONTRACT)),
        f'-DBOUNCE_FIXTURES="{ROOT / "fixtures" / "public"}"',
        *tests,
        *linked,
        *own,
        str(ROOT / "tests" / "cases.cpp"),
        str(ROOT / "tests" / "linked" / "main.cpp"),
        str(ROOT / "student" / "given" / "solve_lcp.cpp"),
        *("-lgtest", "-lpthread", "-o", str(program)),
    ]
    return _seconds(command) + _seconds([str(program)])


def _memory_of_compiling(submission: Path) -> float:
    """MB of the compiler, the largest process of a grading. Without a box, which hides it."""
    build.compile_all(read(submission), submission, Box("none"), jobs=1)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024


def _line(name: str, seconds: list[float]) -> None:
    median = statistics.median(seconds)
    print(f"{name:<54}{median:6.2f} s   ({min(seconds):.2f} to {max(seconds):.2f})")
