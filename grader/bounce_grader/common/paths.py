"""Paths of the kit's files and folders."""

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
PROBE = BUILD / "probe"
CACHE = BUILD / "cache"
CONTRACT = ROOT / "student" / "include"
HANDOUT = ROOT / "student"
STUBS = HANDOUT / "src"
WORK_FOLDER = "bounce-submission-"  # prefix of the temporary folder of a grading
SOURCES = "sources"  # the folder in it with the submission's files
FIXTURES = ROOT / "fixtures"
SCENES = FIXTURES / "scenes"
SECRET = ROOT / "course-secret"
