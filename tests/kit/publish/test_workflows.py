"""docs/workflows: what GitHub, GitLab and Classroom 50 run keeps the kit, its secret and its tokens
from the submissions."""

import json
import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any

import pytest
from bounce_grader.grading.grade import grade
from bounce_grader.publish import handout
from conftest import ROOT, write

yaml = pytest.importorskip("yaml")
WORKFLOWS = ROOT / "docs" / "workflows"
GITHUB = (WORKFLOWS / "github.yml").read_text()
GITLAB = (WORKFLOWS / "gitlab.yml").read_text()
(STEPS,) = (job["steps"] for job in yaml.safe_load(GITHUB)["jobs"].values())
JOB = yaml.safe_load(GITLAB)["grade"]
AUTOGRADER = WORKFLOWS / "classroom50" / "autograder.py"
SCHEMA = Path(__file__).with_name("classroom50.schema.json")
IDENTITY = ("-c", "user.name=a", "-c", "user.email=a@example.org")


def test_githubs_workflow_keeps_its_secrets_from_the_grading() -> None:
    graded = next(step for step in STEPS if step.get("name") == "Grade")
    assert graded["run"].startswith("kit/kit grade submission --format github --min-score 70")
    assert "env" not in graded
    uses = [step.get("uses", step.get("name", "")) for step in STEPS]
    saved = next(i for i, use in enumerate(uses) if use.startswith("actions/cache/save"))
    secret = next(i for i, step in enumerate(STEPS) if "course-secret" in step.get("run", ""))
    assert saved < secret < STEPS.index(graded)  # no cache holds the secret
    checkouts = [step for step in STEPS if step.get("uses", "").startswith("actions/checkout")]
    assert checkouts and all(not step["with"]["persist-credentials"] for step in checkouts)


def test_a_students_files_stay_apart_from_the_kit_on_gitlab(tmp_path: Path) -> None:
    """Runs the script with the kit replaced by a program that shows what lies beside it."""
    assert JOB["variables"]["GIT_STRATEGY"] == "none"
    # Variables of a pipeline come before the job's own: with another KIT, its token goes elsewhere.
    assert "ci_pipeline_variables_minimum_override_role=no_one_allowed" in GITLAB
    victim = tmp_path / "victim"
    victim.write_text("whole")
    kit = write(tmp_path / "kit_there", {"kit": b"#!/bin/sh\nls ${0%/*} ${0%/*}/grader\n"})
    (kit / "kit").chmod(0o755)
    student = write(tmp_path / "student", {".kit/grader/argparse.py": b"", "src/part1.cpp": b""})
    (student / "report.xml").symlink_to(victim)
    for folder in (kit, student):
        for words in (["init", "-q"], ["add", "-f", "."], ["commit", "-qm", "all"]):
            subprocess.run(["git", *IDENTITY, *words], cwd=folder, check=True)
    project = tmp_path / "project"
    for _ in range(2):  # the second time with what the first has kept
        project.mkdir(exist_ok=True)
        script = "\n".join(line for line in JOB["script"] if not line.startswith("apt-get"))
        script = script.replace("https://oauth2:$KIT_TOKEN@$KIT", str(kit))
        script = script.replace("/srv/", f"{tmp_path}/srv/")
        (tmp_path / "srv" / "kit" / "build").mkdir(parents=True, exist_ok=True)
        script = script.replace("&& cp -a .kit", "&& mkdir -p .kit/build && cp -a .kit")
        environment = {
            **os.environ,
            "CI_PROJECT_DIR": str(project),
            "CI_REPOSITORY_URL": str(student),
            "CI_COMMIT_SHA": "HEAD",
            "BOUNCE_COURSE_SECRET": "secret",
        }
        subprocess.run(["bash", "-e"], input=script.encode(), cwd=project, env=environment)
        assert (tmp_path / "srv" / "submission" / "src" / "part1.cpp").exists()
        assert not (tmp_path / "srv" / "kit" / "grader").exists()
        assert "kit" in (project / "report.xml").read_text()
        assert not (project / "report.xml").is_symlink() and victim.read_text() == "whole"


def graded_by_classroom50(bundle: Path, checkout: Path) -> Any:
    """The result, which has what its collecting script demands, beside what its runner adds."""
    words = {"CLASSROOM": "cs1", "ASSIGNMENT": "bounce", "SUBMISSION_TAG": "submit/1"}
    words |= {"GH_TOKEN": "secret", "COMMIT_URL": "https://x", "RELEASE_URL": "https://x"}
    command = [sys.executable, str(bundle / "autograder.py")]
    subprocess.run(command, cwd=checkout, env={**os.environ, **words}, check=True, timeout=900)
    result = json.loads((checkout / "result.json").read_text())
    pytest.importorskip("jsonschema").validate(result, json.loads(SCHEMA.read_text()))
    assert all(one["score"] <= one["max-score"] for one in (result, *result["tests"]))
    return result


@pytest.mark.long
def test_classroom_50_takes_the_result_of_its_autograder(tmp_path: Path) -> None:
    """One part right, one that doesn't compile, and two that are stubs."""
    bundle, checkout = tmp_path / "bundle", tmp_path / "checkout"
    (checkout / "src").mkdir(parents=True)
    bundle.mkdir()
    shutil.copy(AUTOGRADER, bundle)
    handout.write(bundle / "bounce.zip")
    for file in (ROOT / "student" / "src").glob("*.cpp"):
        shutil.copy(file, checkout / "src")
    shutil.copy(ROOT / "solution" / "src" / "part1_contacts.cpp", checkout / "src")
    (checkout / "src" / "part2_lcp.cpp").write_text("#error")
    result = graded_by_classroom50(bundle, checkout)
    assert (result["score"], result["max-score"]) == (30, 100)
    # One mistake in part 1, which parts 3 and 4 call: it is paid for once, as ./kit grade does.
    wrong = ROOT / "tests/submissions/mistakes/part1_highest_corner"
    for folder in (ROOT / "solution" / "src", wrong):
        shutil.copytree(folder, checkout / "src", dirs_exist_ok=True)
    result = graded_by_classroom50(bundle, checkout)
    assert result["score"] == grade(checkout)["score"] < 100
    with zipfile.ZipFile(bundle / "bounce.zip") as archive:
        assert not any("hidden" in name or "solution" in name for name in archive.namelist())


# In place of ./check: its check passes if the process that started it holds no token.
LOOKS = """#!/bin/sh
passed=false
grep -aq PATH /proc/$PPID/environ && ! grep -aq GH_TOKEN /proc/$PPID/environ && passed=true
echo '{"parts": [{"checks": [{"id": "part1.A", "passed": '$passed'}]}]}' > "$2"
"""


def test_classroom_50s_autograder_hands_on_no_token_and_follows_no_link(tmp_path: Path) -> None:
    part = {"part": 1, "stem": "part1", "checks": [{"id": "part1.A", "title": "a", "points": 1}]}
    handout_of_one = {
        "check": LOOKS,
        "src/part1.cpp": "",
        "tests/parts.json": json.dumps({"parts": [part]}),
    }
    shutil.copy(AUTOGRADER, tmp_path)
    with zipfile.ZipFile(tmp_path / "bounce.zip", "w") as archive:
        for name, text in handout_of_one.items():
            archive.writestr(f"bounce/{name}", text)
    checkout = write(tmp_path / "checkout", {"part1.cpp": b""})
    victim = tmp_path / "victim"
    victim.write_text("whole")
    (checkout / "result.json").symlink_to(victim)
    result = graded_by_classroom50(tmp_path, checkout)
    assert victim.read_text() == "whole" and not (checkout / "result.json").is_symlink()
    assert result["score"] == 1
