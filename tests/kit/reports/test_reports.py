"""Every report on every record of records/ is what a person has read in expected/. The records: a
mixed one, written by hand; a right one with remarks and half points; a hostile one, each of whose
texts tries to break out of its format; one with a mistake in each part, and curves; and a submission
that can't be read."""

import copy
import json
import re
from pathlib import Path
from typing import Any

import golden
import odd_texts
import pytest
from bounce_grader import cli, formats
from bounce_grader.common import escaping
from bounce_grader.formats import html, sentences, terminal
from conftest import ROOT, SOLUTION
from edits import edited
from hypothesis import example, given
from odd_texts import TEXTS

HERE = Path(__file__).parent
RECORDS: dict[str, Any] = {
    file.stem: json.loads(file.read_text()) for file in sorted((HERE / "records").glob("*.json"))
}
REFUSED = RECORDS.pop("unreadable")["refused"]
MIXED: Any = RECORDS["mixed"]
SCHEMA = json.loads((ROOT / "docs" / "record.schema.json").read_text())
ENDINGS = {"html": "html", "junit": "xml", "markdown": "md", "github": "txt"}


# --- what a person has read ---


def compare(record: str, texts: dict[str, str]) -> None:
    """Compares reports without styles."""
    for file, text in texts.items():
        text = re.sub(r"(?s)<style>.*?</style>", "<style>...</style>", text)
        texts[file] = text.rstrip("\n") + "\n"
    golden.compare(HERE / "expected" / record, texts)


@pytest.mark.golden
@pytest.mark.parametrize("name", RECORDS)
def test_reports_are_what_a_person_has_read(name: str) -> None:
    record = RECORDS[name]
    made = {f"{format}.{ENDINGS.get(format, 'json')}": format for format in formats.NAMES}
    del made["json.json"]  # the record itself
    texts = {file: formats.render(format, record) for file, format in made.items()}
    texts["html.html"] = html.render(record, "doejane", ("a.pdf is no C++ source and no zip",))
    texts["terminal.txt"] = terminal.render(record)
    compare(name, texts)
    assert json.loads(formats.render("json", record)) == record
    schema = json.loads((HERE / "gradescope.schema.json").read_text())
    pytest.importorskip("jsonschema").validate(json.loads(texts["gradescope.json"]), schema)


@pytest.mark.golden
def test_a_submission_that_cannot_be_read_is_told_where_there_is_a_place() -> None:
    made = {f"{name}.txt": formats.refused(name, REFUSED) for name in formats.NAMES}
    assert formats.refused(None, REFUSED) == ""
    compare("unreadable", {file: text for file, text in made.items() if text})


def test_what_did_not_run_comes_first_as_a_whole() -> None:
    first = sentences.first_to_do(edited(MIXED, "parts 0"))
    assert first.startswith("First: part 2, does not build: ")


# --- the record ---


def test_records_follow_the_published_schema(tmp_path: Path) -> None:
    jsonschema = pytest.importorskip("jsonschema")
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    real = tmp_path / "record.json"
    assert cli.main(["grade", str(SOLUTION), "--no-sanitize", "--speed", "--json", str(real)]) == 0
    for record in (*RECORDS.values(), json.loads(real.read_text())):
        jsonschema.validate(record, SCHEMA)
    wrong = ('score = "32"', 'box = "x"', "parts = []", 'submission_sha256 = "5"')
    for edit in (*wrong, 'speed = {"ratio": 2}'):
        with pytest.raises(jsonschema.ValidationError):
            jsonschema.validate(edited(MIXED, edit), SCHEMA)


# --- whatever a submission says ---


def saying(record: Any, text: str) -> Any:
    """The record of a submission that puts this text wherever it can."""
    words = escaping.printable_text(text)
    changed: Any = copy.deepcopy({**record, "ignored": [escaping.printable_name(text)]})
    changed["speed"] = {"largest_error": None, "otherwise": f"at {words}"}
    for part in changed["parts"]:
        part["message"] = words
        for check in part["checks"]:
            check["message"] = "" if check["passed"] else words
            if check.get("shown"):
                check["shown"]["sentence"] = check["shown"]["name"] = words
    return changed


@given(TEXTS)
@example("##[group]a\n::error::b")
@example("a##[add-mask]b\n  ::stop-commands::x")
def test_nothing_that_is_printed_is_a_command_in_a_log(text: str) -> None:
    record = saying(MIXED, text)
    for name in formats.NAMES:
        printed = formats.render(name, record)
        ours = printed.split("\n") if name == "github" else []
        assert odd_texts.commands_in(printed) == ours, name
        refused = formats.refused(name, escaping.printable_text(text))
        assert odd_texts.commands_in(refused) == ([refused] if ours else []), name
    assert odd_texts.commands_in(terminal.render(record)) == []


def test_a_long_report_stays_below_what_github_takes() -> None:
    record = saying(MIXED, "x" * 20_000)
    text = formats.render("markdown", record)
    assert len(text) < 65_536 and text.endswith("More checks failed than there is room for.")


def test_a_step_of_a_workflow_hands_on_its_score_and_a_summary(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("GITHUB_OUTPUT", str(tmp_path / "output"))
    monkeypatch.setenv("GITHUB_STEP_SUMMARY", str(tmp_path / "summary"))
    formats.render("github", MIXED)
    assert (tmp_path / "output").read_text() == "score=32\n"
    summary = (tmp_path / "summary").read_text()
    assert summary == formats.render("markdown", MIXED) + "\n"
