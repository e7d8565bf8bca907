"""The boxes keep their promises; and without a box, the probe's attempts succeed."""

import errno
import json
import os
import subprocess
import sys
from argparse import Namespace
from pathlib import Path

import pytest
from bounce_grader.common.errors import KitError
from bounce_grader.common.paths import PROBE, RUNNER
from bounce_grader import doctor
from bounce_grader.grading.grade import grade, Options
from bounce_grader.sandbox import box as boxes, processes
from bounce_grader.sandbox.box import Box
from conftest import Patch, Printed, ROOT, write

# What the probe can do without a box, where its attempt would go beyond a compiler's limits.
WITHIN_LIMITS = {"fill": ["1"], "environment": ["PATH"], "descriptors": ["0"]}
WITHIN_LIMITS |= {f"allocate{how}": ["100"] for how in ("", "-late")}
WITHIN_LIMITS |= {"spin": ["0"], "flood": ["0"]}
FOR_ROOT = ("others", "privileges")


def test_without_a_box_the_probe_can_do_it(tmp_path: Path) -> None:
    """Otherwise a failed attempt in a box would prove nothing."""
    with doctor._bait() as protections:
        for protection in protections:
            above = [*doctor.ABOVE, protection.canary]
            for name, *words in protection.attempts:
                attempt = [name, *WITHIN_LIMITS.get(name, words)]
                could, said = doctor.attempt(Box("none"), "compile", tmp_path, attempt, above)
                can = could and name in said
                assert can or os.geteuid() != 0 and name in FOR_ROOT, (name, said)


def test_the_doctor_finds_that_everything_holds() -> None:
    found = doctor.findings()
    assert len(found) >= 100
    assert not [f for f in found if not f.held]


ORDINARY = ["/usr/bin/setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"]


@pytest.mark.long
def test_it_holds_for_an_ordinary_user_too() -> None:
    if os.geteuid() != 0:
        pytest.skip("only root can become somebody else; the other test is an ordinary user's")
    if any(not folder.stat().st_mode & 0o001 for folder in ROOT.parents):
        pytest.skip("the kit lies where others can't go")
    done = subprocess.run(
        [*ORDINARY, sys.executable, "-m", "bounce_grader", "doctor"],
        env={"PATH": "/usr/bin", "HOME": "/nonexistent", "PYTHONPATH": str(ROOT / "grader")},
        capture_output=True,
        text=True,
        check=False,
    )
    protections = done.stdout.partition("a wrong program")[0]  # for that, root's cache isn't theirs
    assert protections and "NO" not in protections, done.stdout + done.stderr


def test_a_failed_protection_is_said(monkeypatch: Patch, capsys: Printed, tmp_path: Path) -> None:
    failing = {"title": "says nothing", "attempts": ["flood 0"], "in": ["compile"]}
    (tmp_path / "protections.json").write_text(json.dumps([failing]))
    monkeypatch.setattr(doctor, "TABLE", tmp_path / "protections.json")
    assert doctor.run(Namespace()) == 1
    assert "full compile: says nothing: NO: could: flood" in capsys.readouterr().out


def test_the_first_box_that_holds_is_taken(monkeypatch: Patch) -> None:
    problems = {"full": "it has no floor", "reduced": None}
    monkeypatch.setattr(boxes, "problem_of", lambda box: problems[box.kind])
    assert boxes.choose.__wrapped__().kind == "reduced"
    problems["reduced"] = "it has no walls"
    with pytest.raises(KitError, match="full: it has no floor; reduced: it has no walls"):
        boxes.choose.__wrapped__()


def test_a_box_that_stops_holding_is_the_kits_fault(monkeypatch: Patch, tmp_path: Path) -> None:
    """Nobody gets a zero because a box stopped working."""
    boxes.choose(("reduced",))
    wrong = write(tmp_path, {"part1_contacts.cpp": b"this is no C++"})
    monkeypatch.setattr(boxes, "problem_of", lambda box: "it has lost its floor")
    with pytest.raises(KitError, match="it has lost its floor"):
        grade(wrong, Options(boxes=("reduced",)))


# An ordinary user who may make no user namespaces, as on some clusters, and has other programs.
CROWDED = """
echo 0 >/proc/sys/user/max_user_namespaces
for i in $(seq 150); do sleep 60 & done
"$@" 2>&1 | cat  # a pipe of its own
kill $(jobs -p)
"""


@pytest.mark.parametrize("number, could", [("3", True), ("800", False)])
@pytest.mark.parametrize("place", ["build", "run"])
def test_no_box_takes_threads_from_another(place: str, number: str, could: bool) -> None:
    """Neither that user's other programs, nor a box that starts as many as it can."""
    box = Box("reduced")
    to_build = [*box.to_build(RUNNER, [PROBE]), str(PROBE), "processes", number]
    boxed = to_build if place == "build" else [*box.to_run(PROBE), "threads", number]
    inside = ["/usr/bin/unshare", "--map-user=1000", "--keep-caps", "/bin/bash", "-c", CROWDED]
    command = [*(ORDINARY if os.geteuid() == 0 else []), *inside, "-", *boxed]
    said = processes.run(command).out.decode()
    assert ("could: " in said) == could and "could" in said, said


@pytest.mark.parametrize("kind", ["full", "reduced", "none"])
def test_a_file_that_fills_the_disk_is_the_kits_fault(kind: str, monkeypatch: Patch) -> None:
    monkeypatch.setattr(os, "fchmod", lambda *_: None)  # of the device below
    copy = ["/usr/bin/cp", "graded_flags.txt", "OUTPUT"]
    command = [*Box(kind).to_build(RUNNER, [], ("cp",)), *copy]
    with pytest.raises(OSError) as full:
        processes.run(command, output=Path("/dev/full"))
    assert full.value.errno == errno.ENOSPC
