"""A command that can't be carried out ends in one sentence and a status, with nothing half-written.
commands.toml has the commands, commands.txt what comes out. Most run in this process, as a start of
Python for each would take longer than all of them; those that end before Python begins, or
print a whole report, run ./kit."""

import os
import re
import shlex
import shutil
import subprocess
from pathlib import Path
from typing import Any

import golden
import pytest
from bounce_grader import cli
from conftest import Patch, Printed, ROOT, SOLUTION

HERE = Path(__file__).parent
KEYS = ("shell", "command")


def in_this_process(words: list[str], capsys: Printed) -> tuple[int, str, str]:
    status = cli.main(words)
    printed = capsys.readouterr()
    return status, printed.out, printed.err


def by_the_program(program: str, words: list[str], more: dict[str, str]) -> tuple[int, str, str]:
    """By ./kit, or by a copy of it at another path, which has looked for no packages yet."""
    copy = Path(program)
    if program != "kit":
        copy.parent.mkdir(exist_ok=True)
        copy.write_bytes((ROOT / "kit").read_bytes())
    command = ["sh", program if program != "kit" else str(ROOT / "kit"), *words]
    env = {**os.environ, **more}
    done = subprocess.run(command, env=env, capture_output=True, text=True, check=False)
    if program != "kit":
        copy.unlink()
    return done.returncode, done.stdout, done.stderr


def files(folder: Path) -> set[str]:
    return {str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()}


def outcome(row: dict[str, Any], folder: Path, capsys: Printed) -> str:
    shell, command = (row.get(key, "").replace("SOLUTION", str(SOLUTION)) for key in KEYS)
    subprocess.run(["sh", "-ec", shell], cwd=folder, check=True)
    before = files(folder)
    words = shlex.split(command.replace("BYTE_FF", "\udcff"))
    if "program" in row:
        status, out, err = by_the_program(row["program"], words, row.get("env", {}))
    else:
        status, out, err = in_this_process(words, capsys)
    assert err.replace("\n", "").isprintable(), row["name"]
    assert status in (0, 1) or err.startswith("kit") and "\n::" not in err, row["name"]
    printed = err + (out if status > 1 and "--format" in words else "")
    new = sorted(files(folder) - before)
    return f"{plain(printed, folder)}status {status}{', new: ' * bool(new)}{', '.join(new)}\n"


def plain(text: str, folder: Path) -> str:
    text = text.replace(f"{folder}/", "").replace(str(ROOT), "KIT")
    text = re.sub(r" \(choose from .*\)", "", text)  # each Python writes it in its own way
    return re.sub(r"(install -y --no-install-recommends) .*", r"\1 ...", text)


@pytest.mark.golden
def test_each_command_ends_as_written_down(
    tmp_path: Path, capsys: Printed, monkeypatch: Patch
) -> None:
    got = ""
    for number, row in enumerate(golden.table(HERE / "commands.toml")["command"]):
        folder = tmp_path / str(number)
        folder.mkdir()
        monkeypatch.chdir(folder)
        command = repr(row["command"])[1:-1]
        got += f"=== {row['name']}\n$ kit {command}\n{outcome(row, folder, capsys)}\n"
    golden.compare_file(HERE / "commands.txt", got)


def test_a_full_standard_output_is_a_fault_of_the_machine() -> None:
    with open("/dev/full", "w") as full:
        command = [str(ROOT / "kit"), "grade", str(SOLUTION), "--no-sanitize"]
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
    assert done.returncode == 3 and "No space left on device" in done.stderr
    assert len(done.stderr.splitlines()) == 1


def test_what_is_wrong_in_the_manifest_is_said_before_what_the_build_says(tmp_path: Path) -> None:
    for name in ("kit", "CMakeLists.txt", "CMakePresets.json"):
        shutil.copy2(ROOT / name, tmp_path)
    shutil.copytree(ROOT / "grader", tmp_path / "grader")
    (tmp_path / "grader" / "parts.json").write_text('{"parts": [1,]}')
    command = [str(tmp_path / "kit"), "grade", str(tmp_path)]
    environment = {**os.environ, "KIT_NO_INSTALL": "1"}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    last = done.stderr.splitlines()[-1]
    assert done.returncode == 2 and last.startswith("kit: grader/parts.json can't be read as JSON")
