"""The handout's zip: the same bytes each time, all that a student needs, the points of the
manifest, and no hidden answer."""

import json
import re
import shutil
import zipfile
from pathlib import Path

import pytest
from bounce_grader import cli
from bounce_grader.common.errors import UsageError
from bounce_grader.common.manifest import parts
from bounce_grader.grading import examples, fixtures
from bounce_grader.publish import handout, handout_page, wrong_programs
from conftest import Patch, ROOT, SOLUTION

SUBMISSIONS = ROOT / "tests/submissions"
# A line says nothing of the solution when it is short, is no more than punctuation, an include or
# a namespace, or stands in what students are given anyway: the stubs and the contract.
TRIVIAL = re.compile(r"\W*|#.*|\}?\s*(?:// )?namespace.*|using .*|return \w+;|for \(.*\) \{")
SHORT = 16


def written(tmp_path: Path) -> Path:
    assert cli.main(["handout", "--out", str(tmp_path / "a.zip")]) == 0
    return tmp_path / "a.zip"


def contents(tmp_path: Path) -> dict[str, bytes]:
    with zipfile.ZipFile(written(tmp_path)) as archive:
        return {name.removeprefix("bounce/"): archive.read(name) for name in archive.namelist()}


def telling_lines(*texts: bytes) -> set[str]:
    lines = b"\n".join(texts).decode("utf-8", "replace").splitlines()
    joined = {" ".join(line.split()) for line in lines}
    return {line for line in joined if len(line) >= SHORT and not TRIVIAL.fullmatch(line)}


def test_holds_what_a_student_needs_in_the_same_bytes_each_time(tmp_path: Path) -> None:
    first = written(tmp_path).read_bytes()
    assert written(tmp_path).read_bytes() == first
    assert [file.name for file in tmp_path.iterdir()] == ["a.zip"]
    with zipfile.ZipFile(tmp_path / "a.zip") as archive:
        modes = {info.filename: info.external_attr >> 16 for info in archive.infolist()}
    assert [name for name, mode in modes.items() if mode & 0o111] == ["bounce/check"]
    assert list(modes) == sorted(set(modes))
    assert {name.partition("/")[0] for name in modes} == {"bounce"}
    assert {name.split("/")[1] for name in modes} == {
        *(".clang-format", ".clangd", ".devcontainer", ".vscode", "CMakeLists.txt"),
        *("CMakePresets.json", "README.html", "README.md", "explore.html", "explore.md"),
        *("check", "check.cmd", "bounce.svg", "complementarity.svg", "examples.txt"),
        *("figure.svg", "main.cpp"),
        *("fixtures", "given", "hints", "include", "src", "tests"),
    }


def test_no_answer_is_in_it(tmp_path: Path) -> None:
    """No line of the solution, no submission of the gallery, and no hidden case."""
    inside = contents(tmp_path)
    stubs = [text for name, text in inside.items() if name.startswith("src/")]
    assert len(stubs) == 4 and all(b"// TODO: " in text for text in stubs)
    contract = [text for name, text in inside.items() if name.startswith("include/")]
    solution = telling_lines(*(file.read_bytes() for file in SOLUTION.glob("*.cpp")))
    secret = solution - telling_lines(*stubs, *contract)
    assert len(secret) > 20, "the solution has lines of its own"
    lines = telling_lines(*inside.values())
    assert not secret & lines

    wrong = {file.read_bytes() for file in SUBMISSIONS.rglob("*.?pp")}
    given = {file.read_bytes() for file in (ROOT / "student").rglob("*.?pp")}
    assert len(wrong) > 50 and not wrong & {*inside.values()} - given
    mistakes = list((SUBMISSIONS / "mistakes").rglob("*.cpp"))
    assert not [str(file) for file in mistakes if telling_lines(file.read_bytes()) <= lines]

    everything = b"\n".join(inside.values()).decode("utf-8", "replace")
    for file in fixtures.hidden_folder().glob("*.json"):
        for cases in json.loads(file.read_text())["checks"].values():
            for case in cases:
                assert json.dumps(case["input"], separators=(",", ":")) not in everything
    assert not any("hidden" in name.split("/") for name in inside)


def test_what_work_leaves_behind_is_left_out(tmp_path: Path, monkeypatch: Patch) -> None:
    folder = tmp_path / "student"
    (folder / "build").mkdir(parents=True)
    for name in ("README.md", "build/log", ".hidden", "animation.html"):
        (folder / name).write_text("x")
    (folder / "link").symlink_to("/etc/hostname")
    monkeypatch.setattr(handout, "HANDOUT", folder)
    of_the_kit = ("tests/", "fixtures/", "given/words/", "given/report/")
    own = [name for name in handout.files() if not name.startswith(of_the_kit)]
    assert own == [".clang-format", "README.md"]


def test_says_other_points_where_the_manifest_does(tmp_path: Path, monkeypatch: Patch) -> None:
    other = [41, 23.5, 37, 17]
    changed = tuple(part._replace(points=other[part.number - 1]) for part in parts())
    monkeypatch.setattr(handout_page, "parts", lambda: changed)
    inside = contents(tmp_path)
    own = [name for name in inside if not name.startswith("tests/")]
    text = "\n".join(inside[name].decode() for name in own if name.endswith((".md", ".hpp")))
    printed = re.findall(r"([\d.]+) points|^\| \d \|.*\| ([\d.]+) \|$", text, re.M)
    assert {one or other for one, other in printed} == {"41", "23.5", "37", "17", "118.5"}
    readme = inside["README.md"].decode()
    assert "41, 23.5, 37 and 17 points" in readme and "worth 118.5 points" in readme


@pytest.mark.parametrize(
    "text", ["{{ points[5] }} points", "{{ default.k }}", "{{ sum }}", "{{ points[1]"]
)
def test_no_page_is_half_filled(text: str) -> None:
    with pytest.raises(UsageError, match="placeholder"):
        handout_page.filled_in(text)


@pytest.mark.parametrize(
    ("file", "old", "new", "refused"),
    [
        (
            "README.md",
            "({{ points[2] }} points)",
            "(30 Punkte)",
            "points[2] }} in place of a number, 3 times",
        ),
        ("README.md", "worth {{ all_points }} points", "100 Punkte wert", "all_points }}"),
        ("README.md", "| {{ default.l }} |", "| 0,2 |", "default.l }}"),
        ("include/bounce/part3_step.hpp", "({{ points[3] }} points)", "(30)", "points[3] }}"),
    ],
)
def test_a_translation_without_a_placeholder_is_refused(
    file: str, old: str, new: str, refused: str, tmp_path: Path, monkeypatch: Patch
) -> None:
    student = shutil.copytree(ROOT / "student", tmp_path / "student")
    text = (student / file).read_text()
    assert old in text
    (student / file).write_text(text.replace(old, new))
    monkeypatch.setattr(handout, "HANDOUT", student)
    with pytest.raises(UsageError, match=re.escape(f"student/{file} needs {{{{ {refused}")):
        handout.contents()


def test_another_default_is_followed_or_refused_by_name(
    tmp_path: Path, monkeypatch: Patch, capsys: pytest.CaptureFixture[str]
) -> None:
    header = (ROOT / "student/include/bounce/types.hpp").read_text()
    (tmp_path / "bounce").mkdir()
    (tmp_path / "bounce/types.hpp").write_text(header.replace("double l = 0.2;", "double l = 0.4;"))
    monkeypatch.setattr(handout_page, "CONTRACT", tmp_path)
    assert b"| `l` | side of the square | 0.4 | m |" in handout.contents()["README.md"]
    command = ["handout", "--out", str(tmp_path / "a.zip")]
    assert cli.main(command) != 0 and "run ./kit fixtures" in capsys.readouterr().err
    table = tmp_path / examples.NAME
    table.write_text(wrong_programs.table())
    for module in (handout, examples):
        monkeypatch.setattr(module, "TABLE", table)
    assert cli.main(command) != 0 and "student/README.md, line" in capsys.readouterr().err
