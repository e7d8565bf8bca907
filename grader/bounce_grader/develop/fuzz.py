"""Fuzzing for ./kit test --long: a million inputs for each C++ reader of untrusted data, by the
fuzzers in tests/kit/fuzz/. An input that makes one fail is stored in build/fuzz/inputs/. The Python
readers have theirs in tests/kit/fuzz/test_readers.py.
"""

import os
import re
import subprocess
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

from bounce_grader.common.paths import BUILD, ROOT

COUNT = 1_000_000
CPP = ("frames", "fixtures", "terminations")
FUZZERS = ROOT / "build" / "fuzz"
INPUTS = FUZZERS / "inputs"


def run() -> int:
    """Returns the exit status: 0 if each input was accepted or rejected as it should be."""
    problem = _build()
    if problem:
        print(problem, flush=True)
        return 1
    INPUTS.mkdir(exist_ok=True)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        return int(not all(list(pool.map(_with_libfuzzer, CPP))))


def _build() -> str:
    """Builds the fuzzers. Returns the error, or ""."""
    for command in (
        ["cmake", "--preset", "fuzz"],
        ["ninja", "-C", str(FUZZERS), *(f"fuzz_{name}" for name in CPP)],
    ):
        done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            return done.stdout + done.stderr
    return ""


def _with_libfuzzer(name: str) -> bool:
    """Runs a fuzzer with libFuzzer, which mutates inputs to reach new code. The seed is fixed."""
    start = time.monotonic()
    options = [f"-runs={COUNT}", "-seed=1", "-timeout=10", "-max_len=8192", "-print_final_stats=1"]
    options += [f"-artifact_prefix={INPUTS}/{name}-"]
    with tempfile.TemporaryDirectory() as seeds:  # libFuzzer adds inputs to it
        subprocess.run([BUILD / f"fuzz_{name}", "--seeds", seeds], check=True)
        command = [str(FUZZERS / f"fuzz_{name}"), *options, seeds]
        done = subprocess.run(command, capture_output=True, check=False)
    output = done.stderr.decode("utf-8", "replace")
    counted = re.search(r"stat::number_of_executed_units: (\d+)", output)
    count = int(counted.group(1)) if counted else 0
    print(f"   {name}: {count} inputs, in {time.monotonic() - start:.0f} s", flush=True)
    if done.returncode == 0 and count >= COUNT:
        return True
    print(output[-4000:], flush=True)
    return False
