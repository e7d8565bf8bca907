"""Students read the points of the manifest, whatever they are."""

import re
import zipfile
from pathlib import Path

import pytest
from bounce_grader.common.manifest import parts
from bounce_grader.publish import handout, points
from conftest import ROOT

TEXTS = [ROOT / "student" / "README.md", *(ROOT / "student" / "include").rglob("*.hpp")]


@pytest.mark.parametrize("file", TEXTS, ids=lambda file: str(file.name))
def test_what_the_repository_says_are_the_points_of_the_manifest(file: Path) -> None:
    assert points.with_points(file.read_text()) == file.read_text()


def test_the_handout_says_other_points_where_the_manifest_does(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    other = [41, 23.5, 37, 17]
    changed = tuple(part._replace(points=other[part.number - 1]) for part in parts())
    monkeypatch.setattr(points, "parts", lambda: changed)
    handout.write(tmp_path / "handout.zip")
    said = set()
    with zipfile.ZipFile(tmp_path / "handout.zip") as archive:
        for name in archive.namelist():
            if name.endswith((".md", ".hpp")) and "/tests/" not in name:
                text = archive.read(name).decode()
                said |= set(re.findall(r"([\d.]+) points", text))
                said |= set(re.findall(r"^\| \d \|.*\| ([\d.]+) \|$", text, re.M))
        readme = archive.read("bounce/README.md").decode()
    assert said == {"41", "23.5", "37", "17", "118.5"}
    assert "41, 23.5, 37 and 17 points" in readme and "worth 118.5 points" in readme
