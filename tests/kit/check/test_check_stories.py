"""What ./check prints in a student's folder. A story has rounds; each gives the words after
./check, and may first change src/. One that names `laid` submissions, `edits` of parts or more
`files` begins with the solution's parts; files may be `gone` for a round. Of what is printed,
`only` lines that match are written down, where memory that was never set decides the others; of a
file that is `counted`, the number of lines. What is printed stands in a text beside the story.

A story that `is_fresh` has a folder of its own, which was never built. There files may be
`changed`, programs `hidden`; and what is in a file is shown `also`."""

import os
import re
from pathlib import Path
from typing import Any

import golden
import pytest
from handed_out import check, put, unzipped

pytestmark = pytest.mark.xdist_group("student")

STORIES = {
    file.with_suffix(".txt"): golden.table(file)
    for file in sorted(Path(__file__).parent.glob("stories/*.toml"))
}
FILES = ("edits", "files")
CHANGES = {"laid", *FILES}


def plain(text: str, home: Path) -> str:
    """What is printed, without what differs each time."""
    text = re.sub("check: building .*\n", "", text)
    text = re.sub(r"(Eigen3|GTest|nlohmann_json)-[\d.]+", r"\1", text)
    text = re.sub(r"In Tumble, with dt [^(]*|Given 1.2 times the time [^(]*", "TIMES ", text)
    text = re.sub(r"measured on \d\d \w+ at \d\d:\d\d", "measured on DAY", text)
    text = re.sub(r"-?\d(\.\d+)?e[+-]3\d\d", "UNSET", text)  # what happens to be in memory
    return text.replace(str(home), "FOLDER")


def programs_without(hidden: str, folder: Path) -> str:
    """A PATH."""
    folder.mkdir()
    for name in {*os.listdir("/usr/bin"), *os.listdir("/bin")}:
        if not re.fullmatch(hidden, name):
            (folder / name).symlink_to(Path("/usr/bin") / name)
    return str(folder)


def play(home: Path, round: dict[str, Any]) -> str:
    if CHANGES & round.keys():
        put(home, *round.get("laid", []), **{key: round.get(key, {}) for key in FILES})
    gone = {home / name: (home / name).read_bytes() for name in round.get("gone", [])}
    for file in gone:
        file.unlink()
    for name, (old, new) in round.get("changed", {}).items():
        text = (home / name).read_text()
        assert old in text
        (home / name).write_text(text.replace(old, new))
    environment = dict(round.get("environment", {}))
    if "hidden" in round:
        environment["PATH"] = programs_without(round["hidden"], home.parent / round["name"])
    words = round["check"].split()
    done = check(home, *words, **environment)
    for file, data in gone.items():
        file.write_bytes(data)
    printed = f"{done.stdout}{done.stderr}status {done.returncode}\n"
    if "also" in round:
        printed += (home / round["also"]).read_text()
    lines = printed.splitlines()
    text = [f"=== {round['name']}", " ".join(["$ ./check", *words])]
    text += [line for line in lines if re.search(round.get("only", ""), line)]
    if "counted" in round:
        count = (home / round["counted"]).read_text().count("\n")
        text.append(f"{round['counted']} has {count} lines")
    return plain("\n".join(text) + "\n", home)


@pytest.mark.golden
@pytest.mark.parametrize(
    "expected",
    [
        pytest.param(file, id=file.stem, marks=[pytest.mark.long] * story.get("long", False))
        for file, story in STORIES.items()
    ],
)
def test_a_student_is_told(expected: Path, tmp_path: Path, request: pytest.FixtureRequest) -> None:
    is_fresh = STORIES[expected].get("is_fresh")
    home = unzipped(tmp_path) if is_fresh else request.getfixturevalue("home")
    for kept in (home / "build/check").glob("*_found.txt"):
        kept.unlink()  # what was measured once after a change
    for name in ("hint", "ladder"):
        (home / "build/check" / name).unlink(missing_ok=True)
    told = [play(home, round) for round in STORIES[expected]["round"]]
    golden.compare_file(expected, "\n".join(told))
