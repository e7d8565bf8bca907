"""./kit bench: measures what a grading, a class and a student's check cost, as shares of what g++ -O1
-c takes for the solution's four files in the same run, in CPU time unless it says otherwise. Seconds
can't be compared between machines, nor between two runs on one. Run it on an idle machine."""

import argparse
import os
import resource
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterator
from itertools import chain
from pathlib import Path
from statistics import mean, median

from bounce_grader.common.errors import KitError
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import CONTRACT, ROOT
from bounce_grader.grading.known_mistakes import expected

ROUNDS = 5
SOLUTION = ROOT / "solution" / "src"
GALLERY = ROOT / "tests" / "submissions"
EVERY = 3  # of the accepted ones, one in so many
PLAIN_GCC = ("g++", "-std=c++20", "-O1", "-isystem", "/usr/include/eigen3", "-I", str(CONTRACT))

# What is measured, its share, and the most that it should be.
Figures = Iterator[tuple[str, float, float]]


def run(options: argparse.Namespace) -> int:
    """Prints every figure, with a class of so many. Returns 0 if all goals are reached."""
    with tempfile.TemporaryDirectory(prefix="bounce-bench-") as name:
        to = Path(name)
        figures = chain(_one(to), _others(to), _class(to, options.submissions), _student(to))
        missed = sum(not _reached(*figure) for figure in chain(figures, _fixtures(to)))
    print(f"load of the machine: {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores")
    return int(missed > 0)


def _reached(what: str, share: float, most: float) -> bool:
    """Prints a figure, and whether it reaches its goal."""
    print(f"{what:<60}{share:8.3f}   {most:.3f}: {'yes' if share <= most else 'NO'}", flush=True)
    return share <= most


def _one(folder: Path) -> Figures:
    """The solution as a submission: new, the same again, and with one part changed."""
    shares: dict[str, list[float]] = {}
    for number in range(ROUNDS):
        submission = _variant(folder / f"one{number}", SOLUTION)
        plain = _plain(submission)

        def note(kind: str, *words: str) -> None:
            shares.setdefault(kind, []).append(_cpu(_grading(submission, *words)) / plain)

        note("fresh", "--no-sanitize")
        part = submission / parts()[number % 4].file
        part.write_text(f"// changed {number} {time.time_ns()}\n" + part.read_text())
        note("changed", "--no-sanitize")
        note("remarks")
        note("again")
    yield "./kit grade, the solution as a new submission", median(shares["fresh"]), 1 / 7
    yield "  with one part changed", median(shares["changed"]), 1 / 10
    yield "  its remarks about undefined behaviour", median(shares["remarks"]), 0.5
    yield "  the same again, with remarks", median(shares["again"]), 0.1


def _others(folder: Path) -> Figures:
    """Right programs in other styles."""
    shares = {}
    for other in sorted((GALLERY / "accepted").iterdir())[::EVERY]:
        submission = _variant(folder / other.name, SOLUTION, other)
        try:
            plain = _plain(submission)
        except KitError:  # it needs its own folders or compiler flags
            continue
        shares[other.name] = _cpu(_grading(submission, "--no-sanitize")) / plain
    slowest = max(shares, key=lambda name: shares[name])
    yield f"  the median of {len(shares)} other programs", median(shares.values()), 1 / 6
    yield f"  the worst, {slowest}", shares[slowest], 0.4


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
    plain = _plain(_variant(folder / "for-class", SOLUTION))
    yield f"./kit class, each of {size}", _cpu(command) / plain / size, 1 / 6
    yield "  the same again, each", _cpu(command) / plain / size, 1 / 100


def _student(folder: Path) -> Figures:
    """./check in a new handout as it comes, then with the parts filled in, then after a change of
    each part. At full points --hint prints the score and ends."""
    from bounce_grader.publish import handout

    handout.write(folder / "handout.zip")
    shutil.unpack_archive(folder / "handout.zip", folder)
    home = folder / handout.TOP
    check = ["sh", str(home / "check")]
    plain = _plain(_variant(folder / "for-check", SOLUTION))
    yield "a student's first ./check", _cpu(check, allowed=(0, 1)) / plain, 3.5
    shutil.copytree(SOLUTION, home / "src", dirs_exist_ok=True)
    yield "  the first with full points, with its verdict", _cpu(check) / plain, 2.5
    whole: list[float] = []
    until_score: list[float] = []  # wall-clock time
    for part in parts():
        for words in (("--hint",), ()):
            file = home / "src" / part.file
            file.write_text(file.read_text() + f"// changed {time.time_ns()}\n")
            start = time.monotonic()
            cpu = _cpu([*check, *words])
            if words:
                until_score.append(time.monotonic() - start)
            else:
                whole.append(cpu)
    plain = _plain(folder / "for-check")
    yield "  after a change of one part, the mean of four", mean(whole) / plain, 0.6
    yield "    until its score is printed, in wall-clock time", mean(until_score) / plain, 0.25


def _fixtures(folder: Path) -> Figures:
    plain = _plain(_variant(folder / "for-fixtures", SOLUTION))
    yield "./kit fixtures, once the gallery was graded", _cpu(
        [str(ROOT / "kit"), "fixtures"]
    ) / plain, 4


def _variant(folder: Path, *sources: Path) -> Path:
    """A copy of these folders over each other, with a comment in each part that no cache knows."""
    folder.mkdir()
    for source in sources:
        for file in filter(Path.is_file, source.iterdir()):
            stamp = f"// {time.time_ns()}\n".encode() if file.name.startswith("part") else b""
            (folder / file.name).write_bytes(stamp + file.read_bytes())
    return folder


def _grading(submission: Path, *words: str) -> list[str]:
    return [str(ROOT / "kit"), "grade", str(submission), "--min-score", "100", *words]


def _plain(submission: Path) -> float:
    """The plain compiler on the four files, one after the other."""
    command = [*PLAIN_GCC, "-o", str(submission.parent / "plain.o"), "-c"]
    return sum(_cpu([*command, str(submission / part.file)]) for part in parts())


def _cpu(command: list[str], allowed: tuple[int, ...] = (0,)) -> float:
    """Seconds of CPU time of a command and all that it starts."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if done.returncode not in allowed:
        last = done.stdout.decode(errors="replace").strip().rpartition("\n")[2]
        raise KitError(f"{command[0]} ended with status {done.returncode}: {last}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
