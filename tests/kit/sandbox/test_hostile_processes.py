"""What hostile submissions must never do with processes and time: leave one behind, or cost more
than a part may have."""

import contextlib
import os
import secrets
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest
from bounce_grader.common.manifest import parts
from bounce_grader.grading.grade import grade
from conftest import ROOT, points, solution_files, write
from hostile import part
from waiting import wait_for

TICKS = os.sysconf("SC_CLK_TCK")


def alive(name: str) -> dict[str, float]:
    """The processes with a name, or of a file with it, and their CPU time."""
    found = {}
    for folder in Path("/proc").glob("[0-9]*"):
        with contextlib.suppress(OSError):
            its_name, _, fields = (folder / "stat").read_text().rpartition(")")
            named = name in its_name or name.encode() in (folder / "cmdline").read_bytes()
            if named and fields.split()[0] != "Z":
                found[folder.name] = sum(map(int, fields.split()[11:13])) / TICKS
    return found


@contextlib.contextmanager
def watched(name: str) -> Iterator[dict[str, float]]:
    """The most CPU time that was seen of each process of a name."""
    seen: dict[str, float] = {}
    done = threading.Event()

    def watch() -> None:
        while not done.wait(0.01):
            seen.update(alive(name))

    thread = threading.Thread(target=watch)
    thread.start()
    try:
        yield seen
    finally:
        done.set()
        thread.join()


def named(name: str, attack: str) -> str:
    """The program takes a name that can be found, before main."""
    return (
        "#include <csignal>\n#include <ctime>\n#include <sys/prctl.h>\n#include <unistd.h>\n"
        f'static const int name_taken = prctl(PR_SET_NAME, "{name}");\n'
        f"static void attack() {{ {attack} }}"
    )


def test_nothing_outlives_its_box(tmp_path: Path) -> None:
    name = secrets.token_hex(7)
    attacks = [
        "if (fork() == 0) { setsid(); if (fork() == 0) for (;;) sleep(1); _exit(0); }",
        "for (;;) pause();",
        "raise(SIGSTOP);",
        "signal(SIGTERM, SIG_IGN); prctl(PR_SET_PDEATHSIG, 0); for (;;) sleep(1);",
    ]
    files = {p.file: part(p.number, named(name, a)) for p, a in zip(parts(), attacks)}
    write(tmp_path, files)
    with watched(name) as seen:
        record = grade(tmp_path)
    assert points(record) == [0, 0, 0, 0]
    assert [p["status"] for p in record["parts"]] == ["crashed"] + ["timed_out"] * 3
    assert seen, "the programs were never seen at work"
    assert not alive(name)


def test_nothing_outlives_a_box_that_is_ended_at_once(tmp_path: Path) -> None:
    """Some fifty times, a runner sends garbage at once, so that its box may still be set up when it
    is ended."""
    name = secrets.token_hex(7)
    attack = named(name, "") + (
        "static char junk[4096]; static const auto wrote = write(4, junk, sizeof junk);"
        "static const int paused = pause();"
    )
    write(tmp_path, {p.file: part(p.number, attack) for p in parts()})
    record = grade(tmp_path)
    assert {p["status"] for p in record["parts"]} == {"no_answer"}
    assert not alive(name)


GRADES = """
import sys
from pathlib import Path
from bounce_grader.grading.grade import grade, Options
grade(Path(sys.argv[1]), Options(boxes=(sys.argv[2],)))
"""
ENDLESS = b"constexpr long count() { long n = 0; while (n >= 0) n = (n + 1) % 1000; return n; }"
SOON = 10  # s: less than an endless compiler would take by itself


@pytest.mark.parametrize("kind", ["full", "reduced"])
@pytest.mark.parametrize("busy", ["program", "compiler"])
def test_nothing_outlives_a_grader_that_is_killed(tmp_path: Path, busy: str, kind: str) -> None:
    """As when a student interrupts it, or a server ends it."""
    name = secrets.token_hex(7)
    files = {"part1_contacts.cpp": part(1, named(name, "for (;;) pause();"))}
    if busy == "compiler":
        files = {f"{name}.cpp": ENDLESS + b"constexpr long counted = count();\n"}
    before = set(Path("/tmp").glob("bounce-box-*"))
    grader = subprocess.Popen(
        [sys.executable, "-c", GRADES, str(write(tmp_path, files)), kind],
        env={"PYTHONPATH": str(ROOT / "grader")},
        stderr=subprocess.DEVNULL,
    )
    wait_for(lambda: alive(name))
    grader.kill()
    grader.wait()
    wait_for(lambda: not alive(name), SOON)
    wait_for(lambda: set(Path("/tmp").glob("bounce-box-*")) <= before, SOON)


SPENDING = {
    "a loop that ignores its limit": "sigset_t all; sigfillset(&all); "
    "sigprocmask(SIG_BLOCK, &all, nullptr); for (volatile int i = 0;; i = 1 - i) {}",
    "a loop that sleeps now and then": "for (;;) { const clock_t start = clock(); "
    "while (clock() - start < CLOCKS_PER_SEC / 20) {} usleep(20000); }",
}


@pytest.mark.parametrize("way", SPENDING)
def test_a_part_that_hangs_costs_three_seconds_at_most(tmp_path: Path, way: str) -> None:
    """Two runners of one second of CPU time each, and a second for what ends them late. Other parts
    are asked beside it, and take hardly any."""
    name = secrets.token_hex(7)
    hanging = {"part1_contacts.cpp": part(1, named(name, SPENDING[way]))}
    write(tmp_path, {**solution_files(), **hanging})
    with watched(name) as seen:
        record = grade(tmp_path)
    assert points(record) == [0, 30, 30, 10]
    assert record["parts"][0]["status"] == "timed_out"
    assert sum(seen.values()) < 3, seen
