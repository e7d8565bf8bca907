"""./kit test: runs all tests of the kit."""

import argparse
import os
import subprocess
import sys
import time
from itertools import compress
from pathlib import Path

from bounce_grader.common.errors import UsageError
from bounce_grader.common.parallel_map import parallel_map
from bounce_grader.common.paths import BUILD, ROOT
from bounce_grader.grading.fixtures import hidden_folder

Command = list[str]
CPP = ("student", "solution", "grader", "tests/parts", "tests/kit")
PYTHON = ["grader/bounce_grader", "tests", "solution"]
CORES = os.cpu_count() or 1
WORKERS = CORES + 1  # some of the tests wait
PYTEST = [sys.executable, "-m", "pytest", "-q", "-n", str(WORKERS)]


def run(options: argparse.Namespace) -> int:
    """Runs the steps, two at a time: the tests in Python take most of the time, and the others are
    done beside them. Returns the exit status."""
    if options.accept:
        return _accept()
    hidden_folder()  # so that the oracle finds the hidden ones too
    steps = _steps(options.long)
    places = {name: f"== {i} of {len(steps)}, {name}" for i, name in enumerate(steps, 1)}

    def fails(name: str) -> bool:
        print(f"{places[name]} ...", flush=True)
        start = time.monotonic()
        failed = any(map(_run, steps[name]))  # until the first that fails
        print(f"{places[name]}: {time.monotonic() - start:.1f} s", flush=True)
        return failed

    failed = [*compress(steps, parallel_map(fails, steps, 2))]
    if failed:
        print(f"failed: {', '.join(failed)}")
    return int(bool(failed))


def _accept() -> int:
    """Writes anew what the golden tests expect. Raises UsageError in CI, where nobody reads it."""
    if os.environ.get("CI"):
        raise UsageError("--accept is for a person who reads the diff; in CI there is none")
    os.environ["BOUNCE_ACCEPT"] = "1"
    status = _run([str(BUILD / "solution_test")]) or _run([*PYTEST, "-m", "golden"])
    print("What is expected was written anew; read it: git diff tests/kit", flush=True)
    return status


def _run(command: Command) -> int:
    """Shows each of the tests in Python, which take minutes; of others what a failing one says."""
    env = {**os.environ, "PYTHONPATH": str(ROOT / "grader")}
    quiet = "pytest" not in command
    done = subprocess.run(command, cwd=ROOT, env=env, capture_output=quiet, text=True, check=False)
    if quiet and done.returncode != 0:
        print(done.stdout, done.stderr, sep="\n", flush=True)
    return done.returncode


def _steps(is_long: bool) -> dict[str, list[Command]]:
    cpp = [str(file) for folder in CPP for file in sorted((ROOT / folder).rglob("*.?pp"))]
    mypy = ["mypy", "--no-error-summary", "--cache-dir", str(BUILD / "mypy"), *PYTHON]
    python = [*PYTEST, "--dist", "loadgroup", *([] if is_long else ["-m", "not long"])]
    steps = {
        "Python tests, the gallery among them": [python],
        "formatting: black": [["black", "-q", "--check", *PYTHON]],
        "formatting: clang-format": [["clang-format", "--dry-run", "-Werror", *cpp]],
        "types: mypy": [mypy],
        "C++ tests": [_ctest(BUILD)],
        "lint: clang-tidy": _clang_tidy(is_long),
    }
    if not is_long:
        return steps
    # Builds each of them; that they are named is shown by the gallery.
    mistakes = "answers of known mistakes are what the kit writes"
    steps[mistakes] = [[str(ROOT / "kit"), "fixtures", "--check"]]
    named = {
        "fuzz": "C++ readers with a million inputs each",
        "sanitize": "C++ tests with sanitizers",
    }
    for preset, name in named.items():
        folder = ROOT / "build" / preset
        built = [["cmake", "--preset", preset], ["ninja", "-C", str(folder), "cpp_tests"]]
        steps[name] = [*built, _ctest(folder)]
    return steps


def _ctest(folder: Path) -> Command:
    return ["ctest", "--test-dir", str(folder), "--output-on-failure", "-j", str(WORKERS)]


def _clang_tidy(is_long: bool) -> list[Command]:
    """Looks at what was changed since the last commit but one; in a long run, at every file: each
    takes several seconds, mostly for headers of Eigen and the standard library."""
    files = ["(solution|grader/judge)/.*"]
    if not is_long:
        # In a container's job the checkout is another user's.
        command = ["git", "-c", f"safe.directory={ROOT}", "diff", "--name-only", "HEAD~1", "--"]
        command += ["solution", "grader/judge"]
        changed = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
        if changed.returncode:
            print("clang-tidy looks at nothing: git knows no commit before this one", flush=True)
        files = [name for name in changed.stdout.split() if name.endswith(".cpp")]
    run_all = [sys.executable, "/usr/bin/run-clang-tidy", "-quiet", "-p", str(ROOT / "build/tidy")]
    run_all += ["-j", str(CORES), *(f"^{ROOT}/{file}$" for file in files)]
    return [["cmake", "--preset", "tidy"], run_all] if files else []
