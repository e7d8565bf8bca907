"""./kit test: runs all tests of the kit."""

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from typing import NamedTuple

from bounce_grader.common.errors import UsageError
from bounce_grader.common.parallel_map import parallel_map
from bounce_grader.common.paths import BUILD, ROOT
from bounce_grader.grading.fixtures import hidden_folder
from bounce_grader.publish import fixtures

CPP = ("student", "solution", "grader", "tests/parts", "tests/kit")
READERS = ("frames", "fixtures", "terminations")
FUZZERS = ROOT / "build" / "fuzz"
PYTHON = ("grader/bounce_grader", "tests", "solution")
WORKERS = (os.cpu_count() or 1) + 2  # much of the tests' time is waiting


class Step(NamedTuple):
    """One step of ./kit test."""

    name: str
    run: Callable[[], int]
    is_long: bool = False  # whether only a long run has it
    parallel: bool = False  # whether it uses all cores all the time


def run(is_long: bool) -> int:
    """Runs the steps: several at a time, and then, one by one, those that use all cores all the time.
    Returns the exit status."""
    steps = [step for step in _steps(is_long) if is_long or not step.is_long]
    single = [step for step in steps if not step.parallel]
    parallel = [step for step in steps if step.parallel]
    ordered = [*single, *parallel]

    def passes(step: Step) -> bool:
        place = f"== {ordered.index(step) + 1} of {len(ordered)}, {step.name}"
        print(f"{place} ...", flush=True)
        start = time.monotonic()
        passed = step.run() == 0
        print(f"{place}: {time.monotonic() - start:.1f} s", flush=True)
        return passed

    passed = [*parallel_map(passes, single, WORKERS), *map(passes, parallel)]
    failed = [step.name for step, ok in zip(ordered, passed) if not ok]
    if failed:
        print(f"failed: {', '.join(failed)}")
    return int(bool(failed))


def accept() -> int:
    """Writes anew what the golden tests expect. Raises UsageError in CI, where nobody reads it."""
    if os.environ.get("CI"):
        raise UsageError("--accept is for a person who reads the diff; in CI there is none")
    os.environ["BOUNCE_ACCEPT"] = "1"
    status = _command(sys.executable, "-m", "pytest", "-q", "-n", str(WORKERS), "-m", "golden")
    print("What is expected was written anew; read it: git diff tests/kit", flush=True)
    return status


def _steps(is_long: bool) -> list[Step]:
    return [
        Step("Python tests, the gallery among them", lambda: _pytest(is_long)),
        Step("types: mypy", _mypy),
        Step("formatting: clang-format", _clang_format),
        Step("formatting: black", lambda: _command("black", "-q", "--check", *PYTHON)),
        Step("fixtures are what the kit writes", fixtures.check),
        Step("C++ tests", _ctest),
        Step("lint: clang-tidy", lambda: _clang_tidy(is_long)),
        Step("C++ tests with sanitizers", _sanitized, True, True),
        Step("C++ readers with a million inputs each", _fuzzed, True, True),
    ]


def _command(*words: str) -> int:
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "grader")}
    return subprocess.run(words, cwd=ROOT, env=environment, check=False).returncode


def _quietly(*words: str) -> int:
    """Runs a command, and prints its output only if it fails."""
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        print(done.stdout, done.stderr, sep="\n", flush=True)
    return done.returncode


def _clang_format() -> int:
    sources = (file for folder in CPP for file in sorted((ROOT / folder).rglob("*.?pp")))
    return _command("clang-format", "--dry-run", "-Werror", *map(str, sources))


def _clang_tidy(is_long: bool) -> int:
    """Looks at what was changed since the last commit but one; in a long run, at every file: each
    takes several seconds, mostly for headers of Eigen and the standard library."""
    files = ["(solution|grader/judge)/.*"]
    if not is_long:
        command = ["git", "diff", "--name-only", "HEAD~1", "--", "solution", "grader/judge"]
        changed = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
        files = [name for name in changed.stdout.split() if name.endswith(".cpp")]
    if not files:
        return 0
    run_all = [sys.executable, "/usr/bin/run-clang-tidy", "-quiet", "-p", str(ROOT / "build/tidy")]
    run_all += ["-j", str(os.cpu_count() or 1), *(f"^{ROOT}/{file}$" for file in files)]
    return _quietly("cmake", "--preset", "tidy") or _quietly(*run_all)


def _mypy() -> int:
    return _command("mypy", "--no-error-summary", "--cache-dir", str(BUILD / "mypy"), *PYTHON)


def _ctest() -> int:
    return _quietly("ctest", "--test-dir", str(BUILD), "--output-on-failure", "-j", str(WORKERS))


def _sanitized() -> int:
    """Runs the C++ tests again, with AddressSanitizer and UBSan."""
    folder = str(ROOT / "build" / "sanitize")
    return (
        _quietly("cmake", "--preset", "sanitize")
        or _quietly("ninja", "-C", folder, "cpp_tests")
        or _quietly("ctest", "--test-dir", folder, "--output-on-failure", "-j", str(WORKERS))
    )


def _fuzzed() -> int:
    """Gives each C++ reader of untrusted data a million inputs, by tests/kit/fuzz/. One that makes
    it fail is stored in build/fuzz/inputs/. The Python readers have theirs in test_readers.py
    there."""
    programs = [f"fuzz_{name}" for name in READERS]
    if _quietly("cmake", "--preset", "fuzz") or _quietly("ninja", "-C", str(FUZZERS), *programs):
        return 1
    (FUZZERS / "inputs").mkdir(exist_ok=True)
    return max(parallel_map(_with_libfuzzer, programs, os.cpu_count() or 1))


def _with_libfuzzer(program: str) -> int:
    """libFuzzer mutates inputs to reach new code. The seed is fixed."""
    options = ["-runs=1000000", "-seed=1", "-timeout=10", "-max_len=8192"]
    options += [f"-artifact_prefix={FUZZERS}/inputs/{program}-"]
    with tempfile.TemporaryDirectory() as seeds:  # libFuzzer adds inputs to it
        subprocess.run([BUILD / program, "--seeds", seeds], check=True)
        return _quietly(str(FUZZERS / program), *options, seeds)


def _pytest(is_long: bool) -> int:
    hidden_folder()  # so that the oracle finds the hidden ones too
    chosen = [] if is_long else ["-m", "not long"]
    workers = ["-n", str(WORKERS), "--dist", "loadgroup"]
    return _command(sys.executable, "-m", "pytest", "-q", *workers, *chosen)
