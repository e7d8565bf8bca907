"""Measures the engines that people use, and numpy, beside our methods, for `./kit study --peers`,
which installs and builds what is needed."""

import os
import sys
import tempfile
from pathlib import Path

from bounce_grader.common.errors import KitError
from bounce_grader.common.files import write_whole
from bounce_grader.common.paths import BUILD, FIXTURES, ROOT
from bounce_grader.sandbox import processes
from bounce_study import pages, tables

PROGRAM = BUILD / "bounce_peers"
SCENES = FIXTURES / "scenes"
STEPS = ROOT / "solution" / "study" / "peers" / "steps"
NUMPY = ROOT / "solution" / "study" / "peers" / "assignment_in_numpy.py"


def run(out: Path, quick: bool) -> None:
    """Writes peers.csv, with the columns of speed_accuracy.csv, the tables beside it and the page,
    all of them or none."""
    if not PROGRAM.exists():
        raise KitError("the engines are not built: run ./kit study --peers")
    print("kit: running the engines, which takes some minutes", file=sys.stderr)
    out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=".measuring-", dir=out) as name:
        folder = Path(name)
        extent = ["--quick"] if quick else []
        done = processes.run([str(PROGRAM), str(SCENES), str(STEPS), name, *extent])
        if not done.ok:
            raise KitError(f"bounce_peers failed: {done.err.strip()}")
        measured = {file.stem: tables.read(file) for file in folder.glob("peers*.csv")}
        page = pages.render(pages.PEERS_PAGE, measured)
        for table in sorted(folder.glob("peers*.csv")):
            os.replace(table, out / table.name)
    write_whole(out / pages.PEERS_PAGE, page)
