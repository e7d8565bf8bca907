"""Grades submissions that attack, as a user would, and says which promise a grading broke.

Each has a secret of its own: in the environment, on command lines, in the home folder, beside the
hidden fixtures, and in the name of the temporary folder. No output of a grading may contain it.
"""

import contextlib
import csv
import ctypes
import hashlib
import io
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

from bounce_grader import formats
from bounce_grader.common.manifest import parts
from bounce_grader.common.paths import CACHE, ROOT
from bounce_grader.formats import classroom50
from bounce_grader.grading import fixtures
from fuzzing.attacks import Attack, some_attack

CPU_SECONDS = 60  # for a grading, whatever is in it
WALL_SECONDS = 120
ATTEMPTS = 3  # while the kit says that the machine is too busy
STUDENTS = 4  # of a class, at most
INPUTS = ROOT / "build" / "fuzz" / "inputs"
GRACE = 5.0  # s, for processes that are about to end
START = "import sys; sys.path.insert(0, sys.argv.pop(1))\n"
WITH_A_BOX = "from bounce_grader.sandbox import box; box.kinds = lambda trust: ({!r},)\n"
MAIN = "import bounce_grader.__main__\n"
SUBREAPER = 36  # of prctl(2)
FULL = {part.number: part.points for part in parts()}


@dataclass(frozen=True)
class World:
    """The folder of one grading, and what is secret in it."""

    folder: Path
    mark: str
    secrets: list[Path]

    @property
    def temporary(self) -> Path:
        """The temporary folder. Its name is a secret, but a cached object may hold it in debug
        information."""
        return self.folder / f"t{self.mark[::-1]}"

    @property
    def submission(self) -> Path:
        return self.folder / "submission"

    @property
    def record(self) -> Path:
        return self.folder / "record.json"


@dataclass(frozen=True)
class Done:
    """The outcome of one run of the kit."""

    code: int
    too_long: bool
    cpu_seconds: float
    out: bytes
    err: bytes
    kept: list[Path]  # objects that are new


def main(count: int, first: int, box: str) -> int:
    """The exit status. Seeds first, first + 1, ..., two at a time."""
    start, graded, broken = time.monotonic(), 0, 0
    with ProcessPoolExecutor(2) as pool:
        for seed, (was_graded, problems) in enumerate(
            pool.map(partial(attacked, box=box), range(first, first + count)), first
        ):
            graded, broken = graded + was_graded, broken + bool(problems)
            for problem in problems:
                print(f"   attacks {seed}: {problem}", flush=True)
    seconds = time.monotonic() - start
    print(
        f"   attacks: {count} submissions from {first} on, {graded / count:.0%} of them graded, "
        f"in {seconds:.0f} s"
    )
    if graded < 0.5 * count:
        print("   attacks: too few were graded for this to show anything")
    return int(broken > 0 or graded < 0.5 * count)


def attacked(seed: int, box: str) -> tuple[bool, list[str]]:
    """Whether the submission was graded, and the promises that this broke."""
    ctypes.CDLL(None).prctl(SUBREAPER, 1)  # what is left behind becomes a child of this process
    with _world(seed) as world:
        attack = some_attack(random.Random(f"attacks {seed}"), list(map(str, world.secrets)))
        _lay_out(attack, world.submission)
        gradings = STUDENTS if attack.is_class else 1
        command = _command(attack, world, seed, box)
        done = _run_again_if_busy(command, world, gradings * WALL_SECONDS)
        problems = [*_of_the_run(done, attack, gradings), *_left_behind(world)]
        if not problems:
            problems = _of_points(done, attack, world, box)
        problems += _of_secrets(done, world)
        if problems:
            _keep(world.submission, seed, problems)
        return done.code in (0, 1), problems


@contextlib.contextmanager
def _world(seed: int) -> Iterator[World]:
    """In a folder of the seed's own, so that a submission that names it is the same each time."""
    folder = INPUTS.parent / "w" / str(seed)
    shutil.rmtree(folder, ignore_errors=True)
    mark = hashlib.sha256(f"the secret of {seed}".encode()).hexdigest()[:32]
    secrets = [
        folder / "home" / ".bash_history",
        fixtures.hidden_folder() / f"canary-{seed}.txt",
    ]
    world = World(folder, mark, secrets)
    for made in (folder / "home", world.temporary):
        made.mkdir(parents=True)
    for file in secrets:
        file.write_text(f'"{mark}"\n')
    try:
        yield world
    finally:
        secrets[1].unlink(missing_ok=True)
        shutil.rmtree(folder, ignore_errors=True)


def _lay_out(attack: Attack, path: Path) -> None:
    if attack.archive:
        path.write_bytes(attack.archive)
        return
    path.mkdir()
    for name, text in attack.files.items():
        file = path / name
        with contextlib.suppress(OSError):  # there can't be such a name
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_bytes(text)


# --- running ---


def _command(attack: Attack, world: World, seed: int, box: str) -> list[str]:
    """Runs the kit below a waiting shell that has the secret on its command line."""
    start = START + WITH_A_BOX.format(box) + MAIN
    kit = ["/usr/bin/python3", "-IS", "-c", start, str(ROOT / "grader")]
    shell = ["/bin/sh", "-c", 'shift; "$@"; exit $?', "sh", world.mark, *kit]
    if attack.is_class:
        return [*shell, "class", str(world.submission), "--out", str(world.folder / "out")]
    rng = random.Random(f"options {seed}")
    command = [*shell, "grade", str(world.submission), "--json", str(world.record)]
    if rng.random() < 0.5:
        command += ["--format", rng.choice(formats.NAMES)]
    more: list[list[str]] = [[], [], [], ["--min-score", "50"], ["--reveal"]]
    return command + rng.choice(more)


def _run_again_if_busy(command: list[str], world: World, seconds: float) -> Done:
    """Runs the kit again where it says that the machine was too busy: other programs may make that
    true now and then, a submission may not make it true each time."""
    kept: list[Path] = []
    for _ in range(ATTEMPTS):
        done = _run(command, world, seconds)
        kept += done.kept
        if done.code != 3 or b"the machine was too busy" not in done.err:
            break
    return replace(done, kept=kept)


def _run(command: list[str], world: World, seconds: float) -> Done:
    secret = {"BOUNCE_CANARY": world.mark}  # the first of all
    environment = secret | {"PATH": os.environ["PATH"], "HOME": str(world.folder / "home")}
    environment |= {"TMPDIR": str(world.temporary), "LANG": "C.UTF-8"}
    before, used = set(CACHE.rglob("*")), _cpu_seconds()
    out, err = world.folder / "out.txt", world.folder / "err.txt"
    with out.open("wb") as to_out, err.open("wb") as to_err:
        process = subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=to_out,
            stderr=to_err,
            env=environment,
            start_new_session=True,
        )
        too_long = False
        try:
            process.wait(seconds)
        except subprocess.TimeoutExpired:
            too_long = True
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
    kept = [path for path in CACHE.rglob("*") if path not in before and path.is_file()]
    spent = _cpu_seconds() - used
    return Done(process.returncode, too_long, spent, out.read_bytes(), err.read_bytes(), kept)


def _cpu_seconds() -> float:
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


# --- promises ---


def _of_the_run(done: Done, attack: Attack, gradings: int) -> list[str]:
    said = (done.out + done.err).decode("utf-8", "replace")
    wrong = []
    if done.too_long:
        wrong.append(f"it took more than {WALL_SECONDS * gradings} s")
    elif done.code not in ((0,) if attack.is_class else (0, 1, 2)):
        wrong.append(f"exit status {done.code}: {said[-300:]!r}")
    if done.cpu_seconds > CPU_SECONDS * gradings:
        wrong.append(f"{done.cpu_seconds:.0f} s of CPU time")
    if "Traceback (most recent call last)" in said:
        wrong.append(f"a traceback: {said[-600:]!r}")
    return wrong


def _left_behind(world: World) -> list[str]:
    """Processes, and files in the temporary folder."""
    end = time.monotonic() + GRACE
    while (alive := _children()) and time.monotonic() < end:
        time.sleep(0.05)
    for process in alive:
        with contextlib.suppress(OSError):
            os.kill(process, signal.SIGKILL)
    wrong = [f"{len(alive)} processes are left behind"] if alive else []
    files = [path.name for path in world.temporary.iterdir()]
    return [*wrong, f"left in the temporary folder: {files[:3]}"] if files else wrong


def _children() -> list[int]:
    """The children of this process that haven't ended."""
    with contextlib.suppress(ChildProcessError):
        while os.waitpid(-1, os.WNOHANG)[0]:
            pass
    return list(map(int, Path(f"/proc/self/task/{os.getpid()}/children").read_text().split()))


def _of_points(done: Done, attack: Attack, world: World, box: str) -> list[str]:
    if attack.is_class:
        return _of_the_class(attack, world)
    if done.code == 2:
        return []
    record = json.loads(world.record.read_text())
    wrong = [] if record["box"] == box else [f"it was graded in another box: {record['box']}"]
    return wrong + [
        f"part {part['part']} is honest, and has {part['score']:g} points: {part['message'][:200]}"
        for part in record["parts"]
        if part["part"] in attack.honest_parts and part["score"] != FULL[part["part"]]
    ]


def _of_the_class(attack: Attack, world: World) -> list[str]:
    text = (world.folder / "out" / "grades.csv").read_text("utf-8-sig")
    rows = list(csv.DictReader(io.StringIO(text, newline="")))
    got = {row["id"]: row["score"] for row in rows}
    return [
        f"student {user} is honest, and has {got.get(str(user), 'no')} points"
        for user in sorted(attack.honest_users)
        if got.get(str(user)) != f"{sum(FULL.values()):g}"
    ]


def _of_secrets(done: Done, world: World) -> list[str]:
    texts = {"standard output": done.out, "standard error": done.err}
    out = world.folder / "out"
    if out.is_dir():
        texts |= {str(path.relative_to(out)): _bytes(path) for path in out.rglob("*")}
    if world.record.exists():
        texts["the record"] = _bytes(world.record)
        record = json.loads(texts["the record"])
        texts |= {name: _rendered(name, record, world.submission) for name in formats.NAMES}
    mark = world.mark.encode()
    wrong = [f"the secret is in {w}" for w, text in texts.items() if mark in text]
    place = world.temporary.name.encode()
    wrong += [
        f"the name of the temporary folder is in {w}" for w, text in texts.items() if place in text
    ]
    kept = [path for path in done.kept if mark in _bytes(path)]
    for path in kept:
        path.unlink(missing_ok=True)
    return [*wrong, *(f"the secret is in the kept object {path.name}" for path in kept)]


def _rendered(name: str, record: dict[str, Any], submission: Path) -> bytes:
    os.environ.update(dict.fromkeys(classroom50.FIELDS.values(), "set by its runner"))
    return formats.render(name, record, submission).encode()


def _bytes(path: Path) -> bytes:
    return path.read_bytes() if path.is_file() else b""


def _keep(submission: Path, seed: int, problems: list[str]) -> None:
    folder = INPUTS / f"attacks-{seed}"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    if submission.is_dir():
        shutil.copytree(submission, folder / "submission")
    else:
        shutil.copy(submission, folder / "submission")
    again = f"PYTHONPATH=grader:tests/kit/support {sys.executable} -m fuzzing attacks 1 {seed}\n"
    (folder / "why.txt").write_text("\n".join([*problems, again]))
