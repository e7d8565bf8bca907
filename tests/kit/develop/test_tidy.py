"""Which files clang-tidy checks; a stand-in replaces clang-tidy itself."""

import json
import subprocess
from pathlib import Path
from typing import Any

import pytest
from bounce_grader.common.paths import BUILD
from bounce_grader.develop import tidy


class Tidy:
    """Records the files that it was asked to check."""

    def __init__(self) -> None:
        self.asked: list[str] = []
        self.status = 0

    def run(self, command: list[str], **_: Any) -> "subprocess.CompletedProcess[str]":
        if command[0] == "git":
            return subprocess.CompletedProcess(command, 0, "grader/judge/session.cpp\n", "")
        self.asked = [word for word in command if word.startswith("^")]
        self.commands = Path(command[command.index("-p") + 1]) / "compile_commands.json"
        return subprocess.CompletedProcess(command, self.status, "found something", "")


@pytest.fixture
def stand_in(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Tidy:
    made = Tidy()
    monkeypatch.setattr(tidy, "CLEAN", tmp_path / "tidied.json")
    monkeypatch.setattr(subprocess, "run", made.run)
    return made


def test_a_usual_run_looks_at_what_changed_last_and_a_whole_run_at_the_rest(stand_in: Tidy) -> None:
    assert tidy.run(all_files=False) == 0
    usual = set(stand_in.asked)
    assert len(usual) == tidy.MOST and any("judge/session.cpp" in file for file in usual)
    assert tidy.run(all_files=True) == 0
    assert len(stand_in.asked) > 30 and not usual & set(stand_in.asked)
    stand_in.asked = []
    assert tidy.run(all_files=True) == 0 and not stand_in.asked


def test_each_file_has_a_command_of_its_own(stand_in: Tidy) -> None:
    tidy.run(all_files=True)
    commands = {
        entry["file"]: entry["command"] for entry in json.loads(stand_in.commands.read_text())
    }
    for file in (word.strip("^$") for word in stand_in.asked):
        assert commands[file].endswith(f" -c {file}")


def test_a_file_that_is_not_built_here_is_not_called_clean(
    stand_in: Tidy, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    entries = json.loads((BUILD / "compile_commands.json").read_text())
    left = [entry for entry in entries if "solution/exact/scene.cpp" not in entry["file"]]
    (tmp_path / "compile_commands.json").write_text(json.dumps(left))
    monkeypatch.setattr(tidy, "BUILD", tmp_path)
    assert tidy.run(all_files=True) == 0
    assert stand_in.asked and not any("exact/scene.cpp" in file for file in stand_in.asked)
    assert "solution/exact/scene.cpp" not in json.loads(tidy.CLEAN.read_text())


def test_what_was_not_clean_is_looked_at_again(
    stand_in: Tidy, capsys: pytest.CaptureFixture[str]
) -> None:
    stand_in.status = 1
    assert tidy.run(all_files=False) == 1
    assert "found something" in capsys.readouterr().out
    before, stand_in.asked, stand_in.status = stand_in.asked, [], 0
    assert tidy.run(all_files=False) == 0 and stand_in.asked == before
