"""Fuzzing for ./kit test --long: a million inputs for each reader of untrusted data.

The fuzzers of C++ readers are in tests/kit/fuzz/, those of Python readers in
tests/kit/support/fuzzing/. The usual test run gives each reader a few thousand inputs. An input
that makes one fail is stored in build/fuzz/inputs/.
"""

import os
import re
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

from bounce_grader.common.paths import BUILD, ROOT, SUPPORT

COUNT = 1_000_000
CPP = ("frames", "fixtures", "terminations")
PYTHON = {"zip": COUNT, "sources": COUNT, "judge": COUNT, "compiler": COUNT}
PYTHON["folder"] = COUNT // 10  # fewer, because each is made on disk
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
        sound = list(pool.map(_with_libfuzzer, CPP))
    sound += [_with_python(name, str(count)) for name, count in PYTHON.items()]
    return int(not all(sound))


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


def _with_python(*words: str) -> bool:
    environment = {**os.environ, "PYTHONPATH": f"{ROOT / 'grader'}:{SUPPORT}"}
    command = [sys.executable, "-m", "fuzzing", *words]
    return subprocess.run(command, cwd=ROOT, env=environment, check=False).returncode == 0
