"""Measures the tables that were asked for, draws the charts and fills the pages.

Tables stay in FOLDER/.unfinished until all of them are measured, each under a name with the hash of
program, scenes and extent. So a study that was stopped goes on from the tables that still hold, and
the folder itself never shows half of a study. A study that has ended measures anew.
"""

import hashlib
import os
import shutil
import tempfile
from dataclasses import dataclass
from pathlib import Path

from bounce_grader.common.errors import KitError, UsageError
from bounce_grader.common.files import write_whole
from bounce_grader.common.paths import BUILD, FIXTURES, ROOT
from bounce_grader.sandbox import processes
from bounce_study import measured_part, peers, tables
from bounce_study.measured_part import Files
from bounce_study.progress import progress

PROGRAM = BUILD / "bounce_study"
SCENES = FIXTURES / "scenes"
STUDIES = ROOT / "docs" / "studies"  # their panel is in the README too
UNFINISHED = ".unfinished"
QUESTIONS = tuple(
    "examples bad_input depth scaling flat_landing almost_flat gauss_seidel solution_count "
    "energy_gain rest_and_drift order truth tolerance random_models chosen_model least_model speed_ratios "
    "speed_accuracy".split()
)


@dataclass(frozen=True)
class Request:
    out: Path
    quick: bool = False
    peers: bool = False
    questions: tuple[str, ...] = ()
    files: Files = Files()
    scenes: Path = SCENES


def run(request: Request) -> int:
    asked = request.questions or (*QUESTIONS, measured_part.NAME)
    for name in asked:
        if name not in (*QUESTIONS, measured_part.NAME):
            known = ", ".join(sorted((*QUESTIONS, measured_part.NAME)))
            raise UsageError(f"there is no question {name!r}; there are {known}")
    questions = [name for name in asked if name != measured_part.NAME]
    if not PROGRAM.exists():
        raise KitError("bounce_study is not built: run ./kit study")
    unfinished = request.out / UNFINISHED
    try:
        unfinished.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise UsageError(f"{request.out} can't be written: {error.strerror}") from error
    if request.peers:  # first, since the charts show them
        peers.run(request.out, request.quick)
    version = _version(request)
    measured = {name: unfinished / f"{name}-{version}.csv" for name in questions}
    with progress(len(asked) + 1) as begin:
        for name, file in measured.items():
            begin(name)
            if not file.exists():
                _measure(name, request, file)
        if measured_part.NAME in asked:
            begin(measured_part.NAME)
            measured |= measured_part.measure(unfinished, request.files, request.quick)
        begin("charts and pages")
        written = _publish(request.out, measured)
    shutil.rmtree(unfinished, ignore_errors=True)
    print(f"{request.out} holds {', '.join(written)}")
    return 0


def _version(request: Request) -> str:
    """Hashes all that a table depends on."""
    version = hashlib.sha256(b"quick" if request.quick else b"whole")
    scenes = sorted(request.scenes.glob("*.json")) if request.scenes.is_dir() else []
    for file in (PROGRAM, *scenes):
        version.update(file.name.encode() + b"\0" + hashlib.sha256(file.read_bytes()).digest())
    return version.hexdigest()[:16]


def _measure(name: str, request: Request, file: Path) -> None:
    """Writes a table; raises UsageError with the program's sentence where a scene is bad."""
    extent = ["--quick"] if request.quick else []
    with tempfile.TemporaryDirectory(prefix="measuring-", dir=file.parent) as folder:
        done = processes.run([str(PROGRAM), *extent, str(request.scenes), folder, name])
        if not done.ok:
            message = done.err.strip().removeprefix("bounce_study: ") or f"status {done.code}"
            raise (UsageError if done.code == 2 else KitError)(message)
        os.replace(Path(folder) / f"{name}.csv", file)


def _publish(out: Path, measured: dict[str, Path]) -> list[str]:
    """Writes the tables, and the charts and pages whose tables are all there. All are drawn
    before anything is written, and each is written whole or not at all."""
    from bounce_study import charts, pages

    older = [out / f"{name}.csv" for name in (*QUESTIONS, *measured_part.TABLES)]
    older += sorted(out.glob("peers*.csv"))
    known = {file.stem: tables.read(file) for file in older if file.exists()}
    known |= {name: tables.read(file) for name, file in measured.items()}
    drawn = charts.draw(known)
    filled = pages.fill(known, {file.name for file in out.glob("*.svg")} | set(drawn))
    for name, file in measured.items():
        write_whole(out / f"{name}.csv", file.read_bytes())
    for name, svg in drawn.items():
        write_whole(out / name, svg)
    for name, text in filled.items():
        write_whole(out / name, text)
    if out == STUDIES and pages.SPEED_PAGE in filled:
        readme = ROOT / "README.md"
        write_whole(readme, pages.with_panel(readme.read_text(encoding="utf-8"), known))
    return [f"{len(measured)} new tables", f"{len(drawn)} charts", f"{len(filled)} pages"]
