"""./kit doctor: tests each protection for real, on this machine and for this user. A program, the
probe, tries to break out of the boxes for compiling, for running, and for running with sanitizers.
A process above the box has a canary on its command line and in its environment; the probe must not
find it."""

import json
import os
import secrets
import socket
import tempfile
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import IO

from bounce_grader.build.compiler import COMPILE, compiler
from bounce_grader.common.paths import JUDGE, PROBE, ROOT
from bounce_grader.sandbox import processes
from bounce_grader.sandbox.box import problem_of, Box

Attempt = list[str]
PLACES = ("compile", "run", "check")
RUN = PLACES[1:]
# A process above the box that holds the canary.
ABOVE = ["/bin/sh", "-c", 'BOUNCE_DOCTOR="$0" "$@"; status=$?; kept="$0"; exit $status']
WATCHING = processes.Limits(cpu_seconds=20, wall_seconds=90, memory=None, file_size=0)
COMPILING = COMPILE._replace(cpu_seconds=1)


@dataclass(frozen=True)
class Protection:
    """Something that a box promises, with the attempts that would break it."""

    title: str
    attempts: list[Attempt]  # arguments for the probe; none of these attempts may succeed
    places: tuple[str, ...] = PLACES
    outside: Callable[[], bool] | None = None  # if given, this check from outside decides
    canary: str = ""  # in a process above the box


@dataclass(frozen=True)
class Finding:
    """The result of one protection in one box; held is None if the box can't be made here."""

    protection: str
    box: str  # "full compile", ...
    held: bool | None
    detail: str


def findings() -> list[Finding]:
    """Every protection in every box, in the order of the table."""
    with _bait() as protections, tempfile.TemporaryDirectory(prefix="bounce-doctor-") as name:
        folder = Path(name)
        Box("full").give(folder)
        return [
            finding
            for kind, places in (("full", PLACES), ("reduced", PLACES[:2]))
            for place in places
            for finding in _in_box(Box(kind), place, folder, protections)
        ]


def _in_box(box: Box, place: str, folder: Path, protections: list[Protection]) -> Iterator[Finding]:
    """Tries the protections in one box, after checking that the box can be made and the probe
    starts."""
    problem = problem_of(box)
    if not problem and not attempt(box, place, folder, ["nothing"])[0]:
        problem = "the probe doesn't start"
    for protection in protections:
        if place not in protection.places:
            continue
        if problem:
            yield Finding(protection.title, f"{box.kind} {place}", None, problem)
            continue
        above = [*ABOVE, protection.canary] if protection.canary else []
        outcomes = [attempt(box, place, folder, words, above) for words in protection.attempts]
        held = not any(could for could, _ in outcomes)
        held = protection.outside() if protection.outside else held
        detail = "; ".join(answer for _, answer in outcomes)
        yield Finding(protection.title, f"{box.kind} {place}", held, detail)


def attempt(
    box: Box, place: str, folder: Path, words: Attempt, above: Sequence[str] = ()
) -> tuple[bool, str]:
    """Runs one attempt of the probe: whether it succeeded, and the output. Unless it is known to
    have failed, it counts as a success."""
    if place != "compile":
        boxed = box.to_run(PROBE) if place == "run" else box.to_run_sanitized(PROBE)
        asked = json.dumps({"watch": True, "sanitized": place == "check"})
        result = processes.run([*above, str(JUDGE), asked, *boxed, *words], WATCHING)
        answer = result.out.decode("utf-8", "replace").strip()
        could = not result.ok or answer == "answered" or answer.endswith("exited 125")
        return could, answer or result.err.strip()
    command = [*above, *box.to_build(folder, [PROBE]), str(PROBE), *words]
    result = processes.run(command, COMPILING, cwd=folder)
    stopped = result.flooded or result.too_long or result.code < 0 or result.code > 128
    answer = (result.out[:200].decode("utf-8", "replace") + result.err).strip()
    return not stopped and result.code != 3, answer or f"ended with status {result.code}"


@contextmanager
def _bait() -> Iterator[list[Protection]]:
    """Sets up bait that the probe must not reach (files, a variable, a port, an open descriptor),
    and gives the protections to test."""
    marker = secrets.token_hex(16)
    with (
        tempfile.NamedTemporaryFile("w", prefix="bounce-bait-") as file,
        tempfile.NamedTemporaryFile("w", prefix="bounce-bait-", dir=_home()) as home,
        socket.create_server(("127.0.0.1", 0)) as server,
    ):
        os.set_inheritable(file.fileno(), True)
        os.chmod(file.name, 0o644)
        os.chmod(home.name, 0o644)
        yield _protections(marker, file, home, server.getsockname()[1])


def _protections(marker: str, file: IO[str], home: IO[str], port: int) -> list[Protection]:
    hidden = [file.name, home.name, str(ROOT / "solution/src/part1_contacts.cpp"), "/etc/passwd"]
    me = os.getpid()
    clock = ~me << 3 | 2  # of its CPU time
    halves = marker[:16], marker[16:]
    return [
        Protection("sees no file of yours", [["read", path] for path in hidden]),
        Protection(
            "can't tell whether a file is there",
            [["look-by-execve", path] for path in (hidden[0], "/no/such/file")],
            RUN,
        ),
        Protection("sees no process of yours", [["read", f"/proc/{me}/environ"]]),
        Protection(
            "writes no file of yours",
            [["write", path] for path in hidden[:2]],
            outside=lambda: all(os.path.getsize(path) == 0 for path in hidden[:2]),
        ),
        Protection("writes no large file", [["fill", "65"]]),
        Protection("makes no file", [["file", "made"]], RUN),
        Protection("has none of your variables", [["environment", "BOUNCE_DOCTOR"]], canary=marker),
        # In two halves, so that the probe doesn't find its own command line.
        *(
            Protection(f"finds nothing in {what} above", [[where, *halves]], canary=marker)
            for where, what in (
                ("environments", "environments"),
                ("command-lines", "command lines"),
            )
        ),
        Protection("opens no memory of others", [["memories"]]),
        Protection("reaches no first process", [["first-process"]]),
        Protection("has none of your open files", [["descriptors", "5"]]),
        Protection(
            "reads none of its own messages",
            _calls(*(f"openat -100 /proc/self/fd/{fd} {os.O_NONBLOCK}" for fd in (1, 2))),
        ),
        Protection("connects to nothing", [["connect", str(port)]]),
        Protection("signals no process of yours", _calls(f"kill {me} 0")),
        Protection("sees no clock of your processes", _calls(f"clock_gettime {clock} BUFFER"), RUN),
        Protection(
            "can't tell whether a process is there",
            _calls(
                f"sched_getaffinity {me} 1024 BUFFER",
                f"prlimit64 {me} 7 0 BUFFER",
                "sysinfo BUFFER",
            ),
            RUN,
        ),
        Protection("sets no limits", _calls("prlimit64 0 7 BUFFER 0"), RUN),
        Protection(
            "can't tell how full a disk is", _calls("statfs / BUFFER", "fstatfs 0 BUFFER"), RUN
        ),
        # A pipe's number grows with every one that another program makes.
        Protection(
            "can't tell how many pipes there are",
            _calls("fstat 1 BUFFER", f"newfstatat 1  BUFFER {0x1000}"),
            ("run",),
        ),
        # To merge a page with others; to swap it.
        Protection(
            "gives no advice on others' memory",
            _calls("madvise BUFFER 4096 12", "madvise BUFFER 4096 21"),
            RUN,
        ),
        Protection("traces no process of yours", _calls(f"ptrace {0x4206} {me} 0 0")),
        Protection("has no privileges", [["privileges"]]),
        Protection("makes no namespaces", _calls(f"unshare {0x10000000}")),
        Protection("starts no process", [["processes", "1"]], RUN),
        Protection("starts few processes", [["processes", "200"]], ("compile",)),
        Protection(
            "leaves nothing behind", [["daemon", marker]], outside=lambda: _no_process_has(marker)
        ),
        Protection(
            "is held to its memory",
            [[f"allocate{how}", "1100"] for how in ("", "-unmapped", "-late")],
            RUN,
        ),
        Protection("is held to its memory", [["allocate", "2200"]], ("compile",)),
        Protection("is held to its CPU time", [["spin", "3"]]),
        Protection("is held to its output", [["flood", "20"]]),
    ]


def _calls(*texts: str) -> list[Attempt]:
    """Attempts to make system calls: a name, and arguments, of which BUFFER is some memory."""
    return [["call", *text.split(" ")] for text in texts]


def _home() -> str | None:
    """The user's home folder; None if it can't be written to."""
    return str(Path.home()) if os.access(Path.home(), os.W_OK) else None


def _no_process_has(marker: str) -> bool:
    """Whether, within a second, no process has this word on its command line."""
    for _ in range(20):
        if not any(marker.encode() in _command_line(p) for p in Path("/proc").glob("[0-9]*")):
            return True
        time.sleep(0.05)
    return False


def _command_line(process: Path) -> bytes:
    try:
        return (process / "cmdline").read_bytes()
    except OSError:
        return b""


def run() -> int:
    """Prints the table. Returns 0 if everything held."""
    from rich.console import Console
    from rich.table import Table

    all_findings = findings()
    boxes = list(dict.fromkeys(finding.box for finding in all_findings))
    by_place = {(f.protection, f.box): f for f in all_findings}
    table = Table(title="What holds here, tried for real")
    table.add_column("a submission …", no_wrap=True)
    for box in boxes:
        table.add_column(box.replace(" ", "\n"))
    for title in dict.fromkeys(finding.protection for finding in all_findings):
        cells = [by_place.get((title, box)) for box in boxes]
        table.add_row(title, *("" if cell is None else _word(cell) for cell in cells))
    console = Console(file=sys.stdout)
    console.print(table)
    for finding in all_findings:
        if finding.held is False:
            console.print(
                f"{finding.box}: {finding.protection}: NO: {finding.detail}", markup=False
            )
    for box, why in dict.fromkeys((f.box, f.detail) for f in all_findings if f.held is None):
        console.print(f"{box}: can't be had here: {why}", markup=False)
    console.print(f"Submissions are compiled by {compiler()}.", markup=False, soft_wrap=True)
    return int(not all(finding.held for finding in all_findings))


def _word(finding: Finding) -> str:
    return {True: "yes", False: "[bold]NO[/bold]", None: "-"}[finding.held]
