"""What has to come out: compared with what does, or written anew by ./kit test --accept for a person
to read in the diff."""

import difflib
import os
import shutil
import sys
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

# Python's own reader of TOML, or the one it was made from.
toml = import_module("tomllib" if sys.version_info >= (3, 11) else "tomli")


def compare_file(expected: Path, got: str) -> None:
    if os.environ.get("BOUNCE_ACCEPT"):
        expected.parent.mkdir(parents=True, exist_ok=True)
        expected.write_text(got, encoding="utf-8", newline="")
    written = expected.read_bytes().decode("utf-8") if expected.exists() else None
    lines = difflib.unified_diff((written or "").splitlines(), got.splitlines(), "expected", "got")
    says = "differs: if that is right, run ./kit test --accept, and read the diff"
    assert got == written, "\n".join([f"{expected} {says}", *lines])


def compare(expected: Path, got: dict[str, str]) -> None:
    """Compares texts, by their file's name, with the files of a folder."""
    if os.environ.get("BOUNCE_ACCEPT"):
        shutil.rmtree(expected, ignore_errors=True)
    for name, text in got.items():
        compare_file(expected / name, text)
    names = {str(path.relative_to(expected)) for path in expected.rglob("*") if path.is_file()}
    assert names == got.keys(), f"{expected} has a file too many, or lacks one"


def table(file: Path) -> dict[str, Any]:
    found: dict[str, Any] = toml.loads(file.read_text("utf-8"))
    return found


def rows(file: Path, name: str) -> list[Any]:
    """The rows of a table in TOML, each a parameter of a test; with `long = true`, of the long
    run."""
    return [
        pytest.param(row, id=row["name"], marks=[pytest.mark.long] * row.get("long", False))
        for row in table(file)[name]
    ]
