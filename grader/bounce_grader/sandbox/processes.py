"""Starts every process on the way of a grading. They get a fixed environment and not ours, because
a program in a box may look for the environments of the processes above it. Output is capped while
it streams: this is the one place that reads what a process prints, so no reader takes more than the
process's Limits say.
"""

import errno
import os
import selectors
import signal
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO, NamedTuple

from bounce_grader.common.errors import KitError

CHUNK = 64 * 1024
GRACE = 2.0  # seconds
ENVIRONMENT = {"PATH": "/usr/bin:/bin", "LC_ALL": "C.UTF-8"}

# Placeholders in a command for descriptors that `run` opens: on STATUS a box reports that it was
# made (grader/box/enter.cpp); OUTPUT receives the file that a build made.
STATUS, OUTPUT = "<status>", "<output>"
MADE, SHORT = b"m", b"s"  # what a box reports on STATUS


class Limits(NamedTuple):
    """What a process may use. The CPU limit decides; the wall-clock limit is a loose backstop. The
    CPU limit ends it by SIGKILL, because a compiler answers SIGXCPU with a long stack trace. A
    process that prints more than `output` bytes is ended; `errors` bytes of its errors are kept."""

    cpu_seconds: int
    wall_seconds: float
    memory: int | None  # None: limited elsewhere
    file_size: int
    output: int = 256 * 1024
    errors: int = 64 * 1024

    def prefix(self) -> list[str]:
        memory = "unlimited" if self.memory is None else self.memory
        most = {"cpu": self.cpu_seconds, "as": memory, "fsize": self.file_size, "core": 0}
        return ["/usr/bin/prlimit", *(f"--{name}={value}" for name, value in most.items()), "--"]


class Result(NamedTuple):
    """How a process ended, and what it printed and used."""

    code: int  # the exit status; -n for signal n
    cpu_seconds: float  # of it and children it waited for; if we killed it, of all its descendants
    out: bytes
    err: str
    too_long: bool  # ended because the wall clock ran out
    flooded: bool  # ended because it printed too much
    boxed: bool = True  # the box was made, if one was asked for, and its command was started
    cpu_limit: float = 0.0  # CPU seconds that it was given
    peak: int = 0  # bytes in memory of the largest of them; 0 if we killed it

    @property
    def ok(self) -> bool:
        return self.code == 0 and self.boxed and not self.stopped

    @property
    def stopped(self) -> bool:
        """Whether `run` killed it. The system's count of our children's CPU time lacks its time."""
        return self.too_long or self.flooded

    @property
    def killed(self) -> bool:
        """Whether SIGKILL ended it, and `run` didn't. A box passes a signal on as a status."""
        return self.code in (-9, 128 + 9) and not self.stopped


def run(
    command: list[str],
    limits: Limits | None = None,
    *,
    stdin: bytes = b"",
    cwd: Path | None = None,
    output: Path | None = None,
) -> Result:
    """Runs a command to its end, with `stdin` as its standard input. The file that a box passes out
    is written to the new file `output`. Without limits, as for the kit's programs, it keeps all
    that is printed."""
    to_us, from_box = os.pipe()  # no file, which the process could be forbidden to write
    with (
        open(to_us, "rb", buffering=0) as status,
        open(from_box, "wb") as reports,
        open(output or os.devnull, "wb") as made,
        _in_memory(stdin) as given,
    ):
        if output:  # whatever the umask: a later box reads it as another user
            os.fchmod(made.fileno(), 0o644)
        os.set_blocking(to_us, False)
        opened = {STATUS: reports.fileno(), OUTPUT: made.fileno()}
        passed = {word: opened[word] for word in opened if word in command}
        words = [*(limits.prefix() if limits else []), *(str(passed.get(w, w)) for w in command)]
        try:
            process = subprocess.Popen(
                words,
                stdin=given if stdin else subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                cwd=cwd,
                env=ENVIRONMENT,
                pass_fds=tuple(passed.values()),
                start_new_session=True,
            )
        except OSError as error:
            raise KitError(f"{words[0]} could not be started: {error.strerror}") from error
        with process:  # closes its streams
            try:
                result = _collect(process, limits)
            except BaseException:
                if process.poll() is None:
                    _stop(process)
                raise
        report = (status.read(8) or b"") if STATUS in command else MADE
    if SHORT in report:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(output))
    return result._replace(boxed=report == MADE, cpu_limit=limits.cpu_seconds if limits else 0.0)


def _in_memory(data: bytes) -> BinaryIO:
    """A read-only file in memory. Unlike a pipe it has room for all bytes, so neither side
    waits."""
    with open(os.memfd_create("stdin"), "wb") as file:
        file.write(data)
        file.flush()
        return open(f"/proc/self/fd/{file.fileno()}", "rb")


def _collect(process: subprocess.Popen[bytes], limits: Limits | None) -> Result:
    assert process.stdout and process.stderr
    out, err = process.stdout.fileno(), process.stderr.fileno()
    kept = {out: bytearray(), err: bytearray()}
    caps = {out: limits.output, err: limits.errors} if limits else dict.fromkeys(kept, sys.maxsize)
    deadline = time.monotonic() + limits.wall_seconds if limits else None
    too_long = flooded = False
    with selectors.DefaultSelector() as selector:
        for fd in kept:
            selector.register(fd, selectors.EVENT_READ)
        while selector.get_map() and not (too_long or flooded):
            left = None if deadline is None else max(0.0, deadline - time.monotonic())
            for key, _ in selector.select(left):
                chunk = os.read(key.fd, CHUNK)
                if not chunk:
                    selector.unregister(key.fd)
                room = caps[key.fd] - len(kept[key.fd])
                kept[key.fd] += chunk[: max(0, room)]
                flooded = flooded or (key.fd == out and len(chunk) > room)
            too_long = deadline is not None and time.monotonic() >= deadline
    code, seconds, peak = _ended(process, stop=too_long or flooded)
    said = kept[err].decode("utf-8", "replace")
    return Result(code, seconds, bytes(kept[out]), said, too_long, flooded, peak=peak)


def _ended(process: subprocess.Popen[bytes], stop: bool) -> tuple[int, float, int]:
    """Its status, CPU seconds and peak of memory."""
    if stop:
        seconds = _seconds_of_all_below(process.pid)  # wait4 wouldn't count them all
        _stop(process)
        return process.returncode, seconds, 0
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, usage.ru_utime + usage.ru_stime, usage.ru_maxrss << 10


def _seconds_of_all_below(root: int) -> float:
    """CPU time of a process, its descendants, and all children that these have waited for."""
    parent_of: dict[int, int] = {}
    ticks_of: dict[int, int] = {}
    for entry in filter(str.isdigit, os.listdir("/proc")):
        with suppress(OSError, ValueError, IndexError):  # it has ended
            stat = Path("/proc", entry, "stat").read_text(errors="replace")
            fields = stat.rpartition(")")[2].split()
            parent_of[int(entry)] = int(fields[1])
            ticks_of[int(entry)] = sum(map(int, fields[11:15]))
    below = {root}
    while more := {pid for pid, parent in parent_of.items() if parent in below} - below:
        below |= more
    return sum(ticks_of.get(pid, 0) for pid in below) / os.sysconf("SC_CLK_TCK")


def _stop(process: subprocess.Popen[bytes]) -> None:
    """Ends a process group: by SIGTERM, so that a reduced box cleans up, and then by SIGKILL."""
    os.killpg(process.pid, signal.SIGTERM)
    try:
        process.wait(GRACE)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
