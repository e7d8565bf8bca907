"""The answer of a hidden case is shown where that is asked for, and nowhere else."""

import json
from pathlib import Path
from typing import Any

import pytest
from bounce_grader import cli
from bounce_grader.formats import html
from bounce_grader.grading import fixtures
from bounce_grader.grading.record import with_answers, without_answers
from conftest import ROOT, solution_files, write

PHI = "part1.MeasuresTheHeightOfTheLowestCorner"


def wrong_only_on_hidden_cases() -> bytes:
    """Part 1, right for the angles of the public cases."""
    public = (fixtures.PUBLIC / "part1_contacts.json").read_text()
    angles = [c["input"]["q"][2] for cs in json.loads(public)["checks"].values() for c in cs]
    known = " || ".join(f"q(2) == {angle!r}" for angle in angles)
    part1 = solution_files()["part1_contacts.cpp"].decode().replace("get_contacts(", "honest(")
    part1 += f"""namespace bounce {{ Contact get_contacts(const Vector3& q, const Parameters& p) {{
        Contact c = honest(q, p); if (!({known})) c.phi += 0.25; return c; }} }}"""
    return part1.encode()


def checks(record: dict[str, Any]) -> dict[str, dict[str, Any]]:
    return {check["id"]: check for part in record["parts"] for check in part["checks"]}


def test_the_answer_of_a_hidden_case_is_shown_only_where_that_is_asked_for(tmp_path: Path) -> None:
    files = {**solution_files(), "part1_contacts.cpp": wrong_only_on_hidden_cases()}
    folder = write(tmp_path / "submission", files)
    records = []
    for reveal in (False, True):
        options = ["--reveal"] if reveal else []
        assert (
            cli.main(
                ["grade", str(folder), "--no-sanitize", "--json", str(tmp_path / "out"), *options]
            )
            == 0
        )
        records.append(json.loads((tmp_path / "out").read_text()))
    closed, opened = map(checks, records)
    got = closed[PHI]["shown"]["quantities"][0]["got"][0][0]
    quantity = opened[PHI]["shown"]["quantities"][0]
    assert quantity["expected"][0][0] == pytest.approx(got - 0.25, abs=1e-9)
    assert f"expected phi = {quantity['expected'][0][0]:.6g}"[:20] in opened[PHI]["message"]
    assert "corner" in opened[PHI]["shown"]["contact"]

    assert "(a hidden case)" in closed[PHI]["message"]
    assert "expected is not shown" in closed[PHI]["message"]
    assert "contact" not in closed[PHI]["shown"]
    page = html.render(records[0])
    assert "what is right isn't shown" in page.replace("&#x27;", "'")
    assert f"{got - 0.25:.6g}" not in json.dumps(records[0]) + page
    for check in closed.values():
        assert "revealed" not in check
        assert all("expected" not in q for q in check.get("shown", {}).get("quantities", []))

    schema = json.loads((ROOT / "docs" / "record.schema.json").read_text())
    for record in records:
        pytest.importorskip("jsonschema").validate(record, schema)


def test_a_record_is_opened_and_closed_without_a_trace() -> None:
    hidden: dict[str, Any] = {"name": "x", "input": "", "sentence": "", "quantities": []}
    check: dict[str, Any] = {"id": "part1.X", "message": "closed", "shown": hidden}
    kept = {**check, "revealed": {"message": "open", "shown": {**hidden, "contact": "answer"}}}
    record = {"parts": [{"checks": [kept]}]}
    assert without_answers(record) == {"parts": [{"checks": [check]}]}
    opened = with_answers(record)["parts"][0]["checks"][0]
    assert opened == {**check, "message": "open", "shown": {**hidden, "contact": "answer"}}
    assert record["parts"][0]["checks"][0] is kept
