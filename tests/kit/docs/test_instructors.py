"""docs/instructors.md: runs its commands as they are written, and checks the files that it
names."""

import csv
import json
import os
import re
import shutil
import stat
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any

import pytest
from bounce_grader.classroom.intake import adjustments, course, roster
from bounce_grader.develop import synthetic_class
from bounce_grader.publish import gradescope, handout
from conftest import ROOT, solution_files, write

PAGE = (ROOT / "docs" / "instructors.md").read_text()
WORKFLOW = ROOT / "docs" / "workflows" / "github.yml"
COMMANDS = [line.strip() for line in PAGE.splitlines() if line.startswith("    ")]
IDENTITY = ("-c", "user.name=a", "-c", "user.email=a@example.org")
NOT_HERE = ("SCHEDULER", "course-secret", "./kit fixtures")  # a cluster; this course's own secret


@pytest.fixture
def place(tmp_path: Path) -> Path:
    """The folders that the page's paths refer to: the kit's folder, and ../hw3 beside it."""
    here = tmp_path / "kit"
    here.mkdir()
    wrapper = here / "kit"
    wrapper.write_text(f'#!/bin/sh\nexec "{ROOT}/kit" "$@"\n')
    wrapper.chmod(0o755)
    (here / "solution").symlink_to(ROOT / "solution")
    write(tmp_path / "hw3" / "2025" / "somebody", solution_files())
    made = [synthetic_class.Made(12, "Doe, Jane", "solution", solution_files(), 100)]
    synthetic_class.canvas_zip(tmp_path / "hw3" / "submissions.zip", made)
    export = synthetic_class.gradebook_csv(made).replace("Final Score", "HW3 part 1 (98766)")
    export = export.replace("(read only)", "30.00").replace("81.20", "")
    (tmp_path / "hw3" / "export.csv").write_text(export)
    return here


def test_the_commands_run_in_their_order(place: Path) -> None:
    ran = []
    for command in COMMANDS:
        if any(word in command for word in NOT_HERE):
            continue
        done = subprocess.run(
            command, shell=True, cwd=place, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, f"{command}\n{done.stdout}{done.stderr}"
        ran.append(command)
    assert len(ran) >= 8
    out = place.parent / "hw3" / "out"
    rows = list(csv.reader((out / "gradebook.csv").open()))
    assert rows[0][0] == "Student"
    named = re.findall(r"`([\w./][\w./-]*)`", PAGE.split("| file | what |")[1].split("\n\n")[0])
    assert len(named) == 10
    for name in [*named, "results-1"]:
        if name == "feedback-new.zip":  # no page has changed here
            continue
        assert (out / name).exists(), name
    assert (place.parent / "hw3" / "cluster" / "slurm" / "1" / "submit.sh").exists()


def test_the_grade_book_of_the_page_has_the_points(place: Path) -> None:
    command = next(c for c in COMMANDS if "--part-column" in c)
    subprocess.run(command, shell=True, cwd=place, check=True, capture_output=True)
    rows = list(csv.reader((place.parent / "hw3" / "out" / "gradebook.csv").open()))
    assert rows[2][0] == "Doe, Jane" and rows[2][6:] == ["100.00", "30.00"]


def test_the_files_of_the_page_are_read(tmp_path: Path) -> None:
    blocks = re.findall(r"^```(csv|toml)\n(.*?)^```$", PAGE, re.M | re.S)
    names = ["roster.csv", "course.toml", "adjustments.csv"]
    assert [kind for kind, _ in blocks] == ["csv", "toml", "csv"]
    for name, (_, text) in zip(names, blocks):
        (tmp_path / name).write_text(text)
    assert roster.read(tmp_path) and course.read(tmp_path).percent_per_day == 10
    assert len(adjustments.read(tmp_path)) == 4


def test_the_secret_is_made_as_grading_says() -> None:
    grading = (ROOT / "docs" / "grading.md").read_text()
    line = next(c for c in COMMANDS if "> course-secret" in c)
    assert line in grading


def test_links_lead_somewhere() -> None:
    for target in re.findall(r"\]\(([^)#]+)\)", PAGE):
        assert (ROOT / "docs" / target).exists(), target


def steps_of(file: Path) -> list[dict[str, Any]]:
    yaml = pytest.importorskip("yaml")
    (job,) = yaml.safe_load(file.read_text())["jobs"].values()
    steps: list[dict[str, Any]] = job["steps"]
    assert job["runs-on"] == "ubuntu-24.04"
    return steps


def test_the_workflow_keeps_its_secrets_from_the_grading() -> None:
    steps = steps_of(WORKFLOW)
    graded = next(step for step in steps if step.get("name") == "Grade")
    assert graded["run"].startswith("kit/kit grade submission --format github --min-score 70")
    assert "env" not in graded
    uses = [step.get("uses", step.get("name", "")) for step in steps]
    saved = next(i for i, use in enumerate(uses) if use.startswith("actions/cache/save"))
    secret = next(i for i, step in enumerate(steps) if "course-secret" in step.get("run", ""))
    assert saved < secret < steps.index(graded)  # no cache holds the secret
    checkouts = [step for step in steps if step.get("uses", "").startswith("actions/checkout")]
    assert all(not step["with"]["persist-credentials"] for step in checkouts)


def test_what_a_workflow_uses_is_pinned() -> None:
    """A tag can be moved to another commit. The version stands beside the digest."""
    for file in (WORKFLOW, ROOT / ".github" / "workflows" / "test.yml"):
        uses = re.findall(r"uses: (.*)", file.read_text())
        assert uses
        for used in uses:
            assert re.match(r"[\w/-]+@[0-9a-f]{40} # v\d+\.\d+\.\d+", used), used
    flow = (ROOT / "docs" / "workflows" / "gitlab.yml").read_text()
    assert re.search(r"^  image: ubuntu:24.04@sha256:[0-9a-f]{64}$", flow, re.MULTILINE)


@pytest.mark.parametrize("name", ["github.yml", "gitlab.yml"])
def test_the_scripts_of_a_workflow_are_shell(name: str) -> None:
    yaml = pytest.importorskip("yaml")
    flow = yaml.safe_load((ROOT / "docs" / "workflows" / name).read_text())
    jobs = [step.get("run", "") for step in steps_of(WORKFLOW)] if name == "github.yml" else []
    for script in jobs or flow["grade"]["script"]:
        text = re.sub(r"\$\{\{.*?\}\}", "x", script)
        assert subprocess.run(["bash", "-n"], input=text.encode(), check=False).returncode == 0


def test_a_students_files_stay_apart_from_the_kit_on_gitlab(tmp_path: Path) -> None:
    """Runs the script with the kit replaced by a program that shows what lies beside it."""
    yaml = pytest.importorskip("yaml")
    job = yaml.safe_load((ROOT / "docs" / "workflows" / "gitlab.yml").read_text())["grade"]
    assert job["variables"]["GIT_STRATEGY"] == "none"
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
        script = "\n".join(line for line in job["script"] if not line.startswith("apt-get"))
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


def test_what_would_open_a_job_on_gitlab_to_its_developer_is_named() -> None:
    """Variables of a pipeline come before the job's own: with another KIT, its token goes
    elsewhere. A terminal has them all."""
    flow = (ROOT / "docs" / "workflows" / "gitlab.yml").read_text()
    assert "ci_pipeline_variables_minimum_override_role=no_one_allowed" in flow
    for text in (flow.replace('"', "*"), PAGE):
        assert "*Minimum role to use pipeline variables*" in text and "*No one allowed*" in text
        assert "[session_server]" in text


def test_the_kits_own_tests_run_on_every_system_that_it_promises() -> None:
    yaml = pytest.importorskip("yaml")
    flow = yaml.safe_load((ROOT / ".github" / "workflows" / "test.yml").read_text())
    lab = yaml.safe_load((ROOT / ".gitlab-ci.yml").read_text())
    images = flow["jobs"]["test"]["strategy"]["matrix"]["image"]
    assert images == lab["test"]["parallel"]["matrix"][0]["IMAGE"]
    assert images == ["debian:12", "debian:13", "ubuntu:22.04", "ubuntu:24.04"]
    assert "./kit test" in [step.get("run") for step in flow["jobs"]["test"]["steps"]]


def accepted_by_classroom50(result: Any, classroom: str, assignment: str) -> None:
    """What its collecting script demands of a result, beside what its runner adds."""
    assert result["schema"] == "classroom50/result/v1"
    assert (result["classroom"], result["assignment"]) == (classroom, assignment)
    assert result["submission"].startswith("submit/")
    for field in ("submission", "commit", "release", "review", "datetime"):
        assert isinstance(result[field], str) and result[field], field
    for scored in (result, *result["tests"]):
        score, most = scored["score"], scored["max-score"]
        assert type(score) is int and type(most) is int and 0 <= score <= most
    for test in result["tests"]:
        assert type(test["passed"]) is bool and isinstance(test["test-name"], str)
        assert test["test-name"]


@pytest.mark.long
def test_classroom_50_takes_the_result_of_its_autograder(tmp_path: Path) -> None:
    """One part right, one that doesn't compile, and two that are stubs."""
    bundle, checkout = tmp_path / "bundle", tmp_path / "checkout"
    (checkout / "src").mkdir(parents=True)
    bundle.mkdir()
    shutil.copy(ROOT / "docs" / "workflows" / "classroom50" / "autograder.py", bundle)
    handout.write(bundle / "bounce.zip")
    for file in (ROOT / "student" / "src").glob("*.cpp"):
        shutil.copy(file, checkout / "src")
    shutil.copy(ROOT / "solution" / "src" / "part1_contacts.cpp", checkout / "src")
    (checkout / "src" / "part2_lcp.cpp").write_text("#error")
    env = {**os.environ, "CLASSROOM": "cs1", "ASSIGNMENT": "bounce", "SUBMISSION_TAG": "submit/1"}
    env |= {"COMMIT_URL": "https://x/commit/1", "RELEASE_URL": "https://x/releases/1"}
    command = [sys.executable, str(bundle / "autograder.py")]
    subprocess.run(command, cwd=checkout, env=env, check=True, timeout=900)
    result = json.loads((checkout / "result.json").read_text())
    accepted_by_classroom50(result, "cs1", "bounce")
    assert (result["score"], result["max-score"]) == (30, 100)
    with zipfile.ZipFile(bundle / "bounce.zip") as archive:
        assert not any("hidden" in name or "solution" in name for name in archive.namelist())


LOOKS = r"""
#include <unistd.h>
#include <fstream>
#include <iterator>
#include <string>
int main(int, char** words) {  // passes if its parent holds no token
  std::ifstream file("/proc/" + std::to_string(getppid()) + "/environ");
  const std::string all{std::istreambuf_iterator<char>(file), {}};
  const bool found = all.find("GH_TOKEN") != std::string::npos || all.empty();
  std::ofstream(std::string(words[1]).substr(20)) << R"({"testsuites": [{"name": "part1",
    "testsuite": [{"name": "A", "failures": [)" << (found ? "1" : "") << "]}]}]}";
}
"""


def test_classroom_50s_autograder_hands_on_no_token_and_follows_no_link(tmp_path: Path) -> None:
    part = {"part": 1, "stem": "part1", "checks": [{"id": "part1.A", "title": "a", "points": 1}]}
    handout_of_one = {
        "CMakeLists.txt": "cmake_minimum_required(VERSION 3.22)\nproject(bounce CXX)\n"
        "add_executable(part1_test src/part1.cpp)\n",
        "src/part1.cpp": "",
        "tests/parts.json": json.dumps({"parts": [part]}),
    }
    script = shutil.copy(ROOT / "docs" / "workflows" / "classroom50" / "autograder.py", tmp_path)
    with zipfile.ZipFile(tmp_path / "bounce.zip", "w") as archive:
        for name, text in handout_of_one.items():
            archive.writestr(f"bounce/{name}", text)
    checkout = write(tmp_path / "checkout", {"part1.cpp": LOOKS.encode()})
    victim = tmp_path / "victim"
    victim.write_text("whole")
    (checkout / "result.json").symlink_to(victim)
    env = {**os.environ, "GH_TOKEN": "secret", "CLASSROOM": "cs1", "ASSIGNMENT": "bounce"}
    env |= {"SUBMISSION_TAG": "submit/1", "COMMIT_URL": "https://x", "RELEASE_URL": "https://x"}
    subprocess.run([sys.executable, script], cwd=checkout, env=env, check=True, timeout=300)
    assert victim.read_text() == "whole" and not (checkout / "result.json").is_symlink()
    result = json.loads((checkout / "result.json").read_text())
    accepted_by_classroom50(result, "cs1", "bounce")
    assert result["score"] == 1


def test_the_autograder_for_gradescope_grades(tmp_path: Path) -> None:
    """Unpacks it where Gradescope does, in /autograder, builds and runs it."""
    packed = tmp_path / "autograder.zip"
    for name in ("autograder.zip", "again.zip"):
        command = [str(ROOT / "kit"), "gradescope", "--out", str(tmp_path / name)]
        subprocess.run(command, check=True)
    assert packed.read_bytes() == (tmp_path / "again.zip").read_bytes()
    with zipfile.ZipFile(packed) as archive:
        names = set(archive.namelist())
        for script in ("setup.sh", "run_autograder", "kit"):
            assert archive.getinfo(script).external_attr >> 16 & 0o111
        assert archive.getinfo("course-secret").external_attr >> 16 == stat.S_IFREG | 0o600
    assert {"course-secret", "grader/parts.json", "solution/src/part1_contacts.cpp"} <= names
    assert not any(name.startswith(("build/", ".git/", "fixtures/hidden/")) for name in names)
    for script in ("setup.sh", "run_autograder"):
        with zipfile.ZipFile(packed) as archive:
            text = archive.read(script)
        assert subprocess.run(["bash", "-n"], input=text, check=False).returncode == 0


def test_the_autograder_holds_the_kit_and_nothing_that_lies_beside_it(tmp_path: Path) -> None:
    for name in gradescope.PACKED:
        if (ROOT / name).is_dir():
            write(tmp_path / name, {"x": b""})
        else:
            write(tmp_path, {name: b""})
    write(tmp_path, {"hw3/out/results/x.json": b"{}", "course-secret": b"", "a.zip": b""})
    write(tmp_path / "student/build", {"x": b""})
    packed = {f.relative_to(tmp_path) for f in gradescope._packed(tmp_path)}
    assert {file.parts[0] for file in packed} == set(gradescope.PACKED)
    assert not any("build" in file.parts for file in packed)
    sources = {file for room in ("grader", "solution") for file in (ROOT / room).rglob("*.?p*")}
    assert {f for f in sources if f.suffix in {".py", ".cpp", ".hpp"}} <= set(
        gradescope._packed(ROOT)
    )
    listed = ["git", "ls-files", "--exclude-standard"]
    tracked = subprocess.run(listed, cwd=ROOT, capture_output=True, text=True, check=False)
    if tracked.returncode == 0:
        tops = {line.split("/")[0] for line in tracked.stdout.splitlines()}
        assert {top for top in tops if not top.startswith(".")} == set(gradescope.PACKED)


def in_a_container(root: Path, *command: str) -> "subprocess.CompletedProcess[str]":
    """Runs a command with `root` as /autograder, as in Gradescope's container."""
    box = ["bwrap", "--dev-bind", "/", "/", "--tmpfs", "/autograder"]
    box += ["--bind", str(root), "/autograder", "--"]
    environment = {**os.environ, "KIT_NO_INSTALL": "1"}
    return subprocess.run(
        [*box, *command], env=environment, capture_output=True, text=True, check=False
    )


@pytest.mark.long
def test_the_autograder_builds_and_grades_in_its_place(tmp_path: Path) -> None:
    root = tmp_path / "autograder"
    packed = tmp_path / "autograder.zip"
    subprocess.run([str(ROOT / "kit"), "gradescope", "--out", str(packed)], check=True)
    for folder in ("source", "submission", "results"):
        (root / folder).mkdir(parents=True)
    subprocess.run(["unzip", "-q", str(packed), "-d", str(root / "source")], check=True)
    if in_a_container(root, "true").returncode != 0:
        pytest.skip("/autograder can't be mounted here")
    for name, text in solution_files().items():
        (root / "submission" / name).write_bytes(text)
    done = in_a_container(root, "bash", "/autograder/source/setup.sh")
    assert done.returncode == 0, done.stderr
    results = root / "results" / "results.json"
    done = in_a_container(root, "bash", "/autograder/source/run_autograder")
    assert done.returncode == 0, done.stderr
    import json

    assert sum(test["score"] for test in json.loads(results.read_text())["tests"]) == 100
    results.unlink()
    for file in (root / "submission").iterdir():
        file.unlink()
    assert in_a_container(root, "bash", "/autograder/source/run_autograder").returncode == 0
    assert json.loads(results.read_text())["score"] == 0
    results.unlink()
    (root / "source" / "build" / "kit" / "judge").unlink()
    (root / "source" / "grader" / "judge" / "main.cpp").write_text("no C++")
    assert in_a_container(root, "bash", "/autograder/source/run_autograder").returncode == 3
    assert not results.exists()
