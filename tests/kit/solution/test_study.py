"""./kit study writes whole results or none, right ones, and says in a sentence what it can't use."""

import copy
import csv
import json
import os
import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from functools import reduce
from operator import getitem
from pathlib import Path
from typing import Any

import pytest
from bounce_grader.cli import main
from bounce_grader.common.paths import BUILD, FIXTURES, ROOT
from oracle import get_contacts, mp, mpf, Parameters, vector, Vector
from waiting import wait_for

SCENES = FIXTURES / "scenes"
# Commands and scenes that are refused, with the sentence; and the columns without which a question
# of the study isn't answered.
TABLES: Any = json.loads((Path(__file__).parent / "study.json").read_text())
QUICK = ("examples", "depth", "truth")
Said = pytest.CaptureFixture[str]


def command(out: Path, *questions: str) -> list[str]:
    study = "-m bounce_grader study --quick --out".split()
    return [sys.executable, *study, str(out), *questions]


def environment(**changes: str) -> dict[str, str]:
    return {**os.environ, "PYTHONPATH": str(ROOT / "grader"), **changes}


def rows(file: Path) -> list[dict[str, str]]:
    lines = file.read_text().splitlines()
    return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def refusal(capsys: Said, *options: object, status: int = 2) -> str:
    """The one sentence that ./kit study ends with."""
    assert main(["study", *map(str, options)]) == status
    message = capsys.readouterr().err
    assert message.startswith("kit: ") and message.count("\n") == 1
    return message


# --- what is written ---


@pytest.fixture(scope="module")
def quick(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("study")
    done = subprocess.run(command(out, *QUICK), env=environment(), capture_output=True, text=True)
    assert done.returncode == 0
    assert [re.sub(r"\d+ s", "_ s", line) for line in done.stderr.splitlines()] == [
        *(f"kit: {i + 1} of 4, _ s: {name}" for i, name in enumerate(QUICK)),
        "kit: 4 of 4, _ s: charts and pages",
    ]
    return out


def test_a_study_leaves_its_tables_and_charts_and_says_where_they_are_from(quick: Path) -> None:
    expected = {f"{name}.csv" for name in QUICK}
    assert {file.name for file in quick.iterdir()} == expected
    for name in QUICK:
        lines = (quick / f"{name}.csv").read_text().splitlines()
        origin = dict(line[2:].split(": ", 1) for line in lines if line.startswith("# "))
        assert set(origin) == {"machine", "compiler", "flags", "date"}, "no times were taken"
        for word in ("cores", "family", "model", "MHz", "Linux"):
            assert word in origin["machine"]
        assert "-O2" in origin["flags"]


def test_the_same_questions_give_the_same_bytes(quick: Path, tmp_path: Path) -> None:
    again = environment(PYTHONHASHSEED="7")
    subprocess.run(command(tmp_path, *QUICK), env=again, check=True, capture_output=True)
    assert all(rows(tmp_path / f"{name}.csv") == rows(quick / f"{name}.csv") for name in QUICK)


@pytest.mark.long
def test_the_quick_study_answers_every_question(tmp_path: Path) -> None:
    subprocess.run(command(tmp_path), env=environment(), check=True, capture_output=True)
    for name, columns in TABLES["columns"].items():
        table = rows(tmp_path / f"{name}.csv")
        assert table and set(columns.split()) <= set(table[0]), name
        timed = "\n# times: CPU time, pinned to core" in (tmp_path / f"{name}.csv").read_text()
        assert timed == (name in TIMED), name
    assert len(list(tmp_path.glob("*.svg"))) == 7 and len(list(tmp_path.glob("*.md"))) == 6
    for page in tmp_path.glob("*.md"):
        for link in re.findall(r"\]\(([\w.]+)(?:#[^)]*)?\)", page.read_text()):
            assert (tmp_path / link).exists() or link == "peers.md", (page.name, link)
    models = [row for row in rows(tmp_path / "least_model.csv") if row["least"] == "1"]
    assert len(models) == len(list(SCENES.iterdir())) and all(
        row["expected"] == "1" for row in models
    )
    for row in rows(tmp_path / "tolerance.csv"):
        assert int(row["violated"]) == 0 < int(row["scenes"])
        assert float(row["bound_over_error"]) <= 100
    trembles = [
        row for row in rows(tmp_path / "rest_and_drift.csv") if row["method"] == "assignment"
    ]
    for row in trembles:  # it is lifted by delta again and again, and hardly sinks
        assert float(row["height_m"]) > 0.002 > float(row["depth_m"]) >= 0
        assert float(row["drift_m"]) > 0.005


TIMED = {"speed_accuracy", "least_model", "tolerance"}


# --- the truth, by other means ---


def of_examples(quick: Path, example: str) -> list[float]:
    return [
        float(row["value"]) for row in rows(quick / "examples.csv") if row["example"] == example
    ]


def test_the_examples_are_what_their_authors_found(quick: Path) -> None:
    newton, poisson, stronge = of_examples(quick, "kane")
    assert newton == pytest.approx(1.25, abs=0.005) and max(poisson, stronge) < 1
    assert of_examples(quick, "rectangle") == pytest.approx([0.8, 4 / 3, 0.5], abs=1e-4)
    assert of_examples(quick, "painleve")[3:] == pytest.approx([3, 0, 0.125, 0.215])


def slide(q: Vector, v: Vector, params: Parameters, times: list[Any]) -> Iterator[Vector]:
    """Friction brakes the square at mu g until nothing moves."""
    rate = -params.mu * params.g[1]
    for t in times:
        braked = min(t, v[0] / rate)
        yield q[0] + v[0] * braked - rate * braked * braked / 2, q[1], q[2]


def bounces(q: Vector, v: Vector, params: Parameters, times: list[Any]) -> Iterator[Vector]:
    """A drop without tilt: each bounce lasts epsilon times as long as the one before."""
    drop, g = get_contacts(q, params).phi, -params.g[1]
    for t in times:
        speed, late = mp.sqrt(2 * drop * g), t + mp.sqrt(2 * drop / g)
        while late >= 2 * speed / g and speed > mpf("1e-30"):
            late -= 2 * speed / g
            speed *= params.epsilon
        height = speed * late - g * late * late / 2
        yield q[0], q[1] - drop + max(height, mpf(0)), q[2]


KNOWN = {"rest": bounces, "slide": slide, "flat_drop": bounces, "zeno": bounces}


@pytest.mark.parametrize("name", KNOWN)
def test_the_truth_is_what_is_known_of_a_scene(quick: Path, name: str) -> None:
    scene = json.loads((SCENES / f"{name}.json").read_text())
    params = Parameters.read(scene["params"])
    table = [row for row in rows(quick / "truth.csv") if row["scene"] == name]
    times = [mpf(scene["compare"]["until"]) * (i + 1) / len(table) for i in range(len(table))]
    known = KNOWN[name](vector(scene["q"]), vector(scene["v"]), params, times)
    for row, (x, y, theta) in zip(table, known, strict=True):
        errors = (float(row["x_m"]) - x, float(row["y_m"]) - y, float(row["theta_rad"]) - theta)
        assert all(abs(error) < 1e-14 for error in errors)


# --- stopped half way ---


def test_a_killed_study_goes_on_and_shows_no_half_of_itself(tmp_path: Path) -> None:
    questions = ("examples", "gauss_seidel")  # the second takes a second or two
    study = subprocess.Popen(
        command(tmp_path, *questions), env=environment(), stderr=subprocess.DEVNULL
    )
    wait_for(lambda: list(tmp_path.glob(".unfinished/examples-*.csv")))
    study.send_signal(signal.SIGKILL)
    study.wait()
    assert not list(tmp_path.glob("*.csv")) + list(tmp_path.glob("*.svg"))
    (kept,) = tmp_path.glob(".unfinished/examples-*.csv")
    kept.write_text("# kept: yes\n" + kept.read_text())
    assert main(["study", "--quick", "--out", str(tmp_path), *questions]) == 0
    assert (tmp_path / "examples.csv").read_text().startswith("# kept: yes")
    written = {"examples.csv", "gauss_seidel.csv"}
    assert {file.name for file in tmp_path.iterdir()} == written


# --- a motion within a tolerance ---

TUMBLE = json.loads((SCENES / "tumble.json").read_text())
START = {name: TUMBLE[name] for name in ("params", "q", "v")}  # all that a motion needs


def changed(scene: Any, path: str, value: Any) -> Any:
    """With another value at "params mu", or without it if that is None."""
    scene = copy.deepcopy(scene)
    *above, last = [int(word) if word.isdigit() else word for word in path.split()]
    holder = reduce(getitem, above, scene)
    if value is None:
        del holder[last]
    else:
        holder[last] = value
    return scene


def written(folder: Path, scene: Any) -> Path:
    file = folder / "scene.json"
    file.write_text(scene if isinstance(scene, str) else json.dumps(scene))
    return file


def test_a_motion_has_what_it_promises(tmp_path: Path, capsys: Said) -> None:
    out, scene = tmp_path / "answer.json", written(tmp_path, START)
    options = ["simulate", str(scene), "--tolerance", "1e-3", "--json", str(out)]
    assert main(["study", *options]) == 0
    answer = json.loads(out.read_text())
    assert set(answer) == set(
        "times q v method bound horizon seconds models methods impacts doubts".split()
    )
    assert len(answer["times"]) == len(answer["q"]) == len(answer["v"]) == 41
    assert answer["q"][0] == [0, 0.5, 0.3] and answer["horizon"] == answer["times"][-1]
    assert 0 < answer["bound"] <= 1e-3
    assert "event-driven: within" in capsys.readouterr().out


@pytest.mark.parametrize("name, needs", TABLES["needs"].items())
def test_a_scene_is_told_its_least_model_and_its_cheapest_method(
    tmp_path: Path, capsys: Said, name: str, needs: list[str]
) -> None:
    own, picture = json.loads((SCENES / f"{name}.json").read_text()), tmp_path / "picture.svg"
    until = 1 + int(own["compare"]["until"] / own["params"]["dt"])
    scene = written(tmp_path, changed(own, "params T", until))
    begin = os.times().children_user
    assert main(["study", "simulate", str(scene), "--picture", str(picture)]) == 0
    assert os.times().children_user - begin < 10
    said = capsys.readouterr().out
    assert re.findall("^the least .*(?:\n  .*)*", said, re.M) == ["\n".join(needs)]
    assert re.search("^the cheapest method within 1.0 mm: .*\n  .* [nµm]?s, (step|tol)", said, re.M)
    assert "<svg" in picture.read_text()


def test_a_motion_that_can_not_be_had_is_refused_with_its_horizon(
    tmp_path: Path, capsys: Said
) -> None:
    out, params = tmp_path / "answer.json", START["params"] | {"T": 5000, "epsilon": 1, "mu": 0}
    scene = written(tmp_path, START | {"params": params})
    options = ("simulate", scene, "--tolerance", "1e-9", "--json", out)
    assert "can be had up to" in refusal(capsys, *options, status=1)
    assert not out.exists()


def test_a_scene_of_ones_own_names_what_it_needs(tmp_path: Path, capsys: Said) -> None:
    assert main(["study", "scene"]) == 0
    template, out = capsys.readouterr().out, tmp_path / "out.json"
    scene = written(tmp_path, "\ufeff" + template)  # as Windows' editor writes it
    files = ["--json", str(out), "--picture", str(tmp_path / "picture.svg")]
    assert main(["study", "simulate", str(scene), *files]) == 0
    told, answer = capsys.readouterr(), json.loads(out.read_text())
    first = (
        "event-driven, or Moreau–Jean.* at a step of .*; friction is needed, a second corner isn't."
    )
    assert re.fullmatch(first, told.out.splitlines()[0]) and told.err == ""
    assert answer["times"] == pytest.approx([0.4 * k / 20 for k in range(21)])
    # Of 0.3 s, 0.1 s are a third, though not in floating point.
    for more, count in (({"T": 5, "m": 7, "delta": 0}, 5), ({"dt": 0.1, "until": 0.3}, 4)):
        own = written(tmp_path, json.loads(template) | more)
        assert main(["study", "simulate", str(own), *files]) == 0
        assert len(json.loads(out.read_text())["times"]) == count
    alone = written(tmp_path, json.loads(template) | {"T": 1})
    capsys.readouterr()
    assert main(["study", "simulate", str(alone)]) == 0
    assert "none of these" not in (said := capsys.readouterr().out) and "start alone" in said


@pytest.mark.parametrize("path, value, doubt", TABLES["own scenes"])
def test_a_number_in_another_unit_is_doubted(
    tmp_path: Path, capsys: Said, path: str, value: Any, doubt: str
) -> None:
    own = {"l": 0.2, "mu": 0.3, "epsilon": 0.5, "g": [0, -9.81, 0], "until": 0.1}
    own |= {"q": [0, 500, 0.3], "v": [0, 0, 0]}
    assert main(["study", "simulate", str(written(tmp_path, changed(own, path, value)))]) == 0
    assert capsys.readouterr().err == f"kit: {doubt}\n"


# --- what can't be used ---

IN_SCENES, IN_A_STUDY = TABLES["scenes"], TABLES["scenes of a study"]


@pytest.mark.parametrize("path, value, sentence", [*IN_SCENES, *IN_A_STUDY])
def test_a_bad_scene_is_a_sentence_that_names_file_and_field(
    tmp_path: Path, capsys: Said, path: str, value: Any, sentence: str
) -> None:
    file = written(tmp_path, changed(TUMBLE, path, value))
    study: list[str | Path] = [BUILD / "bounce_study", tmp_path, tmp_path / "out", "examples"]
    done = subprocess.run(study, capture_output=True, text=True)
    assert done.returncode == 2 and done.stderr.startswith(f"bounce_study: {file}: {sentence}")
    assert done.stderr.count("\n") == 1 and not (tmp_path / "out").exists()
    if [path, value, sentence] in IN_SCENES:
        assert f"{file}: {sentence}" in refusal(capsys, "simulate", file, "--tolerance", "1")


@pytest.mark.parametrize("text, sentence", TABLES["no scenes"].items())
def test_a_file_that_is_no_scene_is_named(
    tmp_path: Path, capsys: Said, text: str, sentence: str
) -> None:
    file = written(tmp_path, text) if text else tmp_path / "none.json"
    message = refusal(capsys, "simulate", file, "--tolerance", "1")
    assert str(file) in message and sentence in message


@pytest.mark.parametrize("options, sentence", TABLES["commands"].items())
def test_a_command_that_can_not_be_done_is_refused(
    tmp_path: Path, capfd: Said, options: str, sentence: str
) -> None:
    (tmp_path / "file").write_text("")
    written(tmp_path, START)
    (tmp_path / "speed_accuracy.csv").write_text("scene,method\nrest,a,b\n,c,d,e\n")
    assert main(["study", *options.replace("OUT", str(tmp_path)).split()]) == 2
    assert sentence in capfd.readouterr().err.splitlines()[-1]
    left = {file.name for file in tmp_path.iterdir()}
    assert left <= {"file", "speed_accuracy.csv", "scene.json", ".unfinished"}


# --- more random cases than the tests in C++ look at in the usual run ---


@pytest.mark.long
@pytest.mark.parametrize("tests", ["exact.*", "simulate_to.Keeps*:simulate_scene.*RandomDrops"])
def test_many_random_cases_hold(tests: str) -> None:
    done = subprocess.run(
        [BUILD / "study_test", f"--gtest_filter={tests}"],
        env={**os.environ, "BOUNCE_RANDOM_CASES": "20000"},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout[-4000:]
