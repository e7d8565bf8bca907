"""./kit bench class: times made-up classes of growing size, first from nothing and then again.
Other programs on the machine disturb it; compare the seconds per submission between sizes."""

import os
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

from bounce_grader.common.errors import KitError
from bounce_grader.common.paths import ROOT
from bounce_grader.develop import synthetic_class

KINDS = ("accepted", "mistakes")  # the folders of the gallery that most of a class is like
FIRST_USER = 1_000_000


@dataclass(frozen=True)
class Measured:
    """What one run of a class took."""

    seconds: float
    megabytes: float  # peak memory of the process that runs the class


def run(largest: int) -> int:
    print(
        f"{'submissions':>11} {'from nothing':>13} {'a minute':>9} {'each':>7} {'again':>7} memory"
    )
    with tempfile.TemporaryDirectory(prefix="bounce-bench-") as name:
        for size in [size for size in (10, 100, 1000) if size <= largest]:
            _size(Path(name) / str(size), size)
    print(f"load of the machine: {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores")
    return 0


def _size(folder: Path, size: int) -> None:
    folder.mkdir()
    users = FIRST_USER + time.time_ns() % 10**9  # in comments, so that the cache has no object
    of = list(synthetic_class.students(size, KINDS, users))
    synthetic_class.canvas_zip(folder / "submissions.zip", of)
    first, again = _class(folder), _class(folder)
    rate = 60 * size / first.seconds
    most = max(first.megabytes, again.megabytes)
    print(
        f"{size:>11} {first.seconds:>11.1f} s {rate:>9.0f} {first.seconds / size:>5.2f} s "
        f"{again.seconds:>5.1f} s {most:.0f} MB",
        flush=True,
    )


def _class(folder: Path) -> Measured:
    start = time.monotonic()
    command = [str(ROOT / "kit"), "class", str(folder / "submissions.zip")]
    process = subprocess.Popen(
        [*command, "--out", str(folder / "out")],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )
    most = 0.0
    while process.poll() is None:
        most = max(most, _largest_so_far(process.pid))
        time.sleep(0.1)
    if process.returncode != 0:
        print(process.stderr.read() if process.stderr else "", file=sys.stderr)
        raise KitError(f"{command[0]} class ended with status {process.returncode}")
    return Measured(time.monotonic() - start, most)


def _largest_so_far(process: int) -> float:
    try:
        status = Path(f"/proc/{process}/status").read_text()
    except OSError:
        return 0.0
    lines = [line for line in status.splitlines() if line.startswith("VmHWM")]
    return int(lines[0].split()[1]) / 1024 if lines else 0.0
