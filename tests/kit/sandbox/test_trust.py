"""The list of trust (docs/security-trust.md) names every place that reads what a submission's
processes could have written. A place that begins to read another thing fails here, until somebody
has thought about what that thing may decide."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

from conftest import ROOT

PAGE = ROOT / "docs" / "security-trust.md"
PACKAGE = ROOT / "grader" / "bounce_grader"
# The fields of processes.Result, and the names that such results have in the code.
RESULT = {"out", "err", "code", "ok", "killed", "boxed", "too_long", "flooded", "cpu_seconds"}
RESULTS = {"result", "first", "done", "tried", "asked", "said", "usage", "self", "process"}
ELSEWHERE = {
    "sandbox/processes.py",  # which makes the results
    *(
        f"develop/{name}.py"
        for name in ("bench", "bench_class", "bench_methods", "fuzz", "selftest")
    ),
}
READING = {
    "a descriptor": r"::(?:read|recv|pread)\(",
    "a wait status": r"\bW(?:IFSIGNALED|EXITSTATUS|TERMSIG)\(",
    "a variable": r"\bgetenv\(",
    "a process of /proc": r"\"/proc",
}


def python_reads() -> Iterator[tuple[str, str]]:
    for file in PACKAGE.rglob("*.py"):
        name = str(file.relative_to(PACKAGE))
        if name in ELSEWHERE:
            continue
        for node in ast.walk(ast.parse(file.read_text())):
            if isinstance(node, ast.Attribute) and node.attr in RESULT:
                called = isinstance(node.value, ast.Call)
                of_a_result = isinstance(node.value, ast.Name) and node.value.id in RESULTS
                if called or of_a_result:
                    yield name, node.attr
            if isinstance(node, ast.Attribute) and node.attr in ("environ", "getenv"):
                yield name, "environ"


def cpp_reads() -> Iterator[tuple[str, str]]:
    for folder in ("judge", "box"):
        for file in (ROOT / "grader" / folder).glob("*.cpp"):
            text = re.sub(r"//.*", "", file.read_text())
            for what, pattern in READING.items():
                if file.name != "probe.cpp" and re.search(pattern, text):
                    yield f"{folder}/{file.name}", what


def listed(heading: str) -> set[tuple[str, str]]:
    """The rows of a table: what reads, and each thing that it reads."""
    section = PAGE.read_text().split(f"## {heading}\n")[1].split("\n## ")[0]
    rows = re.findall(r"^\| `([^`]+)` \| ([^|]+) \|", section, re.MULTILINE)
    return {(name, what.strip()) for name, things in rows for what in things.split(",")}


def test_all_that_python_reads_of_a_process_is_listed() -> None:
    assert set(python_reads()) == listed("Read by the grader")


def test_all_that_the_judge_and_the_boxes_read_is_listed() -> None:
    assert set(cpp_reads()) == listed("Read by the judge and the boxes")


def test_every_row_says_who_and_what_for() -> None:
    rows = [line for line in PAGE.read_text().splitlines() if line.startswith("| `")]
    assert len(rows) > 15
    for row in rows:
        cells = [cell.strip() for cell in row.strip("|").split("|")]
        assert len(cells) == 4 and all(cells), row


def test_what_is_kept_is_named_by_all_that_it_is_made_from() -> None:
    """A key reads the submission's files, the flags and the box, and no compiler's output."""
    tree = ast.parse((PACKAGE / "build" / "object_cache.py").read_text())
    assert not any(isinstance(n, ast.Attribute) and n.attr in RESULT for n in ast.walk(tree))
