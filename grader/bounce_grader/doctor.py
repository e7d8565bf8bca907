"""./kit doctor: tests each protection of protections.json for real, on this machine and for this
user. A program, the probe, tries to break out of the boxes for compiling, for running, and for
running with sanitizers. A process above the box has a canary on its command line and in its
environment; the probe must not find it."""

import argparse
import json
import os
import secrets
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from functools import partial
from itertools import product
from pathlib import Path
from typing import NamedTuple

from bounce_grader.build.toolchain import COMPILE, compiler
from bounce_grader.common.escaping import terminal
from bounce_grader.common.paths import JUDGE, PROBE, ROOT
from bounce_grader.common.progress import Progress
from bounce_grader.grading.self_check import problem_of_judge
from bounce_grader.sandbox import processes
from bounce_grader.sandbox.box import FULL_OR_REDUCED, problem_of, Box

Attempt = list[str]
TABLE = Path(__file__).with_name("protections.json")
PLACES = ("compile", "run", "check")
WORDS = {True: "yes", False: "NO", None: "-"}
# A process above the box that holds the canary.
ABOVE = ["/bin/sh", "-c", 'BOUNCE_DOCTOR="$0" "$@"; status=$?; kept="$0"; exit $status']
WATCHING = processes.Limits(cpu_seconds=20, wall_seconds=90, memory=None, file_size=0)
COMPILING = COMPILE._replace(cpu_seconds=1)


class Protection(NamedTuple):
    """Something that a box promises, with the attempts that would break it."""

    title: str
    attempts: list[Attempt]  # arguments for the probe; none of these attempts may succeed
    places: tuple[str, ...] = PLACES
    outside: Callable[[], bool] | None = None  # if given, this check from outside decides
    canary: str = ""  # in a process above the box


class Finding(NamedTuple):
    """The result of one protection in one box; held is None if the box can't be made here."""

    protection: str
    box: str  # "full compile", ...
    held: bool | None
    detail: str


def findings() -> list[Finding]:
    """Every protection in every box, in the order of the table."""
    with _bait() as protections, tempfile.TemporaryDirectory(prefix="bounce-doctor-") as name:
        folder, found = Path(name), list[Finding]()
        Box("full").give(folder)
        boxes = (*product(["full"], PLACES), *product(["reduced"], PLACES[:2]))
        progress = Progress(len(boxes), "boxes tried")
        for kind, place in boxes:
            found += progress.after(list(_in_box(Box(kind), place, folder, protections)))
        return found


def _in_box(box: Box, place: str, folder: Path, protections: list[Protection]) -> Iterator[Finding]:
    """Tries the protections in one box, if it can be made and the probe starts."""
    name, problem = f"{box.kind} {place}", problem_of(box)
    if not problem and not attempt(box, place, folder, ["nothing"])[0]:
        problem = "the probe doesn't start"
    for protection in (one for one in protections if place in one.places):
        if problem:
            yield Finding(protection.title, name, None, problem)
            continue
        above = [*ABOVE, protection.canary] if protection.canary else []
        outcomes = [attempt(box, place, folder, words, above) for words in protection.attempts]
        held = not any(could for could, _ in outcomes)
        held = protection.outside() if protection.outside else held
        yield Finding(protection.title, name, held, "; ".join(answer for _, answer in outcomes))


def attempt(
    box: Box, place: str, folder: Path, words: Attempt, above: Sequence[str] = ()
) -> tuple[bool, str]:
    """Runs one attempt: whether it succeeded, and its output. It counts as a success unless it is
    known to have failed."""
    if place != "compile":
        boxed = box.to_run(PROBE, sanitized=place == "check")
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
    """Sets up bait that the probe must not reach (files, a variable, an open descriptor), and gives
    the protections to test, with the bait for words in capitals. In two halves, the probe doesn't
    find the marker on its own command line."""
    marker, process = secrets.token_hex(16), os.getpid()
    own = Path.home() if os.access(Path.home(), os.W_OK) else None
    file_in = partial(tempfile.NamedTemporaryFile, "w", prefix="bounce-bait-")
    with file_in() as file, file_in(dir=own) as home:
        names = file.name, home.name
        os.set_inheritable(file.fileno(), True)
        for name in names:
            os.chmod(name, 0o644)
        bait = {"FILE": file.name, "HOME_FILE": home.name, "PROCESS": str(process)}
        bait |= {"MARKER": marker, "HALF": marker[:16], "OTHER_HALF": marker[16:], "EMPTY": ""}
        bait["CLOCK"] = str(~process << 3 | 2)  # of this process's CPU time
        bait["ENVIRONMENT"] = f"/proc/{process}/environ"
        bait["SOLUTION"] = str(ROOT / "solution/src/part1_contacts.cpp")
        outside: dict[str, Callable[[], bool]] = {
            "both files are empty": lambda: not any(map(os.path.getsize, names)),
            "no process is left": lambda: _no_process_has(marker),
        }
        yield [
            Protection(
                row["title"],
                [[bait.get(word, word) for word in words.split()] for words in row["attempts"]],
                tuple(row.get("in", PLACES)),
                outside.get(row.get("outside", "")),
                marker if row.get("canary") else "",
            )
            for row in json.loads(TABLE.read_text("utf-8"))
        ]


def _no_process_has(marker: str) -> bool:
    """Whether, within a second, no process has this word on its command line."""
    for _ in range(20):
        lines = []
        for process in Path("/proc").glob("[0-9]*"):
            with suppress(OSError):  # it has ended
                lines.append((process / "cmdline").read_bytes())
        if not any(marker.encode() in line for line in lines):
            return True
        time.sleep(0.05)
    return False


def run(_: argparse.Namespace) -> int:
    """Prints the table, and what didn't hold. Returns 0 if everything held."""
    found = findings()
    boxes = list(dict.fromkeys(finding.box for finding in found))
    held = {(finding.protection, finding.box): WORDS[finding.held] for finding in found}
    for kinds_or_places in zip(*map(str.split, boxes)):
        print(" " * 42 + "".join(f"{word:<9}" for word in kinds_or_places))
    for title in dict.fromkeys(finding.protection for finding in found):
        print(f"{title:<42}" + "".join(f"{held.get((title, box), ''):<9}" for box in boxes))
    unsound = problem_of_judge(FULL_OR_REDUCED)
    print(f"{'a wrong program loses its points':<42}{WORDS[not unsound]}")
    lines = [f"{f.box}: {f.protection}: NO: {f.detail}" for f in found if f.held is False]
    lacking = (f for f in found if f.held is None)
    lines += dict.fromkeys(f"{f.box}: can't be had here: {f.detail}" for f in lacking)
    lines += [unsound] if unsound else []
    print("\n".join(map(terminal, [*lines, f"Submissions are compiled by {compiler()}."])))
    return int(bool(unsound) or not all(finding.held for finding in found))
