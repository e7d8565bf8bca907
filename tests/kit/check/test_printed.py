"""What ./check prints in a student's folder. A story has rounds; each gives the words after
./check, and may first change src/. One that names `laid` submissions, `edits` of parts or more
`files` begins with the solution's parts. Of what is printed, `only` lines that match are
written down, where memory that was never set decides the others; of a file that is `counted`, the
number of lines. What is printed stands in a text beside the story."""

import re
from pathlib import Path
from typing import Any

import golden
import pytest
from handed_out import check, put

pytestmark = pytest.mark.xdist_group("student")

STORIES = {
    file.with_suffix(".txt"): golden.table(file)
    for file in sorted(Path(__file__).parent.glob("stories/*.toml"))
}
FILES = ("edits", "files")
CHANGES = {"laid", *FILES}


def plain(text: str, home: Path) -> str:
    """What is printed, without what differs each time."""
    text = re.sub("check: building for the first time.*\n", "", text)
    text = re.sub(r"-?\d(\.\d+)?e[+-]3\d\d", "UNSET", text)  # what happens to be in memory
    return text.replace(str(home), "FOLDER")


def play(home: Path, round: dict[str, Any]) -> str:
    if CHANGES & round.keys():
        put(home, *round.get("laid", []), **{key: round.get(key, {}) for key in FILES})
    words = round["check"].split()
    done = check(home, *words, **round.get("environment", {}))
    lines = f"{done.stdout}{done.stderr}status {done.returncode}".splitlines()
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
def test_a_student_is_told(expected: Path, home: Path) -> None:
    (home / "build/check/hint").unlink(missing_ok=True)
    told = [play(home, round) for round in STORIES[expected]["round"]]
    golden.compare_file(expected, "\n".join(told))
