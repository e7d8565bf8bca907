"""The cases that students write before the code: what is said of them, and that the formulas for the
buggy programs answer as the gallery's programs do."""

import json
import re
import subprocess
from pathlib import Path
from typing import Any

import golden
import pytest
from bounce_grader.build.compile import compile_all
from bounce_grader.build.toolchain import link_alone, Work
from bounce_grader.common.manifest import Part, parts
from bounce_grader.common.paths import EXAMPLES, REFERENCE_RUNNER
from bounce_grader.formats import terminal
from bounce_grader.grading import examples, fixtures, known_mistakes
from bounce_grader.grading.examples import folders, TABLE
from bounce_grader.sandbox import box as boxes
from bounce_grader.submission import submission
from conftest import Grade, Patch, ROOT, write

HERE = Path(__file__).parent
HINTS = ROOT / "student" / "given" / "examples" / "hints.txt"
# In the order of a runner's numbers.
OUTPUTS = {
    1: "J00 J10 J20 J01 J11 J21 phi",
    2: "V00 V10 V20 V30 V01 V11 V21 V31 V02 V12 V22 V32 V03 V13 V23 V33 p0 p1 p2 p3",
    3: "x' y' theta' v_x' v_y' omega'",
}
CONTACT = [[1, 0], [0, 1]]  # of J, above the arms
SECRETS = ("one", "two", "three")
AT_ONCE = 100  # lines


def judged(cases: str) -> list[dict[str, Any]]:
    command = [str(EXAMPLES), str(TABLE)]
    done = subprocess.run(command, input=cases, capture_output=True, text=True)
    return list(json.loads(done.stdout)["cases"])


def verdicts(lines: list[str]) -> list[dict[str, Any]]:
    chunks = [lines[at : at + AT_ONCE] for at in range(0, len(lines), AT_ONCE)]
    return [verdict for some in chunks for verdict in judged("\n".join(some))]


def test_each_wrong_program_is_caught_alone_by_a_case_found_by_hand() -> None:
    rows = re.findall(r"(?m)^(part .*?) +# (\d\w)", (HERE / "alone.txt").read_text())
    for (line, program), verdict in zip(rows, verdicts([line for line, _ in rows])):
        assert verdict["caught"] == [program], line
    assert [program for _, program in rows][: len(folders())] == list(folders())
    hinted = re.findall(r"(?m)^(\d\w)\n.+\n.+\nTry (.*), and give (.*)\.$", HINTS.read_text())
    for (line, program), hint in zip(rows, hinted):
        given, said = line[8:].split(" -> ")
        assert hint == (program, given, said.split(" = ")[0])


@pytest.mark.golden
def test_a_case_is_judged_in_one_sentence_with_its_place() -> None:
    said = [
        f"{v['place']}, part {v['part']}: {v['message'] or ' '.join(['right', *v['caught']])}\n"
        for v in judged((HERE / "cases.txt").read_text())
    ]
    golden.compare_file(HERE / "cases.expected.txt", "".join(said))


@pytest.mark.golden
def test_handed_in_cases_may_give_points(grade: Grade, monkeypatch: Patch) -> None:
    monkeypatch.setattr(examples, "example_points", lambda: 46)
    assert grade({})["parts"][-1]["score"] == 0
    cases = (HERE / "alone.txt").read_bytes().partition(b"part 3: y = 0.15")[0]
    record = grade({"examples.txt": cases + b"part 1: -> phi"})
    assert (record["score"], record["max_score"]) == (100 + 46 * 20 / 23, 146)
    schema = json.loads((ROOT / "docs" / "record.schema.json").read_text())
    pytest.importorskip("jsonschema").validate(record, schema)
    report = "".join(f"{line}\n" for _, line in terminal.lines(record))
    golden.compare_file(HERE / "report.expected.txt", report.partition("Part 5")[2])
    monkeypatch.undo()
    assert (record := grade({}))["score"] == record["max_score"] == 100 and not record["ignored"]


@pytest.fixture(scope="module")
def drawn(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Folders with random cases, made as hidden ones are."""
    folders = [tmp_path_factory.mktemp(secret) for secret in SECRETS]
    for folder in folders:
        fixtures.write("hidden", folder, folder.name)
    return folders


def random_cases(part: Part, drawn: list[Path], to: Path) -> list[dict[str, Any]]:
    """All of them, in a folder for the judge, in the order in which it asks them."""
    cases: list[dict[str, Any]] = []
    for folder in drawn:
        checks = json.loads((folder / f"{part.stem}.json").read_text())["checks"]
        every = (case for check in checks.values() for case in check)
        # Cases with two answers aren't asked where answers are compared with one.
        cases += (case for case in every if "other_J" not in case["expected"])
    cases.sort(key=lambda case: (case["params"]["l"], case["params"]["m"]) == (0.2, 0.3))
    text = json.dumps({"stem": part.stem, "checks": {"all": cases}})
    write(to, {f"{part.stem}.json": text.encode()})
    return cases


def answers(
    part: Part, runner: Path, cases: list[dict[str, Any]], folder: Path
) -> list[list[float]]:
    """A program's; of a step, the judge is told by how much q' isn't q + dt v'."""
    got = known_mistakes.answers(part, runner, folder)
    for case, numbers in zip(cases, got if part.number == 3 else []):
        for i in range(3):
            numbers[i] += case["input"]["q"][i] + case["params"]["dt"] * numbers[3 + i]
    return got


def inputs_of(case: dict[str, Any]) -> dict[str, float]:
    given, params = case["input"], case["params"]
    names = {"g": ("g_x", "g_y", ""), "q": ("x", "y", "theta"), "v": ("v_x", "v_y", "omega")}
    values = {key: x for key, x in params.items() if key not in ("g", "T")}
    for key, vector in {"g": params["g"], **given}.items():
        if key == "J":
            values |= {"r_x": vector[2][1], "r_y": -vector[2][0]}
        else:
            values |= dict(zip(names[key], vector))
    values.pop("", None)
    return values


def number(x: float) -> str:
    return "0.000000" if abs(x) < 1e-6 else f"{x:.9f}"


def line_of(part: Part, case: dict[str, Any], answer: list[float]) -> str:
    words = [line.split() for line in TABLE.read_text().splitlines()]
    named = [w[2] for w in words if w[0] in ("input", "output") and str(part.number) in w[6:]]
    given = [f"{name} = {x!r}" for name, x in inputs_of(case).items() if name in named]
    said = zip(OUTPUTS[part.number].split(), answer)
    outputs = [f"{name} = {number(x)}" for name, x in said if name in named]
    return f"part {part.number}: {', '.join(given)} -> {', '.join(outputs)}"


@pytest.mark.parametrize("part", parts()[:3], ids=lambda part: part.stem)
def test_formulas_answer_as_programs(part: Part, drawn: list[Path], tmp_path: Path) -> None:
    asked = tmp_path / "cases"
    cases = random_cases(part, drawn, asked)
    right = answers(part, REFERENCE_RUNNER, cases, asked)
    kept = [
        (case, answer, n)
        for n, (case, answer) in enumerate(zip(cases, right))
        if case["input"].get("J", CONTACT)[:2] == CONTACT
    ]
    for_all = verdicts([line_of(part, case, answer) for case, answer, _ in kept])
    readable = [n for n, verdict in enumerate(for_all) if "column" not in verdict["place"]]
    assert len(readable) > 100 and all(for_all[n]["right"] for n in readable)
    for program, folder in folders().items():
        if not program.startswith(str(part.number)):
            continue
        taken = submission.read(known_mistakes.GALLERY / folder)
        runner = link_alone(
            part, compile_all(Work(taken, tmp_path, boxes.choose(known_mistakes.ANY_BOX)))
        )
        assert runner.path
        wrong = answers(part, runner.path, cases, asked)
        lines = [line_of(part, case, wrong[n]) for case, _, n in kept]
        told = verdicts(lines)
        caught = {n for n in readable if program in for_all[n]["caught"]}
        assert caught == {n for n in readable if not told[n]["right"]} != set()
        assert all(f"buggy program {program} answers this" in told[n]["message"] for n in caught)
