"""./kit study: what it measures is whole or not there, and its pages say what its tables hold."""

import json
import math
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from bounce_grader.cli import main
from bounce_grader.errors import UsageError
from bounce_grader.paths import FIXTURES, ROOT
from bounce_grader.study import analytic, chart_speed, charts, look, pages, placing
from bounce_grader.study import run, runs, tables, words
from bounce_grader.study.run import QUESTIONS, Request

STUDIES = ROOT / "docs" / "studies"
SCENES = FIXTURES / "scenes"
SMALL = ("examples", "depth", "flat_landing")


def committed() -> tables.Tables:
    return {file.stem: tables.read(file) for file in sorted(STUDIES.glob("*.csv"))}


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
    timed |= {"peers", "peers_beside", "peers_ratios", "peers_steps", "peers_lcp"}
    for name, table in committed().items():
        assert ("times" in table.origin) == (name in timed), name
        if name in timed:
            assert re.match(r"CPU time, pinned to core \d+, the median of", table.origin["times"])


def test_the_quick_study_finds_what_the_whole_one_finds(quick: Path) -> None:
    for name in ("examples", "depth"):
        assert tables.read(quick / f"{name}.csv").rows == tables.read(STUDIES / f"{name}.csv").rows


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


# --- stopped half way ---


def test_a_killed_study_goes_on_and_shows_no_half_of_itself(
    tmp_path: Path, measured: list[str]
) -> None:
    questions = ("examples", "gauss_seidel")  # the second takes a second or two
    command = [sys.executable, "-m", "bounce_grader", "study", "--quick", "--out", str(tmp_path)]
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "grader")}
    study = subprocess.Popen([*command, *questions], env=environment, stderr=subprocess.DEVNULL)
    unfinished = tmp_path / run.UNFINISHED
    _wait_for(
        lambda: list(unfinished.glob("examples-*.csv")) + list(unfinished.glob("measuring-*"))
    )
    _wait_for(lambda: list(unfinished.glob("examples-*.csv")))
    study.send_signal(signal.SIGKILL)
    study.wait()
    assert not list(tmp_path.glob("*.csv")) + list(tmp_path.glob("*.svg"))
    run.run(Request(tmp_path, quick=True, questions=questions))
    assert measured == ["gauss_seidel"]
    written = {"examples.csv", "gauss_seidel.csv", "gauss_seidel.svg"}
    assert {file.name for file in tmp_path.iterdir()} - {run.UNFINISHED} == written


def _wait_for(condition: Callable[[], Any]) -> None:
    end = time.monotonic() + 60
    while not condition():
        assert time.monotonic() < end
        time.sleep(0.002)


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


def _stop(out: Path, kept: dict[str, Path]) -> list[str]:
    raise KeyboardInterrupt


# --- bad input ---


def _scenes(folder: Path, changes: dict[str, Any]) -> Path:
    copy = folder / "scenes"
    copy.mkdir()
    for file in SCENES.glob("*.json"):
        (copy / file.name).write_text(file.read_text())
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
    "path, value, said",
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
    tmp_path: Path, path: str, value: Any, said: str
) -> None:
    scenes = _scenes(tmp_path, {path: value})
    out = tmp_path / "out"
    with pytest.raises(UsageError) as refusal:
        run.run(Request(out, quick=True, questions=("examples",), scenes=scenes))
    sentence = str(refusal.value)
    assert sentence.startswith(f"{scenes / 'rest.json'}: {said}")
    assert "\n" not in sentence
    assert not list(out.glob("*.*v*"))


def test_an_unknown_question_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["study", "--quick", "--out", str(tmp_path / "out"), "speed"]) == 2
    said = capsys.readouterr().err
    assert said.startswith("kit: there is no question 'speed'; there are almost_flat,")
    assert not (tmp_path / "out").exists()


def test_a_folder_that_can_not_be_written_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("")
    assert main(["study", "--out", str(tmp_path / "file" / "out"), "examples"]) == 2
    assert f"{tmp_path / 'file' / 'out'} can't be written" in capsys.readouterr().err


@pytest.mark.parametrize(
    "text, said",
    [
        ("scene,method\nrest,box2d\n", "peers.csv has no column setting"),
        ("scene,method\nrest\n", "peers.csv: a row has another number of fields"),
    ],
)
def test_a_table_of_another_form_is_named(tmp_path: Path, text: str, said: str) -> None:
    (tmp_path / "peers.csv").write_text(text)
    with pytest.raises(UsageError) as refusal:
        known = {**committed(), "peers": tables.read(tmp_path / "peers.csv")}
        runs.runs(known)
    assert said in str(refusal.value)


# --- charts ---


def test_the_same_table_gives_the_same_bytes_in_another_process(quick: Path) -> None:
    program = (
        "import sys, pathlib; from bounce_grader.study import charts, tables;"
        "folder = pathlib.Path(sys.argv[1]);"
        "known = {f.stem: tables.read(f) for f in folder.glob('*.csv')};"
        "sys.stdout.buffer.write(charts.draw(known)['depth.svg'])"
    )
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "grader"), "PYTHONHASHSEED": "7"}
    command = [sys.executable, "-c", program, str(quick)]
    drawn = subprocess.run(command, env=environment, stdout=subprocess.PIPE, check=True).stdout
    assert drawn == (quick / "depth.svg").read_bytes()
    assert b"<dc:date>" not in drawn


@pytest.mark.long
def test_the_committed_charts_are_drawn_from_the_committed_tables() -> None:
    import matplotlib

    if matplotlib.__version__ != "3.6.3":
        pytest.skip("the committed charts are drawn by Debian 12's matplotlib")
    for name, svg in charts.draw(committed()).items():
        assert svg == (STUDIES / name).read_bytes(), name


def test_no_two_methods_look_alike_in_grey() -> None:
    styles = [*look.METHODS.values(), *look.PEERS.values(), look.style("one", ["one"])]
    marks = [style.marker for style in styles]
    assert len(set(marks)) == len(marks)
    assert all(look.is_letter(style) for style in look.PEERS.values())


def _with_an_engine() -> tables.Tables:
    """The committed tables, with one engine that is as the penalty method."""
    known = committed()
    rows = [row for row in known["speed_accuracy"].rows if row["method"] == "penalty"]
    engine = [{**row, "method": "engine"} for row in rows]
    known["peers"] = tables.Table("peers", {}, engine)
    known["peers_beside"] = known["speed_accuracy"]
    known["peers_ratios"] = tables.Table("peers_ratios", {}, [])
    return known


def test_engines_are_drawn_in_grey_with_a_letter() -> None:
    known = _with_an_engine()
    assert runs.peers(runs.runs(known)) == ["engine"]
    assert look.style("engine", ["engine"]).color == look.GREY
    alone = {**known}
    del alone["peers"]
    draw = {chart.name: chart.draw for chart in charts.CHARTS}["speed_accuracy_one.svg"]
    assert len(draw(known)) > len(draw(alone))
    page = pages.fill(known, {file.name for file in STUDIES.glob("*.svg")})["speed_accuracy.md"]
    assert "[peers.csv](peers.csv): engine" in page
    assert "(peers.md)" in pages.facts_of("README.md", known)["peers_row"]
    assert pages.facts_of("README.md", alone)["peers_row"] == ""


def test_beside_engines_our_times_are_those_of_the_same_rounds() -> None:
    known = _with_an_engine()
    rows = known["speed_accuracy"].rows
    known["peers_beside"] = tables.Table(
        "peers_beside",
        {"times": "other"},
        [{**row, "ns_per_simulated_second": "7"} for row in rows],
    )
    ours = [run for run in runs.runs(known) if not run.peer]
    assert {run.ns for run in ours} == {7.0}
    assert [run.note for run in ours] == [row["note"] for row in rows], "reasons stay"
    assert pages.facts_of("speed_accuracy.md", known)["times"] == "other"


def test_engines_measured_beside_another_program_are_left_out() -> None:
    known = _with_an_engine()
    rows = [{**row, "error_m": "0.5"} for row in known["speed_accuracy"].rows]
    known["peers_beside"] = tables.Table("peers_beside", {}, rows)
    assert not runs.compared(known)
    assert runs.peers(runs.runs(known)) == []


def test_a_profile_reaches_as_far_as_its_table() -> None:
    shares = chart_speed.profiles(runs.runs(committed()))
    furthest = max(r for own in shares.values() for r in own if math.isfinite(r))
    figure, axes = look.pyplot().subplots()
    chart_speed._profile_panel(axes, shares, [m for m in shares if m not in look.METHODS])
    look.pyplot().close(figure)
    for line, ratios in zip(axes.lines, shares.values()):
        assert line.get_ydata()[-1] == sum(map(math.isfinite, ratios)) / len(ratios)
    assert axes.get_xlim()[1] > furthest


def test_texts_in_a_panel_lie_on_neither_marks_nor_each_other() -> None:
    figure, axes = look.pyplot().subplots()
    room = placing.Places(axes)
    for _ in range(3):
        room.keep(0.5, 0.5, 5)
    written = [room.put("abc", 0.5, 0.5, 8, 3) for _ in range(20)]
    look.pyplot().close(figure)
    assert sum(written) == len(axes.texts) == len({text.xyann for text in axes.texts})
    assert 4 <= sum(written) < 20


# --- the truth, by other means ---


def test_the_truth_is_what_is_known_of_ten_scenes() -> None:
    checks = analytic.checks(committed())
    assert {check.scene for check in checks} == {f.stem for f in SCENES.glob("*.json")} - {
        "tilted_settling"
    }
    for check in checks:
        assert check.error < (1e-12 if check.scene == "pointed_drop" else 2e-15), check


def test_a_truth_that_is_off_is_seen() -> None:
    rows = [dict(row) for row in committed()["truth"].rows]
    for row in rows:
        row["y_m"] = str(float(row["y_m"]) + 1e-9)
    for check in analytic.checks({"truth": tables.Table("truth", {}, rows)}):
        assert check.error == pytest.approx(1e-9, rel=1e-3), check


# --- pages ---


def test_pages_are_their_templates_filled_from_the_tables_beside_them() -> None:
    filled = pages.fill(committed(), {file.name for file in STUDIES.glob("*.svg")})
    assert sorted(filled) == sorted(page.name for page in pages.PAGES)
    for name, text in filled.items():
        assert text == (STUDIES / name).read_text(encoding="utf-8"), name


@pytest.mark.parametrize("page", [page.name for page in pages.PAGES])
def test_templates_have_no_numbers_of_their_own(page: str) -> None:
    text = pages.NAME.sub("", (pages.TEMPLATES / page).read_text(encoding="utf-8"))
    text = re.sub(r"\(eq\. \d+\)|\]\([^)]*\)", "", text)  # equations, and where links lead
    known = (
        "1 − b²/(ac)",
        "θ = 0",
        "δ = 0",
        "p_1 =",
    )  # of formulas, and what was set, not measured
    for formula in known:
        text = text.replace(formula, "")
    assert not re.findall(r".{0,30}\d.{0,30}", text)


@pytest.mark.parametrize("page", [page.name for page in pages.PAGES])
def test_pages_link_to_what_is_there(page: str) -> None:
    text = (STUDIES / page).read_text(encoding="utf-8")
    links = re.findall(r"\]\(([^)#]+)\)", text)
    assert links
    for link in links:
        assert (STUDIES / link).exists(), link


def test_every_chart_and_table_is_on_a_page() -> None:
    text = "".join((STUDIES / page.name).read_text(encoding="utf-8") for page in pages.PAGES)
    text += (ROOT / "README.md").read_text(encoding="utf-8")
    text += (STUDIES / "peers.md").read_text(encoding="utf-8")
    for chart in charts.CHARTS:
        assert chart.name in text
    for question in QUESTIONS:
        assert f"{question}.csv" in text


def test_the_readme_says_of_its_panel_what_the_table_says() -> None:
    """One sentence under one panel, every number of it from the table."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    assert len(pages.PANEL.findall(text)) == 1
    assert pages.with_panel(text, committed()) == text


def test_numbers_are_written_short() -> None:
    values = (0.0, 0.00123, 1.5e-7, 33.7, 184025, 0.999)
    assert [words.short(x) for x in values] == ["0", "0.0012", "1.5e-7", "34", "1.8e5", "1.00"]
    assert [words.plain(x) for x in (1e-3, 1e-5, 10000.0)] == ["0.001", "1e-5", "1e4"]
    assert [words.metres(x) for x in (2.0, 0.05, 1e-3, 1e-6)] == [
        "2.0 m",
        "5.0 cm",
        "1.0 mm",
        "1.0e-6 m",
    ]
    assert words.listed(["a", "b", "c"]) == "a, b and c"


# --- what the pages claim in words holds of the tables ---


def test_the_failing_methods_fail_and_the_cures_hold() -> None:
    known = committed()
    facts = pages.facts_of("stability.md", known)
    assert facts["gain_below"] == "0" and facts["gain_others"] == "0"
    assert facts["several_below"] == "0"
    assert facts["several_above"] == facts["several_points"]
    assert facts["stack_pivots"].isdigit(), "the same number at every mass ratio"
    assert float(facts["flat_literal_fine"]) < 1e-12 < float(facts["flat_literal_coarse"])
    assert float(facts["scale_closed"]) < 1e-15
    assert int(facts["gain_count"]) > 0 and int(facts["flat_wrong"]) > 0
    assert "Moreau–Jean, two corners" in facts["rest_still"]
    assert "Moreau–Jean, two corners" in facts["landing_upright"]
    assert "assignment" in facts["landing_mirrored"]
    assert int(facts["floor_scenes"]) > int(facts["floor_of"]) / 2
    assert float(facts["sweeps_high"]) > 100 * float(facts["sweeps_low"])
    assert float(facts["endless_from"]) > 4 / 3
    assert float(facts["flat_merged"]) < 1e-12 < float(facts["flat_residual"])
    models = pages.facts_of("least_model.md", known)
    assert models["ladder_expected"] == models["ladder_scenes"] == "11"


def test_event_driven_comes_within_a_micrometre_in_every_scene() -> None:
    all_runs = runs.runs(committed())
    for scene in runs.scenes(all_runs):
        assert runs.least_time(all_runs, scene, "event_driven", 1e-6) < 1e6


@pytest.mark.long
def test_the_quick_study_is_whole(tmp_path: Path) -> None:
    assert run.run(Request(tmp_path, quick=True)) == 0
    drawn = {chart.name for chart in charts.CHARTS if "peers_steps" not in chart.needs}
    expected = {f"{name}.csv" for name in QUESTIONS} | drawn
    expected |= {page.name for page in pages.PAGES}
    assert {file.name for file in tmp_path.iterdir()} == expected
