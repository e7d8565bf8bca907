"""If the kit is started in a folder of strangers' files, it runs none of them outside a box."""

import json
import subprocess
from pathlib import Path

import classes
import pytest
from conftest import ROOT, solution_files, write

# Under each name that Python looks for first: some are imported at the start of any program, some by
# processes that a class starts.
NAMES = ("argparse", "bounce_grader", "encodings", "json", "multiprocessing", "os", "re", "site")
STRANGE = 'open("{canary}", "a").write(__name__)\nraise SystemExit("strange")\n'


@pytest.fixture
def among_strangers(tmp_path: Path) -> Path:
    folder = write(tmp_path / "among", solution_files())
    text = STRANGE.format(canary=tmp_path / "canary")
    for name in NAMES:
        (folder / f"{name}.py").write_text(text)
        write(folder / "packages" / name, {"__init__.py": text.encode()})
    return folder


def kit(*words: str, cwd: Path) -> "subprocess.CompletedProcess[str]":
    return subprocess.run([ROOT / "kit", *words], cwd=cwd, capture_output=True, text=True)


def test_a_grading_and_a_class_run_nothing_of_the_present_folder(among_strangers: Path) -> None:
    for inside in ("", "packages"):
        words = ("grade", str(among_strangers), "--no-sanitize", "--json", "-")
        done = kit(*words, cwd=among_strangers / inside)
        assert (done.returncode, json.loads(done.stdout)["score"]) == (0, 100), done.stderr
    source = classes.download(among_strangers.parent / "x.zip", [101, 102])
    done = kit("class", str(source), "--out", "../out", cwd=among_strangers)
    assert done.returncode == 0, done.stderr
    assert (among_strangers.parent / "out" / "grades.csv").exists()
    assert not (among_strangers.parent / "canary").exists()


def test_the_kit_is_found_through_a_link_to_it(tmp_path: Path) -> None:
    (tmp_path / "bounce").symlink_to(ROOT / "kit")
    (tmp_path / "again").symlink_to("bounce")
    done = subprocess.run([tmp_path / "again", "--help"], capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, "") and "grade" in done.stdout
