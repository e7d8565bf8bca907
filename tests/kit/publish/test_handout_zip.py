"""The handout's zip: the same bytes each time, all that a student needs, and no hidden answer."""

import io
import json
import re
import zipfile
from pathlib import Path

import pytest
from bounce_grader import cli
from bounce_grader.grading import fixtures
from bounce_grader.publish import handout
from conftest import ROOT, SOLUTION

# A line says nothing of the solution when it is short, is no more than punctuation, an include or
# a namespace, or stands in what students are given anyway: the stubs and the contract.
TRIVIAL = re.compile(r"\W*|#.*|\}?\s*(?:// )?namespace.*|using .*|return \w+;|for \(.*\) \{")
SHORT = 16


def telling_lines(text: bytes) -> set[str]:
    lines = (" ".join(line.split()) for line in text.decode("utf-8", "replace").splitlines())
    return {line for line in lines if len(line) >= SHORT and not TRIVIAL.fullmatch(line)}


def given_lines() -> set[str]:
    given = [*(ROOT / "student/src").glob("*.cpp"), *(ROOT / "student/include").rglob("*.hpp")]
    return set().union(*(telling_lines(file.read_bytes()) for file in given))


def test_the_same_kit_gives_the_same_bytes(tmp_path: Path) -> None:
    for name in "ab":
        assert cli.main(["handout", "--out", str(tmp_path / f"{name}.zip")]) == 0
    assert (tmp_path / "a.zip").read_bytes() == (tmp_path / "b.zip").read_bytes()
    assert sorted(file.name for file in tmp_path.iterdir()) == ["a.zip", "b.zip"]


def test_a_zip_that_cannot_be_written_is_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["handout", "--out", str(tmp_path / "missing" / "a.zip")]) == 2
    assert "can't be written" in capsys.readouterr().err


def test_holds_the_folder_the_tests_and_the_public_fixtures(tmp_path: Path) -> None:
    handout.write(tmp_path / "a.zip")
    archive = zipfile.ZipFile(io.BytesIO((tmp_path / "a.zip").read_bytes()))
    names = archive.namelist()
    assert all(name.startswith("bounce/") for name in names) and names == sorted(set(names))
    folders = {name.split("/")[1] for name in names if name.count("/") > 1}
    of_editors = {".devcontainer", ".vscode"}
    assert folders == {"fixtures", "given", "hints", "include", "src", "tests"} | of_editors
    assert {n.removeprefix("bounce/") for n in names if n.count("/") == 1} == {
        *(".clang-format", ".clangd", "CMakeLists.txt", "CMakePresets.json"),
        *("README.html", "README.md", "explore.html", "explore.md", "check", "check.cmd"),
        *("complementarity.svg", "figure.svg", "main.cpp"),
    }
    modes = {info.filename: info.external_attr >> 16 for info in archive.infolist()}
    assert [name for name, mode in modes.items() if mode & 0o111] == ["bounce/check"]


def test_the_parts_are_the_stubs() -> None:
    parts = {name: text for name, text in handout.contents().items() if name.startswith("src/")}
    assert len(parts) == 4 and all(b"// TODO: " in text for text in parts.values())


def test_no_line_of_the_solution_is_in_it() -> None:
    solution = set().union(*(telling_lines(f.read_bytes()) for f in SOLUTION.glob("*.cpp")))
    secret = solution - given_lines()
    assert len(secret) > 20, "the solution has lines of its own"
    for name, text in handout.contents().items():
        assert not secret & telling_lines(text), name


def test_no_mistake_is_in_it() -> None:
    inside = set(handout.contents().values())
    wrong = list((ROOT / "tests/submissions").rglob("*.?pp"))
    stubs = {file.read_bytes() for file in (ROOT / "student").rglob("*.?pp")}
    assert len(wrong) > 50
    for file in wrong:
        assert file.read_bytes() not in inside - stubs, file
    own = given_lines() | set().union(
        *(telling_lines(text) for text in handout.contents().values())
    )
    mistakes = (ROOT / "tests/submissions/mistakes").rglob("*.cpp")
    assert not [str(file) for file in mistakes if telling_lines(file.read_bytes()) <= own]


def test_no_hidden_case_is_in_it() -> None:
    everything = b"\n".join(handout.contents().values()).decode("utf-8", "replace")
    hidden = fixtures.hidden_folder()
    for file in sorted(hidden.glob("*.json")):
        for cases in json.loads(file.read_text())["checks"].values():
            for case in cases:
                question = json.dumps(case["input"], separators=(",", ":"))
                assert question not in everything
    assert "hidden" not in {part for name in handout.contents() for part in Path(name).parts}


def test_what_work_in_the_folder_leaves_behind_is_left_out(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "student"
    (folder / "build").mkdir(parents=True)
    for name in ("README.md", "build/log", ".hidden", "animation.html"):
        (folder / name).write_text("x")
    (folder / "link").symlink_to("/etc/hostname")
    monkeypatch.setattr(handout, "HANDOUT", folder)
    own = [name for name in handout.files() if not name.startswith(("tests/", "fixtures/"))]
    assert own == [".clang-format", "README.md"]
