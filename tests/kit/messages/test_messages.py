"""What a student or an instructor is told for what a program says or a file holds. Each file of
expected/ has both: some lines of input and, after "->", the sentence. For a new one, write the
input and "->", run ./kit test --accept, and read the sentence."""

import json
import re
from collections.abc import Callable, Iterator
from functools import partial, reduce
from pathlib import Path

import golden
import pytest
from bounce_grader.build.errors import of_linker
from bounce_grader.build.toolchain import compile_problem, Work
from bounce_grader.common import manifest
from bounce_grader.common.errors import UsageError
from bounce_grader.common.paths import WORK_FOLDER
from bounce_grader.grading import judging
from bounce_grader.sandbox import processes
from bounce_grader.sandbox.box import Box
from bounce_grader.sandbox.processes import Result
from bounce_grader.submission.submission import Place, Submission
from conftest import Patch, ROOT
from edits import edited

Sentences = dict[str, Callable[[str], str]]
EXPECTED = Path(__file__).parent / "expected"
MANIFEST = json.loads((ROOT / "grader" / "parts.json").read_text())


def failed(said: str) -> Result:
    return Result(1, 0.0, b"", said, False, False)


def of_the_manifest(edits: str, where: Path) -> str:
    """About parts.json after some edits, or after "{" about that in its place."""
    text = edits
    if not edits.startswith("{"):
        text = json.dumps(reduce(edited, edits.splitlines(), MANIFEST))
    (where / manifest.NAME).write_text(text)
    manifest.read.cache_clear()
    try:
        return ", ".join(
            f"{' + '.join(str(check.points) for check in part.checks)} = {part.points}"
            for part in manifest.parts()
        )
    except UsageError as refused:
        return str(refused)


def of_addr2line(lines: str) -> str:
    return str(judging.place_in(lines.replace("WORK", WORK_FOLDER).replace("ESC", "\x1b").encode()))


SENTENCES: Sentences = {
    "compiler": lambda said: compile_problem(failed(said), "part2_lcp.cpp").problem,
    "linker": lambda said: of_linker(said).problem,
    "addr2line": of_addr2line,
}


@pytest.mark.parametrize("flooded", [False, True])
def test_what_addr2line_says_counts_if_it_ended_in_order(flooded: bool, monkeypatch: Patch) -> None:
    line = f"/tmp/{WORK_FOLDER}a1b2/sources-0123456789abcdef/part1_contacts.cpp:12\n".encode()
    result = Result(0, 0.0, line, "", False, flooded)
    monkeypatch.setattr(processes, "run", lambda *_: result)
    taken = Submission("", {"part1_contacts.cpp": b""}, {}, {})
    place = judging._place("0x1", Path("runner"), Work(taken, Path(), Box("none")))
    assert place == (None if flooded else Place("part1_contacts.cpp", 12))


@pytest.fixture
def elsewhere(tmp_path: Path, monkeypatch: Patch) -> Iterator[Path]:
    """A folder for another manifest."""
    (tmp_path / "grader").mkdir()
    monkeypatch.setattr(manifest, "ROOT", tmp_path)
    yield tmp_path
    manifest.read.cache_clear()


@pytest.mark.golden
def test_each_message_has_its_sentence(elsewhere: Path) -> None:
    told: dict[str, str] = {}
    sentences: Sentences = {**SENTENCES, "manifest": partial(of_the_manifest, where=elsewhere)}
    for name, sentence in sentences.items():
        written = (EXPECTED / f"{name}.txt").read_text()
        said = re.findall(r"(.+?)\n->[^\n]*\n+", written, re.DOTALL)
        assert len(said) == written.count("\n->"), name
        told[f"{name}.txt"] = "\n".join(f"{one}\n-> {sentence(one)}\n" for one in said)
    golden.compare(EXPECTED, told)
