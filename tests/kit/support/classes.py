"""A small class as Canvas hands it out, and what its run has written, where a stand-in grades."""

import csv
import io
from pathlib import Path

from bounce_grader.classroom.grading.results import load, SET
from handed_in import zipped

COLUMN = "HW3 (98765)"
USERS = list(range(101, 111))  # of a small class
POINTS = ("30.00", "23.00", "19.00", "13.00", "8.00", "4.00", "0.00")  # of part 2


def download(path: Path, users: list[int], extra: dict[str, bytes] | None = None) -> Path:
    own = {
        f"doejane_{user}_{user}0_part2_lcp.cpp": f"// {user}\n// fails: {user % 7}\n".encode()
        for user in users
    }
    return zipped(path, own | (extra or {}))


def book(path: Path, users: list[int]) -> Path:
    lines = [f"Student,ID,SIS Login ID,Section,{COLUMN}", "    Points Possible,,,,100.00"]
    lines += [f'"Doe, Jane",{user},l{user},S,' for user in users]
    path.write_text("\n".join(lines) + "\n")
    return path


def points_of(users: list[int]) -> dict[str, str]:
    """What the stand-in gives them."""
    return {str(user): POINTS[user % 7] for user in users}


def column(path: Path) -> dict[str, str]:
    rows = list(csv.reader(io.StringIO(path.read_text())))
    place = rows[0].index(COLUMN)
    return {row[1]: row[place] for row in rows[2:]}


def scores(out: Path) -> dict[str, str]:
    """By id, as the gradebook would have them."""
    rows = csv.DictReader(io.StringIO((out / "grades.csv").read_text("utf-8-sig")))
    return {row["id"]: f"{float(row['score']):.2f}" for row in rows if row["score"]}


def keys(out: Path) -> set[str]:
    """Of the results."""
    return {file.stem for file in (out / "results").glob("*.json") if file.name != SET}


def graded(out: Path) -> dict[str, str]:
    """When each was graded, by its result's key."""
    found = {key: load(out / "results", key) for key in keys(out)}
    return {key: str(result["at"]) for key, result in found.items() if result}


def same(one: Path, other: Path) -> bool:
    """Whether two runs have written the same."""
    files = ("gradebook.csv", "grades.csv", "class.html")
    names = [name for name in files if (one / name).exists()]
    return all((one / name).read_bytes() == (other / name).read_bytes() for name in names)
