"""./kit bench: measures what a grading, a class and a student's check cost, and compares it with
goals. Run it on an idle machine. Only ratios within one run can be compared between machines: a goal
in seconds is that of a machine on which g++ takes PACE for the solution, and is scaled to this one."""

import argparse
import math
import os
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterator
from itertools import chain
from pathlib import Path
from statistics import median

from bounce_grader.common.errors import KitError
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import CONTRACT, ROOT
from bounce_grader.grading.known_mistakes import expected

ROUNDS = 9
SOLUTION = ROOT / "solution" / "src"
GALLERY = ROOT / "tests" / "submissions"
PACE = 6.0  # s, of g++ -O1 -c for the four files
EVERY = 3  # of the accepted ones, one in so many
PLAIN_GCC = ("g++", "-std=c++20", "-O1", "-isystem", "/usr/include/eigen3", "-I", str(CONTRACT))


# What is measured, its value and unit; and its goal if there is one, from the least to the most.
Figures = Iterator[tuple[str, float, str] | tuple[str, float, str, float, float]]


def run(options: argparse.Namespace) -> int:
    """Prints every figure, with a class of so many. Returns 0 if all goals are reached."""
    with tempfile.TemporaryDirectory(prefix="bounce-bench-") as name:
        to, size = Path(name), options.submissions
        figures = chain(_one(to), _others(to), _class(to, size), _student(to))
        missed = sum(not _reached(*figure) for figure in figures)
    print(f"load of the machine: {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores")
    return int(missed > 0)


def _reached(
    what: str, value: float, unit: str, least: float = -math.inf, most: float = math.inf
) -> bool:
    """Prints a figure, and whether it reaches its goal."""
    reached = least <= value <= most
    goal = f"   from {least:.3g} to {most:.3g}: {'yes' if reached else 'NO'}"
    has_goal = (least, most) != (-math.inf, math.inf)
    print(f"{what:<58}{value:8.2f} {unit:<4}{goal if has_goal else ''}", flush=True)
    return reached


def _one(folder: Path) -> Figures:
    """Times the solution: new, the same again, and with one part changed."""
    fresh, again, changed, compiler = [], [], [], []
    for number in range(ROUNDS):
        submission = _variant(folder / f"one{number}", SOLUTION)
        fresh.append(_seconds(_grading(submission)))
        again.append(_seconds(_grading(submission)))
        part = submission / parts()[number % 4].file
        part.write_text(f"// changed {number} {time.time_ns()}\n" + part.read_text())
        changed.append(_seconds(_grading(submission)))
        if number < 3:
            compiler.append(_compiling(submission))
    yield "the solution as a new submission, ./kit grade", median(fresh), "s"
    yield "the same again", median(again), "s"
    yield "the same with one part changed", median(changed), "s"
    yield "g++ -O1 -c of its four files alone", median(compiler), "s"
    yield "  as new gradings", median(compiler) / median(fresh), "", 12, math.inf


def _others(folder: Path) -> Figures:
    """Right programs in other styles: g++ -O1 -c of the four files, in times of a new grading."""
    ratios = {}
    for other in sorted((GALLERY / "accepted").iterdir())[::EVERY]:
        submission = _variant(folder / other.name, SOLUTION, other)
        try:
            plain = _compiling(submission)
        except KitError:  # it needs its own folders or compiler flags
            continue
        ratios[other.name] = plain / _seconds(_grading(submission))
    slowest = min(ratios, key=lambda name: ratios[name])
    yield f"  the median of {len(ratios)} other programs", median(ratios.values()), "", 9, math.inf
    yield f"  the worst, {slowest}", ratios[slowest], "", 3, math.inf


def _class(folder: Path, size: int) -> Figures:
    """A class of the gallery's submissions, from nothing and then again."""
    kinds = ("accepted", "mistakes")
    every = [one for kind in kinds for one in sorted((GALLERY / kind).iterdir()) if one.is_dir()]
    (folder / "class").mkdir()
    for number in range(size):
        one = every[7 * number % len(every)]
        below = () if expected(one).get("alone") else (SOLUTION,)
        _variant(folder / "class" / str(number), *below, one)
    command = [str(ROOT / "kit"), "class", str(folder / "class"), "--out", str(folder / "out")]
    rate = 60 * size / _seconds(command)
    yield f"a class of {size}", rate, "/min", 120 / _slower(folder), math.inf
    yield "  the same again", _seconds(command), "s"


def _student(folder: Path) -> Figures:
    """Times ./check in a new handout as it comes, and with the parts filled in and part 2 changed.
    The time that the compiler takes for the student's own text isn't counted. The first check is
    timed twice, and the shorter time counts: the compiler may have to come from the disk."""
    from bounce_grader.publish import handout

    handout.write(folder / "handout.zip")
    first: list[float] = []
    for place in (folder / "one", folder / "two"):
        shutil.unpack_archive(folder / "handout.zip", place)
        home = place / handout.TOP
        check = ["sh", str(home / "check")]
        first.append(_seconds(check, allowed=(0, 1)))
    shutil.copytree(SOLUTION, home / "src", dirs_exist_ok=True)
    _seconds(check)
    part = home / "src" / "part2_lcp.cpp"
    build = ["cmake", "--build", str(home / "build"), "--target", "part2_lcp"]
    kinds = {"compiler": build, "whole": [*check, "--hint"], "sanitized": check}
    times: dict[str, list[float]] = {kind: [] for kind in kinds}
    for kind, command in 3 * list(kinds.items()):
        part.write_text(part.read_text() + "// changed\n")
        times[kind].append(_seconds(command))
    alone, hinted, sanitized = (median(times[kind]) for kind in kinds)
    slower = _slower(folder)
    yield "a student's first check", min(first), "s", 0, 20 * slower
    yield "a change of part 2: compiling it", alone, "s"
    yield "  and the rest of its check", hinted - alone, "s", 0, slower
    yield "  and, at full points, its sanitizers", sanitized - hinted, "s", 0, 8 * slower


def _variant(folder: Path, *sources: Path) -> Path:
    """A copy of these folders over each other, with a comment in each part that no cache knows."""
    folder.mkdir()
    for source in sources:
        for file in filter(Path.is_file, source.iterdir()):
            stamp = f"// {time.time_ns()}\n".encode() if file.name.startswith("part") else b""
            (folder / file.name).write_bytes(stamp + file.read_bytes())
    return folder


def _grading(submission: Path) -> list[str]:
    return [str(ROOT / "kit"), "grade", str(submission), "--no-sanitize", "--min-score", "100"]


def _compiling(submission: Path) -> float:
    """The plain compiler on the four files, one after the other."""
    command = [*PLAIN_GCC, "-o", str(submission.parent / "plain.o"), "-c"]
    return sum(_seconds([*command, str(submission / part.file)]) for part in parts())


def _slower(folder: Path) -> float:
    """How many times as long as on the goals' machine everything takes here, just now."""
    return _compiling(_variant(folder / f"pace{time.time_ns()}", SOLUTION)) / PACE


def _seconds(command: list[str], allowed: tuple[int, ...] = (0,)) -> float:
    start = time.monotonic()
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if done.returncode not in allowed:
        last = done.stdout.decode(errors="replace").strip().rpartition("\n")[2]
        raise KitError(f"{command[0]} ended with status {done.returncode}: {last}")
    return time.monotonic() - start
