"""A Dask cluster on this machine, for tests that lose parts of it."""

import json
import os
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from shutil import which

import pytest
from waiting import wait_for

ROOT = Path(__file__).resolve().parents[3]


@dataclass
class Cluster:
    address: str = ""
    processes: list["subprocess.Popen[bytes]"] = field(default_factory=list)

    def start(
        self, *words: str, path: str = f"{ROOT / 'grader'}:{ROOT / 'tests/kit/support'}"
    ) -> "subprocess.Popen[bytes]":
        quiet = subprocess.DEVNULL
        environment = {**os.environ, "PYTHONPATH": path}
        command = [sys.executable, *words]
        process = subprocess.Popen(command, env=environment, stdout=quiet, stderr=quiet)
        self.processes.append(process)
        return process

    def worker(self, **more: str) -> "subprocess.Popen[bytes]":
        options = ["--nthreads", "1", "--no-nanny", "--no-dashboard"]
        return self.start("/usr/bin/dask-worker", self.address, *options, **more)


@contextmanager
def started(folder: Path) -> Iterator[Cluster]:
    """A scheduler, without workers yet."""
    if which("dask-worker") is None:
        pytest.skip("python3-distributed is missing")
    file = folder / "scheduler.json"
    made = Cluster()
    options = ["--host", "127.0.0.1", "--port", "0", "--no-dashboard"]
    made.start("/usr/bin/dask-scheduler", *options, "--scheduler-file", str(file))
    wait_for(lambda: file.exists() and file.read_text().endswith("}"))
    made.address = json.loads(file.read_text())["address"]
    yield made
    for process in made.processes:
        process.kill()
        process.wait()


@contextmanager
def killed_once(
    happened: Callable[[], object], process: "subprocess.Popen[bytes]"
) -> Iterator[None]:
    """Kills a process as soon as this has happened."""

    def kill() -> None:
        wait_for(happened)
        process.kill()

    killer = threading.Thread(target=kill)
    killer.start()
    yield
    killer.join()
