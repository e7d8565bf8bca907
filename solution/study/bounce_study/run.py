"""Measures the tables that were asked for, draws the charts and fills the pages.

Tables stay in FOLDER/.unfinished until all of them are measured, each under a name with the hash of
program, scenes and extent. So a study that was stopped goes on from the tables that still hold, and
the folder itself never shows half of a study. A study that has ended measures anew.
"""

import hashlib
import shutil
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.files import write_whole
from bounce_grader.common.paths import BUILD, FIXTURES, ROOT
from bounce_grader.sandbox import processes
from bounce_study import tables

PROGRAM, PEERS = BUILD / "bounce_study", BUILD / "bounce_peers"
SCENES = FIXTURES / "scenes"
STUDIES = ROOT / "docs" / "studies"
HANDOUT = FIXTURES / "study"  # of the committed tables, those that the handout is made of
OF_HANDOUT = ("speed_accuracy", "truth", "measured_laws", "measured_impacts", "measured_body")
MEASURED = "measured"
MEASURED_TABLES = OF_HANDOUT[2:]
QUESTIONS = tuple(
    "examples depth flat_landing almost_flat gauss_seidel solution_count energy_gain endings truth "
    "rest_and_drift slope_and_energy large_friction event_limits tolerance random_models "
    "chosen_model least_model restitution speed_accuracy".split()
)
WITH_PEERS = ("restitution", "speed_accuracy")
# The library below Siconos waits for its other threads by computing, on the core that is measured.
ONE_THREAD = ["env", "OPENBLAS_NUM_THREADS=1", "OMP_NUM_THREADS=1"]


@dataclass(frozen=True)
class Request:
    out: Path
    quick: bool = False
    peers: bool = False
    questions: tuple[str, ...] = ()
    squares: Path = FIXTURES / "measured" / "squares.csv.gz"
    ellipses: Path = FIXTURES / "measured" / "ellipses.csv"

    def file_of(self, table: str) -> Path:
        committed = self.out == STUDIES and table in OF_HANDOUT
        return (HANDOUT if committed else self.out) / f"{table}.csv"


def run(request: Request) -> int:
    known = (*QUESTIONS, MEASURED)
    asked = request.questions or known
    for name in asked:
        if name not in known:
            names = ", ".join(sorted(known))
            raise UsageError(f"there is no question {name!r}; there are {names}")
    program = PEERS if request.peers else PROGRAM
    if not program.exists():
        raise KitError(f"{program.name} is not built: run ./kit study, with --peers for engines")
    unfinished = request.out / ".unfinished"
    try:
        unfinished.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise UsageError(f"{request.out} can't be written: {error.strerror}") from error
    version, start = _version(request), time.monotonic()
    measured: dict[str, Path] = {}
    for i, name in enumerate((*asked, "charts and pages"), start=1):
        where = f"{i} of {len(asked) + 1}, {time.monotonic() - start:.0f} s"
        print(f"kit: {where}: {name}", file=sys.stderr, flush=True)
        if name == MEASURED:
            measured |= _measured(request, unfinished)
        elif name in QUESTIONS:
            measured[name] = unfinished / f"{name}-{version}.csv"
            if not measured[name].exists():
                _measure(name, request, measured[name])
    written = _publish(request, measured)
    shutil.rmtree(unfinished, ignore_errors=True)
    print(f"{request.out} holds {written}")
    return 0


def _version(request: Request) -> str:
    """Hashes all that a table depends on."""
    version = hashlib.sha256(f"{request.quick} {request.peers}".encode())
    programs = [PROGRAM, *([PEERS] if request.peers else [])]
    for file in (*programs, *sorted(SCENES.glob("*.json"))):
        version.update(file.name.encode() + b"\0" + hashlib.sha256(file.read_bytes()).digest())
    return version.hexdigest()[:16]


def _measure(name: str, request: Request, file: Path) -> None:
    """Writes a table; raises UsageError with the program's sentence where a scene is bad."""
    program = PEERS if request.peers and name in WITH_PEERS else PROGRAM
    extent = ["--quick"] if request.quick else []
    unfinished = file.with_suffix(".unfinished")
    done = processes.run([*ONE_THREAD, str(program), *extent, str(SCENES), str(unfinished), name])
    if not done.ok:
        message = done.err.strip().partition(": ")[2] or f"status {done.code}"
        raise (UsageError if done.code == 2 else KitError)(message)
    unfinished.replace(file)


def _measured(request: Request, folder: Path) -> dict[str, Path]:
    """Real impacts; quick enough to be worked out anew each time."""
    files = {name: folder / f"{name}.csv" for name in MEASURED_TABLES}
    for name, table in measured_tables(request).items():
        write_whole(files[name], table.to_csv(index=False, float_format="%.5g"))
    return files


def measured_tables(request: Request) -> tables.Tables:
    from measured import study

    return study.tables(request.squares, request.ellipses, request.quick)


def _publish(request: Request, measured: dict[str, Path]) -> str:
    """Writes the tables, and the charts and pages whose tables are all there. All are drawn
    before anything is written, and each is written whole or not at all."""
    from bounce_study import charts, pages

    older = {name: request.file_of(name) for name in (*QUESTIONS, *MEASURED_TABLES)}
    read = {name: file for name, file in older.items() if file.exists()} | measured
    known = {name: tables.read(file) for name, file in read.items()}
    try:
        drawn, filled = charts.draw(known), pages.fill(known)
    except KeyError as error:
        raise UsageError(f"a table has no {error}; measure it again") from error
    for name, file in measured.items():
        write_whole(older[name], file.read_bytes())
    made: dict[str, bytes | str] = {**drawn, **filled}
    for name, data in made.items():
        write_whole(request.out / name, data)
    return f"{len(measured)} new tables, {len(drawn)} charts, {len(filled)} pages"
