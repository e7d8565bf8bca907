"""Whatever one student's files contain, nobody else loses anything: the class is graded, and that
student is named. uploads_in_a_class.txt and folders_in_a_class.txt say what becomes of each; what
is odd are the zips of odd_zips.py, the uploads of odd_students.py and the folders of
odd_submissions.py."""

import csv
import io
import os
import re
import subprocess
import zipfile
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any

import golden
import pytest
from bounce_grader import cli
from bounce_grader.classroom.grading import grading, near_copies
from classes import download
from conftest import Patch, write
from corpus import Member, UTF8, zip_of
from handed_in import limited_memory, zipped
from odd_students import UPLOADS
from odd_submissions import bash, COMMANDS, PARTS
from odd_zips import PLAIN
from stand_in import grade_class

EXPECTED = Path(__file__).parent / "expected"
HONEST = {"doejane_101_1010_part2_lcp.cpp": b"// fails: 1\n"}
CLOSED = COMMANDS["closed"]
TWICE = ("an upload that is there twice", "roe_299_1_part2_lcp.cpp")


@pytest.fixture(autouse=True)
def in_this_process(monkeypatch: Patch) -> None:
    """Grades here, which is quicker: these tests are about the code around it."""
    here = lambda tasks, _, worker: ((task, worker(task)) for task in tasks)
    monkeypatch.setattr(grading, "in_processes", here)


def rows(out: Path) -> dict[str, dict[str, str]]:
    table = (out / "grades.csv").read_text("utf-8-sig")
    return {row["id"]: row for row in csv.DictReader(io.StringIO(table))}


def short(text: str) -> str:
    """A text without what a library says of a broken archive, and cut if it is long."""
    text = re.sub(r"broken \((?!its entries).*?\):", "broken (...):", text)
    text = text if text.isprintable() else ascii(text)
    shown = f"{text[:80]}... ({len(text)} characters) ...{text[-40:]}"
    return text if len(text) < 200 else shown


def outcomes(source: Path, alone: Path, honest: str, names: Mapping[str, str]) -> str:
    """What becomes of each student, by what is odd. The honest one's row is the same as alone."""
    out = source.parent / "out"
    with limited_memory(400 << 20, file_size=1 << 20):
        assert grade_class(source, out) == 0
    assert grade_class(alone, source.parent / "alone") == 0
    found = rows(out)
    assert found.pop(honest) == rows(source.parent / "alone")[honest]
    page = (out / "class.html").read_text()
    assert len(page) < 300_000
    assert max(len(cell) for row in found.values() for cell in row.values()) < 8_000
    assert all(file.stat().st_size < 40_000 for file in (out / "feedback").iterdir())
    told = []
    for id, row in found.items():
        words = [f"{row['state']}, needs a look: {row['needs a look']}"]
        words += [f"not used: {short(row['not used'])}"] * bool(row["not used"])
        told.append([names.get(id, id), *words])
    listed = page.partition("Unassigned files")[2].partition("</ul>")[0]
    told += [["nobody's", row] for row in re.findall(r"<li>(.*?)</li>", listed)]
    lines = ["\n    ".join(map(short, words)) for words in told if words[0] not in CLOSED]
    return "\n".join(f"{line}\n" for line in lines)


@pytest.mark.golden
def test_no_upload_costs_anybody_else(tmp_path: Path) -> None:
    users = {str(user): what for user, what in enumerate(UPLOADS, 300)}
    entries = [*HONEST.items(), (TWICE[1], b"// one"), (TWICE[1], b"// two")]
    for user, what in users.items():
        entries += [(name.replace("USER", user), text) for name, text in UPLOADS[what].items()]
    download = zip_of(Member(name.encode(), text, flags=UTF8) for name, text in entries)
    (tmp_path / "x.zip").write_bytes(download)
    alone = zipped(tmp_path / "alone.zip", HONEST)
    names = {**users, "299": TWICE[0]}
    got = outcomes(tmp_path / "x.zip", alone, "101", names)
    golden.compare_file(EXPECTED / "uploads_in_a_class.txt", got)
    assert "and 1880 more" in (tmp_path / "out" / "grades.csv").read_text()


@pytest.mark.golden
def test_no_folder_costs_anybody_else(tmp_path: Path) -> None:
    every, alone = (write(tmp_path / top / "parts", PARTS).parent for top in ("all", "one"))
    odd = os.fsdecode(b"ann\xe4")
    write(every, {f"{odd}/part2_lcp.cpp": b"// x", f"{odd}/notes\udcfc.txt": b""})
    for name in ("n" * 255, "ü" * 126 + "a", "ü" * 126 + "b"):
        write(every / name, {"part2_lcp.cpp": b"// y"})
    try:
        for kind in ("folders", "closed", "links"):
            for what, command in COMMANDS[kind].items():
                bash(command, every / what)
        got = outcomes(every, alone, "parts", {})
    finally:
        subprocess.run(["chmod", "-R", "u+rwX", str(every)], check=False)
        subprocess.run(["rm", "-rf", str(every)], check=True)  # however deep
    assert not Path("/tmp/was-run").exists()
    golden.compare_file(EXPECTED / "folders_in_a_class.txt", got)
    pages = [os.fsencode(file.name) for file in (tmp_path / "out" / "feedback").iterdir()]
    assert b"ann\xe4.html" in pages and max(map(len, pages)) < 240
    assert len([page for page in pages if page.startswith("ü".encode())]) == 2


# --- what nobody foresaw ---


def fails(error: Exception, *_: Any, **__: Any) -> Any:
    raise error


@pytest.mark.parametrize("error", [OverflowError("x"), MemoryError(), RecursionError("deep")])
def test_a_reading_fails_alone(tmp_path: Path, monkeypatch: Patch, error: Exception) -> None:
    write(tmp_path, {"odd.zip": PLAIN})
    monkeypatch.setattr(zipfile.ZipFile, "infolist", partial(fails, error))
    assert cli.main(["grade", str(tmp_path / "odd.zip")]) == 2


def test_who_cannot_be_compared_needs_a_look(tmp_path: Path, monkeypatch: Patch) -> None:
    monkeypatch.setattr(near_copies, "tokens_of", partial(fails, OverflowError("too large")))
    assert grade_class(download(tmp_path / "x.zip", [101]), tmp_path / "out") == 0
    assert "can't be compared" in rows(tmp_path / "out")["101"]["needs a look"]
