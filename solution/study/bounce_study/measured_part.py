"""The question `measured`: real impacts and drops, for `./kit study measured`. The program is the
package in solution/study/measured/; this runs it and keeps its tables."""

import hashlib
import json
import os
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from bounce_grader.common.errors import UsageError
from bounce_grader.common.files import write_whole
from bounce_grader.common.paths import BUILD, FIXTURES, ROOT

if TYPE_CHECKING:
    from measured.study import Study

NAME = "measured"
TABLES = tuple(
    f"{NAME}_{it}" for it in ("extraction", "ladder", "bodies", "drops", "findings", "impacts")
)
SQUARES = FIXTURES / "measured" / "squares.csv.gz"
ELLIPSES = FIXTURES / "measured" / "ellipses.csv"
PROGRAM = BUILD / "bounce_measured"
SOURCES = ROOT / "solution" / "study" / "measured"


@dataclass(frozen=True)
class Files:
    """The figures, where they aren't the committed ones; and where the JSON object goes."""

    squares: Path | None = None
    ellipses: Path | None = None
    json: Path | None = None

    @property
    def others(self) -> bool:
        return self.squares is not None or self.ellipses is not None


def measure(folder: Path, files: Files, quick: bool) -> dict[str, Path]:
    """Gives the file of each table; works them out where the folder doesn't have them yet."""
    version = _version(files, quick)
    tables = {name: folder / f"{name}-{version}.csv" for name in TABLES}
    answer = folder / f"{NAME}-{version}.json"
    if not all(file.exists() for file in (*tables.values(), answer)):
        from measured import study

        with tempfile.TemporaryDirectory(prefix="measuring-", dir=folder) as name:
            done = _run(files, quick)
            for table, data in study.tables(done).items():
                (Path(name) / table).write_bytes(data)
            (Path(name) / answer.name).write_text(_text(done), encoding="utf-8")
            for table, file in tables.items():
                os.replace(Path(name) / f"{table}.csv", file)
            os.replace(Path(name) / answer.name, answer)
    if files.json:
        _write(files.json, answer.read_text(encoding="utf-8"))
    return tables


def report(files: Files, quick: bool) -> int:
    """Answers for figures that aren't the committed ones, in the JSON file or on the terminal."""
    text = _text(_run(files, quick))
    if files.json:
        _write(files.json, text)
        print(f"{files.json} holds the answer")
    else:
        print(text, end="")
    return 0


def _run(files: Files, quick: bool) -> "Study":
    from measured import study

    return study.run(files.squares or SQUARES, files.ellipses or ELLIPSES, quick)


def _text(done: "Study") -> str:
    from measured import study

    return json.dumps(study.as_json(done), indent=1, ensure_ascii=False) + "\n"


def _write(file: Path, text: str) -> None:
    if str(file) == "-":
        sys.stdout.write(text)
        return
    try:
        write_whole(file, text)
    except OSError as error:
        raise UsageError(f"{file} can't be written: {error.strerror}") from error


def _version(files: Files, quick: bool) -> str:
    """Hashes all that the tables depend on."""
    version = hashlib.sha256(b"quick" if quick else b"whole")
    figures = (files.squares or SQUARES, files.ellipses or ELLIPSES)
    for file in (*figures, PROGRAM, *sorted(SOURCES.glob("*.py"))):
        try:
            version.update(hashlib.sha256(file.read_bytes()).digest())
        except OSError as error:
            raise UsageError(f"{file} can't be read: {error.strerror}") from error
    return version.hexdigest()[:16]
