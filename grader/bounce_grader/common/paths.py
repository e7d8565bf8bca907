"""Where things are."""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
BUILD = ROOT / "build" / "kit"
RUNNER = BUILD / "runner"
JUDGE = BUILD / "judge"
STOPWATCH = BUILD / "stopwatch"
REFERENCE_RUNNER = BUILD / "reference_runner"
ENTER = BUILD / "enter"
PROBE = BUILD / "probe"
WATCH = BUILD / "watch"
CACHE = BUILD / "cache"
CONTRACT = ROOT / "student" / "include"
HANDOUT = ROOT / "student"
STUBS = HANDOUT / "src"
WORK_FOLDER = "bounce-submission-"  # the prefix of a temporary one
SOURCES = "sources"  # in it, what was submitted
FIXTURES = ROOT / "fixtures"
SCENES = FIXTURES / "scenes"
SUPPORT = ROOT / "tests" / "kit" / "support"  # what the kit's tests share
SECRET = ROOT / "course-secret"
