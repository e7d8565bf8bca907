"""A small class as Canvas hands it out, and what its run has written, where a stand-in grades."""

import csv
import io
import zipfile
from pathlib import Path
from typing import Any

import stand_in
from bounce_grader.classroom import run
from bounce_grader.classroom.work import log
from bounce_grader.submission import submission
from conftest import write

COLUMN = "HW3 (98765)"


def text_of(user: int) -> bytes:
    return f"// part 2 of {user}\n".encode()


def download(path: Path, users: list[int], extra: dict[str, bytes] | None = None) -> Path:
    with zipfile.ZipFile(path, "w") as archive:
        for user in users:
            archive.writestr(f"doejane_{user}_{user}0_part2_lcp.cpp", text_of(user))
        for name, data in (extra or {}).items():
            archive.writestr(name, data)
    return path


def book(path: Path, users: list[int]) -> Path:
    lines = [f"Student,ID,SIS Login ID,Section,{COLUMN}", "    Points Possible,,,,100.00"]
    lines += [f'"Doe, Jane",{user},l{user},S,' for user in users]
    path.write_text("\n".join(lines) + "\n")
    return path


def points_of(user: int, tmp_path: Path) -> str:
    """What the stand-in gives, worked out without the class."""
    folder = write(tmp_path / "alone" / str(user), {"part2_lcp.cpp": text_of(user)})
    return f"{stand_in.record_of(submission.read(folder))['score']:.2f}"


def column(path: Path) -> dict[str, str]:
    rows = list(csv.reader(io.StringIO(path.read_text())))
    return {row[1]: row[4] for row in rows[2:]}


def graded(out: Path) -> list[str]:
    return [line["result"] for line in log.read(out / "log.jsonl") if line["event"] == "graded"]


def grade_class(source: Path, out: Path, **more: Any) -> int:
    return run.run(stand_in.request(source, out, **more))
