"""The formats of other services: each is read by an independent reader, if there is one, and
compared with a file in tests/kit/formats/expected/ that a person has read."""

import base64
import copy
import json
import os
import re
import subprocess
from pathlib import Path
from typing import Any

import odd_texts
import pytest
from bounce_grader import cli, formats
from bounce_grader.common import escaping
from bounce_grader.common.errors import UsageError
from bounce_grader.common.manifest import parts
from bounce_grader.formats import github, html, sentences, terminal
from bounce_grader.formats.templates import fill
from bounce_grader.submission import folders, zips
from conftest import ROOT, SOLUTION, write
from hypothesis import example, given
from odd_texts import TEXTS

FOLDER = ROOT / "tests" / "kit" / "formats" / "expected"
SCHEMA = ROOT / "docs" / "record.schema.json"
NOWHERE = Path("/nowhere")


@pytest.fixture
def record() -> dict[str, Any]:
    """Written by hand: a wrong answer, a part that doesn't compile, one that crashes, one that is
    missing, and a message that would like to be markup."""
    loaded: dict[str, Any] = json.loads((FOLDER / "record.json").read_text())
    return loaded


@pytest.mark.parametrize(
    "name", [name for name in formats.NAMES if name not in ("json", "html", "classroom50")]
)
def test_is_what_a_person_has_read(name: str, record: dict[str, Any]) -> None:
    assert formats.render(name, record, NOWHERE) + "\n" == (FOLDER / f"{name}.txt").read_text()


def test_the_students_page_is_what_a_person_has_read(record: dict[str, Any]) -> None:
    page = html.render(record, "doejane", ("a.pdf is no C++ source and no zip",))
    assert page == (FOLDER / "feedback.html").read_text()


@pytest.mark.parametrize("name", [name for name in formats.NAMES if name != "json"])
def test_has_the_remarks_of_a_part_with_all_points(name: str, record: dict[str, Any]) -> None:
    part = record["parts"][3]
    for whole in (part, *part["checks"]):
        whole.update(score=whole["max_score"], message="", passed=True)
    part.update(status="graded", remarks=["part4_simulate.cpp:11: it uses a variable that is gone"])
    assert "it uses a variable that is gone" in formats.render(name, record, NOWHERE)
    text = "".join(line for _, line in terminal.lines(record))
    assert "  remark, no points: part4_simulate.cpp:11: it uses" in text


def test_the_record_written_by_hand_adds_up(record: dict[str, Any]) -> None:
    assert record["score"] == sum(part["score"] for part in record["parts"])
    for written, part in zip(record["parts"], parts()):
        assert [check["id"] for check in written["checks"]] == [check.id for check in part.checks]
        assert written["score"] == sum(check["score"] for check in written["checks"])


def test_records_follow_the_published_schema(record: dict[str, Any], tmp_path: Path) -> None:
    jsonschema = pytest.importorskip("jsonschema")
    schema = json.loads(SCHEMA.read_text())
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.validate(record, schema)
    real = tmp_path / "record.json"
    assert cli.main(["grade", str(SOLUTION), "--speed", "--json", str(real)]) == 0
    jsonschema.validate(json.loads(real.read_text()), schema)


@pytest.mark.parametrize(
    "spoil",
    [
        {"score": "32"},
        {"box": "x"},
        {"parts": []},
        {"submission_sha256": "5"},
        {"speed": {"ratio": 2}},
    ],
)
def test_the_schema_refuses_what_is_no_record(
    record: dict[str, Any], spoil: dict[str, Any]
) -> None:
    jsonschema = pytest.importorskip("jsonschema")
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({**record, **spoil}, json.loads(SCHEMA.read_text()))


def hostile(record: dict[str, Any], text: str) -> dict[str, Any]:
    """The record of a submission that puts this text wherever it can."""
    words = escaping.printable_text(text)
    changed: dict[str, Any] = copy.deepcopy({**record, "ignored": [escaping.printable_name(text)]})
    changed["speed"] = {"largest_error": None, "otherwise": f"at {words}"}
    for part in changed["parts"]:
        part["message"] = words
        for check in part["checks"]:
            check["message"] = "" if check["passed"] else words
            if check.get("shown"):
                check["shown"]["sentence"] = check["shown"]["input"] = words
    return changed


@pytest.fixture(autouse=True)
def classroom50(monkeypatch: pytest.MonkeyPatch) -> None:
    """What its runner sets."""
    for name in ("CLASSROOM", "ASSIGNMENT", "COMMIT_URL", "RELEASE_URL"):
        monkeypatch.setenv(name, name.lower())
    monkeypatch.setenv("SUBMISSION_TAG", "submit/1")


def test_classroom_50_gets_whole_numbers(
    record: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    check = record["parts"][0]["checks"][0]
    check["max_score"] += 0.5
    check["score"] = check["max_score"] if check["passed"] else 0
    result = json.loads(formats.render("classroom50", record, NOWHERE))
    assert result["schema"] == "classroom50/result/v1" and result["submission"] == "submit/1"
    assert result["review"] == "commit_url"
    for one in (result, *result["tests"]):
        assert type(one["score"]) is int and type(one["max-score"]) is int
    assert result["max-score"] == 201
    assert result["score"] == sum(test["score"] for test in result["tests"])
    monkeypatch.delenv("CLASSROOM")
    with pytest.raises(UsageError, match="CLASSROOM isn't set"):
        formats.render("classroom50", record, NOWHERE)


@given(TEXTS)
@example("##[group]a\n::error::b")
@example("a##[add-mask]b\n  ::stop-commands::x")
def test_nothing_that_is_printed_is_a_command_in_a_log(text: str) -> None:
    record = hostile(json.loads((FOLDER / "record.json").read_text()), text)
    for name in formats.NAMES:
        printed = formats.render(name, record, NOWHERE)
        ours = printed.split("\n") if name == "github" else []
        assert odd_texts.commands_in(printed) == ours, name
        refused = formats.refused(name, escaping.printable_text(text))
        assert odd_texts.commands_in(refused) == ([refused] if ours else []), name
    shown = "\n".join(line for _, line in terminal.lines(record))
    assert odd_texts.commands_in(shown) == []


def test_a_name_that_a_template_lacks_is_an_error() -> None:
    with pytest.raises(Exception, match="'title' is undefined"):
        fill("formats/page.html.j2")


def test_json_is_the_record_itself(record: dict[str, Any]) -> None:
    assert json.loads(formats.render("json", record, NOWHERE)) == record


# gradescope-autograders.readthedocs.io/en/latest/specs: the fields and their values.
def an_object(properties: dict[str, Any], *required: str) -> dict[str, Any]:
    known = {"properties": properties, "additionalProperties": False}
    return {"type": "object", "required": list(required), **known}


def a_list(items: dict[str, Any]) -> dict[str, Any]:
    return {"type": "array", "items": items}


VISIBILITY = {"enum": ["hidden", "after_due_date", "after_published", "visible"]}
FORMAT = {"enum": ["text", "html", "simple_format", "md", "ansi"]}
NUMBER, STRING = {"type": "number"}, {"type": "string"}
OUTPUT = {"output": STRING, "output_format": FORMAT, "visibility": VISIBILITY}
TEST = OUTPUT | {"score": NUMBER, "max_score": NUMBER, "status": {"enum": ["passed", "failed"]}}
TEST |= {"name": STRING, "name_format": FORMAT, "number": STRING, "tags": a_list(STRING)}
ROW = {"name": STRING, "value": {"type": ["number", "string"]}, "order": {"enum": ["asc", "desc"]}}
RESULT = OUTPUT | {"score": NUMBER, "execution_time": NUMBER, "extra_data": {"type": "object"}}
RESULT |= dict.fromkeys(("test_output_format", "test_name_format"), FORMAT)
RESULT["stdout_visibility"] = VISIBILITY
RESULT |= {"tests": a_list(an_object(TEST)), "leaderboard": a_list(an_object(ROW, "name", "value"))}
GRADESCOPE = an_object(RESULT, "tests")


def test_gradescope_gets_its_fields_and_the_right_sum(record: dict[str, Any]) -> None:
    jsonschema = pytest.importorskip("jsonschema")
    result = json.loads(formats.render("gradescope", record, NOWHERE))
    jsonschema.validate(result, GRADESCOPE)
    assert "score" not in result  # it would override the sum
    assert sum(test["score"] for test in result["tests"]) == record["score"]
    assert sum(test["max_score"] for test in result["tests"]) == record["max_score"]
    assert [row["name"] for row in result["leaderboard"]] == ["Points"]
    jsonschema.validate(json.loads(formats.refused("gradescope", "it is empty")), GRADESCOPE)


def test_only_right_answers_compete_in_speed_and_accuracy(record: dict[str, Any]) -> None:
    right = {**record, "score": record["max_score"]}
    rows = json.loads(formats.render("gradescope", right, NOWHERE))["leaderboard"]
    names = [row["name"] for row in rows]
    assert names == ["Points", "Time over the solution's", "Largest error"]


def test_prairielearn_gets_a_share_and_points_for_every_test(record: dict[str, Any]) -> None:
    result = json.loads(formats.render("prairielearn", record, NOWHERE))
    assert result["gradable"] is True and result["score"] == pytest.approx(0.32)
    assert all({"points", "max_points", "name"} <= test.keys() for test in result["tests"])
    points = sum(test["points"] for test in result["tests"])
    most = sum(test["max_points"] for test in result["tests"])
    assert points / most == pytest.approx(result["score"])
    assert json.loads(formats.refused("prairielearn", "it is empty")) == {
        "gradable": False,
        "format_errors": ["it is empty"],
    }


def test_autolab_finds_the_scores_in_the_last_line(record: dict[str, Any]) -> None:
    lines = formats.render("autolab", record, NOWHERE).splitlines()
    scores = json.loads(lines[-1])["scores"]
    assert scores == {part["stem"]: part["score"] for part in record["parts"]}
    shown = json.loads(lines[-2])
    assert shown["_presentation"] == "semantic" and len(lines) == 2
    for stage in shown["stages"]:
        assert all(isinstance(test["passed"], bool) for test in shown[stage].values())


def test_junit_is_read_by_another_reader(record: dict[str, Any], tmp_path: Path) -> None:
    junitparser = pytest.importorskip("junitparser")
    path = tmp_path / "report.xml"
    path.write_text(formats.render("junit", record, NOWHERE))
    suites = list(junitparser.JUnitXml.fromfile(str(path)))
    assert [suite.name for suite in suites] == [part["stem"] for part in record["parts"]]
    failed = {
        f"{case.classname.split('_')[0]}.{case.name}"
        for suite in suites
        for case in suite
        if case.result
    }
    checks = [check for part in record["parts"] for check in part["checks"]]
    assert failed == {check["id"] for check in checks if not check["passed"]}
    for suite in suites:
        kinds = [type(result).__name__ for case in suite for result in case.result]
        counts = (suite.tests, suite.failures, suite.errors)
        assert counts == (len(list(suite)), kinds.count("Failure"), kinds.count("Error"))


def commands(text: str) -> list[tuple[str, dict[str, str], str]]:
    """As actions/runner reads them (ActionCommand.TryParseV2): "::name k=v,k=v::data"."""

    def unescaped(escaped: str, *codes: str) -> str:
        for code in (*codes, "%0D", "%0A", "%25"):
            escaped = escaped.replace(code, chr(int(code[1:], 16)))
        return escaped

    matches = [re.fullmatch(r"::(\w+) ?([^:]*)::(.*)", line) for line in text.split("\n")]
    assert all(matches), text
    return [
        (
            match[1],
            {
                name: unescaped(value, "%3A", "%2C")
                for name, value in (pair.split("=", 1) for pair in match[2].split(",") if pair)
            },
            unescaped(match[3]),
        )
        for match in filter(None, matches)
    ]


def test_github_annotates_the_students_lines(record: dict[str, Any]) -> None:
    found = commands(formats.render("github", record, NOWHERE))
    assert [kind for kind, _, _ in found] == ["warning", *["error"] * 3, *["notice"] * 2]
    _, where, said = found[1]
    assert (where["file"], where["line"], where["col"]) == ("src/part2_lcp.cpp", "12", "5")
    assert where["title"] == "Part 2: 0 / 30" and said.endswith("'mu', 100%")
    assert found[2][1]["line"] == "21"
    assert found[4][1:] == ({"title": "Autograding complete"}, "Points 32/100")
    assert json.loads(found[5][2]) == {"totalPoints": 32, "maxPoints": 100}


def test_a_forged_notice_stays_within_its_line(record: dict[str, Any]) -> None:
    forged = "got 1\n::notice title=Autograding report::{}\r\n%0A::error::x"
    record["parts"][0]["message"] = forged
    found = commands(formats.render("github", record, NOWHERE))
    assert len(found) == 6
    assert "::notice title=Autograding report::{}" in found[0][2]


def test_github_finds_the_file_where_the_repository_has_it(
    record: dict[str, Any], tmp_path: Path
) -> None:
    write(tmp_path, {"hw/src/part3_step.cpp": b"", "hw/src/part1_contacts.cpp": b""})
    found = commands(github.render(record, tmp_path))
    assert found[0][1]["file"] == "hw/src/part1_contacts.cpp"
    assert found[2][1]["file"] == "hw/src/part3_step.cpp"


@pytest.mark.parametrize("folder", ["my hw", "my hw (v2)", "a%b", "été/a b/c"])
def test_github_finds_a_file_whose_folder_has_an_unusual_sign(
    record: dict[str, Any], tmp_path: Path, folder: str
) -> None:
    """A message's path is cut off there."""
    write(tmp_path, {f"{folder}/part2_lcp.cpp": b"", "my_part2_lcp.cpp": b""})
    record["parts"][1]["message"] = f"{folder}/part2_lcp.cpp:7: Assertion `a' failed"
    found = commands(github.render(record, tmp_path))
    assert (found[1][1]["file"], found[1][1]["line"]) == (f"{folder}/part2_lcp.cpp", "7")


def test_github_is_pointed_at_no_file_that_was_not_handed_in(
    record: dict[str, Any], tmp_path: Path
) -> None:
    write(tmp_path, {"part1_contacts.cpp": b"", "part2_lcp.cpp": b"", "helper.hpp": b""})
    record["parts"][1]["message"] = "kit/judge.cpp:7: Assertion `forged' failed"
    record["parts"][2]["message"] = "a crash, at helper.hpp:5"
    found = commands(github.render(record, tmp_path))
    assert (found[1][1]["file"], found[1][1]["line"]) == ("part2_lcp.cpp", "1")
    assert (found[2][1]["file"], found[2][1]["line"]) == ("helper.hpp", "5")
    files = {test["name"][0]: test["filename"] for test in reported(record, tmp_path)["tests"]}
    assert (files["2"], files["3"]) == ("part2_lcp.cpp", "helper.hpp")


def test_github_lists_the_repository_once_and_unpacks_nothing(
    record: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """This takes no time of the grading's: a commit of 20 KB took minutes, unpacked for each
    place that its messages named."""
    opened: list[Path] = []

    def counted(path: Path, *more: Any) -> Any:
        opened.append(path)
        return listing(path, *more)

    listing = folders.opened
    monkeypatch.setattr(folders, "opened", counted)
    monkeypatch.setattr(zips, "opened", counted)
    write(tmp_path, {"hw.zip": (ROOT / "LICENSE").read_bytes()})
    for part in record["parts"]:
        for check in part["checks"]:
            check["message"] = "see elsewhere.cpp:1"
    github.render(record, tmp_path)
    assert opened == [tmp_path]
    github.reporter_result(record, tmp_path)
    assert opened == [tmp_path] * 2


def test_a_submission_that_cannot_be_read_is_an_error_and_no_points() -> None:
    found = commands(formats.refused("github", "x is empty: hand in the parts"))
    assert found == [("error", {"title": "Not graded"}, "x is empty: hand in the parts")]
    assert formats.refused("junit", "x") == formats.refused(None, "x") == ""


def reported(
    record: dict[str, Any], root: Path = NOWHERE, pass_score: float = 0.0
) -> dict[str, Any]:
    result: dict[str, Any] = json.loads(
        base64.b64decode(github.reporter_result(record, root, pass_score))
    )
    return result


def test_the_reporter_adds_up_the_points_of_checks(record: dict[str, Any]) -> None:
    """As autograding-grading-reporter does: the sum of the tests' scores, out of max_score. Each
    test passes or fails as a whole, and so is one check."""
    result = reported(record)
    assert result["version"] == 1 and result["max_score"] == 100
    assert sum(test["score"] for test in result["tests"]) == 32
    checks = [check for part in record["parts"] for check in part["checks"]]
    assert [(t["status"] == "pass", t["score"]) for t in result["tests"]] == [
        (check["passed"], check["score"]) for check in checks
    ]
    second = next(test for test in result["tests"] if test["name"].startswith("2.1 "))
    assert (second["filename"], second["line_no"]) == ("src/part2_lcp.cpp", 12)


@pytest.mark.parametrize("pass_score, status", [(0, "pass"), (32, "pass"), (32.5, "fail")])
def test_the_reporter_fails_the_job_only_below_the_score_that_is_enough(
    record: dict[str, Any], pass_score: float, status: str
) -> None:
    assert reported(record, NOWHERE, pass_score)["status"] == status


def test_a_step_of_a_workflow_hands_on_its_result(
    record: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("GITHUB_OUTPUT", str(tmp_path / "output"))
    monkeypatch.setenv("GITHUB_STEP_SUMMARY", str(tmp_path / "summary"))
    formats.render("github", record, NOWHERE)
    lines = (tmp_path / "output").read_text().splitlines()
    assert lines == [f"result={github.reporter_result(record)}", "score=32"]
    assert (tmp_path / "summary").read_text().startswith("## 32 / 100 points")


def test_markdown_keeps_a_message_in_its_block(record: dict[str, Any]) -> None:
    message = "got\n````\n<script>alert(1)</script> @everyone [x](http://y) | <!-- -->"
    record["parts"][0]["checks"][0]["message"] = message
    record["parts"][0]["message"] = message
    text = formats.render("markdown", record, NOWHERE)
    outside = re.sub(r"(`{3,})text\n.*?\n\1", "", text, flags=re.DOTALL)
    assert "<script>" not in outside and "@everyone" not in outside
    assert r"\[x\]\(http" in outside and "<!--" not in outside


def test_a_long_report_stays_below_what_github_takes(record: dict[str, Any]) -> None:
    for part in record["parts"]:
        for check in part["checks"]:
            check["passed"], check["message"] = False, "x" * 20_000
    text = formats.render("markdown", record, NOWHERE)
    assert len(text) < 65_536 and text.endswith("More checks failed than there is room for.\n")


@pytest.mark.parametrize(
    "message, place",
    [
        ("part3_step.cpp:12:5: expected ';'", ("part3_step.cpp", 12, 5)),
        ("a crash, at src/part3_step.cpp:21", ("src/part3_step.cpp", 21, None)),
        ("part3_step.cpp:3 uses rotation(double)", ("part3_step.cpp", 3, None)),
    ],
)
def test_a_place_is_found_in_a_message(message: str, place: tuple[str, int, int | None]) -> None:
    found = sentences.place_in(message)
    assert found and (found.file, found.line, found.column) == place


def test_no_place_is_found_where_there_is_none() -> None:
    assert sentences.place_in("got phi = 1.5:2, nothing.cpp") is None


def test_two_equations_are_both_named() -> None:
    place = sentences.where_to_read({"equations": [5, 6], "hint": "1.2 The moment arm r"})
    assert place == "eqs. (5), (6) and hint 1.2 The moment arm r"


def kit(*arguments: str, **environment: str) -> "subprocess.CompletedProcess[str]":
    command = [str(ROOT / "kit"), *arguments]
    variables = {**os.environ, **environment}
    return subprocess.run(command, env=variables, capture_output=True, text=True, check=False)


def test_the_command_prints_a_format_and_keeps_its_status(tmp_path: Path) -> None:
    done = kit("grade", str(SOLUTION), "--format", "gradescope", "--min-score", "100")
    assert done.returncode == 0
    assert sum(test["score"] for test in json.loads(done.stdout)["tests"]) == 100
    empty = tmp_path / "empty"
    empty.mkdir()
    done = kit("grade", str(empty), "--format", "gradescope")
    assert done.returncode == 2 and "is empty" in json.loads(done.stdout)["output"]
    done = kit("grade", str(empty), "--format", "autolab")
    assert done.returncode == 2 and done.stdout == ""
    done = kit("grade", str(SOLUTION), "--format", "junit", "--json", "-")
    assert done.returncode == 2 and "give one" in done.stderr


def test_a_file_of_any_name_is_looked_for(tmp_path: Path) -> None:
    write(tmp_path, {"src/part1_contacts.cpp": b"", "part2_lcp.cpp": b"", "old/part2_lcp.cpp": b""})
    files = github._files(tmp_path)
    assert github._in_repository("part1_contacts.cpp", files) == "src/part1_contacts.cpp"
    assert github._in_repository("part2_lcp.cpp", files) == "part2_lcp.cpp"
    for name in ("nothing.cpp", f"{'a' * 300}.cpp", "../../etc/a.cpp"):
        assert github._in_repository(name, files) == name
