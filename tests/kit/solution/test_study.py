"""./kit study writes complete results or none, and names files that it can't read."""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from bounce_grader.cli import main
from bounce_grader.common.errors import UsageError
from bounce_grader.common.paths import ROOT
from bounce_study import charts, measured_part, measurements, pages, run, tables
from bounce_study.run import QUESTIONS, Request
from studies import SCENES, STUDIES, committed
from waiting import wait_for

SMALL = ("examples", "depth", "flat_landing")


@pytest.fixture(scope="module")
def quick(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A study of the small questions."""
    out = tmp_path_factory.mktemp("study")
    assert run.run(Request(out, quick=True, questions=SMALL)) == 0
    return out


@pytest.fixture
def measured(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The questions that are answered while a test runs."""
    names: list[str] = []
    measure = run._measure

    def counting(name: str, request: Request, file: Path) -> None:
        names.append(name)
        measure(name, request, file)

    monkeypatch.setattr(run, "_measure", counting)
    return names


# --- what is written ---


def test_a_study_leaves_its_tables_their_charts_and_nothing_else(quick: Path) -> None:
    expected = {f"{name}.csv" for name in SMALL} | {"depth.svg", "flat_landing.svg"}
    assert {file.name for file in quick.iterdir()} == expected


def test_tables_say_where_they_are_from(quick: Path) -> None:
    origin = tables.read(quick / "depth.csv").origin
    assert set(origin) == {"machine", "compiler", "flags", "date"}
    for word in ("cores", "family", "model", "MHz", "Linux"):
        assert word in origin["machine"]
    assert "-O2" in origin["flags"]


def test_tables_with_times_say_how_they_were_taken_and_others_do_not() -> None:
    timed = {"speed_accuracy", "speed_ratios", "least_model", "chosen_model", "bad_input"}
    timed |= {"tolerance"}
    timed |= {"peers", "peers_beside", "peers_ratios", "peers_steps", "peers_lcp"}
    for name, table in committed().items():
        assert ("times" in table.origin) == (name in timed), name
        if name in timed:
            assert re.match(r"CPU time, pinned to core \d+, the median of", table.origin["times"])


def test_the_quick_study_finds_what_the_whole_one_finds(quick: Path) -> None:
    for name in ("examples", "depth"):
        assert tables.read(quick / f"{name}.csv").rows == tables.read(STUDIES / f"{name}.csv").rows


def test_the_same_table_gives_the_same_bytes_in_another_process(quick: Path) -> None:
    program = (
        "import sys, pathlib; from bounce_study import charts, tables;"
        "folder = pathlib.Path(sys.argv[1]);"
        "known = {f.stem: tables.read(f) for f in folder.glob('*.csv')};"
        "sys.stdout.buffer.write(charts.draw(known)['depth.svg'])"
    )
    path = f"{ROOT / 'grader'}:{ROOT / 'solution' / 'study'}"
    environment = {**os.environ, "PYTHONPATH": path, "PYTHONHASHSEED": "7"}
    command = [sys.executable, "-c", program, str(quick)]
    drawn = subprocess.run(command, env=environment, stdout=subprocess.PIPE, check=True).stdout
    assert drawn == (quick / "depth.svg").read_bytes()
    assert b"<dc:date>" not in drawn


def test_a_study_that_has_ended_measures_anew(tmp_path: Path, measured: list[str]) -> None:
    for _ in range(2):
        run.run(Request(tmp_path, quick=True, questions=("examples",)))
    assert measured == ["examples", "examples"]


def test_the_questions_are_those_of_the_program() -> None:
    command = [str(run.PROGRAM), str(SCENES), "/nowhere", "no-such-question"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert set(done.stderr.partition("there are:")[2].split()) == set(QUESTIONS)


def test_without_a_terminal_progress_is_plain_lines(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    run.run(Request(tmp_path, quick=True, questions=("examples",)))
    lines = capsys.readouterr().err.splitlines()
    assert [re.sub(r"\d+ s", "_ s", line) for line in lines] == [
        "kit: 1 of 2, _ s: examples",
        "kit: 2 of 2, _ s: charts and pages",
    ]


@pytest.mark.long
def test_the_quick_study_is_whole(tmp_path: Path) -> None:
    assert run.run(Request(tmp_path, quick=True)) == 0
    drawn = {chart.name for chart in charts.CHARTS if "peers_steps" not in chart.needs}
    expected = {f"{name}.csv" for name in (*QUESTIONS, *measured_part.TABLES)} | drawn
    expected |= {page.name for page in pages.PAGES} - {pages.PEERS_PAGE}
    assert {file.name for file in tmp_path.iterdir()} == expected


# --- stopped half way ---


def test_a_killed_study_goes_on_and_shows_no_half_of_itself(
    tmp_path: Path, measured: list[str]
) -> None:
    questions = ("examples", "gauss_seidel")  # the second takes a second or two
    command = [sys.executable, "-m", "bounce_grader", "study", "--quick", "--out", str(tmp_path)]
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "grader")}
    study = subprocess.Popen([*command, *questions], env=environment, stderr=subprocess.DEVNULL)
    unfinished = tmp_path / run.UNFINISHED
    wait_for(lambda: list(unfinished.glob("examples-*.csv")) + list(unfinished.glob("measuring-*")))
    wait_for(lambda: list(unfinished.glob("examples-*.csv")))
    study.send_signal(signal.SIGKILL)
    study.wait()
    assert not list(tmp_path.glob("*.csv")) + list(tmp_path.glob("*.svg"))
    run.run(Request(tmp_path, quick=True, questions=questions))
    assert measured == ["gauss_seidel"]
    written = {"examples.csv", "gauss_seidel.csv", "gauss_seidel.svg"}
    assert {file.name for file in tmp_path.iterdir()} - {run.UNFINISHED} == written


def test_kept_tables_of_other_scenes_are_measured_again(
    tmp_path: Path, measured: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    out, scenes = tmp_path / "out", _scenes(tmp_path, {})
    request = Request(out, quick=True, questions=("examples",), scenes=scenes)
    monkeypatch.setattr(run, "_publish", _stop)
    for changed in (False, False, True):
        if changed:
            _spoil(scenes / "rest.json", "title", "Another rest")
        with pytest.raises(KeyboardInterrupt):
            run.run(request)
    assert measured == ["examples", "examples"]


def _stop(out: Path, measured: dict[str, Path]) -> list[str]:
    raise KeyboardInterrupt


# --- bad input ---


def _scenes(folder: Path, changes: dict[str, Any]) -> Path:
    copy = shutil.copytree(SCENES, folder / "scenes")
    for path, value in changes.items():
        _spoil(copy / "rest.json", path, value)
    return copy


def _spoil(file: Path, path: str, value: Any) -> None:
    """Sets the field, or takes it away where the value is None."""
    scene = json.loads(file.read_text())
    *above, last = path.split(".")
    inner = scene
    for name in above:
        inner = inner[name]
    if value is None:
        del inner[last]
    else:
        inner[last] = value
    file.write_text(json.dumps(scene))


@pytest.mark.parametrize(
    "path, value, message",
    [
        ("params.mu", None, "params.mu is missing"),
        ("params.my", 0.3, "params.my is unknown; take it out or correct its name"),
        ("params.m", -0.3, "params.m is -0.3; it must be above 0"),
        ("v", [0, float("nan"), 0], "v can't be read as JSON"),
        ("params.dt", 0, "params.dt is 0; it must be above 0"),
        ("params.T", 2_000_000_000, "params.T is 2000000000: the columns need 96 GB"),
        ("least_model", "clairvoyance", 'least_model is "clairvoyance", which is no model'),
    ],
)
def test_a_bad_scene_is_one_sentence_that_names_file_and_field(
    tmp_path: Path, path: str, value: Any, message: str
) -> None:
    scenes = _scenes(tmp_path, {path: value})
    out = tmp_path / "out"
    with pytest.raises(UsageError) as refusal:
        run.run(Request(out, quick=True, questions=("examples",), scenes=scenes))
    sentence = str(refusal.value)
    assert sentence.startswith(f"{scenes / 'rest.json'}: {message}")
    assert "\n" not in sentence
    assert not list(out.glob("*.*v*"))


def test_an_unknown_question_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["study", "--quick", "--out", str(tmp_path / "out"), "speed"]) == 2
    message = capsys.readouterr().err
    assert message.startswith("kit: there is no question 'speed'; there are almost_flat,")
    assert not (tmp_path / "out").exists()


def test_a_folder_that_can_not_be_written_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("")
    assert main(["study", "--out", str(tmp_path / "file" / "out"), "examples"]) == 2
    assert f"{tmp_path / 'file' / 'out'} can't be written" in capsys.readouterr().err


@pytest.mark.parametrize(
    "text, message",
    [
        ("scene,method\nrest,box2d\n", "peers.csv has no column setting"),
        ("scene,method\nrest\n", "peers.csv: a row has another number of fields"),
    ],
)
def test_a_table_of_another_form_is_named(tmp_path: Path, text: str, message: str) -> None:
    (tmp_path / "peers.csv").write_text(text)
    with pytest.raises(UsageError) as refusal:
        known = {**committed(), "peers": tables.read(tmp_path / "peers.csv")}
        measurements.read(known)
    assert message in str(refusal.value)
