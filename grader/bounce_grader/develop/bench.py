"""./kit bench: measures what a grading costs, and compares it with goals. Run it on an idle
machine. Only the ratios within one run can be compared between machines."""

import json
import math
import statistics
import subprocess
import sys
import tempfile
import time
import zipfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from bounce_grader.common.errors import KitError
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import BUILD, CONTRACT, REFERENCE_RUNNER, ROOT

ROUNDS = 9
MANY = 100
AT_ONCE = 10
SOLUTION = ROOT / "solution" / "src"
CHECKS = ROOT / "tests" / "parts"
PLAIN_GCC = ("g++", "-std=c++20", "-O1", "-isystem", "/usr/include/eigen3", "-I", str(CONTRACT))
GRADING = "import sys; from bounce_grader.cli import main; main(sys.argv[1:])"
COMPILING = """
import sys
from pathlib import Path
from bounce_grader.build.compile import compile_all
from bounce_grader.sandbox.box import Box
from bounce_grader.submission.submission import read
compile_all(read(Path(sys.argv[1])), Path(sys.argv[2]), Box("none"), jobs=1)
"""


@dataclass(frozen=True)
class Line:
    """One measured figure, with its goal if there is one."""

    what: str
    value: float
    unit: str
    goal: str = ""
    reached: bool = True

    def __str__(self) -> str:
        verdict = f"   {self.goal}: {'yes' if self.reached else 'NO'}" if self.goal else ""
        return f"{self.what:<58}{self.value:8.2f} {self.unit:<4}{verdict}"


def run() -> int:
    subprocess.run([str(BUILD / "kit_bench"), str(REFERENCE_RUNNER)], check=True)
    print()
    from bounce_grader.develop import bench_methods as methods

    reached = True
    for line in methods.lines():
        print(line, flush=True)
        reached = reached and line.reached
    print()
    with tempfile.TemporaryDirectory(prefix="bounce-bench-") as name:
        for measure in (_one, _speed, _student, _plain, _many, _at_once, _memory):
            for line in measure(Path(name)):
                print(line, flush=True)
                reached = reached and line.reached
    return int(not reached)


def _one(folder: Path) -> list[Line]:
    """Times one submission: new, the same again, and with one part changed; and, for comparison,
    the plain compiler on its four files, one after the other."""
    fresh, again, changed, compiler = [], [], [], []
    for number in range(ROUNDS):
        submission = _variant(folder / f"one{number}", number)
        fresh.append(_seconds(_grading(submission)))
        again.append(_seconds(_grading(submission)))
        part = submission / parts()[number % 4].file
        part.write_text(f"// changed {number} {time.time_ns()}\n" + part.read_text())
        changed.append(_seconds(_grading(submission)))
        if number < 3:
            compiler.append(_compiling(submission, folder / "plain.o"))
    once, ratio = statistics.median(fresh), statistics.median(compiler) / statistics.median(fresh)
    edit = statistics.median(changed)
    return [
        Line("a new submission, ./kit grade", once, "s", "at most 0.9", once <= 0.9),
        Line("the same again", statistics.median(again), "s"),
        Line("the same with one part changed", edit, "s", "at most 0.5", edit <= 0.5),
        Line("g++ -O1 -c of its four files alone", statistics.median(compiler), "s"),
        Line("  takes as long as new gradings:", ratio, "", "at least 12", ratio >= 12),
    ]


def _speed(_: Path) -> list[Line]:
    """What --speed says of the solution beside itself."""
    from bounce_grader.grading.grade import grade, Options

    ratio = grade(SOLUTION, Options(speed=True))["speed"].get("ratio", math.inf)
    goal = "0.8 to 1.25"
    return [Line("--speed: the solution by itself", ratio, "", goal, 0.8 <= ratio <= 1.25)]


def _student(folder: Path) -> list[Line]:
    """Times ./check in a new handout as it comes, and with the parts filled in and part 2 changed.
    The time that the compiler takes for the student's own text isn't counted. The first check is
    timed twice and the shorter time counts, because the first may have to read the compiler from
    the disk."""
    from bounce_grader.publish import handout

    handout.write(folder / "handout.zip")
    first = math.inf
    for place in (folder / "one", folder / "two"):
        with zipfile.ZipFile(folder / "handout.zip") as archive:
            archive.extractall(place)
        home = place / handout.TOP
        check = ["sh", str(home / "check")]
        first = min(first, _seconds(check, allowed=(0, 1)))
    for file in SOLUTION.glob("*.cpp"):
        (home / "src" / file.name).write_text(file.read_text())
    _seconds(check)
    part = home / "src" / "part2_lcp.cpp"
    build = ["cmake", "--build", str(home / "build"), "--target", "part2_lcp"]
    compiler: list[float] = []
    whole: list[float] = []
    sanitized: list[float] = []
    for command, times in 3 * [(build, compiler), ([*check, "--hint"], whole), (check, sanitized)]:
        part.write_text(part.read_text() + "// changed\n")
        times.append(_seconds(command))
    looking = statistics.median(sanitized) - statistics.median(whole)
    alone = statistics.median(compiler)
    beyond = statistics.median(whole) - alone
    return [
        Line("a student's first check", first, "s", "at most 20", first <= 20),
        Line("a change of part 2: compiling it", alone, "s"),
        Line("  and the rest of its check", beyond, "s", "at most 1", beyond <= 1),
        Line("  and, at full points, its sanitizers", looking, "s", "at most 8", looking <= 8),
    ]


def _many(folder: Path) -> list[Line]:
    """Grades different submissions, one after the other."""
    start = time.monotonic()
    for number in range(MANY):
        _seconds(_grading(_variant(folder / f"many{number}", number)))
    rate = 60 * MANY / (time.monotonic() - start)
    return [Line(f"{MANY} different ones in a row", rate, "/min", "at least 120", rate >= 120)]


def _at_once(folder: Path) -> list[Line]:
    """Compares the scores of concurrent gradings with those of single ones: they must be the same,
    because the limits count CPU time."""
    submissions = sorted((ROOT / "tests" / "submissions" / "mistakes").iterdir())[::8][:AT_ONCE]
    alone = [_score(_mistaken(folder / f"alone{n}", s, n)) for n, s in enumerate(submissions)]
    with ThreadPoolExecutor(AT_ONCE) as pool:
        variants = [_mistaken(folder / f"beside{n}", s, n) for n, s in enumerate(submissions)]
        together = list(pool.map(_score, variants))
    same = sum(a == b for a, b in zip(alone, together))
    goal = f"all {len(alone)} the same"
    return [Line(f"{AT_ONCE} at once: scores as one at a time", same, "", goal, alone == together)]


def _plain(folder: Path) -> list[Line]:
    """Times the usual way: compile the submission, link it with the tests and GoogleTest, and run
    it."""
    submission, program = _variant(folder / "plain", 0), folder / "program"
    # Without the given parts, which would be there twice.
    linked = {*(CHECKS / "linked").glob("*.cpp")} - {*(CHECKS / "linked").glob("before_*.cpp")}
    command = [
        *PLAIN_GCC,
        f'-DBOUNCE_FIXTURES="{ROOT / "fixtures" / "public"}"',
        *map(str, (*CHECKS.glob("*.cpp"), *linked)),
        *(str(submission / part.file) for part in parts()),
        str(ROOT / "student" / "given" / "solve_lcp.cpp"),
        *("-lgtest", "-lpthread", "-o", str(program)),
    ]
    seconds = _seconds(command) + _seconds([str(program)])
    return [Line("the plain way: g++ and GoogleTest, linked with it", seconds, "s")]


def _memory(folder: Path) -> list[Line]:
    """Peak memory of the grader itself; and of the compiler, run without a box, which would hide
    it."""
    submission = _variant(folder / "memory", 0)
    own = _largest("SELF", GRADING, "grade", str(submission), "--json", "/dev/null")
    submission = _variant(folder / "compiled", 1)
    compiler = _largest("CHILDREN", COMPILING, str(submission), str(folder / "objects"))
    return [
        Line("the grader itself", own, "MB", "below 100", own < 100),
        Line("the compiler, the largest process that it starts", compiler, "MB"),
    ]


def _largest(whose: str, program: str, *words: str) -> float:
    """The peak memory, in MB, of a Python program with these arguments, or of its largest child."""
    report = f"import resource; print(resource.getrusage(resource.RUSAGE_{whose}).ru_maxrss)"
    command = [sys.executable, "-c", f"{program}\n{report}", *words]
    folder = ROOT / "grader"  # where the package is
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True)
    return int(done.stdout.splitlines()[-1]) / 1024


def _variant(folder: Path, number: int) -> Path:
    """A copy of the solution with a new comment in each part, so that no object is in the cache."""
    folder.mkdir()
    for file in SOLUTION.glob("*.cpp"):
        stamp = f"// {time.time_ns()} {number}\n"
        (folder / file.name).write_text(stamp + file.read_text())
    return folder


def _mistaken(folder: Path, mistake: Path, number: int) -> Path:
    _variant(folder, number)
    for file in mistake.glob("*.cpp"):
        stamp = f"// {time.time_ns()} {number}\n".encode()
        (folder / file.name).write_bytes(stamp + file.read_bytes())
    return folder


def _grading(submission: Path) -> list[str]:
    return [str(ROOT / "kit"), "grade", str(submission), "--no-sanitize", "--min-score", "100"]


def _score(submission: Path) -> float:
    command = [str(ROOT / "kit"), "grade", str(submission), "--no-sanitize", "--json", "-"]
    done = subprocess.run(command, stdout=subprocess.PIPE, check=True)
    return float(json.loads(done.stdout)["score"])


def _compiling(submission: Path, to: Path) -> float:
    return sum(
        _seconds([*PLAIN_GCC, "-c", str(submission / part.file), "-o", str(to)]) for part in parts()
    )


def _seconds(command: list[str], allowed: tuple[int, ...] = (0,)) -> float:
    start = time.monotonic()
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if done.returncode not in allowed:
        print(done.stdout.decode(), file=sys.stderr)
        raise KitError(f"{command[0]} ended with status {done.returncode}")
    return time.monotonic() - start
