"""What hostile submissions must never do with processes and time: leave one behind, or cost more
than a part may have."""

import contextlib
import os
import secrets
import subprocess
import threading
from pathlib import Path

import pytest
from bounce_grader.common.manifest import parts
from bounce_grader.grading.grade import grade
from conftest import ROOT, points, solution_files, write
from hostile import part
from waiting import wait_for

TICKS = os.sysconf("SC_CLK_TCK")


class Watch:
    """Repeatedly counts the processes of a name and their CPU time."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.cpu: dict[str, float] = {}
        self._done = threading.Event()
        self._thread = threading.Thread(target=self._run)

    def __enter__(self) -> "Watch":
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._done.set()
        self._thread.join()

    def _run(self) -> None:
        while not self._done.wait(0.01):
            self.look()

    def look(self) -> list[str]:
        alive = []
        for folder in Path("/proc").iterdir():
            if folder.name.isdigit():
                with contextlib.suppress(OSError):
                    name, _, fields = (folder / "stat").read_text().rpartition(")")
                    if self.name in name and fields.split()[0] != "Z":
                        utime, stime = fields.split()[11:13]
                        self.cpu[folder.name] = (int(utime) + int(stime)) / TICKS
                        alive.append(folder.name)
        return alive


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
    with Watch(name) as watch:
        record = grade(tmp_path)
        seen = dict(watch.cpu)
    assert points(record) == [0, 0, 0, 0]
    assert [p["status"] for p in record["parts"]] == ["crashed"] + ["timed_out"] * 3
    assert seen, "the programs were never seen at work"
    assert watch.look() == []


def test_nothing_outlives_a_box_that_is_ended_at_once(tmp_path: Path) -> None:
    """Some fifty times, a runner sends garbage at once, so that its box may still be set up when it
    is ended."""
    name = secrets.token_hex(7)
    attack = (
        named(name, "")
        + """
    static char junk[4096];
    static const auto wrote = write(4, junk, sizeof junk);
    static const int paused = pause();
    """
    )
    write(tmp_path, {p.file: part(p.number, attack) for p in parts()})
    record = grade(tmp_path)
    assert {p["status"] for p in record["parts"]} == {"no_answer"}
    assert Watch(name).look() == []


def test_nothing_outlives_a_grader_that_is_killed(tmp_path: Path) -> None:
    """As when a student interrupts it, or a server ends it."""
    name = secrets.token_hex(7)
    write(tmp_path, {"part1_contacts.cpp": part(1, named(name, "for (;;) pause();"))})
    grader = subprocess.Popen(
        [str(ROOT / "kit"), "grade", str(tmp_path)],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
    watch = Watch(name)
    wait_for(watch.look)
    grader.kill()
    grader.wait()
    wait_for(lambda: not watch.look())


SPENDING = {
    "a loop": "for (volatile int i = 0;; i = 1 - i) {}",
    "a loop that ignores its limit": "sigset_t all; sigfillset(&all); "
    "sigprocmask(SIG_BLOCK, &all, nullptr); for (volatile int i = 0;; i = 1 - i) {}",
    "a loop that sleeps now and then": "for (;;) { const clock_t start = clock(); "
    "while (clock() - start < CLOCKS_PER_SEC / 20) {} usleep(20000); }",
    "sleep": "for (;;) pause();",
}


@pytest.mark.parametrize("way", SPENDING)
@pytest.mark.usual(2)
def test_a_part_that_hangs_costs_three_seconds_at_most(tmp_path: Path, way: str) -> None:
    """Two runners of one second of CPU time each, and a second for what ends them late. Other parts
    are asked beside it, and take hardly any."""
    name = secrets.token_hex(7)
    hanging = {"part1_contacts.cpp": part(1, named(name, SPENDING[way]))}
    write(tmp_path, {**solution_files(), **hanging})
    with Watch(name) as watch:
        record = grade(tmp_path)
    assert points(record) == [0, 30, 30, 10]
    assert record["parts"][0]["status"] == "timed_out"
    assert sum(watch.cpu.values()) < 3, watch.cpu
    assert record["seconds"]["run"] < 60, "not even on a busy machine"
