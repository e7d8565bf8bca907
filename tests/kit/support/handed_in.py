"""Makes submissions for the tests of reading them, and returns the sentence that refuses one."""

import zipfile
from pathlib import Path

import pytest
from bounce_grader.common.errors import UsageError
from bounce_grader.submission import submission

PARTS = {f"{stem}.cpp" for stem in ("part1_contacts", "part2_lcp", "part3_step", "part4_simulate")}


def zip_of(path: Path, files: dict[str, bytes]) -> Path:
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files.items():
            archive.writestr(name, text)
    return path


def refusal(path: Path) -> str:
    with pytest.raises(UsageError) as refused:
        submission.read(path)
    sentence = str(refused.value)
    assert "\n" not in sentence
    return sentence
