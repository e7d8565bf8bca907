"""Paths of the kit's files and folders, and those that are given."""

from argparse import ArgumentTypeError
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
BUILD = ROOT / "build" / "kit"
RUNNER = BUILD / "runner"
JUDGE = BUILD / "judge"
STOPWATCH = BUILD / "stopwatch"
GIVEN_RUNNER = BUILD / "given_runner"
REFERENCE_RUNNER = BUILD / "reference_runner"
ENTER = BUILD / "enter"
EXAMPLES = BUILD / "examples"
REPORT = BUILD / "report"
SENTENCES = ROOT / "grader" / "words"
PROBE = BUILD / "probe"
CACHE = BUILD / "cache"
CONTRACT = ROOT / "student" / "include"
HANDOUT = ROOT / "student"
STUBS = HANDOUT / "src"
WORK_FOLDER = "bounce-grading-"  # prefix of the temporary folder of a grading
SOURCES = "sources"  # the folder in it with the submission's files
FIXTURES = ROOT / "fixtures"
SCENES = FIXTURES / "scenes"
SECRET = ROOT / "course-secret"


def given_path(text: str) -> Path:
    """An argument that is a path. An empty one, as of an unset variable, isn't meant for `.`"""
    if not text:
        raise ArgumentTypeError("it is empty: give a path, or . for this folder")
    return Path(text)
