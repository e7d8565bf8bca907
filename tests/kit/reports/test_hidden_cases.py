"""The answer of a hidden case is shown where that is asked for, and nowhere else."""

import json
from html import escape
from pathlib import Path
from typing import Any

import pytest
from bounce_grader import cli
from bounce_grader.formats import html
from bounce_grader.grading import fixtures
from conftest import ROOT, solution_files, write

PHI = "part1.MeasuresTheHeightOfTheLowestCorner"


def wrong_only_on_hidden_cases() -> bytes:
    """Part 1, right for the angles of the public cases."""
    public = json.loads((fixtures.PUBLIC / "part1_contacts.json").read_text())["checks"]
    angles = [case["input"]["q"][2] for cases in public.values() for case in cases]
    known = " || ".join(f"q(2) == {angle!r}" for angle in angles)
    part1 = solution_files()["part1_contacts.cpp"].decode()
    return part1.replace("q(1) + r.y()", f"q(1) + r.y() + (({known}) ? 0 : 0.25)").encode()


def test_the_answer_of_a_hidden_case_is_shown_only_where_that_is_asked_for(tmp_path: Path) -> None:
    files = {**solution_files(), "part1_contacts.cpp": wrong_only_on_hidden_cases()}
    folder, out = write(tmp_path / "submission", files), tmp_path / "out"
    schema = json.loads((ROOT / "docs" / "record.schema.json").read_text())
    records, checks = [], []
    command = ["grade", str(folder), "--no-sanitize", "--json", str(out)]
    for words in (command, [*command, "--reveal"]):
        assert cli.main(words) == 0
        record: Any = json.loads(out.read_text())
        pytest.importorskip("jsonschema").validate(record, schema)
        records.append(record)
        checks.append({c["id"]: c for part in record["parts"] for c in part["checks"]})
    closed, opened = (found[PHI] for found in checks)
    got = closed["shown"]["quantities"][0]["got"][0][0]
    expected = opened["shown"]["quantities"][0]["expected"][0][0]
    assert expected == pytest.approx(got - 0.25, abs=1e-9)
    assert "yours, >wrong<    right\n" in opened["message"]
    assert f"{expected:.6g}"[:7] in opened["message"].rpartition("<")[2]
    assert "corner" in opened["shown"]["contact"] and not closed["shown"]["contact"]
    assert "(a hidden case)" in closed["message"]
    told = "the right numbers aren't shown, as the case is hidden"
    assert told in closed["message"] and "wrong<    right" not in closed["message"]
    page = html.render(records[0])
    assert escape(told) in page
    assert f"{expected:.6g}" not in json.dumps(records[0]) + page
    for check in checks[0].values():
        assert "revealed" not in check
        assert all("expected" not in q for q in check.get("shown", {}).get("quantities", []))


def test_a_program_that_is_wrong_in_one_hidden_case_alone_isnt_told_its_answer(
    tmp_path: Path,
) -> None:
    """Its input is shown, so that a program can be wrong there and nowhere else: any case that was
    made from it would have its answer, too."""
    hidden = json.loads((fixtures.hidden_folder() / "part1_contacts.json").read_text())["checks"]
    case = next(case for case in hidden[PHI] if case["name"].startswith("a square turned"))
    (_, y, theta), phi = case["input"]["q"], case["expected"]["phi"]
    part1 = solution_files()["part1_contacts.cpp"].decode()
    there = f"q(1) == {y!r} && q(2) == {theta!r}"
    part1 = part1.replace("q(1) + r.y()", f"q(1) + r.y() + ({there} ? 0.25 : 0)")
    files = {**solution_files(), "part1_contacts.cpp": part1.encode()}
    out = tmp_path / "out"
    folder = write(tmp_path / "submission", files)
    assert cli.main(["grade", str(folder), "--no-sanitize", "--json", str(out)]) == 0
    record: Any = json.loads(out.read_text())
    check = next(c for c in record["parts"][0]["checks"] if c["id"] == PHI)
    assert "(a hidden case)" in check["message"] and not check["passed"]
    assert f"{phi:.6g}" not in json.dumps(record)
