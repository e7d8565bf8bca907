#!/usr/bin/env python3
"""Grades a submission on Classroom 50 by the public cases, and writes its result.json.

Put it with the handout's zip, as bounce.zip, into CLASSROOM/autograders/ASSIGNMENT/ of the
classroom50 repository. That folder is published: the handout holds nothing that students don't
have. The hidden cases are graded by ./kit class, or on a runner of the course's own.

The tests run in one process with the submission, without a box: a student who wants to can write
any result, and read what the machine's user may read. So this keeps only a few variables, and none
of them secret; but the processes above it, which are the service's, have their own: let nothing in
that workflow be a secret to the student. It is for practice; the points that count come from
./kit class.
"""

import contextlib
import datetime
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

BUNDLE = Path(os.environ.get("CLASSROOM50_BUNDLE_DIR") or Path(__file__).resolve().parent)
SECONDS = 900
KEPT = (  # of the environment
    *("PATH", "HOME", "LANG", "LC_ALL", "TMPDIR", "CLASSROOM50_BUNDLE_DIR", "CLASSROOM"),
    *("ASSIGNMENT", "SUBMISSION_TAG", "COMMIT_URL", "RELEASE_URL", "REVIEW_URL"),
)


def keep_no_secret() -> None:
    """Starts this program again without other variables, before anything is built: a submission
    could look for them in the /proc of this process."""
    if sys.argv[1:] != ["again"]:
        kept = {name: value for name, value in os.environ.items() if name in KEPT}
        os.execve(sys.executable, [sys.executable, __file__, "again"], kept)


def run(*command: str, cwd: Path) -> None:
    """Ends it with all that it started if it takes too long."""
    process = subprocess.Popen(command, cwd=cwd, stdout=sys.stderr, start_new_session=True)
    try:
        process.wait(SECONDS)
    except subprocess.TimeoutExpired:
        print(f"{command[0]} took more than {SECONDS} s and was stopped", file=sys.stderr)
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()


def unpack(folder: Path) -> Path:
    """The handout, with the sources of the submission in place of the stubs."""
    with zipfile.ZipFile(BUNDLE / "bounce.zip") as archive:
        archive.extractall(folder)
    home = folder / "bounce"
    (home / "check").chmod(0o755)
    own = Path("src") if Path("src").is_dir() else Path(".")
    for file in own.iterdir():
        known = file.suffix in (".cpp", ".hpp", ".h") and file.name != "main.cpp"
        if known and file.is_file() and not file.is_symlink():
            shutil.copy(file, home / "src" / file.name)
    return home


def passed_checks(home: Path) -> set[str]:
    """The checks that pass, as ./check counts them: a part is also judged with correct earlier parts,
    so that one mistake is paid for once. None if nothing could be checked."""
    record = home / "record.json"
    run("./check", "--json", record.name, cwd=home)
    parts = json.loads(record.read_text())["parts"] if record.exists() else []
    return {check["id"] for part in parts for check in part["checks"] if check["passed"]}


def result(rows: list[dict[str, object]]) -> dict[str, object]:
    """The runner adds who handed it in."""
    env = os.environ
    now = datetime.datetime.now(datetime.timezone.utc)
    return {
        "schema": "classroom50/result/v1",
        "classroom": env["CLASSROOM"],
        "assignment": env["ASSIGNMENT"],
        "submission": env["SUBMISSION_TAG"],
        "commit": env["COMMIT_URL"],
        "release": env["RELEASE_URL"],
        "review": env.get("REVIEW_URL") or env["COMMIT_URL"],
        "datetime": now.strftime("%Y-%m-%dT%H:%M:%SZ"),
        "score": sum(int(str(row["score"])) for row in rows),
        "max-score": sum(int(str(row["max-score"])) for row in rows),
        "tests": rows,
    }


def write_anew(path: Path, text: str) -> None:
    """Writes a new file in place of what is there, which may be a link of the student's."""
    with tempfile.NamedTemporaryFile("w", dir=path.parent, delete=False) as file:
        file.write(text)
        os.fchmod(file.fileno(), 0o644)
    os.replace(file.name, path)


def main() -> None:
    keep_no_secret()
    rows = []
    with tempfile.TemporaryDirectory() as name:
        home = unpack(Path(name))
        parts = json.loads((home / "tests" / "parts.json").read_text())["parts"]
        points = [check["points"] for part in parts for check in part["checks"]]
        scale = next(s for s in (1, 2, 4, 5, 10, 100) if all((p * s) % 1 == 0 for p in points))
        passed = passed_checks(home)
        for part in parts:
            for number, check in enumerate(part["checks"], 1):
                most = int(check["points"] * scale)  # whole numbers alone are allowed
                is_passed = check["id"] in passed
                rows.append(
                    {
                        "test-name": f"{part['part']}.{number} {check['title']}",
                        "passed": is_passed,
                        "score": most if is_passed else 0,
                        "max-score": most,
                    }
                )
    write_anew(Path("result.json"), json.dumps(result(rows), indent=1))


if __name__ == "__main__":
    main()
