"""A Dask cluster on this machine, for tests that lose parts of it."""

import os
import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from shutil import which

import pytest
from waiting import wait_for

ROOT = Path(__file__).resolve().parents[3]


@dataclass
class Cluster:
    address: str
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

    def wait_for_worker(self) -> None:
        from distributed import Client

        with Client(self.address, set_as_default=False) as client:
            client.wait_for_workers(1, timeout=60)


@contextmanager
def started() -> Iterator[Cluster]:
    """A scheduler, without workers yet."""
    if which("dask-worker") is None:
        pytest.skip("python3-distributed is missing")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    made = Cluster(f"tcp://127.0.0.1:{port}")
    options = ["--host", "127.0.0.1", "--port", str(port), "--no-dashboard"]
    made.start("/usr/bin/dask-scheduler", *options)

    def answers() -> bool:
        with socket.socket() as probe:
            return probe.connect_ex(("127.0.0.1", port)) == 0

    wait_for(answers)
    yield made
    for process in made.processes:
        process.kill()
        process.wait()
